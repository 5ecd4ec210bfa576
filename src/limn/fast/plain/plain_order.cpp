#include "limn/fast/plain/plain_order.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "limn/fast/layout/grid_patches.h"

namespace limn::fast {
namespace {

/// The half-edge between two neighbours; the faces round `to`, which should have few, are gone
/// through.
Index halfedge_between(const Mesh& mesh, Index from, Index to) {
  const Index first = mesh.halfedge_of_vertex(to);
  Index h = first;
  do {
    if (mesh.origin(mesh.prev(h)) == from) return mesh.prev(h);
    h = mesh.rotate(h);
  } while (h != kNone && h != first);
  return kNone;
}

/// The vertex that a step puts into face f, or on its boundary edge where that is halved.
Index point_of_face(const Mesh& mesh, const Births& births, Index f) {
  const auto place = [](const std::vector<Index>& list, Index one) {
    const auto found = std::lower_bound(list.begin(), list.end(), one);
    return found != list.end() && *found == one
               ? static_cast<Index>(std::distance(list.begin(), found))
               : kNone;
  };
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1) && !births.edges.empty(); ++h)
    if (mesh.twin(h) == kNone)
      if (const Index at = place(births.edges, mesh.edge(h)); at != kNone)
        return births.from_vertices + at;
  return births.from_vertices + births.from_edges +
         (births.faces.empty() ? f : place(births.faces, f));
}

/// The vertex that lies next to the origin of h on its edge, once a cycle has cut that; `last` is
/// what the cycle's last step bears, of the mesh `middle`. Of two steps that cut edges in three,
/// the first gives its face at the origin of h the number of h, and keeps the number of a boundary
/// edge; of two that halve them, its face e comes from edge e.
Index next_along(const Mesh& coarse, const Mesh& middle, const GridCycle& cycle, const Births& last,
                 Index h) {
  if (cycle.steps == 1) return child_along(coarse, last, h);
  if (cycle.cut == 2) return point_of_face(middle, last, coarse.edge(h));
  const auto position = [](const std::vector<Index>& list, auto found) {
    return static_cast<Index>(std::distance(list.begin(), found));
  };
  if (coarse.twin(h) == kNone) {
    const std::vector<Index>& ends = last.edge_ends;
    const auto found =
        std::lower_bound(ends.begin(), ends.end(), coarse.edge(h),
                         [&](Index end, Index e) { return coarse.edge(end / 6) < e; });
    assert(found != ends.end() && *found == 6 * h);
    return last.from_vertices + position(ends, found);
  }
  const Index first = last.from_vertices + last.from_edges;
  if (last.faces.empty()) return first + h;
  const auto found = std::lower_bound(last.faces.begin(), last.faces.end(), h);
  assert(found != last.faces.end() && *found == h);
  return first + position(last.faces, found);
}

/// Walks each control face of the last level without centres row by row.
class Order {
 public:
  Order(const Mesh& control, const GridCycle& cycle, std::span<const SplitResult> steps)
      : control_(control),
        cycle_(cycle),
        steps_(steps),
        full_(static_cast<int>(steps.size()) / cycle.steps * cycle.steps),
        grid_(mesh(full_)),
        made_(control, cycle, static_cast<int>(steps.size())),
        layout_(made_.old_points.grid()) {}

  std::vector<Index> make() {
    order_.assign(static_cast<std::size_t>(made_.old_points.vertex_count()), kNone);
    for (Index v = 0; v < control_.vertex_count(); ++v) order_[v] = v;
    for (Index f = 0; f < control_.face_count(); ++f) walk(f);
    return std::move(order_);
  }

 private:
  [[nodiscard]] const Mesh& mesh(int level) const {
    return level == 0 ? control_ : steps_[static_cast<std::size_t>(level) - 1].mesh;
  }

  void walk(Index f) {
    const Index n = layout_.n(), side = layout_.sides() * f;
    const bool triangles = cycle_.lattice == Lattice::triangle;
    Index row = side;  // the half-edge from (0, y) to (1, y)
    for (int level = 0; level < full_; level += cycle_.steps) {
      const int end = level + cycle_.steps;
      row = halfedge_between(mesh(end), mesh(level).origin(row),
                             next_along(mesh(level), mesh(end - 1), cycle_,
                                        steps_[static_cast<std::size_t>(end) - 1].births, row));
    }
    centre_ = made_.old_points.centre_begin(f);
    for (Index y = 0; y < n; ++y) {
      Index h = row;
      for (Index x = 0, last = triangles ? n - 1 - y : n - 1; x <= last; ++x) {
        see_cell(side, {x, y}, h);
        if (x < last && triangles) see_centre(down(h));
        if (x < last) h = grid_.next(grid_.twin(grid_.next(triangles ? down(h) : h)));
      }
      if (y + 1 == n) break;
      // the triangle that points down beside (0, y) has the next row's first edge opposite
      row = triangles ? grid_.twin(grid_.prev(grid_.twin(grid_.next(row))))
                      : grid_.twin(grid_.next(grid_.next(row)));
    }
  }

  /// The triangle that points down, over the side of the one that h is the lower edge of.
  [[nodiscard]] Index down(Index h) const { return grid_.twin(grid_.next(h)); }

  void see_cell(Index side, Offset at, Index h) {
    const Index count = layout_.sides();
    for (Index k = 0; k < count; ++k, h = grid_.next(h)) {
      const Offset corner = in_patch(cycle_.lattice, 1, k, {0, 0});
      order_[layout_.point(side, at.a + corner.a, at.b + corner.b)] = grid_.origin(h);
    }
    see_centre(h);
  }

  void see_centre(Index h) {
    if (made_.old_points.has_centres()) order_[centre_++] = grid_.vertex_count() + grid_.face(h);
  }

  const Mesh& control_;
  const GridCycle& cycle_;
  std::span<const SplitResult> steps_;
  int full_;  // steps of full cycles
  const Mesh& grid_;
  GridStep made_;
  GridLayout layout_;
  Index centre_ = 0;
  std::vector<Index> order_;
};

/// Over the quad beyond a side, to the side opposite.
Index across(const Mesh& mesh, Index side) { return mesh.next(mesh.next(mesh.twin(side))); }

}  // namespace

std::vector<Index> grid_order(const Mesh& control, const GridCycle& cycle,
                              std::span<const SplitResult> steps) {
  return Order(control, cycle, steps).make();
}

std::vector<Index> kite_order(const KiteLayout& layout, const Mesh& fine) {
  const Kites& kites = layout.kites();
  std::vector<Index> order(static_cast<std::size_t>(layout.vertex_count()));
  // the first half-edges of the fine mesh are still those of the control mesh: they run from corner
  // to corner of the faces' shrunk images, and from there each patch is walked
  for (Index h = 0; h < kites.control().halfedge_count(); ++h) {
    order[static_cast<std::size_t>(layout.point(h, 0, 0))] = h;
    Index row = h;  // leaves (0, y) towards (-1, y)
    for (Index y = 0; y < layout.n() && kites.has_point(h, 0, y); ++y) {
      if (y > 0) row = across(fine, row);
      if (y > 0) order[static_cast<std::size_t>(layout.point(h, 0, y))] = fine.origin(row);
      Index side = row;
      for (Index x = 1; x < layout.n() && kites.has_point(h, x, y); ++x) {
        side = across(fine, x == 1 ? fine.prev(side) : side);  // comes to (x, y) from (x, y-1)
        order[static_cast<std::size_t>(layout.point(h, x, y))] = fine.target(side);
      }
    }
  }
  // isolated vertices are the last of both
  std::iota(order.begin() + layout.isolated_begin(), order.end(), layout.isolated_begin());
  return order;
}

}  // namespace limn::fast
