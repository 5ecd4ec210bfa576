#pragma once
/// All stencils of a √3 scheme, read by refining linear forms on stars and fans with the plain
/// engine: nothing here knows a rule.

#include <map>

#include "limn/refine/fast/sqrt3_reach.h"
#include "limn/refine/fast/stencil_tables.h"

namespace limn::fast {

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

/// Of one step.
struct Sqrt3Tables {
  Sqrt3Reach reach;
  std::array<Stencil, kSqrt3Classes> interior;  ///< local, from the anchor
  /// Of new points (X, Y) along a boundary side that runs along the first axis, the mesh lying
  /// above: number 3·Y + X mod 3, for Y ≤ reach.strip_depth; thirds, from the point. Empty where
  /// there is no new point.
  std::vector<Stencil> strips;
  std::map<Index, ZoneTable> stars;  ///< by valence of an interior vertex
  std::map<Index, ZoneTable> fans;   ///< by number of faces at a boundary vertex
};

/// The tables that refining a mesh with vertices and faces of these kinds needs, of both steps.
/// Fails as read_stencils.
[[nodiscard]] Result<std::array<Sqrt3Tables, 2>> read_sqrt3_stencils(
    const Scheme& scheme, const std::vector<VertexKind>& kinds, const BoundarySides& sides);

}  // namespace limn::fast
