#include "limn/refine/fast/patch_step.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "limn/refine/fast/lane_stencil.h"
#include "limn/refine/fast/patch_worker.h"

namespace limn::fast {
namespace {

template <class Real>
using Line = std::vector<LanePoint<Real>>;

template <class Real>
std::vector<LaneStencil<Real>> lane_stencils(const PatchPlan& plan, const PatchProgram& program) {
  std::vector<LaneStencil<Real>> stencils;
  stencils.reserve(plan.stencils.size());
  for (const Stencil& stencil : plan.stencils) stencils.emplace_back(stencil, program);
  return stencils;
}

/// Whether all places that new points take from are in the local grid; each takes from so many
/// stencils, from the one that it names on.
[[maybe_unused]] bool stays_in_grid(const PatchPlan& plan, const PatchProgram& program,
                                    std::size_t each) {
  for (const PatchBlock& block : program.blocks)
    for (const StencilPoints& points : block.points)
      for (std::size_t s = points.stencil; s < points.stencil + each; ++s)
        for (const Tap& tap : plan.stencils[s])
          for (const Index anchor : points.anchors) {
            const Index slot = anchor + program.slot_step(tap.place);
            if (slot < 0 || slot >= program.slots) return false;
          }
  return true;
}

/// Position and two tangents of the points of a block, and the normal from these.
template <class Real>
class LimitLines {
 public:
  explicit LimitLines(std::size_t points)
      : position_(points), first_(points), second_(points), lengths_(points * kLanes<Real>) {}

  void make(const std::vector<LaneStencil<Real>>& stencils, const LanePoint<Real>* grid,
            const StencilPoints& points) {
    stencils[0].apply(grid, points, position_.data());
    stencils[1].apply(grid, points, first_.data());
    stencils[2].apply(grid, points, second_.data());
    cross_to_units();
  }
  [[nodiscard]] const LanePoint<Real>* positions() const { return position_.data(); }
  [[nodiscard]] const LanePoint<Real>* normals() const { return first_.data(); }

 private:
  /// first := first × second, as unit vectors; zero stays. In three loops, so that the compiler
  /// takes several roots in one instruction.
  void cross_to_units() {
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const LanePoint<Real> a = first_[i], b = second_[i];
      const LanePoint<Real> n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
      first_[i] = n;
      store(&lengths_[i * kLanes<Real>], n.x * n.x + n.y * n.y + n.z * n.z);
    }
    constexpr Real kSmallest = std::numeric_limits<Real>::min();
    for (Real& l : lengths_) l = 1 / std::sqrt(l + kSmallest);  // no branch
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const Vector<Real> scale = load(&lengths_[i * kLanes<Real>]);
      first_[i] = {first_[i].x * scale, first_[i].y * scale, first_[i].z * scale};
    }
  }

  Line<Real> position_, first_, second_;
  std::vector<Real> lengths_;  // of the normals, then their inverses
};

}  // namespace

template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out) {
  assert(stays_in_grid(plan, program, 1));
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
  assert(stays_in_grid(plan, program, 3));
  const std::vector<LaneStencil<Real>> stencils = lane_stencils<Real>(plan, program);
  for_batches(plan, program, in, [&] {
    return [&, sums = LimitLines<Real>(static_cast<std::size_t>(program.line))](
               PatchWorker<Real>& worker) mutable {
      for (const PatchBlock& block : program.blocks) {
        sums.make(stencils, worker.grid(), block.points.front());
        worker.put(block, sums.positions(), positions);
        worker.put(block, sums.normals(), normals);
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
