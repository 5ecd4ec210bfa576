#include "limn/fast/families/dual_zone.h"

#include <algorithm>

#include "limn/base/parallel.h"

namespace limn::fast {

void number_zone(const DualLayout& layout, const std::vector<Index>& sectors, bool vertex,
                 const std::vector<SectorPoint>& points, Index* out) {
  const Index last = layout.n() - 1;
  for (const SectorPoint& p : points) {
    const Index h = sectors[static_cast<std::size_t>(p.sector)];
    *out++ = vertex ? layout.point(h, last - p.x, last - p.y) : layout.point(h, p.x, p.y);
  }
}

std::vector<Index> vertices_of_sides(const DualCorners& corners, Index sides) {
  std::vector<Index> vertices;
  for (Index i = 0; i < std::ssize(corners.inner_vertices()); ++i)
    if (corners.vertex_begin(i + 1) - corners.vertex_begin(i) == sides)
      vertices.push_back(corners.control().halfedge_of_vertex(
          corners.inner_vertices()[static_cast<std::size_t>(i)]));
  return vertices;
}

RowPlan plan_dual_zones(const DualZone& zone, Index sides, const std::vector<Index>& faces,
                        const std::vector<Index>& vertices, const DualLayout& coarse,
                        const DualLayout& fine, bool overlap) {
  constexpr Index kNumberGrain = 16384;  // numbers that one call of a parallel loop makes
  const Mesh& mesh = coarse.corners().control();
  RowPlan plan{zone.table, {}, {}, overlap};
  const std::size_t centres = faces.size() + vertices.size();
  plan.sources = HugeArray<Index>(centres * zone.sources.size());
  plan.targets = HugeArray<Index>(centres * zone.targets.size());
  parallel_for(
      std::size_t{0}, centres,
      [&](std::size_t first, std::size_t last) {
        std::vector<Index> sectors(static_cast<std::size_t>(sides));
        for (std::size_t i = first; i < last; ++i) {
          const bool face = i < faces.size();
          Index h = face ? faces[i] : vertices[i - faces.size()];
          for (Index& sector : sectors) {
            sector = h;
            h = face ? mesh.next(h) : mesh.rotate(h);
          }
          number_zone(coarse, sectors, !face, zone.sources,
                      plan.sources.data() + i * zone.sources.size());
          number_zone(fine, sectors, !face, zone.targets,
                      plan.targets.data() + i * zone.targets.size());
        }
      },
      std::max<std::ptrdiff_t>(1, kNumberGrain / std::ssize(zone.targets)));
  return plan;
}

}  // namespace limn::fast
