#pragma once
/// The points of a step that patches cannot make, from rows.

#include "limn/fast/kernel/step_plan.h"

namespace limn::fast {

/// Some places of a row plan, and the numbers of their targets, place by place (kNone: not to be
/// made).
struct RowPlaces {
  const Index* list = nullptr;  ///< the places, or null: `first` and those after it
  std::size_t first = 0, count = 0;
  const Index* targets = nullptr;
};

/// A row plan, its weights made ready, so that any place can be made anywhere. The plan must
/// outlive it.
template <class Real>
class RowStep {
 public:
  explicit RowStep(const RowPlan& plan);
  /// Makes the places one after the other; arrays as for make_rows.
  void make(const RowPlaces& places, const Real* in, Real* out) const;
  /// Of a limit plan.
  void make_limit(const RowPlaces& places, const Real* in, Real* positions, Real* normals) const;

 private:
  const RowPlan* plan_;
  std::vector<Real> weights_;
};

/// Overwrites the targets of all places. Arrays as for make_patches (patch_step.h).
template <class Real>
void make_rows(const RowPlan& plan, const Real* in, Real* out);

/// Of a limit plan (step_plan.h): limit positions, and unit normals.
template <class Real>
void make_limit_rows(const RowPlan& plan, const Real* in, Real* positions, Real* normals);

extern template class RowStep<float>;
extern template class RowStep<double>;
extern template void make_rows<float>(const RowPlan&, const float*, float*);
extern template void make_rows<double>(const RowPlan&, const double*, double*);
extern template void make_limit_rows<float>(const RowPlan&, const float*, float*, float*);
extern template void make_limit_rows<double>(const RowPlan&, const double*, double*, double*);

}  // namespace limn::fast
