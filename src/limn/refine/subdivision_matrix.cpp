#include "limn/refine/subdivision_matrix.h"

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/refine_values.h"

namespace limn {
namespace {

constexpr int kMargin = 4;  // rings round the neighbourhood, so that no row meets the rim

struct Star {
  Mesh mesh;
  Index size;
};

Star make_star(const Split& split, int n, int rings) {
  if (split.births_corners) return {face_star(n, rings), face_star_size(n, rings)};
  return {star(split.lattice, n, rings), star_size(split.lattice, n, rings)};
}

/// The half-edge of the refined mesh that plays the part of half-edge 0 of the star.
Index refined_start(const Split& split, const Mesh& coarse, const SplitResult& fine) {
  if (split.births_corners) return 0;  // the face's first half-edge keeps its number
  const Index toward = split.births_edges
                           ? fine.births.from_vertices + coarse.edge(0)
                           : fine.births.from_vertices + fine.births.from_edges + coarse.face(0);
  Index h = fine.mesh.halfedge_of_vertex(0);
  while (fine.mesh.target(h) != toward) h = fine.mesh.rotate(h);
  return h;
}

/// Which vertex of `mesh`, explored from half-edge `start`, plays the part of each vertex of
/// `pattern`, explored from its half-edge 0.
std::vector<Index> matched_vertices(const Mesh& pattern, const Mesh& mesh, Index start) {
  std::vector<Index> partner(static_cast<std::size_t>(pattern.halfedge_count()), kNone);
  std::vector<Index> vertices(static_cast<std::size_t>(pattern.vertex_count()), kNone);
  std::vector<Index> stack{0};
  partner[0] = start;
  const auto meet = [&](Index h, Index g) {
    if (h == kNone || partner[h] != kNone) return;
    partner[h] = g;
    stack.push_back(h);
  };
  while (!stack.empty()) {
    const Index h = stack.back();
    stack.pop_back();
    vertices[pattern.origin(h)] = mesh.origin(partner[h]);
    meet(pattern.next(h), mesh.next(partner[h]));
    meet(pattern.twin(h), mesh.twin(partner[h]));
  }
  return vertices;
}

}  // namespace

template <class Number>
Result<SubdivisionMatrix<Number>> subdivision_matrix(const Scheme& scheme, int n, int rings) {
  const Split& split = *scheme.split;
  if (n < kSmallestValence)
    return Error{fmt::format("valence {} is below {}", n, kSmallestValence), {}, {}, 0, 0};
  if (rings < 1) return Error{"a neighbourhood needs at least one ring", {}, {}, 0, 0};
  const Star inner = make_star(split, n, rings);
  const Star outer = make_star(split, n, rings + kMargin);
  const SplitResult fine = split.apply(outer.mesh, 0);
  RuleTables<Number> tables(scheme, Boundary::left_out);
  if (Status status = tables.prepare(outer.mesh, fine.births); !status) return status.error();
  const std::vector<LinearForm<Number>> forms =
      refine_values(scheme, outer.mesh, fine.births, tables, unit_forms<Number>(outer.size));
  const std::vector<Index> rows =
      matched_vertices(inner.mesh, fine.mesh, refined_start(split, outer.mesh, fine));

  SubdivisionMatrix<Number> matrix;
  matrix.size = inner.size;
  matrix.center = split.births_corners ? 0 : 1;
  matrix.entries.assign(static_cast<std::size_t>(inner.size) * static_cast<std::size_t>(inner.size),
                        Number(0));
  for (Index i = 0; i < inner.size; ++i)
    for (const auto& [vertex, value] : forms[rows[i]].terms) {
      if (vertex < inner.size) {
        matrix.entries[static_cast<std::size_t>(i) * static_cast<std::size_t>(inner.size) +
                       static_cast<std::size_t>(vertex)] = value;
      } else if (Arithmetic<Number>::approx(value) != 0) {
        return Error{fmt::format("the {}-ring neighbourhood at valence {} is not invariant under "
                                 "scheme '{}'",
                                 rings, n, scheme.name),
                     "take more rings",
                     {},
                     0,
                     0};
      }
    }
  return matrix;
}

Result<int> invariant_rings(const Scheme& scheme, int n, int largest) {
  Error last;
  for (int rings = 1; rings <= largest; ++rings) {
    const Result<SubdivisionMatrix<double>> matrix = subdivision_matrix<double>(scheme, n, rings);
    if (matrix) return rings;
    last = matrix.error();
  }
  return last;
}

template Result<SubdivisionMatrix<double>> subdivision_matrix<double>(const Scheme&, int, int);
template Result<SubdivisionMatrix<Exact>> subdivision_matrix<Exact>(const Scheme&, int, int);

}  // namespace limn
