#include "limn/extraordinary/fast_limit.h"

namespace limn {

Result<std::optional<FastRefiner::Limit>> approx_fast_limit(const Scheme& scheme,
                                                            const FastRefiner& refiner) {
  FrequencyAnalysis analysis(scheme);
  return refiner.limit([&](bool open, Index faces) -> Result<fast::LimitSums> {
    Result<LimitStencil> stencil =
        open ? approx_boundary_limit_stencil(scheme, faces) : approx_limit_stencil(analysis, faces);
    if (!stencil) return stencil.error();
    return fast::LimitSums{stencil->rings,
                           {stencil->position, stencil->first_tangent, stencil->second_tangent}};
  });
}

}  // namespace limn
