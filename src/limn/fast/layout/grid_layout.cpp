#include "limn/fast/layout/grid_layout.h"

#include <cassert>

namespace limn::fast {
namespace {

/// The half-edge before (after) one on the boundary.
Index side_before(const Mesh& mesh, Index h) {
  assert(mesh.twin(h) == kNone);
  for (Index next = mesh.rotate(h); next != kNone; next = mesh.rotate(h)) h = next;
  return mesh.prev(h);
}
Index side_after(const Mesh& mesh, Index h) {
  assert(mesh.twin(h) == kNone);
  h = mesh.next(h);
  while (mesh.twin(h) != kNone) h = mesh.next(mesh.twin(h));
  return h;
}

}  // namespace

GridLayout::GridLayout(const Mesh& control, Lattice lattice, Index n, Index unit, bool centres)
    : mesh_(&control),
      lattice_(lattice),
      n_(n),
      sides_(lattice == Lattice::triangle ? 3 : 4),
      unit_(unit),
      centres_(centres),
      face_size_(lattice == Lattice::triangle ? (n - 1) * (n - 2) / 2 : (n - 1) * (n - 1)),
      edges_at_(control.vertex_count()),
      faces_at_(edge_begin(control.edge_count())),
      centres_at_(faces_at_ + control.face_count() * face_size_) {
  assert(!centres || unit > 1);
}

GridLayout::Spot GridLayout::spot(Index k, Index x, Index y) const {
  if (unit_ == 1) return grid_spot(k, x, y);
  if (x % unit_ == 0 && y % unit_ == 0) return grid_spot(k, x / unit_, y / unit_);
  assert(centres_ && (x - y) % unit_ == 0);
  // of a triangle that points up, the centre lies at 1, of one that points down at 2 (of 3)
  const Index down = x % unit_ - 1;
  Index cell_x = x / unit_, cell_y = y / unit_;
  for (; k > 0; --k) {
    const Index turned = sides_ == 3 ? n() - 1 - cell_x - cell_y - down : n() - 1 - cell_y;
    cell_y = cell_x;
    cell_x = turned;
  }
  if (sides_ == 4) return {Spot::centre, 0, cell_y * n() + cell_x};
  const Index above = n() - cell_y;  // rows that are not before it
  return {Spot::centre, 0, n() * n() - above * above + 2 * cell_x + down};
}

GridLayout::Spot GridLayout::grid_spot(Index k, Index x, Index y) const {
  const Index last = n();
  if (sides_ == 3) {
    assert(x >= 0 && y >= 0 && x + y <= last);
    if (y == 0)
      return x == 0      ? Spot{Spot::corner, 0, 0}
             : x == last ? Spot{Spot::corner, 1, 0}
                         : Spot{Spot::edge, 0, x};
    if (x == 0) return y == last ? Spot{Spot::corner, 2, 0} : Spot{Spot::edge, 2, last - y};
    if (x + y == last) return {Spot::edge, 1, y};
  } else {
    assert(0 <= x && x <= last && 0 <= y && y <= last);
    if (y == 0)
      return x == 0      ? Spot{Spot::corner, 0, 0}
             : x == last ? Spot{Spot::corner, 1, 0}
                         : Spot{Spot::edge, 0, x};
    if (y == last)
      return x == 0      ? Spot{Spot::corner, 3, 0}
             : x == last ? Spot{Spot::corner, 2, 0}
                         : Spot{Spot::edge, 2, last - x};
    if (x == 0) return {Spot::edge, 3, last - y};
    if (x == last) return {Spot::edge, 1, y};
  }
  for (; k > 0; --k) {  // a corner back: the origin was at (n, 0)
    const Index old = x;
    x = last - y - (sides_ == 3 ? x : 0);
    y = old;
  }
  if (sides_ == 4) return {Spot::inner, 0, (y - 1) * (last - 1) + x - 1};
  return {Spot::inner, 0, (y - 1) * (last - 1) - (y - 1) * y / 2 + x - 1};
}

Index GridLayout::point_beyond(Index h, Index x, Index y) const {
  const Mesh& mesh = control();
  const Index last = side();
  // across a side, in the frame of its half-edge there, which runs the other way
  const auto across = [&](Index k, Index along, Index up) {
    const Index twin = mesh.twin(turned(h, k));
    return twin == kNone ? kNone : point(twin, last - along, up);
  };
  if (sides_ == 3) {
    if (y == 0 && x < 0) return point(side_before(mesh, h), last + x, 0);
    if (y == 0 && x > last) return point(side_after(mesh, h), x - last, 0);
    if (x == 0 && y > last) return point(side_before(mesh, mesh.prev(h)), 2 * last - y, 0);
    if (y < 0) return across(0, x, -y);
    if (x < 0) return across(2, last - x - y, -x);
    if (x + y > last) return across(1, y, x + y - last);
  } else {
    if (y < 0) return across(0, x, -y);
    if (x < 0) return across(3, last - y, -x);
    if (x > last) return across(1, y, x - last);
    if (y > last) return across(2, last - x, y - last);
  }
  return point(h, x, y);
}

Offset in_patch(Lattice lattice, Index n, Index side, Offset point) {
  for (; side > 0; --side)
    point = {n - point.b - (lattice == Lattice::triangle ? point.a : 0), point.a};
  return point;
}

std::vector<Offset> inner_places(Lattice lattice, Index n) {
  std::vector<Offset> places;
  for (Index y = 1; y < n; ++y)
    for (Index x = 1; x < (lattice == Lattice::triangle ? n - y : n); ++x) places.push_back({x, y});
  return places;
}

std::vector<Offset> centre_places(Lattice lattice, Index n, Index unit) {
  const bool triangles = lattice == Lattice::triangle;
  std::vector<Offset> places;
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < (triangles ? n - y : n); ++x) {
      places.push_back({unit * x + 1, unit * y + 1});
      if (triangles && x + y + 1 < n) places.push_back({unit * x + 2, unit * y + 2});
    }
  return places;
}

}  // namespace limn::fast
