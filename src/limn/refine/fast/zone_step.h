#pragma once
/// The fine points at control vertices and round them, from the tables of their valences, and those
/// along boundaries.

#include "limn/refine/fast/stencil_tables.h"
#include "limn/refine/fast/triangle_layout.h"

namespace limn::fast {

/// Control vertices of one table.
struct ZoneGroup {
  const ZoneTable* table = nullptr;
  std::vector<Index> vertices;
};

/// All vertices of the control mesh; the tables must outlive the groups. An isolated vertex stays.
[[nodiscard]] std::vector<ZoneGroup> group_vertices(const StencilTables& tables,
                                                    const Mesh& control);

/// The half-edges out of a group's vertices, counterclockwise, as many for each as the table has
/// sectors.
[[nodiscard]] std::vector<Index> sectors_of(const ZoneGroup& group, const Mesh& control);

/// The vertices that a group's table names, in the numbers of a level and the next: for each
/// vertex, the table's sources (targets) in order, 4 bytes each.
struct ZoneNumbers {
  std::vector<Index> sources, targets;
};
[[nodiscard]] ZoneNumbers number_zones(const ZoneGroup& group, const std::vector<Index>& sectors,
                                       const TriangleLayout& coarse, const TriangleLayout& fine);

/// Overwrites the points of the zones in `out`. Arrays as for refine_patches (patch_step.h), which
/// goes before; numbers[i] belongs to group i. `overlap`: zones may share points; then they are
/// done one after the other.
template <class Real>
void refine_zones(const std::vector<ZoneGroup>& groups, const std::vector<ZoneNumbers>& numbers,
                  bool overlap, const Real* in, Real* out);

/// Overwrites the points along the boundary sides but for those in zones, which come after.
/// `sides` are the boundary half-edges.
template <class Real>
void refine_strips(const StencilTables& tables, const std::vector<Index>& sides,
                   const TriangleLayout& coarse, const TriangleLayout& fine, const Real* in,
                   Real* out);

extern template void refine_zones<float>(const std::vector<ZoneGroup>&,
                                         const std::vector<ZoneNumbers>&, bool, const float*,
                                         float*);
extern template void refine_zones<double>(const std::vector<ZoneGroup>&,
                                          const std::vector<ZoneNumbers>&, bool, const double*,
                                          double*);
extern template void refine_strips<float>(const StencilTables&, const std::vector<Index>&,
                                          const TriangleLayout&, const TriangleLayout&,
                                          const float*, float*);
extern template void refine_strips<double>(const StencilTables&, const std::vector<Index>&,
                                           const TriangleLayout&, const TriangleLayout&,
                                           const double*, double*);

}  // namespace limn::fast
