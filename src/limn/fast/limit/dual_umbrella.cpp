#include "limn/fast/limit/dual_umbrella.h"

#include <cassert>

#include "limn/fast/limit/limit_sums.h"

namespace limn::fast {
namespace {

Mesh mesh_of(const Umbrella& umbrella) {
  const Index outer = umbrella.vertex_count() - 1;
  Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(outer) + 1);
  Index at = 0;
  for (const Index degree : umbrella.degrees) {
    polygons.corners.push_back(0);
    for (Index i = 0; i + 1 < degree; ++i) polygons.corners.push_back(1 + (at + i) % outer);
    at += degree - 2;
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  Result<Mesh> mesh = Mesh::build(polygons);
  assert(mesh.ok());
  return *std::move(mesh);
}

}  // namespace

Index Umbrella::vertex_count() const {
  Index count = open ? 2 : 1;
  for (const Index degree : degrees) count += degree - 2;
  return count;
}

Result<std::optional<RowTable>> read_umbrella(LimitReader& reader, int level,
                                              const Umbrella& umbrella) {
  using Found = std::optional<RowTable>;
  const auto forms = reader.read(mesh_of(umbrella), level, !umbrella.open, {0});
  if (!forms) return forms.error();
  if (!forms->front()) return Found();
  RowTable table;
  table.sources = umbrella.vertex_count();
  for (const LinearForm<double>& form : *forms->front()) {
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) table.terms.push_back({vertex, weight});
    table.row_begin.push_back(static_cast<int>(table.terms.size()));
  }
  return Found(std::move(table));
}

void add_isolated_limits(const std::vector<Index>& vertices, std::vector<RowPlan>& rows) {
  if (vertices.empty()) return;
  rows.push_back(
      {isolated_limit_rows(), HugeArray<Index>(vertices), HugeArray<Index>(vertices), false});
}

}  // namespace limn::fast
