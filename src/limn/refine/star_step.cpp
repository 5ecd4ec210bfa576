#include "limn/refine/star_step.h"

#include <cassert>

#include "limn/mesh/pattern.h"

namespace limn::refine {
namespace {

/// Whether corners of quad rings count to the ring beyond.
bool crops_corners(const Split& split) {
  return split.lattice == Lattice::quad && !split.is_dual() && split.dilation.turns();
}

constexpr int kMargin = 4;  // rings round the neighbourhood, so that no row meets the rim

/// The half-edge of the refined mesh that plays the part of half-edge 0 of the star.
Index refined_start(const Split& split, const Mesh& coarse, const SplitResult& fine) {
  if (split.is_dual()) return 0;  // the face's first half-edge keeps its number
  const Index toward = split.births.edges
                           ? child_along(coarse, fine.births, 0)
                           : fine.births.from_vertices + fine.births.from_edges + coarse.face(0);
  Index h = fine.mesh.halfedge_of_vertex(0);
  while (fine.mesh.target(h) != toward) h = fine.mesh.rotate(h);
  return h;
}

}  // namespace

Mesh split_star(const Split& split, Index n, Index rings) {
  if (crops_corners(split)) return mesh::cropped_star(n, rings);
  return split.is_dual() ? mesh::face_star(n, rings) : mesh::star(split.lattice, n, rings);
}

int least_star_rings(const Split& split) { return crops_corners(split) ? 2 : 1; }

Index split_star_size(const Split& split, Index n, Index rings) {
  if (crops_corners(split)) return mesh::cropped_star_size(n, rings);
  return split.is_dual() ? mesh::face_star_size(n, rings)
                         : mesh::star_size(split.lattice, n, rings);
}

StarStep star_step(const Split& split, int n, int rings) {
  const Mesh inner = split_star(split, n, rings);
  StarStep step;
  step.coarse = split_star(split, n, rings + kMargin);
  step.fine = split.apply(step.coarse, 0);
  step.size = inner.vertex_count();
  const bool found = mesh::Pattern(inner, 0).match(
      step.fine.mesh, refined_start(split, step.coarse, step.fine), step.images);
  assert(found);
  (void)found;
  return step;
}

SectorStep sector_step(const Split& split, const mesh::Sectors& sectors, int rings) {
  const Mesh inner = mesh::sector_star(sectors, rings);
  SectorStep step;
  step.coarse = mesh::sector_star(sectors, rings + kMargin);
  step.size = inner.vertex_count();
  step.fine.push_back(split.apply(step.coarse, 0));
  // the boundary of a trisecting split moves in every second step only
  if (sectors.open && split.boundary_rests())
    step.fine.push_back(split.apply(step.fine.front().mesh, 1));
  const Mesh& last = step.fine.back().mesh;
  const Index start = sectors.open ? last.halfedge_of_vertex(0)
                                   : refined_start(split, step.coarse, step.fine.back());
  const bool found = mesh::Pattern(inner, 0).match(last, start, step.images);
  assert(found);
  (void)found;
  return step;
}

}  // namespace limn::refine
