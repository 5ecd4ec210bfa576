#include "limn/refine/fast/reach.h"

#include <algorithm>

#include "limn/mesh/lattice.h"
#include "limn/refine/fast/walk_hull.h"

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
        sectors_(sectors),
        open_(open),
        mesh_(open ? fan(Lattice::triangle, sectors, kRings)
                   : star(Lattice::triangle, sectors, kRings)) {}

  /// What the rule of a fine point of sector 0 sees.
  [[nodiscard]] std::vector<SectorPoint> seen(Index fine_x, Index fine_y) const {
    const Index h = birth_of(mesh_, sectors_, open_, {0, fine_x, fine_y});
    const std::set<Index> vertices = class_of(fine_x, fine_y) == 0 ? vertex_hull(scheme_, mesh_, h)
                                                                   : edge_hull(scheme_, mesh_, h);
    std::vector<SectorPoint> points;
    for (const Index v : vertices) {
      points.push_back(sector_point(sectors_, open_, v));
      if (points.back().x + points.back().y >= kRings) too_wide_ = true;
    }
    return points;
  }

  /// The same as offsets from the anchor.
  [[nodiscard]] Hull hull(Index fine_x, Index fine_y) const {
    Hull offsets;
    for (const SectorPoint& point : seen(fine_x, fine_y)) {
      const Offset place = on_plane(point);
      offsets.push_back({place.a - fine_x / 2, place.b - fine_y / 2});
    }
    return offsets;
  }

  /// The outermost coarse ring that fine points of fine rings 0 … `zone` see.
  [[nodiscard]] Index rings(Index zone) const {
    Index result = 1;
    for (Index x = 0; x <= zone; ++x)
      for (Index y = 0; x + y <= zone; ++y)
        for (const SectorPoint& point : seen(x, y)) result = std::max(result, point.x + point.y);
    return result;
  }

 private:
  const Scheme& scheme_;
  bool& too_wide_;
  Index sectors_;
  bool open_;
  Mesh mesh_;
};

class Finder {
 public:
  Finder(const Scheme& scheme, bool boundary)
      : scheme_(scheme),
        boundary_(boundary),
        ends_(scheme.rule(RuleKind::edge_end).has_value()),
        star_(scheme, 6, false, too_wide_) {}

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

  /// Beyond a corner there is no one patch: a + b < 0, and so on round it.
  void find_star_zone() {
    reach_.star_zone = ends_ ? 1 : 0;
    for (Index x = 0; x < 2 * kRings; ++x)
      for (Index y = 0; y < 2 * kRings; ++y)
        if (!all(interior(x, y), x, y, [](Index a, Index b) { return a + b >= 0; }))
          reach_.star_zone = std::max(reach_.star_zone, x + y);
  }

  void find_strips() {
    const Site side(scheme_, 3, true, too_wide_);
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
    for (Index y = 0; y <= reach_.strip_depth; ++y)
      for (Index t = 0; t < 2 * kRings; ++t) {
        const Hull& left = strip(t, y);
        if (!all(left, t, y, [](Index a, Index b) { return a + b >= 0; }))
          wide = std::max(wide, t + y);
        if (t <= reach_.strip_depth || !all(left, t, y, [](Index a, Index) { return a >= 0; }))
          corner = std::max(corner, t + y);
        const Index x = -y - t;  // from the end of the side
        const Hull& right = strip(x, y);
        if (!all(right, x, y, [](Index a, Index) { return a <= 0; })) wide = std::max(wide, y + t);
        if (!all(right, x, y, [](Index a, Index b) { return a + b <= 0; }))
          corner = std::max(corner, y + t);
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
    for (Index y = 0; y <= 2 * n; ++y)
      for (Index x = 0; x + y <= 2 * n; ++x)
        if (!fits_interior(x, y) || (boundary_ && y <= reach_.strip_depth && !fits_strip(x, y)))
          return false;
    return true;
  }

  [[nodiscard]] bool fits_interior(Index x, Index y) const {
    const Index n = reach_.smallest_grid;
    const Index nearest = std::min({x + y, 2 * n - x, 2 * n - y});
    return nearest <= reach_.star_zone || all(interior(x, y), x, y, [n](Index a, Index b) {
             return a <= n && b <= n && a + b >= 0;
           });
  }

  [[nodiscard]] bool fits_strip(Index x, Index y) const {
    const Index n = reach_.smallest_grid;
    const Index left = x + y, right = 2 * n - x;
    const Hull& hull = strip(x, y);
    if (std::min(left, right) > reach_.fan_zone &&
        !all(hull, x, y, [n](Index a, Index b) { return a <= n && b <= n && a + b >= 0; }))
      return false;
    if (std::min(left, right) <= reach_.corner_zone) return true;
    const Index depth = reach_.strip_depth;
    return x > depth && 2 * n - x - y > depth &&
           all(hull, x, y, [n](Index a, Index b) { return a >= 0 && a + b <= n; });
  }

  const Scheme& scheme_;
  bool boundary_, ends_;
  bool too_wide_ = false;
  Site star_;
  std::array<Hull, kClasses> interior_;
  std::vector<Hull> strips_;
  Reach reach_;
};

/// The half-edge between two neighbours, either way.
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

}  // namespace

Index birth_of(const Mesh& star, Index sectors, bool open, const SectorPoint& fine) {
  const auto vertex = [&](Index x, Index y) {
    return vertex_at(sectors, open, {fine.sector, fine.x / 2 + x, fine.y / 2 + y});
  };
  switch (class_of(fine.x, fine.y)) {
    case 0: return star.halfedge_of_vertex(vertex(0, 0));
    case 1: return between(star, vertex(0, 0), vertex(1, 0));
    case 2: return between(star, vertex(0, 0), vertex(0, 1));
    default: return between(star, vertex(1, 0), vertex(0, 1));
  }
}

std::optional<Reach> find_reach(const Scheme& scheme, bool boundary) {
  return Finder(scheme, boundary).find();
}

}  // namespace limn::fast
