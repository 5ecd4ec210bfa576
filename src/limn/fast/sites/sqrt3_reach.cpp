#include "limn/fast/sites/sqrt3_reach.h"

#include <algorithm>
#include <set>

#include "limn/fast/sites/walk_hull.h"

namespace limn::fast {
namespace {

constexpr Index kRings = 5;          // of the stars that are explored, in control edges
constexpr Index kScan = 3 * kRings;  // no point farther out sees the middle
constexpr Index kWideFan = 6;        // sectors of a fan whose two sides do not see each other
constexpr Index kLargestSide = 27;   // a rule that needs a finer grid is left to the plain engine

using Hull = std::vector<Offset>;

Index third(Index i) { return ((i % 3) + 3) % 3; }

/// What the rule of the new vertex at a place sees, as vertices of site.mesh(step).
std::set<Index> hull_at(const Scheme& scheme, const Sqrt3Site& site, Sqrt3Step step,
                        const SectorPoint& place) {
  const Sqrt3Site::Origin from = site.origin(step, place);
  const Mesh& mesh = site.mesh(step);
  switch (from.kind) {
    case Sqrt3Site::Birth::vertex:
      if (step == Sqrt3Step::centroids && mesh.is_boundary_vertex(mesh.origin(from.halfedge)))
        return {mesh.origin(from.halfedge)};  // it stays
      return vertex_hull(scheme, mesh, from.halfedge);
    case Sqrt3Site::Birth::face: return face_hull(scheme, mesh, from.halfedge);
    case Sqrt3Site::Birth::edge_end: break;
  }
  return edge_end_hull(scheme, mesh, from.halfedge, from.at_target);
}

class Finder {
 public:
  Finder(const Scheme& scheme, Sqrt3Step step, const BoundarySides& sides)
      : scheme_(scheme),
        step_(step),
        sides_(sides),
        boundary_(sides[1] || sides[2] || sides[3]),
        corners_(sides[2] || sides[3]) {}

  std::optional<Sqrt3Reach> find() {
    const Sqrt3Site star(*scheme_.split, 6, false, kRings);
    for (Index y = 0; y < 3; ++y)
      for (Index x = 0; x < 3; ++x) interior_.push_back(hull(star, x, y));
    find_star_zone();
    reach_.star_rings = extent(star, {reach_.star_zone}).a;
    if (boundary_) {
      find_strips();
      find_fan_zones();
      const Sqrt3Site wide(*scheme_.split, kWideFan, true, kRings);
      reach_.fan_rings =
          std::max(extent(star, {reach_.fan_zone}).a, extent(wide, {reach_.fan_zone}).a);
    }
    if (corners_) {
      const Sqrt3Site one(*scheme_.split, 1, true, kRings);
      const Offset seen = extent(one, {reach_.corner_zone, true});
      reach_.corner_rings = seen.a;
      reach_.corner_width = seen.b;
    }
    while (!too_wide_ && !fits()) {
      reach_.smallest_side *= 3;
      too_wide_ = reach_.smallest_side > kLargestSide;
    }
    if (too_wide_) return std::nullopt;
    return reach_;
  }

 private:
  [[nodiscard]] bool made(Index x, Index y) const { return is_new(step_, x, y); }

  /// What the rule of a new point of sector 0 sees.
  std::vector<SectorPoint> seen(const Sqrt3Site& site, Index x, Index y) {
    std::vector<SectorPoint> points;
    for (const Index v : hull_at(scheme_, site, step_, {0, x, y})) {
      points.push_back(site.place(v));
      if (points.back().x + points.back().y >= site.rim()) too_wide_ = true;
    }
    return points;
  }

  /// The same on the plane, relative to the point.
  Hull hull(const Sqrt3Site& site, Index x, Index y) {
    Hull offsets;
    if (!made(x, y)) return offsets;
    for (const SectorPoint& point : seen(site, x, y)) {
      const Offset place = on_plane(Lattice::triangle, point);
      offsets.push_back({place.a - x, place.b - y});
    }
    return offsets;
  }

  /// The outermost ring that a sector's new points of a zone see, and how far along a spoke.
  Offset extent(const Sqrt3Site& site, Sqrt3Zone zone) {
    Offset most;
    for (Index x = 0; x <= zone.size; ++x)
      for (Index y = 0; zone.has(x, y) && !too_wide_; ++y) {
        if (x + y >= site.rim()) too_wide_ = true;
        if (too_wide_ || !made(x, y)) continue;
        for (const SectorPoint& point : seen(site, x, y))
          most = {std::max(most.a, point.x + point.y), std::max({most.b, point.x, point.y})};
      }
    return most;
  }

  [[nodiscard]] const Hull& interior(Index x, Index y) const {
    return interior_[static_cast<std::size_t>(3 * third(y) + third(x))];
  }
  /// Precondition: 0 ≤ y ≤ strip_depth.
  [[nodiscard]] const Hull& strip(Index x, Index y) const {
    return strips_[static_cast<std::size_t>(3 * y + third(x))];
  }

  /// Whether every place seen from the new point satisfies the condition; of no point, all do.
  template <class Condition>
  static bool all(const Hull& hull, Index x, Index y, Condition condition) {
    return std::all_of(hull.begin(), hull.end(),
                       [&](const Offset& offset) { return condition(x + offset.a, y + offset.b); });
  }

  /// Beyond a corner there is no one patch: a + b < 0, and so on round it.
  void find_star_zone() {
    for (Index x = 0; x < kScan; ++x)
      for (Index y = 0; y < kScan; ++y)
        if (!all(interior(x, y), x, y, [](Index a, Index b) { return a + b >= 0; }))
          reach_.star_zone = std::max(reach_.star_zone, x + y);
  }

  void find_strips() {
    for (Index y = 0; y < kScan; ++y)
      for (Index x = 0; x < 3; ++x)
        if (!all(interior(x, y), x, y, [](Index, Index b) { return b >= 0; }))
          reach_.strip_depth = std::max(reach_.strip_depth, y);
    const Sqrt3Site side(*scheme_.split, 3, true, kRings);
    too_wide_ = too_wide_ || reach_.strip_depth + 3 >= side.rim();
    for (Index y = 0; y <= reach_.strip_depth && !too_wide_; ++y)
      for (Index x = 0; x < 3; ++x) strips_.push_back(hull(side, x, y));
  }

  /// Near a boundary vertex: where a strip's points see beyond the corner at either end of the
  /// side, or, at a corner of one face, the other side.
  void find_fan_zones() {
    Index& wide = reach_.fan_zone;
    Index& corner = reach_.corner_zone;
    wide = std::max(reach_.star_zone, reach_.strip_depth);
    for (Index y = 0; y <= reach_.strip_depth && !too_wide_; ++y)
      for (Index t = 0; t < kScan; ++t) {
        const Hull& left = strip(t, y);
        if (!all(left, t, y, [](Index a, Index b) { return a + b >= 0; }))
          wide = std::max(wide, t + y);
        if (made(t, y) &&
            (t <= reach_.strip_depth || !all(left, t, y, [](Index a, Index) { return a >= 0; })))
          corner = std::max({corner, t, y});
        const Index x = -y - t;  // from the end of the side
        const Hull& right = strip(x, y);
        if (!all(right, x, y, [](Index a, Index) { return a <= 0; })) wide = std::max(wide, y + t);
        if (!all(right, x, y, [](Index a, Index b) { return a + b <= 0; }))
          corner = std::max({corner, t, y});
      }
    corner = std::max(corner, wide);
  }

  /// Whether a patch of smallest_side is large enough.
  [[nodiscard]] bool fits() const {
    const Index side = reach_.smallest_side;
    // two zones may overlap, but no point may be born of the next control vertex
    if (reach_.star_zone >= side || reach_.star_rings > side) return false;
    if (boundary_ && (reach_.fan_zone >= side || reach_.fan_rings > side)) return false;
    if (corners_ && (2 * reach_.corner_zone >= side || reach_.corner_width > side)) return false;
    if (sides_[3] && reach_.corner_rings > side) return false;
    for (int count = 0; count < 4; ++count)
      if (sides_[static_cast<std::size_t>(count)] && !fits_patch(count)) return false;
    return true;
  }

  /// The same for a patch whose first so many sides lie on the boundary.
  [[nodiscard]] bool fits_patch(int count) const {
    const Index side = reach_.smallest_side;
    std::array<Sqrt3Zone, 3> zones;  // round the patch's corners
    for (int i = 0; i < 3; ++i) {
      const int closed = ((i + 2) % 3 < count ? 1 : 0) + (i < count ? 1 : 0);
      zones[static_cast<std::size_t>(i)] = reach_.zone(3 - closed, closed > 0);
    }
    for (Index y = 0; y <= side; ++y)
      for (Index x = 0; x + y <= side; ++x) {
        const Index z = side - x - y;
        if (zones[0].has(x, y) || zones[1].has(y, z) || zones[2].has(z, x)) continue;
        if (!fits_point(count, x, y)) return false;
      }
    return true;
  }

  /// The same of a point in no zone.
  [[nodiscard]] bool fits_point(int count, Index x, Index y) const {
    const Index side = reach_.smallest_side;
    int near = 0;
    bool fit = true;
    Offset p{x, y};
    for (int i = 0; i < count; ++i, p = {p.b, side - p.a - p.b}) {  // in each side's frame
      if (p.b > reach_.strip_depth) continue;
      ++near;
      const bool left = (i + 2) % 3 < count, right = (i + 1) % 3 < count;
      fit = fit && all(strip(p.a, p.b), p.a, p.b, [&](Index a, Index b) {
              return a <= side && a + b >= 0 && (!left || a >= 0) && (!right || a + b <= side);
            });
    }
    if (near > 0) return near == 1 && fit;
    return all(interior(x, y), x, y,
               [&](Index a, Index b) { return a <= side && b <= side && a + b >= 0; });
  }

  const Scheme& scheme_;
  Sqrt3Step step_;
  BoundarySides sides_;
  bool boundary_, corners_;
  bool too_wide_ = false;
  std::vector<Hull> interior_, strips_;
  Sqrt3Reach reach_;
};

}  // namespace

BoundarySides boundary_sides(const Mesh& control) {
  BoundarySides sides{};
  for (Index f = 0; f < control.face_count(); ++f) {
    std::size_t count = 0;
    for (Index h = control.face_begin(f); h < control.face_begin(f + 1); ++h)
      if (control.twin(h) == kNone) ++count;
    sides[count] = true;
  }
  return sides;
}

std::optional<Sqrt3Reach> find_sqrt3_reach(const Scheme& scheme, Sqrt3Step step,
                                           const BoundarySides& sides) {
  return Finder(scheme, step, sides).find();
}

}  // namespace limn::fast
