#pragma once
/// All stencils of a scheme whose levels are grids, read by refining linear forms on sites with the
/// plain engine (refine/refine_values.h): nothing here knows a rule.

#include <map>
#include <vector>

#include "limn/fast/sites/reach.h"
#include "limn/refine/refine_values.h"

namespace limn::fast {

/// Forms of new points over site.mesh(step).
[[nodiscard]] Result<std::vector<refine::LinearForm<double>>> read_new_points(
    const Scheme& scheme, refine::RuleTables<double>& rules, const Site& site, int step,
    const std::vector<SectorPoint>& points);

/// New points round a vertex, as sums over the old ones round it.
struct ZoneTable {
  Index sectors = 0;
  std::vector<SectorPoint> sources;  ///< old points, sector by sector
  std::vector<SectorPoint> targets;  ///< new points, the centre first
  RowTable rows;                     ///< of the targets over the sources
};

/// Of all places of a kind.
struct ZoneTables {
  Zone zone;                      ///< the points that the tables make
  std::vector<ZoneTable> tables;  ///< one, or one for the centre and one for the rest
};

/// Forms over the old vertices of a site's step, as rows of the targets.
[[nodiscard]] ZoneTable zone_table(std::span<const refine::LinearForm<double>> forms,
                                   const Site& site, int step, std::vector<SectorPoint> targets);

/// A row of points along a side of the mesh that runs along the first axis, the mesh lying above:
/// those (x, y) with x ≡ phase (mod period). One sum for each, or several.
struct SideRow {
  Index y = 0, phase = 0, period = 1;
  RowTable table;
  std::vector<Offset> sources;  ///< from the point
};

/// Forms of a point of a site on the plane, or on half of it, as that of a row.
[[nodiscard]] SideRow side_row(std::span<const refine::LinearForm<double>> forms, const Site& site,
                               int step, const SectorPoint& point, Index period);

/// Of one step, or of the limit surface at a level (limit_tables.h).
struct StencilTables {
  Reach reach;
  /// By class (lattice_step.h), or the limit's three; local, from the anchor.
  std::vector<Stencil> interior;
  std::vector<SideRow> strips;        ///< along a boundary
  std::map<Index, ZoneTables> stars;  ///< by faces at an interior vertex; 0 at an isolated one
  std::map<Index, ZoneTables> fans;   ///< by faces at a boundary vertex
};

inline constexpr Index kLargestTable = 1000;  ///< valence of a table

/// How many rings of control edges a site needs, so that on all zones, and on points so many steps
/// farther out, rules see as far as they look.
[[nodiscard]] Index rings_of_site(const GridCycle& cycle, std::span<const StencilTables> tables,
                                  Index more);

/// The tables of each step of the cycle that refining a mesh with vertices and faces of these kinds
/// needs. Fails where a rule is missing, or looks too far (find_reach), or a vertex has too few
/// faces in a ring (fewest_sectors) or more than kLargestTable: then the plain engine is the one to
/// ask, which may say more. Cost: some 0.1 ms a valence.
[[nodiscard]] Result<std::vector<StencilTables>> read_stencils(const Scheme& scheme,
                                                               const GridCycle& cycle,
                                                               const std::vector<StarShape>& kinds,
                                                               const BoundarySides& sides);

}  // namespace limn::fast
