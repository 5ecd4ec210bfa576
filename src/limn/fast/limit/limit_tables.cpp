#include "limn/fast/limit/limit_tables.h"

#include <algorithm>
#include <map>

#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

using Form = refine::LinearForm<double>;
using Places = std::vector<SectorPoint>;

constexpr Index kRim = 2;            // edges from the rim that sums must not come to
constexpr Index kMostRings = 24;     // of a site
constexpr Index kFewestSeen = 2;     // edges round a vertex, or from a side, that are read;
constexpr Index kMostSeen = 8;       // if need be more. Those of the last edge must not differ.
constexpr Index kLargestZone = 200;  // valence of a zone wider than its vertex

class LimitTableMaker {
 public:
  LimitTableMaker(const LimitControl& control, int level, int steps_made, LimitReader& reader)
      : control_(control),
        step_(control.cycle, level),
        n_(power(control.cycle.cut, level / control.cycle.steps)),
        side_(n_ * step_.edge),
        index_(level % control.cycle.steps),
        lattice_(control.cycle.lattice),
        edge_(step_.edge),
        steps_made_(steps_made),
        reader_(reader) {}

  Result<std::optional<StencilTables>> make() {
    using Found = std::optional<StencilTables>;
    for (const auto read :
         {&LimitTableMaker::find_rings, &LimitTableMaker::read_plane, &LimitTableMaker::read_sides,
          &LimitTableMaker::read_kinds, &LimitTableMaker::read_near}) {
      Known found = (this->*read)();
      // a coarse mesh may have no regular vertex to fail at
      if (!found && n_ > 1) return found.error();
      if (!found || !*found) return Found();
    }
    for (const Stencil& stencil : interior_) {
      Stencil& local = tables_.interior.emplace_back(stencil);
      for (Tap& tap : local) tap.place = step_.to_local(tap.place);
      std::sort(local.begin(), local.end(),
                [](const Tap& p, const Tap& q) { return p.place < q.place; });
    }
    for (const auto& [y, sums] : side_rows_) {
      auto [table, places] = limit_rows(sums);
      tables_.strips.push_back({y, y % edge_, edge_, std::move(table), std::move(places)});
    }
    tables_.stars[0].tables = {{0, {SectorPoint{}}, {SectorPoint{}}, isolated_limit_rows()}};
    return Found(std::move(tables_));
  }

 private:
  using Known = Result<bool>;  // whether there are sums that can be used
  using Sums = std::vector<LimitSums>;
  /// Whether a vertex's sums are found on its own ring, whatever follows.
  [[nodiscard]] bool is_near() const { return inner_ <= 1 && outer_ <= 1; }
  /// Whether they are along a boundary. With centres, the vertices there have other valences.
  [[nodiscard]] bool is_near_boundary() const { return is_near() && index_ == 0; }

  Known find_rings() {
    const Result<Index> inner = reader_.regular_rings(false);
    if (!inner) return inner.error();
    inner_ = *inner;
    if (!control_.boundary) return true;
    const Result<Index> outer = reader_.regular_rings(true);
    if (!outer) return outer.error();
    outer_ = *outer;
    return true;
  }

  struct Read {
    Site site;
    Sums sums;
  };
  /// At points up to so many steps from the middle of a site, which gets as many rings as it takes
  /// until no sum comes near the rim. Nothing where that does not help, or there are no sums.
  Result<std::optional<Read>> read(const StarShape& shape, Index seen, const Places& points) {
    using Found = std::optional<Read>;
    for (Index rings = (seen + edge_ - 1) / edge_ + reach_ + kRim; rings <= kMostRings;
         rings += kRim) {
      Found found(Read{Site(control_.split, control_.cycle, shape, rings), {}});
      const Site& site = found->site;
      std::vector<Index> vertices;
      for (const SectorPoint& point : points) vertices.push_back(site.old_vertex(index_, point));
      auto read = reader_.read(site.mesh(index_), steps_made_, !shape.open, vertices);
      if (!read) return read.error();
      bool inside = true;
      for (std::size_t i = 0; i < points.size(); ++i) {
        LimitSums& sums = found->sums.emplace_back();
        if (std::optional<LimitForms>& forms = (*read)[i]) {
          sums.assign(forms->begin(), forms->end());
        } else if (points[i] == SectorPoint{}) {
          Result<LimitSums> chain = read_chain(site, vertices[i]);
          if (!chain) return chain.error();
          sums = std::move(*chain);
        } else {
          return Found();
        }
        for (Form& form : sums) {
          drop_rounding(form);
          for (const auto& [vertex, weight] : form.terms)
            inside = inside && ring(site, vertex) <= edge_ * (rings - (index_ == 0 ? 1 : kRim));
        }
      }
      if (inside) return found;
    }
    return Found();
  }

  /// Of the middle; its rings are kept.
  Result<LimitSums> read_chain(const Site& site, Index vertex) {
    auto chain = reader_.read_chain(site.mesh(index_), steps_made_, !site.shape().open, vertex);
    if (!chain) return chain.error();
    chain_rings_ = std::max(chain_rings_, chain->rings);
    return std::move(chain->forms);
  }

  [[nodiscard]] Index ring(const Site& site, Index vertex) const {
    return site.ring(site.place(index_, vertex));
  }

  /// Sums at a point of the plane, or of half of it, by offsets from the point.
  [[nodiscard]] LimitStencils on_plane_from(const LimitSums& sums, const Site& site,
                                            const SectorPoint& point) const {
    const Offset from = on_plane(lattice_, point);
    LimitStencils stencils;
    for (std::size_t i = 0; i < stencils.size(); ++i) {
      std::vector<Offset> places;
      std::vector<double> weights;
      for (const auto& [vertex, weight] : sums[i].terms) {
        const Offset at = on_plane(lattice_, site.place(index_, vertex));
        places.push_back({at.a - from.a, at.b - from.b});
        weights.push_back(weight);
      }
      stencils[i] = rounded_stencil(places, std::move(weights));
    }
    return stencils;
  }

  Known read_plane() {
    const SectorPoint first{0, step_.first(), step_.first()};
    const auto plane = read({lattice_, plane_sectors(lattice_), false}, 0, {first});
    if (!plane) return plane.error();
    if (!*plane || (*plane)->sums.front().size() != 3) return false;
    const LimitSums& sums = (*plane)->sums.front();
    interior_ = on_plane_from(sums, (*plane)->site, first);
    Index far = 0;
    for (const Form& form : sums)
      for (const auto& [vertex, weight] : form.terms)
        far = std::max(far, ring((*plane)->site, vertex));
    reach_ = (far + edge_ - 1) / edge_;
    return true;
  }

  /// Along a straight boundary.
  Known read_sides() {
    if (!control_.boundary) return true;
    for (Index seen = is_near_boundary() ? 0 : kFewestSeen; seen <= kMostSeen; seen *= 2) {
      Known found = read_sides(seen * edge_);
      const Index depth = side_rows_.empty() ? 0 : side_rows_.rbegin()->first;
      if (!found || !*found || seen == 0 || depth <= (seen - 1) * edge_) return found;
    }
    return false;
  }

  Known read_sides(Index seen) {
    Places points;
    for (Index y = 0; y <= seen; ++y)
      if (step_.is_old(y % edge_, y)) points.push_back({0, y % edge_, y});
    const auto read = this->read({lattice_, half_plane_sectors(lattice_), true}, seen, points);
    if (!read) return read.error();
    if (!*read) return false;
    const auto& [site, all] = **read;
    std::map<Offset, SectorPoint> plane;
    for (Index v = 0; v < site.mesh(index_).vertex_count(); ++v)
      plane.emplace(on_plane(lattice_, site.place(index_, v)), site.place(index_, v));
    std::map<Index, LimitStencils> rows;
    Index depth = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [sector, x, y] = points[i];
      if (all[i].size() != 3) return false;
      rows[y] = on_plane_from(all[i], site, points[i]);
      const auto expected = moved(interior_, site, [&, x = x, y = y](Offset tap) {
        const auto at = plane.find({x + tap.a, y + tap.b});
        return at == plane.end() ? std::nullopt : std::optional(at->second);
      });
      if (y > 0 && !(expected && same_limit(*expected, all[i]))) depth = y;
    }
    side_rows_.clear();
    for (auto& [y, sums] : rows)
      if (y <= depth) side_rows_.emplace(y, std::move(sums));
    return true;
  }

  /// A vertex's sums as those of another one like it; nothing where the site has not all places.
  template <class At>
  [[nodiscard]] std::optional<LimitSums> moved(const LimitStencils& stencils, const Site& site,
                                               At at) const {
    LimitSums sums(stencils.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
      for (const Tap& tap : stencils[i]) {
        const std::optional<SectorPoint> point = at(tap.place);
        if (!point) return std::nullopt;
        refine::add_scaled(sums[i], tap.weight, Form::unit(site.old_vertex(index_, *point)));
      }
    return sums;
  }

  /// What patches and side rows make at a point of a site; nothing where they do not look.
  [[nodiscard]] std::optional<LimitSums> usual(const Site& site, const SectorPoint& point) const {
    const auto& [sector, x, y] = point;
    const StarShape& shape = site.shape();
    const bool first = shape.open && sector == 0 && x > 0 && side_rows_.contains(y);
    const bool last = shape.open && sector == shape.sectors - 1 && y > 0 && side_rows_.contains(x);
    if (first && last) return std::nullopt;  // two sides would make it
    const LimitStencils& stencils = first ? side_rows_.at(y) : last ? side_rows_.at(x) : interior_;
    return moved(stencils, site, [&, point = point](Offset tap) -> std::optional<SectorPoint> {
      // a fan's last spoke is the end of a side, which leads to the middle
      if (last) tap = {tap.b, mirrored(lattice_, 0, tap.a, tap.b)};
      const Offset place{point.x + tap.a, point.y + tap.b};
      if (lattice_ == Lattice::triangle) {  // past the middle, along the boundary
        if (first && place.a < 0 && place.b == 0)
          return SectorPoint{shape.sectors - 1, 0, -place.a};
        if (last && place.a == 0 && place.b < 0) return SectorPoint{0, -place.b, 0};
      }
      return site.beside(point.sector, place);
    });
  }

  Known read_kinds() {
    for (const StarShape& shape : control_.kinds) {
      if (shape.sectors == 0) continue;
      // the middle of a regular star is no point
      if (control_.cycle.offset && shape.sectors == plane_sectors(lattice_)) continue;
      ZoneTables& around = (shape.open ? tables_.fans : tables_.stars)[shape.sectors];
      Known found = read_kind(shape, around);
      if (!found || !*found) return found;
      if (!fits(shape, around)) return false;
    }
    return chain_rings_ <= n_;
  }

  Known read_kind(const StarShape& shape, ZoneTables& around) {
    const bool near = shape.open ? is_near_boundary() : inner_ <= 1 && !control_.cycle.offset;
    if (!near && shape.sectors > kLargestZone) return false;
    for (Index seen = near ? 0 : kFewestSeen; seen <= kMostSeen; seen *= 2) {
      Known found = read_zone(shape, seen * edge_, around);
      if (!found || !*found || seen == 0 || around.zone.size <= (seen - 1) * edge_) return found;
    }
    return false;
  }

  /// The old points up to a ring, the middle first.
  [[nodiscard]] Places points_round(Index sectors, bool last_spoke, Index seen) const {
    Places points;
    if (step_.is_old(0, 0)) points.emplace_back();
    for (Index s = 0; s < sectors; ++s)
      for (Index x = 1; x <= seen; ++x)
        for (Index y = 0; ring_of(lattice_, x, y) <= seen; ++y)
          if (step_.is_old(x, y)) points.push_back({s, x, y});
    for (Index y = 1; last_spoke && y <= seen; ++y)
      if (step_.is_old(0, y)) points.push_back({sectors - 1, 0, y});
    return points;
  }

  Known read_zone(const StarShape& shape, Index seen, ZoneTables& around) {
    // the sectors of a star are alike
    Places points = points_round(shape.open ? shape.sectors : 1, shape.open, seen);
    auto found = read(shape, seen, points);
    if (!found) return found.error();
    if (!*found) return false;
    around.zone = {0, lattice_ == Lattice::quad};
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] == SectorPoint{}) continue;
      const auto expected = usual((*found)->site, points[i]);
      if (!expected || (*found)->sums[i].size() != 3 || !same_limit(*expected, (*found)->sums[i]))
        around.zone.size = std::max(around.zone.size, ring_of(lattice_, points[i].x, points[i].y));
    }
    if (!shape.open) turn(around.zone.size, **found, points);
    add_tables(**found, points, around);
    if (is_near_boundary() || !shape.open || shape.sectors > 1) return true;
    // where the only face at a corner gives the normal, it has to be of the level itself
    const Result<LimitSums> chain =
        read_chain((*found)->site, (*found)->site.old_vertex(index_, {}));
    if (!chain) return chain.error();
    return true;
  }

  /// Adds what is in the sectors after the first, so far from the middle.
  void turn(Index size, Read& read, Places& points) const {
    const Index sectors = read.site.shape().sectors;
    const std::size_t count = points.size();
    for (Index s = 1; s < sectors; ++s)
      for (std::size_t i = 0; i < count; ++i) {
        const auto [sector, x, y] = points[i];
        if (ring_of(lattice_, x, y) > size || (x == 0 && y == 0)) continue;
        points.push_back({s, x, y});
        LimitSums sums = read.sums[i];
        for (Form& form : sums)
          for (auto& [vertex, weight] : form.terms) {
            SectorPoint at = read.site.place(index_, vertex);
            at.sector = (at.sector + s) % sectors;
            vertex = read.site.old_vertex(index_, at);
          }
        read.sums.push_back(std::move(sums));
      }
  }

  void add_tables(const Read& read, const Places& points, ZoneTables& around) const {
    around.tables.clear();
    const bool alike = read.sums.front().size() == 3;
    for (const bool centre : {true, false}) {
      std::vector<Form> forms;
      Places targets;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (ring_of(lattice_, points[i].x, points[i].y) > around.zone.size) continue;
        if (centre != (alike || points[i] == SectorPoint{})) continue;
        targets.push_back(points[i]);
        forms.insert(forms.end(), read.sums[i].begin(), read.sums[i].end());
      }
      if (!targets.empty())
        around.tables.push_back(zone_table(forms, read.site, index_, std::move(targets)));
    }
  }

  /// Whether a zone ends, and its sums do, before another's begins.
  [[nodiscard]] bool fits(const StarShape& shape, const ZoneTables& around) const {
    const Index side = side_;
    const bool alone = n_ == 1;
    const auto all_sources = [&](auto condition) {
      return std::all_of(around.tables.begin(), around.tables.end(), [&](const ZoneTable& table) {
        return std::all_of(table.sources.begin(), table.sources.end(), condition);
      });
    };
    // a zone may hold the centre of its only triangle, that across the triangle's third side
    // counts, and the next vertices along the boundary
    if (alone && control_.cycle.steps == 2 && shape.open && shape.sectors == 1 &&
        around.zone.size < edge_)
      return all_sources([&](const SectorPoint& p) {
        return (p.x <= side && p.y <= side) || (p.x * p.y == 0 && p.x + p.y <= 2 * side);
      });
    if (around.zone.size > 0 && 2 * around.zone.size + edge_ > side) return false;
    // neighbours see one another's control vertices, and no more (read_near)
    return all_sources([&](const SectorPoint& p) {
      const Index far = ring_of(lattice_, p.x, p.y);
      return far < side || (alone && far == side);
    });
  }

  /// Where control vertices are neighbours: whether they do without each other's surroundings. The
  /// sums are read again where all that is beyond the neighbours is cut off.
  Known read_near() {
    if (n_ > 1 || control_.cycle.offset) return true;
    if (control_.lone && index_ > 0) return false;  // its centre is in three zones
    if (is_near()) return true;
    for (const auto& [lattice, sectors, open, offset] : control_.kinds) {
      if (sectors == 0) continue;
      std::vector<LimitForms> read;
      for (const Index rings : {reach_ + kRim, Index{1}}) {
        const Mesh near =
            open ? mesh::fan(lattice_, sectors, rings) : mesh::star(lattice_, sectors, rings);
        auto limit = reader_.read(near, steps_made_ - index_, !open, {0});
        if (!limit || !limit->front()) return false;
        for (Form& form : *limit->front()) drop_rounding(form);
        read.push_back(*limit->front());
      }
      if (!same_limit(read[0], read[1])) return false;
    }
    return true;
  }

  const LimitControl& control_;
  LatticeStep step_;
  Index n_, side_;  // edges, and steps, of a patch
  int index_;       // of the step in its cycle
  Lattice lattice_;
  Index edge_;  // steps of an edge of the level's grid
  int steps_made_;
  LimitReader& reader_;
  Index inner_ = 1, outer_ = 1;               // regular_rings
  Index reach_ = 1;                           // edges that a regular vertex's sums reach
  Index chain_rings_ = 1;                     // the most of a LimitChain
  std::map<Index, LimitStencils> side_rows_;  // by row
  LimitStencils interior_;
  StencilTables tables_;
};

}  // namespace

Result<std::optional<StencilTables>> read_limit_tables(const LimitControl& control, int level,
                                                       int steps_made, LimitReader& reader) {
  return LimitTableMaker(control, level, steps_made, reader).make();
}

}  // namespace limn::fast
