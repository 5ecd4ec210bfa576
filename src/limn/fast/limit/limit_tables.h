#pragma once
/// The limit surface at the vertices of a level of grids, as sums over that level: read on stars
/// and fans, and compared with one another to see how far irregular vertices and boundaries are
/// felt. Nothing here knows how far a rule looks.

#include "limn/fast/limit/limit_sums.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {

/// The vertices round one of a kind whose sums are not those of the lattice, or lie where patches
/// do not look.
struct LimitZone {
  Index radius = 0;  ///< rings that the tables' targets fill
  /// Each with as many rows for all its targets.
  std::vector<ZoneTable> tables;
};

struct LimitTables {
  LimitStencils interior;
  Index halo = 0;  ///< rows beyond a patch's sides that these take from
  /// Of vertices so many rows above a straight boundary side. Empty without a boundary.
  std::vector<LimitStencils> strips;
  std::map<Index, LimitZone> stars;  ///< by valence of an interior vertex; 0: isolated
  std::map<Index, LimitZone> fans;   ///< by number of faces at a boundary vertex
  /// The fewest edges that a control edge must have been cut into, so that zones lie apart and
  /// nothing is taken from beyond the next control vertices.
  Index smallest_grid = 1;
};

inline constexpr Index kLargestLimitZone = 200;  ///< valence of a zone wider than its vertex

/// Of a level after so many steps of a mesh that has these groups of vertices. Nothing where a
/// normal at a regular vertex is not that of two sums, or the sums take too many vertices. Fails as
/// `reader`. Cost: some milliseconds a valence; far less where only a vertex's own ring counts.
[[nodiscard]] Result<std::optional<LimitTables>> read_limit_tables(
    LimitReader& reader, Lattice lattice, int level, const std::vector<ZoneGroup>& groups);

}  // namespace limn::fast
