#include "limn/refine/fast/patch_step.h"

#include <cmath>

#include "limn/refine/fast/lane_stencil.h"
#include "limn/refine/fast/patch_worker.h"

namespace limn::fast {
namespace {

template <class Real>
using Line = std::vector<LanePoint<Real>>;

template <class Real>
std::vector<LaneStencil<Real>> lane_stencils(const PatchPlan& plan, const PatchProgram& program) {
  std::vector<LaneStencil<Real>> stencils;
  for (const Stencil& stencil : plan.stencils) stencils.emplace_back(stencil, program);
  return stencils;
}

/// first := first × second, as unit vectors; zero stays.
template <class Real>
void cross_to_unit(LanePoint<Real>& first, const LanePoint<Real>& second) {
  const LanePoint<Real> normal{first.y * second.z - first.z * second.y,
                               first.z * second.x - first.x * second.z,
                               first.x * second.y - first.y * second.x};
  const Vector<Real> squared = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
  Vector<Real> scale{};
  for (int lane = 0; lane < kLanes<Real>; ++lane)
    scale[lane] = squared[lane] > 0 ? 1 / std::sqrt(squared[lane]) : 0;
  first = {normal.x * scale, normal.y * scale, normal.z * scale};
}

}  // namespace

template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out) {
  const std::vector<LaneStencil<Real>> stencils = lane_stencils<Real>(plan, program);
  for_batches(plan, program, in, [&] {
    return [&, line = Line<Real>(static_cast<std::size_t>(program.line))](
               PatchWorker<Real>& worker) mutable {
      for (const PatchBlock& block : program.blocks) {
        for (const StencilPoints& points : block.points)
          stencils[points.stencil].apply(worker.grid(), points, line.data());
        worker.put(block, line.data(), out);
      }
    };
  });
}

template <class Real>
void make_limit_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in,
                        Real* positions, Real* normals) {
  const std::vector<LaneStencil<Real>> stencils = lane_stencils<Real>(plan, program);
  for_batches(plan, program, in, [&] {
    const Line<Real> line(static_cast<std::size_t>(program.line));
    return
        [&, sums = std::array<Line<Real>, 3>{line, line, line}](PatchWorker<Real>& worker) mutable {
          for (const PatchBlock& block : program.blocks) {
            for (std::size_t i = 0; i < sums.size(); ++i)
              stencils[i].apply(worker.grid(), block.points.front(), sums[i].data());
            for (std::size_t i = 0; i < sums[1].size(); ++i) cross_to_unit(sums[1][i], sums[2][i]);
            worker.put(block, sums[0].data(), positions);
            worker.put(block, sums[1].data(), normals);
          }
        };
  });
}

template void make_patches<float>(const PatchPlan&, const PatchProgram&, const float*, float*);
template void make_patches<double>(const PatchPlan&, const PatchProgram&, const double*, double*);
template void make_limit_patches<float>(const PatchPlan&, const PatchProgram&, const float*, float*,
                                        float*);
template void make_limit_patches<double>(const PatchPlan&, const PatchProgram&, const double*,
                                         double*, double*);

}  // namespace limn::fast
