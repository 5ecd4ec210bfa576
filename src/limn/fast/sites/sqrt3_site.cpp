#include "limn/fast/sites/sqrt3_site.h"

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
    const SectorPoint point = sector_point({Lattice::triangle, sectors_, open_}, v);
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
  if (x % 3 == 0) return vertex_at({Lattice::triangle, sectors_, open_}, {sector, x / 3, y / 3});
  const Index face =
      x % 3 == 1 ? triangle_up(sector, x / 3, y / 3) : triangle_up(sector, x / 3 + 1, y / 3) + 1;
  return control_.vertex_count() + face;
}

Sqrt3Site::Third Sqrt3Site::third(const SectorPoint& place) const {
  const auto& [sector, x, y] = place;
  const Index i = x % 3, j = y % 3;  // on a side of the triangle that points up here
  const Index side = j == 0 ? 0 : i == 0 ? 2 : 1;
  const bool near_target = side == 0 ? i == 2 : side == 1 ? j == 2 : j == 1;
  return {3 * triangle_up(sector, x / 3, y / 3) + side, near_target};
}

Sqrt3Site::Origin Sqrt3Site::origin(Sqrt3Step step, const SectorPoint& place) const {
  assert(is_new(step, place.x, place.y));
  if (is_old(step, place.x, place.y))
    return {Birth::vertex, mesh(step).halfedge_of_vertex(old_vertex(place)), false};
  if (step == Sqrt3Step::centroids)
    return {Birth::face, 3 * (old_vertex(place) - control_.vertex_count()), false};
  const auto [h, near_target] = third(place);
  const Index twin = control_.twin(h);
  // face h of level 1 lies at the origin of h (split_sqrt3.cpp)
  if (twin == kNone) return {Birth::edge_end, 3 * h, near_target};
  return {Birth::face, 3 * (near_target ? twin : h), false};
}

Index Sqrt3Site::vertex(const SectorPoint& place) const {
  if ((place.x - place.y) % 3 == 0) return old_vertex(place);
  const auto [h, near_target] = third(place);
  return third_along(control_, second_, h, near_target);
}

Index third_along(const Mesh& control, const Births& second, Index h, bool near_target) {
  const auto position = [](const std::vector<Index>& list, auto found) {
    return static_cast<Index>(std::distance(list.begin(), found));
  };
  if (control.twin(h) == kNone) {  // half-edge 3h of level 1; its edge keeps its number
    const std::vector<Index>& ends = second.edge_ends;
    const auto found =
        std::lower_bound(ends.begin(), ends.end(), control.edge(h),
                         [&](Index end, Index e) { return control.edge(end / 6) < e; });
    assert(found != ends.end() && *found == 6 * h);
    return second.from_vertices + position(ends, found) + (near_target ? 1 : 0);
  }
  const Index face = near_target ? control.twin(h) : h;
  const Index first = second.from_vertices + second.from_edges;
  if (second.faces.empty()) return first + face;
  const auto found = std::lower_bound(second.faces.begin(), second.faces.end(), face);
  assert(found != second.faces.end() && *found == face);
  return first + position(second.faces, found);
}

}  // namespace limn::fast
