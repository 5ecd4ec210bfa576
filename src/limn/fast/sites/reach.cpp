#include "limn/fast/sites/reach.h"

#include <algorithm>

#include "limn/fast/sites/walk_hull.h"
#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

constexpr Index kRings = 7;         // of the stars that are explored
constexpr Index kWideFan = 6;       // sectors of a fan whose two sides do not see each other
constexpr Index kLargestGrid = 16;  // a rule that needs a finer one is left to the plain engine

using Hull = std::vector<Offset>;

/// A star or fan, and hulls on it.
class Site {
 public:
  /// `too_wide` is set where a hull meets the rim.
  Site(const Scheme& scheme, Index sectors, bool open, bool& too_wide)
      : scheme_(scheme),
        too_wide_(too_wide),
        shape_{scheme.split->lattice, sectors, open},
        mesh_(open ? fan(shape_.lattice, sectors, kRings) : star(shape_.lattice, sectors, kRings)) {
  }

  /// What the rule of a fine point of sector 0 sees.
  [[nodiscard]] std::vector<SectorPoint> seen(Index fine_x, Index fine_y) const {
    std::vector<SectorPoint> points;
    for (const Index v : birth_hull(scheme_, mesh_, shape_, {0, fine_x, fine_y})) {
      points.push_back(sector_point(shape_, v));
      if (ring(points.back()) >= kRings) too_wide_ = true;
    }
    return points;
  }

  /// The same as offsets from the anchor.
  [[nodiscard]] Hull hull(Index fine_x, Index fine_y) const {
    Hull offsets;
    for (const SectorPoint& point : seen(fine_x, fine_y)) {
      const Offset place = on_plane(shape_.lattice, point);
      offsets.push_back({place.a - fine_x / 2, place.b - fine_y / 2});
    }
    return offsets;
  }

  /// The outermost coarse ring that fine points of fine rings 0 … `zone` see.
  [[nodiscard]] Index rings(Index zone) const {
    Index result = 1;
    for (Index x = 0; x <= zone; ++x)
      for (Index y = 0; ring({0, x, y}) <= zone; ++y)
        for (const SectorPoint& point : seen(x, y)) result = std::max(result, ring(point));
    return result;
  }

 private:
  [[nodiscard]] Index ring(const SectorPoint& point) const {
    return ring_of(shape_.lattice, point.x, point.y);
  }

  const Scheme& scheme_;
  bool& too_wide_;
  StarShape shape_;
  Mesh mesh_;
};

class Finder {
 public:
  Finder(const Scheme& scheme, bool boundary)
      : scheme_(scheme),
        lattice_(scheme.split->lattice),
        boundary_(boundary),
        ends_(scheme.rule(RuleKind::edge_end).has_value()),
        star_(scheme, plane_sectors(lattice_), false, too_wide_) {}

  std::optional<Reach> find() {
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) interior_[class_of(x, y)] = star_.hull(x, y);
    find_star_zone();
    reach_.star_rings = star_.rings(reach_.star_zone);
    if (boundary_) {
      find_strips();
      find_fan_zones();
      reach_.fan_rings = std::max({star_.rings(reach_.fan_zone),
                                   Site(scheme_, kWideFan, true, too_wide_).rings(reach_.fan_zone),
                                   Site(scheme_, 1, true, too_wide_).rings(reach_.corner_zone)});
    }
    while (!too_wide_ && !fits()) {
      reach_.smallest_grid *= 2;
      too_wide_ = reach_.smallest_grid > kLargestGrid;
    }
    if (too_wide_) return std::nullopt;
    return reach_;
  }

 private:
  /// floor(i / 2), for negative i as well.
  static Index half(Index i) { return i >> 1; }

  /// Whether every place seen from the fine point satisfies the condition.
  template <class Condition>
  static bool all(const Hull& hull, Index fine_x, Index fine_y, Condition condition) {
    return std::all_of(hull.begin(), hull.end(), [&](const Offset& offset) {
      return condition(half(fine_x) + offset.a, half(fine_y) + offset.b);
    });
  }

  [[nodiscard]] const Hull& interior(Index x, Index y) const { return interior_[class_of(x, y)]; }
  /// Precondition: y ≤ strip_depth.
  [[nodiscard]] const Hull& strip(Index x, Index y) const {
    return strips_[static_cast<std::size_t>(2 * y + (x & 1))];
  }

  [[nodiscard]] Index ring(Index x, Index y) const { return ring_of(lattice_, x, y); }
  /// Whether what is seen from a boundary side is seen by way of faces that are there whatever the
  /// number of faces at the side's left (right) end. Of quads, the side is continued by that of the
  /// second one at its end, which need not lie on the boundary.
  [[nodiscard]] bool before_left_end(Index a, Index b) const {
    return lattice_ == Lattice::triangle ? a + b >= 0 : a >= 0;
  }
  static bool before_right_end(Index a, Index /*b*/) { return a <= 0; }

  /// Beyond a corner there is no one patch.
  void find_star_zone() {
    reach_.star_zone = ends_ ? 1 : 0;
    for (Index x = 0; x < 2 * kRings; ++x)
      for (Index y = 0; y < 2 * kRings; ++y)
        if (!all(interior(x, y), x, y, [&](Index a, Index b) {
              return beside_corner(lattice_, {a, b});
            }))
          reach_.star_zone = std::max(reach_.star_zone, ring(x, y));
  }

  void find_strips() {
    const Site side(scheme_, half_plane_sectors(lattice_), true, too_wide_);
    reach_.strip_depth = ends_ ? 1 : 0;
    for (Index y = 0; y < 2 * kRings; ++y)
      for (const Index x : {0, 1})
        if (!all(interior(x, y), x, y, [](Index, Index b) { return b >= 0; }))
          reach_.strip_depth = std::max(reach_.strip_depth, y);
    for (Index y = 0; y <= reach_.strip_depth; ++y)
      for (const Index x : {0, 1}) strips_.push_back(side.hull(x, y));
  }

  /// Near a boundary vertex: where a strip's points see beyond the corner at either end of the
  /// side, or, at a corner of one face, the other side.
  void find_fan_zones() {
    Index& wide = reach_.fan_zone;
    Index& corner = reach_.corner_zone;
    wide = std::max(reach_.star_zone, reach_.strip_depth);
    const auto in_corner = [&](Index a, Index b) { return mirrored(lattice_, 0, a, b) >= 0; };
    for (Index y = 0; y <= reach_.strip_depth; ++y)
      for (Index t = 0; t < 2 * kRings; ++t) {
        const Index far = ring(t, y);
        const Hull& left = strip(t, y);
        if (!all(left, t, y, [&](Index a, Index b) { return before_left_end(a, b); }))
          wide = std::max(wide, far);
        if (t <= reach_.strip_depth || !all(left, t, y, [](Index a, Index) { return a >= 0; }))
          corner = std::max(corner, far);
        const Index x = mirrored(lattice_, 0, t, y);  // from the end of the side
        const Hull& right = strip(x, y);
        if (!all(right, x, y, before_right_end)) wide = std::max(wide, far);
        if (!all(right, x, y, in_corner)) corner = std::max(corner, far);
      }
    corner = std::max(corner, wide);
  }

  /// Whether a patch of smallest_grid edges a side is large enough.
  [[nodiscard]] bool fits() const {
    const Index n = reach_.smallest_grid;
    const Index zone = std::max({reach_.star_zone, reach_.fan_zone, reach_.corner_zone});
    // two zones may overlap, but no point may be born of the next control vertex, or at its end
    if (zone > 2 * n - (ends_ ? 2 : 1)) return false;
    if (reach_.star_rings > n || (boundary_ && reach_.fan_rings > n)) return false;
    // opposite sides of a quad may both lie on the boundary
    if (lattice_ == Lattice::quad && reach_.strip_depth >= n) return false;
    for (Index y = 0; y <= 2 * n; ++y)
      for (Index x = 0; patch_holds(lattice_, 2 * n, {x, y}); ++x)
        if (!fits_interior(x, y) || (boundary_ && y <= reach_.strip_depth && !fits_strip(x, y)))
          return false;
    return true;
  }

  [[nodiscard]] bool fits_interior(Index x, Index y) const {
    const Index n = reach_.smallest_grid;
    return ring_of_nearest_corner(lattice_, 2 * n, x, y) <= reach_.star_zone ||
           all(interior(x, y), x, y, [&](Index a, Index b) {
             return patch_sees(lattice_, n, {a, b});
           });
  }

  [[nodiscard]] bool fits_strip(Index x, Index y) const {
    const Index n = reach_.smallest_grid, depth = reach_.strip_depth;
    const Index to_right = mirrored(lattice_, 2 * n, x, y);
    const Index nearest = std::min(ring(x, y), ring(to_right, y));
    const Hull& hull = strip(x, y);
    if (nearest > reach_.fan_zone && !all(hull, x, y, [&](Index a, Index b) {
          return patch_sees(lattice_, n, {a, b});
        }))
      return false;
    // beyond that, other sides may lie on the boundary as well
    return nearest <= reach_.corner_zone ||
           (x > depth && to_right > depth && all(hull, x, y, [&](Index a, Index b) {
              return patch_holds(lattice_, n, {a, b});
            }));
  }

  const Scheme& scheme_;
  Lattice lattice_;
  bool boundary_, ends_;
  bool too_wide_ = false;
  Site star_;
  std::array<Hull, kClasses> interior_;
  std::vector<Hull> strips_;
  Reach reach_;
};

/// A half-edge of the edge between two neighbours; kNone where there is none.
Index between(const Mesh& mesh, Index u, Index v) {
  for (const auto& [from, to] : {std::pair{u, v}, std::pair{v, u}}) {
    const Index first = mesh.halfedge_of_vertex(from);
    Index h = first;
    do {
      if (mesh.target(h) == to) return h;
      h = mesh.rotate(h);
    } while (h != kNone && h != first);
  }
  return kNone;
}

/// A half-edge of the face that has these neighbours and this vertex.
Index face_with(const Mesh& mesh, Index u, Index v, Index corner) {
  const Index h = between(mesh, u, v);
  for (Index k = mesh.next(h); k != h; k = mesh.next(k))
    if (mesh.origin(k) == corner) return h;
  return mesh.twin(h);
}

}  // namespace

std::set<Index> birth_hull(const Scheme& scheme, const Mesh& star, const StarShape& shape,
                           const SectorPoint& fine) {
  const auto vertex = [&](Index x, Index y) {
    return vertex_at(shape, {fine.sector, fine.x / 2 + x, fine.y / 2 + y});
  };
  const auto edge = [&](Index u, Index v) { return edge_hull(scheme, star, between(star, u, v)); };
  switch (class_of(fine.x, fine.y)) {
    case 0: return vertex_hull(scheme, star, star.halfedge_of_vertex(vertex(0, 0)));
    case 1: return edge(vertex(0, 0), vertex(1, 0));
    case 2: return edge(vertex(0, 0), vertex(0, 1));
    default: break;
  }
  if (shape.lattice == Lattice::triangle) return edge(vertex(1, 0), vertex(0, 1));
  return face_hull(scheme, star, face_with(star, vertex(0, 0), vertex(1, 0), vertex(1, 1)));
}

std::optional<Reach> find_reach(const Scheme& scheme, bool boundary) {
  return Finder(scheme, boundary).find();
}

}  // namespace limn::fast
