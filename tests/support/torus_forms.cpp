#include "support/torus_forms.h"

#include <cstdlib>
#include <vector>

#include "limn/mesh/lattice.h"
#include "limn/number/exact.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"

namespace limn::test {
namespace {

constexpr int kSide = 7;  // control edges round the torus

using Offset = std::array<int, 2>;

Offset place_of(Index v) { return {v % kSide, v / kSide}; }

/// The representative of `step` mod `period` in (-period/2, period/2).
int nearest(int step, int period) {
  const int rest = ((step % period) + period) % period;
  return rest <= period / 2 ? rest : rest - period;
}

/// Four times the mean of the face's corners, or of the edge's ends, unwrapped near the first.
Offset four_times_mean(const std::vector<Index>& vertices) {
  const Offset first = place_of(vertices.front());
  Offset sum{0, 0};
  for (const Index v : vertices)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += nearest(place_of(v)[d] - first[d], kSide);
  const int share = 4 / static_cast<int>(vertices.size());
  return {4 * first[0] + share * sum[0], 4 * first[1] + share * sum[1]};
}

/// Four times the places of the new vertices in control edges (so: twice the refined place).
std::vector<Offset> birth_places(const Mesh& mesh, const Births& births) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>(births.from_vertices + births.from_edges));
  const auto corners = [&](Index f) {
    std::vector<Index> all;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      all.push_back(mesh.origin(h));
    return all;
  };
  for (Index v = 0; v < births.from_vertices; ++v) places.push_back(four_times_mean({v}));
  for (Index e = 0; e < births.from_edges; ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    places.push_back(four_times_mean({mesh.origin(h), mesh.target(h)}));
  }
  for (Index f = 0; f < births.from_faces; ++f) places.push_back(four_times_mean(corners(f)));
  for (Index h = 0; h < births.from_corners; ++h) {
    std::vector<Index> all = corners(mesh.face(h));
    const Offset vertex = place_of(mesh.origin(h));
    const Offset mean = four_times_mean(all);
    Offset place{};
    for (std::size_t d = 0; d < 2; ++d)  // half way from the vertex to the mean
      place[d] = 4 * vertex[d] + nearest(mean[d] - 4 * vertex[d], 4 * kSide) / 2;
    places.push_back(place);
  }
  return places;
}

/// Twice the offset on the refined lattice, from four times that in control edges. The refined
/// edges of a dyadic split are half of those; those of √2 go half the way along the diagonals.
Offset doubled_offset(const Split& split, Offset quarters) {
  if (split.name != "quad-sqrt2") return quarters;
  return {(quarters[0] + quarters[1]) / 2, (quarters[1] - quarters[0]) / 2};
}

}  // namespace

Result<Mask> refined_mask(const Scheme& scheme) {
  const Mesh mesh = torus(scheme.split->lattice, kSide, kSide);
  const SplitResult split = scheme.split->apply(mesh, 0);
  RuleTables<Exact> tables(scheme);
  if (Status status = tables.prepare(mesh, split.births); !status) return status.error();
  const std::vector<LinearForm<Exact>> forms =
      refine_values(scheme, mesh, split.births, tables, unit_forms<Exact>(mesh.vertex_count()));
  const std::vector<Offset> places = birth_places(mesh, split.births);
  Mask mask{scheme.split->lattice, scheme.split->dilation, {}};
  std::map<Offset, int> met;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    for (const auto& [vertex, weight] : forms[i].terms) {
      if (weight.is_zero()) continue;
      Offset offset{};
      for (std::size_t d = 0; d < 2; ++d)
        offset[d] = nearest(places[i][d] - 4 * place_of(vertex)[d], 4 * kSide);
      offset = doubled_offset(*scheme.split, offset);
      if (!weight.is_rational()) return Error{"an irrational coefficient"};
      const auto [entry, is_new] = mask.coefficients.emplace(offset, weight.rational());
      if (!is_new && entry->second != weight.rational())
        return Error{"the mask is not the same everywhere"};
      ++met[offset];
    }
  }
  for (const auto& [offset, count] : met)
    if (count != kSide * kSide) return Error{"the mask is not the same everywhere"};
  return mask;
}

}  // namespace limn::test
