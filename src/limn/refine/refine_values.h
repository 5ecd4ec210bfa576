#pragma once
/// One refinement step of values of any type: positions, scalars, complex numbers and linear forms
/// all refine through this function.

#include <vector>

#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"
#include "limn/refine/add_scaled.h"
#include "limn/refine/staged_step.h"
#include "limn/refine/step_stencils.h"

namespace limn::refine {

namespace detail {

/// The values of one step: those of the old vertices, and the new ones in their blocks.
template <class Number, class Value>
class ValueStep {
 public:
  ValueStep(const Scheme& scheme, const Mesh& mesh, const Births& births,
            const RuleTables<Number>& tables, const std::vector<Value>& old)
      : stencils_(scheme, mesh, births, tables),
        old_(old),
        fresh_(base::large_vector<Value>(static_cast<std::size_t>(stencils_.count()))) {}

  /// Only the new vertices of the list, in its order.
  std::vector<Value> run_at(const std::vector<Index>& wanted) {
    fill(stencils_.faces_at(), stencils_.corners_at());
    std::vector<Value> values;
    values.reserve(wanted.size());
    for (const Index i : wanted) values.push_back(is_of_face(i) ? fresh_[i] : value(i));
    return values;
  }

  std::vector<Value> run() {
    stencils_.prepare_all();
    if constexpr (std::is_same_v<Value, Point3>) {
      bigs_ = &stencils_.use_big_rings();
      sum_big_rings(0, stencils_.big_rings_of_faces());
    }
    fill(stencils_.faces_at(), stencils_.corners_at());
    if constexpr (std::is_same_v<Value, Point3>)
      sum_big_rings(stencils_.big_rings_of_faces(), bigs_->size());
    fill(0, stencils_.faces_at());
    fill(stencils_.corners_at(), stencils_.count());
    return std::move(fresh_);
  }

 private:
  [[nodiscard]] bool is_of_face(Index i) const {
    return i >= stencils_.faces_at() && i < stencils_.corners_at();
  }

  void fill(Index begin, Index end) {
    base::parallel_for(begin, end, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) fresh_[i] = value(i);
    });
  }

  [[nodiscard]] const Value& value_of(Source source) const {
    if (source.is_face) return fresh_[stencils_.faces_at() + source.index];
    if constexpr (std::is_same_v<Value, Point3>)
      if (static_cast<std::size_t>(source.index) >= old_.size())
        return big_sums_[static_cast<std::size_t>(source.index) - old_.size()];
    return old_[source.index];
  }

  [[nodiscard]] Value value(Index i) const {
    Value sum{};
    stencils_.visit(
        i, [&](Source source, const Number& weight) { add_scaled(sum, weight, value_of(source)); });
    return sum;
  }

  /// One after the other, each in a fixed order.
  void sum_big_rings(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<Point3> sums =
          (*bigs_)[i].sums([&](Source source) { return value_of(source); });
      big_sums_.insert(big_sums_.end(), sums.begin(), sums.end());
    }
  }

  StepStencils<Number> stencils_;
  const std::vector<Value>& old_;
  std::vector<Value> fresh_;
  const std::vector<BigRing>* bigs_ = nullptr;
  std::vector<Value> big_sums_;
};

}  // namespace detail

/// The values at the refined mesh's vertices, in the order of `births`. `old` has one value per
/// vertex of `mesh`; `tables` has been prepared for `mesh` and `births`. Every value is
/// summed by one thread in a fixed order, so one thread and many give the same bits.
/// Value needs a default (zero) and `add_scaled`. Cost O(size of the refined mesh) for points, but
/// for a factor log n where n values are summed round something (big_rings.h says how this rounds);
/// of other values there n². Of a scheme of stages that times their number.
template <class Number, class Value>
[[nodiscard]] std::vector<Value> refine_values(const Scheme& scheme, const Mesh& mesh,
                                               const Births& births,
                                               const RuleTables<Number>& tables,
                                               const std::vector<Value>& old) {
  if (scheme.stages)
    return detail::StagedStep<Number, Value>(scheme, mesh, births, tables, old).run();
  return detail::ValueStep<Number, Value>(scheme, mesh, births, tables, old).run();
}

/// The same at the new vertices of a list alone, on this thread. Cost O(length of the list), and of
/// all faces where these have rules; of a scheme of stages see staged_step.h.
template <class Number, class Value>
[[nodiscard]] std::vector<Value> refine_values_at(const Scheme& scheme, const Mesh& mesh,
                                                  const Births& births,
                                                  const RuleTables<Number>& tables,
                                                  const std::vector<Value>& old,
                                                  const std::vector<Index>& wanted) {
  if (scheme.stages)
    return detail::StagedStep<Number, Value>(scheme, mesh, births, tables, old).run_at(wanted);
  return detail::ValueStep<Number, Value>(scheme, mesh, births, tables, old).run_at(wanted);
}

}  // namespace limn::refine
