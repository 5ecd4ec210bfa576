#pragma once
/// The stencils of a dual scheme, read by refining linear forms on face stars with the plain
/// engine, and how far its rule looks, by its walks: nothing here knows a weight. The centre of a
/// face and an interior vertex look alike after the first step: both are a face of so many sides
/// amid a regular mesh. "Round a centre" means round either.

#include <array>
#include <map>
#include <optional>

#include "limn/fast/sites/dual_places.h"
#include "limn/fast/sites/dual_rims.h"

namespace limn::fast {

struct DualTables {
  /// Whether the rule sees nothing beyond its own face. Then it may stand at any face, at the
  /// boundary and in the first step too.
  bool own_face = false;
  /// Of fine point (X, Y) of a patch, by class_of, from the anchor (⌊X/2⌋, ⌊Y/2⌋).
  std::array<Stencil, kClasses> interior;
  Index halo = 1;  ///< rows beyond a patch's sides that interior stencils see
  Index zone = 1;  ///< fine points of rings 1 … zone round a centre need its zone's table
  std::map<Index, DualZone> zones;  ///< by sides of a centre, 4 among them
  std::optional<DualRims> rims;     ///< where there is a boundary that the rule can see
  /// The fewest points along a patch's side (a power of two) for all this to be so: centres are
  /// then far enough apart.
  Index smallest_grid = 1;
};

inline constexpr Index kLargestDualTable = 1000;  ///< sides of a centre

/// The tables that refining `control` needs. Fails where the rule is missing, or looks too far for
/// tables, or a face or vertex has fewer than 3 or more than kLargestDualTable sides: then the
/// plain engine is the one to ask, which may say more. Cost: some 0.1 ms for each number of sides,
/// n² weights each.
[[nodiscard]] Result<DualTables> read_dual_tables(const Scheme& scheme, const Mesh& control);

}  // namespace limn::fast
