#pragma once
/// The patches of a step from one level of grids to the next: what each reads and makes, and the
/// numbers for it.

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/lattice_step.h"
#include "limn/fast/layout/patch_frame.h"

namespace limn::fast {

/// A level, and the one that its step leads to; places are in the step's finer grid.
struct GridStep {
  GridStep(const Mesh& control, const GridCycle& cycle, int level)
      : step(cycle, level),
        old_points(control, cycle.lattice, grid_of(control, cycle, level), cycle.cut,
                   step.from_centres),
        new_points(step.to_centres ? GridLayout(control, cycle.lattice, n(), cycle.cut, true)
                                   : GridLayout(control, cycle.lattice, side())) {}

  [[nodiscard]] const Mesh& control() const { return old_points.control(); }
  [[nodiscard]] Index n() const { return old_points.n(); }
  [[nodiscard]] Index side() const { return old_points.side(); }

  LatticeStep step;
  GridLayout old_points, new_points;

 private:
  /// Without faces nothing grows, whatever the level.
  static Index grid_of(const Mesh& control, const GridCycle& cycle, int level) {
    return control.face_count() == 0 ? 1 : power(cycle.cut, level / cycle.steps);
  }
};

/// What patches make: the new points, by the stencils of their classes, or something at the old
/// ones, all by the first stencil.
enum class Made { next_level, same_level };

/// `stencils` are local, from the anchor; an old point is its own. What takes from points beyond a
/// patch's neighbours is to be overwritten. The corners are not made.
[[nodiscard]] PatchPlan plan_patches(const GridStep& step, std::vector<Stencil> stencils,
                                     const PatchTopology& faces, Made made);

}  // namespace limn::fast
