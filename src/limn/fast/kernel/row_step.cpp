#include "limn/fast/kernel/row_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "limn/base/parallel.h"
#include "limn/fast/kernel/quad.h"
#include "limn/mesh/unit_normal.h"

namespace limn::fast {
namespace {

constexpr std::ptrdiff_t kPlaceGrain = 1024;

/// Sums the rows of one table.
template <class Real>
class RowWorker {
 public:
  using Four = typename Quad<Real>::Type;

  RowWorker(const RowTable& table, const std::vector<Real>& weights)
      : table_(table), weights_(weights), points_(static_cast<std::size_t>(table.sources)) {}

  void load(const Index* sources, const Real* in) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      std::memcpy(&points_[i], in + 3 * static_cast<std::ptrdiff_t>(sources[i]), sizeof(Four));
  }

  /// The largest coordinate of the points.
  [[nodiscard]] Real size() const {
    Real size = 0;
    for (const Four& point : points_)
      size = std::max({size, std::abs(point[0]), std::abs(point[1]), std::abs(point[2])});
    return size;
  }

  /// By reference, as such vectors are not returned alike on all processors.
  void sum(int row, Four& to) const {
    Four sum{};
    for (int t = table_.row_begin[row]; t < table_.row_begin[row + 1]; ++t)
      sum += weights_[t] * points_[table_.terms[t].source];
    to = sum;
  }

 private:
  const RowTable& table_;
  const std::vector<Real>& weights_;
  std::vector<Four> points_;
};

template <class Real>
void put(const typename Quad<Real>::Type& value, Index number, Real* out) {
  Real* to = out + 3 * static_cast<std::ptrdiff_t>(number);
  for (int i = 0; i < 3; ++i) to[i] = value[i];
}

/// sum := sum + first × second.
template <class Real>
void add_cross(const typename Quad<Real>::Type& first, const typename Quad<Real>::Type& second,
               typename Quad<Real>::Type& sum) {
  sum += typename Quad<Real>::Type{first[1] * second[2] - first[2] * second[1],
                                   first[2] * second[0] - first[0] * second[2],
                                   first[0] * second[1] - first[1] * second[0], 0};
}

/// A sum's numbers.
template <class Real>
std::array<double, 3> numbers(const typename Quad<Real>::Type& sum) {
  return {sum[0], sum[1], sum[2]};
}

/// Makes the vector a unit one, unless it is so large or small that products may be lost, or may be
/// no more than rounding leaves of points of this size and tangents of these squares: then false.
template <class Real>
bool is_normalized(typename Quad<Real>::Type& normal, Real size, Real squares) {
  const Real squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  constexpr Real kError = Real(mesh::kTangentUnits) * std::numeric_limits<Real>::epsilon();
  const Real least = kError * size * kError * size * squares;
  if (!(squared > least && squared > mesh::kSafeSquare<Real> &&
        squared < 1 / mesh::kSafeSquare<Real>))
    return false;
  normal *= 1 / std::sqrt(squared);
  return true;
}

template <class Real>
Real square(const typename Quad<Real>::Type& sum) {
  return sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
}

/// The normal of a chain of rows at any size, or zero.
template <class Real>
void careful_normal(const RowWorker<Real>& worker, int row, int end, Real size,
                    typename Quad<Real>::Type& normal) {
  std::vector<std::array<double, 3>> chain;
  typename Quad<Real>::Type sum;
  for (; row < end; ++row) {
    worker.sum(row, sum);
    chain.push_back(numbers<Real>(sum));
  }
  const std::array<double, 3> unit = mesh::unit_normal<Real>(chain, static_cast<double>(size));
  for (int i = 0; i < 3; ++i) normal[i] = static_cast<Real>(unit[static_cast<std::size_t>(i)]);
}

/// Makes the rows of a place whose sources have been read, but for those without a target.
template <class Real>
void make_place(const RowWorker<Real>& worker, int rows, const Index* targets, Real* out) {
  typename Quad<Real>::Type sum;
  for (int row = 0; row < rows; ++row) {
    if (targets[row] == kNone) continue;
    worker.sum(row, sum);
    put<Real>(sum, targets[row], out);
  }
}

/// The same of a limit plan: `points` of so many rows each.
template <class Real>
void make_limit_place(const RowWorker<Real>& worker, int points, int rows, const Index* targets,
                      Real* positions, Real* normals) {
  typename Quad<Real>::Type position, last, next;
  const Real size = worker.size();
  for (int i = 0; i < points; ++i) {
    if (targets[i] == kNone) continue;
    const int first = i * rows;
    typename Quad<Real>::Type normal{};
    worker.sum(first, position);
    worker.sum(first + 1, last);
    Real squares = square<Real>(last);
    for (int row = first + 2; row < first + rows; ++row, last = next) {
      worker.sum(row, next);
      add_cross<Real>(last, next, normal);
      squares += square<Real>(next);
    }
    if (!is_normalized<Real>(normal, size, squares))
      careful_normal(worker, first + 1, first + rows, size, normal);
    put<Real>(position, targets[i], positions);
    put<Real>(normal, targets[i], normals);
  }
}

/// work(worker, the place's targets) for each of the places, after its sources have been read.
template <class Real, class Work>
void for_places(const RowPlan& plan, const std::vector<Real>& weights, const RowPlaces& places,
                const Real* in, const Work& work) {
  RowWorker<Real> worker(plan.table, weights);
  const Index* targets = places.targets;
  for (std::size_t i = 0; i < places.count; ++i, targets += plan.targets_each()) {
    const std::size_t place =
        places.list != nullptr ? static_cast<std::size_t>(places.list[i]) : places.first + i;
    worker.load(plan.sources.data() + place * static_cast<std::size_t>(plan.table.sources), in);
    work(worker, targets);
  }
}

/// work(places) for all places of a plan.
template <class Work>
void for_all_places(const RowPlan& plan, const Work& work) {
  const auto places = static_cast<std::ptrdiff_t>(plan.places());
  base::parallel_for(
      std::ptrdiff_t{0}, places,
      [&](std::ptrdiff_t first, std::ptrdiff_t last) {
        const auto begin = static_cast<std::size_t>(first);
        work(RowPlaces{nullptr, begin, static_cast<std::size_t>(last - first),
                       plan.targets.data() + begin * plan.targets_each()});
      },
      plan.overlap ? places : kPlaceGrain);
}

}  // namespace

template <class Real>
RowStep<Real>::RowStep(const RowPlan& plan) : plan_(&plan) {
  weights_.reserve(plan.table.terms.size());
  for (const RowTable::Term& term : plan.table.terms)
    weights_.push_back(static_cast<Real>(term.weight));
}

template <class Real>
void RowStep<Real>::make(const RowPlaces& places, const Real* in, Real* out) const {
  const int rows = plan_->table.targets();
  for_places(*plan_, weights_, places, in,
             [&](const RowWorker<Real>& worker, const Index* targets) {
               make_place(worker, rows, targets, out);
             });
}

template <class Real>
void RowStep<Real>::make_limit(const RowPlaces& places, const Real* in, Real* positions,
                               Real* normals) const {
  const auto points = static_cast<int>(plan_->targets_each());
  if (points == 0) return;
  const int rows = plan_->table.targets() / points;
  for_places(*plan_, weights_, places, in,
             [&](const RowWorker<Real>& worker, const Index* targets) {
               make_limit_place(worker, points, rows, targets, positions, normals);
             });
}

template <class Real>
void make_rows(const RowPlan& plan, const Real* in, Real* out) {
  const RowStep<Real> step(plan);
  for_all_places(plan, [&](const RowPlaces& places) { step.make(places, in, out); });
}

template <class Real>
void make_limit_rows(const RowPlan& plan, const Real* in, Real* positions, Real* normals) {
  const RowStep<Real> step(plan);
  for_all_places(plan,
                 [&](const RowPlaces& places) { step.make_limit(places, in, positions, normals); });
}

template class RowStep<float>;
template class RowStep<double>;
template void make_rows<float>(const RowPlan&, const float*, float*);
template void make_rows<double>(const RowPlan&, const double*, double*);
template void make_limit_rows<float>(const RowPlan&, const float*, float*, float*);
template void make_limit_rows<double>(const RowPlan&, const double*, double*, double*);

}  // namespace limn::fast
