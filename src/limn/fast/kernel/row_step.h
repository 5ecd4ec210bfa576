#pragma once
/// The points of a step that patches cannot make, from rows.

#include "limn/fast/kernel/step_plan.h"

namespace limn::fast {

/// Overwrites the targets of all places. Arrays as for make_patches (patch_step.h).
template <class Real>
void make_rows(const RowPlan& plan, const Real* in, Real* out);

/// Of a limit plan (step_plan.h): limit positions, and unit normals.
template <class Real>
void make_limit_rows(const RowPlan& plan, const Real* in, Real* positions, Real* normals);

extern template void make_rows<float>(const RowPlan&, const float*, float*);
extern template void make_rows<double>(const RowPlan&, const double*, double*);
extern template void make_limit_rows<float>(const RowPlan&, const float*, float*, float*);
extern template void make_limit_rows<double>(const RowPlan&, const double*, double*, double*);

}  // namespace limn::fast
