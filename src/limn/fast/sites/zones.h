#pragma once
/// Rows for the points round control vertices, from the tables of their valences, and for those
/// along boundaries, with the numbers that a layout gives them.

#include <functional>

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

/// The table of a group's vertices; an isolated vertex stays.
[[nodiscard]] const ZoneTable& table_of(const StencilTables& tables, const VertexKind& kind);

/// A table's rows round each vertex of a group, from points of one layout to points of another.
[[nodiscard]] RowPlan zone_rows(const ZoneTable& table, const ZoneGroup& group,
                                const GridLayout& old_points, const GridLayout& new_points,
                                bool overlap);

/// The zone of the points round a boundary vertex of so many faces.
using ZoneOfFaces = std::function<Zone(Index faces)>;

/// The rows' points but for those in zones; `sides` are the boundary half-edges.
void add_side_rows(const std::vector<SideRow>& rows, const std::vector<Index>& sides,
                   const ZoneOfFaces& zone_of, const GridLayout& old_points,
                   const GridLayout& new_points, std::vector<RowPlan>& plans);

}  // namespace limn::fast
