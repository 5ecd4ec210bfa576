#pragma once
/// Rows for the points round control vertices, from the tables of their valences, and for those
/// along boundaries, with the numbers that a layout gives them.

#include "limn/fast/layout/grid_patches.h"
#include "limn/fast/sites/stencil_tables.h"

namespace limn::fast {

/// Control vertices of one kind.
struct ZoneGroup {
  VertexKind kind;
  /// The half-edges out of its vertices, counterclockwise, as many for each as it has faces.
  std::vector<Index> sectors;
  std::vector<EdgeCode> codes;  ///< of these half-edges
  std::vector<Index> ends;      ///< their targets
};

/// All vertices of the control mesh.
[[nodiscard]] std::vector<ZoneGroup> group_vertices(std::vector<VertexKind> kinds,
                                                    const Mesh& control);

/// A table's rows round each vertex of a group, from points of one layout to points of another.
[[nodiscard]] RowPlan zone_rows(const ZoneTable& table, const ZoneGroup& group,
                                const GridLayout& old_points, const GridLayout& new_points,
                                bool overlap);

/// The rows along boundary sides, but for the points in zones; `sides` are the boundary half-edges.
void add_side_rows(const StencilTables& tables, const std::vector<Index>& sides,
                   const GridLayout& old_points, const GridLayout& new_points,
                   std::vector<RowPlan>& plans);

}  // namespace limn::fast
