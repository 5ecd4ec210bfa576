#include "limn/fast/sites/reach.h"

#include <algorithm>
#include <cstdlib>

#include "limn/scheme/seen_from.h"

namespace limn::fast {
namespace {

constexpr Index kScan = 15;    // new points from the middle of a site to the rim; none sees farther
constexpr Index kWideFan = 6;  // sectors of a fan whose two sides do not see each other
constexpr Index kLargestSide = 32;  // a rule that needs a finer grid is left to the plain engine

using Offsets = std::vector<Offset>;

bool has_side(unsigned sides, Index side, Index count) {
  return ((sides >> static_cast<unsigned>((side + count) % count)) & 1U) != 0;
}

/// How far an octagon of points round the middle goes.
struct Extent {
  Index ring = 0, width = 0;
};

class Finder {
 public:
  Finder(const Scheme& scheme, const GridCycle& cycle, int step, const BoundarySides& sides)
      : scheme_(scheme),
        cycle_(cycle),
        index_(step),
        step_(cycle, step),
        scan_(kScan * step_.new_edge),
        lattice_(cycle.lattice),
        count_(lattice_ == Lattice::triangle ? 3 : 4),
        sides_(sides),
        boundary_(!cycle.offset && std::find(sides.begin() + 1, sides.end(), true) != sides.end()),
        seen_from_(!cycle.offset && scheme::has_rules_seen_from(scheme)) {}

  std::optional<Reach> find() {
    const bool quads = lattice_ == Lattice::quad;
    reach_.star_zone.square = reach_.fan_zone.square = reach_.corner_zone.square = quads;
    const Site star = site(plane_sectors(lattice_), false);
    for (Index y = 0; y < step_.edge; ++y)
      for (Index x = 0; x < step_.edge; ++x) interior_.push_back(offsets(star, x, y));
    if (seen_from_) own_ = std::max(own_ring(star), boundary_ ? own_ring(site(kWideFan, true)) : 0);
    find_star_zone();
    reach_.star_rings = extent(star, reach_.star_zone).ring;
    if (cycle_.offset) find_rim();
    if (boundary_) {
      find_strips();
      find_fan_zones();
      reach_.fan_rings = std::max(extent(star, reach_.fan_zone).ring,
                                  extent(site(kWideFan, true), reach_.fan_zone).ring);
      const Extent corner = extent(site(1, true), reach_.corner_zone);
      reach_.corner_rings = corner.ring;
      reach_.corner_width = corner.width;
    }
    reach_.smallest_side = step_.edge;
    while (!too_wide_ && !fits()) {
      reach_.smallest_side *= step_.cut;
      too_wide_ = reach_.smallest_side > kLargestSide;
    }
    if (too_wide_) return std::nullopt;
    return reach_;
  }

 private:
  [[nodiscard]] Site site(Index sectors, bool open) const {
    return {*scheme_.split, cycle_, {lattice_, sectors, open}, scan_ / step_.edge};
  }
  [[nodiscard]] Index ring(Index x, Index y) const { return ring_of(lattice_, x, y); }

  /// What the rule of a new point of sector 0 sees; nothing where there is none.
  std::vector<SectorPoint> seen(const Site& site, Index x, Index y) {
    std::vector<SectorPoint> points;
    if (!step_.is_new(x, y)) return points;
    const Mesh& mesh = site.mesh(index_);
    const Births& births = site.births(index_);
    const Birth birth = birth_of(mesh, births, site.new_vertex(index_, {0, x, y}));
    for (const Index v : dependence(scheme_, mesh, births, birth)) {
      points.push_back(site.place(index_, v));
      if (site.ring(points.back()) >= site.rim()) too_wide_ = true;
    }
    return points;
  }

  /// The same on the plane, relative to the point.
  Offsets offsets(const Site& site, Index x, Index y) {
    Offsets offsets;
    for (const SectorPoint& point : seen(site, x, y)) {
      const Offset place = on_plane(lattice_, point);
      offsets.push_back({place.a - x, place.b - y});
    }
    return offsets;
  }

  /// What a sector's new points of a zone see.
  Extent extent(const Site& site, Zone zone) {
    Extent most{1, 1};
    for (Index x = 0; x <= zone.size; ++x)
      for (Index y = 0; zone.has(x, y) && !too_wide_; ++y) {
        if (ring(x, y) >= site.rim()) too_wide_ = true;
        if (too_wide_) break;
        for (const SectorPoint& p : seen(site, x, y))
          most = {std::max(most.ring, site.ring(p)), std::max({most.width, p.x, p.y})};
      }
    return most;
  }

  [[nodiscard]] const Offsets& interior(Index x, Index y) const {
    return interior_[static_cast<std::size_t>(step_.edge * step_.modulo(y) + step_.modulo(x))];
  }
  /// Precondition: 0 ≤ y ≤ strip_depth.
  [[nodiscard]] const Offsets& strip(Index x, Index y) const {
    return strips_[static_cast<std::size_t>(step_.edge * y + step_.modulo(x))];
  }

  /// Whether every place seen from the new point satisfies the condition; of no point, all do.
  template <class Condition>
  static bool all(const Offsets& seen, Index x, Index y, Condition condition) {
    return std::all_of(seen.begin(), seen.end(),
                       [&](const Offset& offset) { return condition(x + offset.a, y + offset.b); });
  }

  /// Whether the new point of sector 0 is born of an edge or a face at an old vertex for which
  /// `is_one_of(vertex)`.
  template <class IsOneOf>
  bool is_born_at(const Site& site, Index x, Index y, const IsOneOf& is_one_of) {
    if (!step_.is_new(x, y) || ring(x, y) >= site.rim()) return false;
    const Mesh& mesh = site.mesh(index_);
    const Birth birth = birth_of(mesh, site.births(index_), site.new_vertex(index_, {0, x, y}));
    const Index h = birth.halfedge;
    switch (birth.kind) {
      case Birth::edge: return is_one_of(mesh.origin(h)) || is_one_of(mesh.target(h));
      case Birth::edge_end: return is_one_of(birth.at_target ? mesh.target(h) : mesh.origin(h));
      case Birth::face: {
        const Index f = mesh.face(h);
        for (Index k = mesh.face_begin(f); k < mesh.face_begin(f + 1); ++k)
          if (is_one_of(mesh.origin(k))) return true;
        return false;
      }
      default: return false;
    }
  }

  /// How far from the middle new points are born of edges and faces there.
  Index own_ring(const Site& site) {
    const Index middle = site.old_vertex(index_, {0, 0, 0});
    Index most = 0;
    for (Index y = 0; y <= 2 * step_.edge; ++y)
      for (Index x = 0; x <= 2 * step_.edge; ++x)
        if (is_born_at(site, x, y, [&](Index v) { return v == middle; }))
          most = std::max(most, ring(x, y));
    return most;
  }

  /// How many rows of new points are born of edges and faces at a boundary side's vertices.
  Index own_depth(const Site& side) {
    Index most = 0;
    for (Index y = 0; y <= 2 * step_.edge; ++y)
      for (Index x = 0; x < step_.edge; ++x)
        if (is_born_at(side, x, y,
                       [&](Index v) { return side.mesh(index_).is_boundary_vertex(v); }))
          most = std::max(most, y);
    return most;
  }

  /// Beyond a corner there is no one patch.
  void find_star_zone() {
    Index& size = reach_.star_zone.size;
    size = own_;
    for (Index x = 0; x < scan_; ++x)
      for (Index y = 0; y < scan_; ++y)
        if (!all(interior(x, y), x, y, [&](Index a, Index b) {
              return beside_corner(lattice_, {a, b});
            }))
          size = std::max(size, ring(x, y));
  }

  /// Where the mesh recedes. A rule that sees its own face alone sees no side.
  void find_rim() {
    const bool own_face = reach_.star_zone.size == 1 && reach_.star_rings == step_.first();
    Index far = 0;
    for (Index y = 0; y < step_.edge; ++y)
      for (Index x = 0; x < step_.edge; ++x)
        for (const Offset& offset : interior(x, y)) {
          const Offset cell = step_.to_local({x + offset.a, y + offset.b});
          far = std::max({far, std::abs(cell.a), std::abs(cell.b)});
        }
    reach_.rim = own_face ? 1 : 2 * far;
  }

  void find_strips() {
    const Site side = site(half_plane_sectors(lattice_), true);
    reach_.strip_depth = seen_from_ ? own_depth(side) : 0;
    for (Index y = 0; y < scan_; ++y)
      for (Index x = 0; x < step_.edge; ++x)
        if (!all(interior(x, y), x, y, [](Index, Index b) { return b >= 0; }))
          reach_.strip_depth = std::max(reach_.strip_depth, y);
    too_wide_ = too_wide_ || reach_.strip_depth + step_.edge >= side.rim();
    for (Index y = 0; y <= reach_.strip_depth && !too_wide_; ++y)
      for (Index x = 0; x < step_.edge; ++x) strips_.push_back(offsets(side, x, y));
  }

  /// Whether what is seen from a boundary side is seen by way of faces that are there whatever the
  /// number of faces at the side's left (right) end. Of quads, the side is continued by that of the
  /// second one at its end, which need not lie on the boundary.
  [[nodiscard]] bool before_left_end(Index a, Index b) const {
    return lattice_ == Lattice::triangle ? a + b >= 0 : a >= 0;
  }

  /// Near a boundary vertex: where a strip's points see beyond the corner at either end of the
  /// side, or, at a corner of one face, the other side.
  void find_fan_zones() {
    Index& wide = reach_.fan_zone.size;
    wide = std::max(reach_.star_zone.size, reach_.strip_depth);
    Index rings = 0, width = 0;  // of what needs the corner's zone
    for (Index y = 0; y <= reach_.strip_depth && !too_wide_; ++y)
      for (Index t = 0; t < scan_; ++t) {
        const Index x = mirrored(lattice_, 0, t, y);  // from the end of the side
        const Offsets &left = strip(t, y), &right = strip(x, y);
        if (!all(left, t, y, [&](Index a, Index b) { return before_left_end(a, b); }) ||
            !all(right, x, y, [](Index a, Index) { return a <= 0; }))
          wide = std::max(wide, ring(t, y));
        if ((step_.is_new(t, y) && t <= reach_.strip_depth) ||
            !all(left, t, y, [](Index a, Index) { return a >= 0; }) ||
            !all(right, x, y, [&](Index a, Index b) { return mirrored(lattice_, 0, a, b) >= 0; })) {
          rings = std::max(rings, ring(t, y));
          width = std::max({width, t, y});
        }
      }
    Zone& corner = reach_.corner_zone;
    corner.square = corner.square || 2 * std::max(width, wide) <= std::max(rings, wide);
    corner.size = std::max(corner.square ? width : rings, wide);
  }

  /// Whether a patch of smallest_side is large enough.
  [[nodiscard]] bool fits() const {
    const Index side = reach_.smallest_side;
    // two zones may overlap, but no point may be born of the next control vertex, or at its end
    const Index room = side - 1 - own_;
    if (reach_.star_zone.size > room || reach_.star_rings > side) return false;
    if (boundary_ && (reach_.fan_zone.size > room || reach_.fan_rings > side)) return false;
    if (cycle_.offset) return fits_patch(0) && (!sides_[1] || reach_.rim * step_.edge <= side);
    for (unsigned mask = 0; mask < sides_.size(); ++mask)
      if (sides_[mask] && !(fits_corners(mask, room) && fits_patch(mask))) return false;
    return true;
  }

  /// Whether a patch whose sides in `mask` lie on the boundary has room for the zones of its
  /// corners that are its own.
  [[nodiscard]] bool fits_corners(unsigned mask, Index room) const {
    bool corner = false;
    for (Index i = 0; i < count_; ++i)
      corner = corner || (has_side(mask, i - 1, count_) && has_side(mask, i, count_));
    if (!corner) return true;
    const bool triangle = lattice_ == Lattice::triangle;
    const Zone& zone = reach_.corner_zone;
    if (triangle && zone.square ? 2 * zone.size >= reach_.smallest_side : zone.size > room)
      return false;
    if (reach_.corner_width > reach_.smallest_side) return false;
    return mask != 7 || !triangle || reach_.corner_rings <= reach_.smallest_side;
  }

  [[nodiscard]] Offset next_frame(Offset p) const {
    return {p.b, mirrored(lattice_, reach_.smallest_side, p.a, p.b)};
  }

  /// Whether the points of such a patch that are in no zone see no farther than stencils can.
  [[nodiscard]] bool fits_patch(unsigned mask) const {
    const Index side = reach_.smallest_side;
    for (Index y = 0; y <= side; ++y)
      for (Index x = 0; patch_holds(lattice_, side, {x, y}); ++x)
        if (step_.is_new(x, y) && !in_zone(mask, {x, y}) && !fits_point(mask, {x, y})) return false;
    return true;
  }

  [[nodiscard]] bool in_zone(unsigned mask, Offset p) const {
    for (Index i = 0; i < count_; ++i, p = next_frame(p)) {
      const bool before = has_side(mask, i - 1, count_), after = has_side(mask, i, count_);
      if (reach_.zone(before && after ? 1 : 2, before || after).has(p.a, p.b)) return true;
    }
    return false;
  }

  [[nodiscard]] bool fits_point(unsigned mask, Offset point) const {
    const Index side = reach_.smallest_side;
    int near = 0;
    bool fit = true;
    Offset p = point;
    for (Index i = 0; i < count_; ++i, p = next_frame(p)) {
      if (!has_side(mask, i, count_) || p.b > reach_.strip_depth) continue;
      ++near;
      fit = fit && all(strip(p.a, p.b), p.a, p.b, [&](Index a, Index b) {
              return b >= 0 && patch_sees(lattice_, side, {a, b}) && !sees_over(mask, i, {a, b});
            });
    }
    if (near > 0) return near == 1 && fit;
    return all(interior(point.a, point.b), point.a, point.b, [&](Index a, Index b) {
      return patch_sees(lattice_, side, {a, b});
    });
  }

  /// Whether a place, in the frame of side i, lies beyond another side on the boundary.
  [[nodiscard]] bool sees_over(unsigned mask, Index i, Offset p) const {
    for (Index k = 1; k < count_; ++k) {
      p = next_frame(p);
      if (p.b < 0 && has_side(mask, i + k, count_)) return true;
    }
    return false;
  }

  const Scheme& scheme_;
  const GridCycle& cycle_;
  int index_;
  LatticeStep step_;
  Index scan_;
  Lattice lattice_;
  Index count_;  // sides of a patch
  BoundarySides sides_;
  bool boundary_, seen_from_;
  Index own_ = 0;  // how far from a vertex points may have rules that are seen from it
  bool too_wide_ = false;
  std::vector<Offsets> interior_, strips_;
  Reach reach_;
};

}  // namespace

BoundarySides boundary_sides(const Mesh& control) {
  BoundarySides sides{};
  sides[0] = true;
  if (!control.has_boundary()) return sides;
  for (Index f = 0; f < control.face_count(); ++f) {
    unsigned mask = 0;
    for (Index h = control.face_begin(f), k = 0; h < control.face_begin(f + 1); ++h, ++k)
      if (control.twin(h) == kNone) mask |= 1U << static_cast<unsigned>(k);
    sides[mask] = true;
  }
  return sides;
}

bool Reach::zones_meet(Index side) const {
  // a triangle's square reaches as far as its corner
  const Index corner = corner_zone.size * (corner_zone.square && !star_zone.square ? 2 : 1);
  return 2 * std::max({star_zone.size, fan_zone.size, corner}) >= side;
}

std::optional<Reach> find_reach(const Scheme& scheme, const GridCycle& cycle, int step,
                                const BoundarySides& sides) {
  return Finder(scheme, cycle, step, sides).find();
}

}  // namespace limn::fast
