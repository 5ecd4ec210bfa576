#pragma once
/// Rows for the points round control vertices, from the tables of their valences, and for those
/// along boundaries, with the numbers that a layout gives them.

#include "limn/fast/layout/grid_patches.h"
#include "limn/fast/sites/stencil_tables.h"

namespace limn::fast {

/// Control vertices that have as many faces in a ring, or in a fan (on the boundary). Isolated
/// vertices make a group of their own, of no face.
struct ZoneGroup {
  StarShape kind;
  std::vector<Index> vertices;  ///< ascending
  /// The half-edges out of its vertices, counterclockwise, as many for each as it has faces.
  std::vector<Index> sectors;
  std::vector<EdgeCode> codes;  ///< of these half-edges
  std::vector<Index> ends;      ///< their targets
};

/// All vertices of the control mesh, rings before fans, few faces before many. Cost O(half-edges).
[[nodiscard]] std::vector<ZoneGroup> group_vertices(const Mesh& control, Lattice lattice);

/// A table's rows round each vertex of a group, from points of one layout to points of another.
[[nodiscard]] RowPlan zone_rows(const ZoneTable& table, const ZoneGroup& group,
                                const GridLayout& old_points, const GridLayout& new_points,
                                bool overlap);

/// The rows along boundary sides, but for the points in zones; `sides` are the boundary half-edges.
void add_side_rows(const StencilTables& tables, const std::vector<Index>& sides,
                   const GridLayout& old_points, const GridLayout& new_points,
                   std::vector<RowPlan>& plans);

}  // namespace limn::fast
