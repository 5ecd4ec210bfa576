#include "limn/refine/fast/sqrt3_site.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "limn/mesh/lattice.h"

namespace limn::fast {

Sqrt3Site::Sqrt3Site(const Split& split, Index sectors, bool open, Index rings)
    : sectors_(sectors),
      rings_(rings),
      open_(open),
      control_(open ? fan(Lattice::triangle, sectors, rings)
                    : star(Lattice::triangle, sectors, rings)),
      first_(split.apply(control_, 0)),
      second_(split.apply(first_.mesh, 1).births) {
  place_all();
}

void Sqrt3Site::place_all() {
  places_.resize(static_cast<std::size_t>(first_.mesh.vertex_count()));
  for (Index v = 0; v < control_.vertex_count(); ++v) {
    const SectorPoint point = sector_point(sectors_, open_, v);
    places_[v] = {point.sector, 3 * point.x, 3 * point.y};
  }
  SectorPoint* centroid = &places_[control_.vertex_count()];
  for (Index r = 0; r < rings_; ++r)  // in the order of the star's faces
    for (Index s = 0; s < sectors_; ++s)
      for (Index y = 0; y <= r; ++y) {
        *centroid++ = {s, 3 * (r - y) + 1, 3 * y + 1};
        if (y < r) *centroid++ = {s, 3 * (r - y) - 1, 3 * y + 2};
      }
}

Index Sqrt3Site::triangle_up(Index sector, Index x, Index y) const {
  const Index r = x + y;
  return sectors_ * r * r + sector * (2 * r + 1) + 2 * y;
}

Index Sqrt3Site::old_vertex(const SectorPoint& place) const {
  const auto& [sector, x, y] = place;
  if (x % 3 == 0) return vertex_at(sectors_, open_, {sector, x / 3, y / 3});
  const Index face = x % 3 == 1 ? triangle_up(sector, x / 3, y / 3)
                                : triangle_up(sector, x / 3 + 1, y / 3) + 1;
  return control_.vertex_count() + face;
}

/// Thirds of control edges are born from the faces of the level between that have the edge's half
/// for their first side (split_sqrt3.cpp numbers them by half-edges), or on the boundary.
Sqrt3Site::Origin Sqrt3Site::third(const SectorPoint& place) const {
  const auto& [sector, x, y] = place;
  const Index i = x % 3, j = y % 3;  // on a side of the triangle that points up here
  const Index side = j == 0 ? 0 : i == 0 ? 2 : 1;
  const Index h = 3 * triangle_up(sector, x / 3, y / 3) + side;
  const bool at_target = side == 0 ? i == 2 : side == 1 ? j == 2 : j == 1;
  if (!at_target && control_.twin(h) != kNone) return {Birth::face, 3 * h, false};
  if (control_.twin(h) != kNone) return {Birth::face, 3 * control_.twin(h), false};
  return {Birth::edge_end, 3 * h, at_target};
}

Sqrt3Site::Origin Sqrt3Site::origin(Sqrt3Step step, const SectorPoint& place) const {
  assert(is_new(step, place.x, place.y));
  if (is_old(step, place.x, place.y))
    return {Birth::vertex, mesh(step).halfedge_of_vertex(old_vertex(place)), false};
  if (step == Sqrt3Step::thirds) return third(place);
  return {Birth::face, 3 * (old_vertex(place) - control_.vertex_count()), false};
}

Index Sqrt3Site::vertex(Sqrt3Step step, const SectorPoint& place) const {
  if ((place.x - place.y) % 3 == 0) return old_vertex(place);
  const Origin from = third(place);
  if (from.kind == Birth::edge_end) {
    const auto found = std::find(second_.edge_ends.begin(), second_.edge_ends.end(),
                                 2 * from.halfedge + (from.at_target ? 1 : 0));
    assert(found != second_.edge_ends.end());
    return second_.from_vertices +
           static_cast<Index>(std::distance(second_.edge_ends.begin(), found));
  }
  assert(step == Sqrt3Step::thirds);
  (void)step;
  const auto found =
      std::lower_bound(second_.faces.begin(), second_.faces.end(), from.halfedge / 3);
  assert(found != second_.faces.end() && *found == from.halfedge / 3);
  return second_.from_vertices + second_.from_edges +
         static_cast<Index>(std::distance(second_.faces.begin(), found));
}

}  // namespace limn::fast
