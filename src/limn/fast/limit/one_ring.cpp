#include "limn/fast/limit/one_ring.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "limn/fast/limit/limit_forms.h"
#include "limn/fast/limit/limit_sums.h"
#include "limn/fast/sites/stencil_tables.h"

namespace limn::fast {
namespace {

/// The faces round a vertex: how many corners each has, counterclockwise; at the boundary (first)
/// from the first one.
using Degrees = std::pair<bool, std::vector<Index>>;

/// The faces by themselves: the vertex, then the others counterclockwise from the first edge on.
Mesh mesh_of(const Degrees& ring) {
  Index outer = ring.first ? 1 : 0, at = 0;
  for (const Index degree : ring.second) outer += degree - 2;
  Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(outer) + 1);
  for (const Index degree : ring.second) {
    polygons.corners.push_back(0);
    for (Index i = 0; i + 1 < degree; ++i) polygons.corners.push_back(1 + (at + i) % outer);
    at += degree - 2;
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  Result<Mesh> mesh = Mesh::build(polygons);
  assert(mesh.ok());
  return *std::move(mesh);
}

/// The half-edges out of a vertex, turned so that its faces' degrees are the least of their turns.
std::vector<Index> fan_of(const Mesh& mesh, Index v) {
  std::vector<Index> fan;
  const Index first = mesh.halfedge_of_vertex(v);
  for (Index h = first; h != kNone && (fan.empty() || h != first); h = mesh.rotate(h))
    fan.push_back(h);
  if (mesh.is_boundary_vertex(v)) return fan;
  const auto degree = [&](Index h) { return mesh.degree(mesh.face(h)); };
  std::vector<Index> least = fan;
  for (std::size_t i = 1; i < least.size(); ++i) {
    std::rotate(fan.begin(), fan.begin() + 1, fan.end());
    if (std::lexicographical_compare(fan.begin(), fan.end(), least.begin(), least.end(),
                                     [&](Index g, Index h) { return degree(g) < degree(h); }))
      least = fan;
  }
  return least;
}

/// Vertices that are alike, and what is round each, in the order of mesh_of.
struct Group {
  std::vector<Index> vertices, rings;
};

void add(const Mesh& mesh, Index v, std::map<Degrees, Group>& groups) {
  const std::vector<Index> fan = fan_of(mesh, v);
  const bool open = mesh.is_boundary_vertex(v);
  Degrees ring{open, {}};
  for (const Index h : fan) ring.second.push_back(mesh.degree(mesh.face(h)));
  Group& group = groups[ring];
  group.vertices.push_back(v);
  group.rings.push_back(v);
  for (const Index h : fan)
    for (Index g = mesh.next(h); g != mesh.prev(h); g = mesh.next(g))
      group.rings.push_back(mesh.origin(g));
  if (open) group.rings.push_back(mesh.origin(mesh.prev(fan.back())));
}

}  // namespace

Result<std::optional<StepPlan>> plan_one_rings(const Mesh& mesh, std::span<const Index> numbers,
                                               int level, LimitReader& reader) {
  using Found = std::optional<StepPlan>;
  const Result<Index> seen = reader.regular_rings(false);
  if (!seen) return seen.error();
  if (*seen > 1) return Found();
  std::map<Degrees, Group> groups;
  std::vector<Index> isolated;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index valence = mesh.valence(v);
    if (valence > kLargestTable || (valence == 2 && !mesh.is_boundary_vertex(v))) return Found();
    if (mesh.is_isolated(v))
      isolated.push_back(v);
    else
      add(mesh, v, groups);
  }
  StepPlan plan;
  const auto add_rows = [&](RowTable table, std::vector<Index> sources,
                            std::vector<Index> targets) {
    for (std::vector<Index>* list : {&sources, &targets})
      for (Index& v : *list) v = numbers.empty() ? v : numbers[static_cast<std::size_t>(v)];
    plan.rows.push_back({std::move(table), base::HugeArray<Index>(sources),
                         base::HugeArray<Index>(targets), false});
  };
  for (auto& [degrees, group] : groups) {
    const Mesh ring = mesh_of(degrees);
    const auto forms = reader.read(ring, level, !degrees.first, {0});
    if (!forms) return forms.error();
    if (!forms->front()) return Found();
    RowTable table;
    table.sources = ring.vertex_count();
    for (const refine::LinearForm<double>& form : *forms->front()) {
      for (const auto& [vertex, weight] : form.terms)
        if (weight != 0) table.terms.push_back({vertex, weight});
      table.row_begin.push_back(static_cast<int>(table.terms.size()));
    }
    add_rows(std::move(table), std::move(group.rings), std::move(group.vertices));
  }
  if (!isolated.empty()) add_rows(isolated_limit_rows(), isolated, isolated);
  return Found(std::move(plan));
}

}  // namespace limn::fast
