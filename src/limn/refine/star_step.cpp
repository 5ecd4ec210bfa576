#include "limn/refine/star_step.h"

#include "limn/mesh/lattice.h"

namespace limn {
namespace {

constexpr int kMargin = 4;  // rings round the neighbourhood, so that no row meets the rim

Mesh make_star(const Split& split, int n, int rings) {
  return split.births_corners ? face_star(n, rings) : star(split.lattice, n, rings);
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

StarStep star_step(const Split& split, int n, int rings) {
  const Mesh inner = make_star(split, n, rings);
  StarStep step;
  step.coarse = make_star(split, n, rings + kMargin);
  step.fine = split.apply(step.coarse, 0);
  step.size = inner.vertex_count();
  step.images =
      matched_vertices(inner, step.fine.mesh, refined_start(split, step.coarse, step.fine));
  return step;
}

}  // namespace limn
