#pragma once
/// The patches of a step, several at once (lanes.h).

#include "limn/fast/kernel/patch_program.h"

namespace limn::fast {

/// Makes the runs of all patches. `in` has the old points, three numbers each, and one number of
/// padding, `out` room for the new points; they do not overlap. Each value is summed by one thread
/// in a fixed order. For float and double.
template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out);

/// Of a limit plan (step_plan.h): the patches' limit positions, and unit normals.
template <class Real>
void make_limit_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in,
                        Real* positions, Real* normals);

extern template void make_patches<float>(const PatchPlan&, const PatchProgram&, const float*,
                                         float*);
extern template void make_patches<double>(const PatchPlan&, const PatchProgram&, const double*,
                                          double*);
extern template void make_limit_patches<float>(const PatchPlan&, const PatchProgram&, const float*,
                                               float*, float*);
extern template void make_limit_patches<double>(const PatchPlan&, const PatchProgram&,
                                                const double*, double*, double*);

}  // namespace limn::fast
