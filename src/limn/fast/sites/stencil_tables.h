#pragma once
/// All stencils of a dyadic scheme on triangles or quads, read by refining linear forms on stars
/// and fans with the plain engine (refine/refine_values.h): nothing here knows a rule.

#include <array>
#include <map>
#include <vector>

#include "limn/fast/sites/reach.h"
#include "limn/fast/sites/vertex_kinds.h"

namespace limn::fast {

/// The fine points round a vertex, as sums over the old ones round it.
struct ZoneTable {
  Index sectors = 0;
  std::vector<SectorPoint> sources;  ///< old points, sector by sector
  std::vector<SectorPoint> targets;  ///< fine points, the centre first
  RowTable rows;                     ///< of the targets over the sources
};

struct StencilTables {
  Lattice lattice = Lattice::triangle;
  Reach reach;
  std::array<Stencil, kClasses> interior;  ///< by class_of
  Index halo = 0;  ///< rows beyond a patch's sides that interior stencils take from
  /// Of fine points (X, Y) along a boundary side that runs along the first axis, the mesh lying
  /// above: number 2·Y + X mod 2, for Y ≤ reach.strip_depth. Empty without a boundary.
  std::vector<Stencil> strips;
  std::map<Index, ZoneTable> stars;  ///< by valence of an interior vertex
  std::map<Index, ZoneTable> fans;   ///< by number of faces at a boundary vertex
};

inline constexpr Index kLargestTable = 1000;  ///< valence of a table

/// The tables that refining a mesh (of triangles or of quads, as the split has it) with vertices of
/// these kinds needs. Fails where a rule is missing, or looks too far (find_reach), or a vertex has
/// too few faces in a ring (fewest_sectors) or more than kLargestTable: then the plain engine is
/// the one to ask, which may say more. Cost: some 0.1 ms a valence.
[[nodiscard]] Result<StencilTables> read_stencils(const Scheme& scheme,
                                                  const std::vector<VertexKind>& kinds);

}  // namespace limn::fast
