#pragma once
/// The first steps, by the plain engine, with vertices renumbered as the quick engine has them.

#include "limn/refine/rule_tables.h"

namespace limn::fast {

/// Of a split that cuts edges in two: the half-edge of the refined mesh that starts as h does, on
/// the same edge.
[[nodiscard]] Index first_part(const Mesh& coarse, const SplitResult& split, Index h);

class PlainSteps {
 public:
  /// `count` ≥ 0 steps from the control mesh; scheme and mesh must outlive them. Fails as refine
  /// (refine/refine.h) does.
  [[nodiscard]] static Result<PlainSteps> make(const Scheme& scheme, const Mesh& control,
                                               int count);

  [[nodiscard]] int count() const { return static_cast<int>(splits_.size()); }

  /// What each step made; of a single step, the births alone.
  [[nodiscard]] const std::vector<SplitResult>& splits() const { return splits_; }

  /// From now on, vertices are put out in this order (the plain engine's own, if it is empty).
  void set_order(std::vector<Index> order) { order_ = std::move(order); }

  /// x, y, z of the control vertices → those of the vertices after `count` steps. Sums in double.
  template <class Real>
  void evaluate(const Real* control, Real* fine) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  PlainSteps(const Scheme& scheme, const Mesh& control)
      : scheme_(&scheme), control_(&control), tables_(scheme) {}
  [[nodiscard]] const Mesh& mesh(std::size_t step) const {
    return step == 0 ? *control_ : splits_[step - 1].mesh;
  }

  const Scheme* scheme_;
  const Mesh* control_;
  RuleTables<double> tables_;
  std::vector<SplitResult> splits_;
  std::vector<Index> order_;
};

extern template void PlainSteps::evaluate<float>(const float*, float*) const;
extern template void PlainSteps::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
