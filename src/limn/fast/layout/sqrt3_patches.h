#pragma once
/// The patches of √3 grids (sqrt3_layout.h): what each reads and makes, and the numbers for it.

#include "limn/fast/layout/sqrt3_layout.h"
#include "limn/fast/layout/triangle_frame.h"
#include "limn/fast/sites/sqrt3_site.h"

namespace limn::fast {

[[nodiscard]] constexpr Sqrt3Step step_from(int level) {
  return level % 2 == 0 ? Sqrt3Step::centroids : Sqrt3Step::thirds;
}

/// The lattice of old points: local coordinates in which their patch is a dense grid. The old
/// points of a step of thirds have the basis (2, -1), (1, 1).
[[nodiscard]] constexpr Offset to_local(Sqrt3Step step, Offset old) {
  if (step == Sqrt3Step::centroids) return {old.a / 3, old.b / 3};
  return {(old.a - old.b) / 3, (old.a + 2 * old.b) / 3};
}

/// Regular new points of one class have one stencil but for a translation: the class is how far
/// from its anchor, an old point, a point lies, along (1, 1) or (1, 0).
inline constexpr Index kSqrt3Classes = 3;
[[nodiscard]] constexpr Index sqrt3_class(Sqrt3Step step, Offset made) {
  const Index along = step == Sqrt3Step::centroids ? made.a : made.a - made.b;
  return ((along % 3) + 3) % 3;
}
[[nodiscard]] constexpr Offset anchor_of(Sqrt3Step step, Offset made) {
  const Index c = sqrt3_class(step, made);
  return {made.a - c, step == Sqrt3Step::centroids ? made.b - c : made.b};
}

/// A level, and the one that its step leads to; places are in its grid of thirds.
struct Sqrt3Level {
  Sqrt3Level(const Mesh& control, int level)
      : step(step_from(level)), odd(control, power_of_3(level / 2)), thirds(control, side()) {}

  [[nodiscard]] Index n() const { return odd.n(); }
  [[nodiscard]] Index side() const { return 3 * odd.n(); }
  /// Old points, also beyond the patch's sides.
  [[nodiscard]] Index old_point(Index h, Index x, Index y) const {
    return step == Sqrt3Step::thirds ? odd.point_beyond(h, x, y)
                                     : odd.grid().point_beyond(h, x / 3, y / 3);
  }
  [[nodiscard]] Index new_point(Index h, Index x, Index y) const {
    return step == Sqrt3Step::thirds ? thirds.point(h, x, y) : odd.point(h, x, y);
  }

  Sqrt3Step step;
  CentroidLayout odd;
  TriangleLayout thirds;
};

/// The two sides of a step for number_points (zones.h).
struct Sqrt3OldPoints {
  const Sqrt3Level& level;
  [[nodiscard]] Index n() const { return level.side(); }
  [[nodiscard]] Index point(Index h, Index x, Index y) const { return level.old_point(h, x, y); }
  [[nodiscard]] Index point_along(EdgeCode code, Index x) const {
    return level.odd.grid().point_along(code, x / 3);
  }
};
struct Sqrt3NewPoints {
  const Sqrt3Level& level;
  [[nodiscard]] Index n() const { return level.side(); }
  [[nodiscard]] Index point(Index h, Index x, Index y) const { return level.new_point(h, x, y); }
  [[nodiscard]] Index point_along(EdgeCode code, Index x) const {
    return level.step == Sqrt3Step::thirds ? level.thirds.point_along(code, x)
                                           : level.odd.grid().point_along(code, x / 3);
  }
};

/// What patches make: the new points, by the stencils of their classes, or something at the old
/// ones, all by the first stencil.
enum class Sqrt3Made { next_level, same_level };

/// `stencils` are local, from the anchor; an old point is its own. What takes from points beyond a
/// patch's neighbours is to be overwritten. `faces` are all of the control mesh's. The corners are
/// not made.
[[nodiscard]] PatchPlan plan_sqrt3_patches(const Sqrt3Level& level, std::vector<Stencil> stencils,
                                           const HugeArray<TriangleTopology>& faces,
                                           Sqrt3Made made);

}  // namespace limn::fast
