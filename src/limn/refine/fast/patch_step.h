#pragma once
/// The inner points of a level: for each patch, several patches at once (lanes.h).

#include "limn/refine/fast/patch_program.h"
#include "limn/refine/fast/triangle_layout.h"

namespace limn::fast {

/// From a level to the next: every fine point but those at control vertices, by interior
/// stencils. Near control vertices and boundaries what is written is of no use: zone_step.h comes
/// after. `in` has coarse.vertex_count() points of three numbers and one number
/// of padding, `out` room for fine.vertex_count() points; they do not overlap. Each value is summed
/// by one thread in a fixed order. For float and double.
template <class Real>
void refine_patches(const TriangleLayout& coarse, const TriangleLayout& fine,
                    const StencilTables& tables, const Real* in, Real* out);

extern template void refine_patches<float>(const TriangleLayout&, const TriangleLayout&,
                                           const StencilTables&, const float*, float*);
extern template void refine_patches<double>(const TriangleLayout&, const TriangleLayout&,
                                            const StencilTables&, const double*, double*);

}  // namespace limn::fast
