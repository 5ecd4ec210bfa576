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

/// 12 times the mean of the face's corners, or of the edge's ends, unwrapped near the first.
Offset twelve_times_mean(const std::vector<Index>& vertices) {
  const Offset first = place_of(vertices.front());
  Offset sum{0, 0};
  for (const Index v : vertices)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += nearest(place_of(v)[d] - first[d], kSide);
  const int share = 12 / static_cast<int>(vertices.size());
  return {12 * first[0] + share * sum[0], 12 * first[1] + share * sum[1]};
}

/// 12 times the places of the new vertices in control edges.
std::vector<Offset> birth_places(const Mesh& mesh, const Births& births) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>(births.from_vertices + births.from_edges));
  const auto corners = [&](Index f) {
    std::vector<Index> all;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      all.push_back(mesh.origin(h));
    return all;
  };
  for (Index v = 0; v < births.from_vertices; ++v) places.push_back(twelve_times_mean({v}));
  for (Index i = 0; i < births.from_edges; ++i) {
    const EdgeChild child = edge_child(mesh, births, i);
    const Index v = mesh.origin(child.halfedge), w = mesh.target(child.halfedge);
    if (!child.third)
      places.push_back(twelve_times_mean({v, w}));
    else
      places.push_back(child.at_target ? twelve_times_mean({w, w, v})
                                       : twelve_times_mean({v, v, w}));
  }
  for (Index f = 0; f < births.from_faces; ++f) places.push_back(twelve_times_mean(corners(f)));
  for (Index h = 0; h < births.from_corners; ++h) {
    std::vector<Index> all = corners(mesh.face(h));
    const Offset vertex = place_of(mesh.origin(h));
    const Offset mean = twelve_times_mean(all);
    Offset place{};
    for (std::size_t d = 0; d < 2; ++d) {
      const int way = nearest(mean[d] - 12 * vertex[d], 12 * kSide);
      place[d] = 12 * vertex[d] + (births.from_vertices > 0 ? 2 * way / 3 : way / 2);
    }
    places.push_back(place);
  }
  return places;
}

/// Twice the offset on the refined lattice, from 12 times that in control edges. The refined edges
/// of a dyadic split are half of those, of a ternary one a third; those of √2 go half the way along
/// the diagonals.
Offset doubled_offset(const Split& split, Offset twelfths) {
  if (split.name == "quad-sqrt2" || split.name == "midedge")
    return {(twelfths[0] + twelfths[1]) / 6, (twelfths[1] - twelfths[0]) / 6};
  const int edge = split.name.ends_with("ternary") ? 3 : 2;
  return {twelfths[0] * edge / 6, twelfths[1] * edge / 6};
}

}  // namespace

Result<Mask> refined_mask(const Scheme& scheme) {
  const Mesh mesh = mesh::torus(scheme.split->lattice, kSide, kSide);
  const SplitResult split = scheme.split->apply(mesh, 0);
  refine::RuleTables<number::Exact> tables(scheme);
  if (Status status = tables.prepare(mesh, split.births); !status) return status.error();
  const std::vector<refine::LinearForm<number::Exact>> forms = refine::refine_values(
      scheme, mesh, split.births, tables, refine::unit_forms<number::Exact>(mesh.vertex_count()));
  const std::vector<Offset> places = birth_places(mesh, split.births);
  Mask mask{scheme.split->lattice, scheme.split->dilation, {}};
  std::map<Offset, int> met;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    for (const auto& [vertex, weight] : forms[i].terms) {
      if (weight.is_zero()) continue;
      Offset offset{};
      for (std::size_t d = 0; d < 2; ++d)
        offset[d] = nearest(places[i][d] - 12 * place_of(vertex)[d], 12 * kSide);
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
