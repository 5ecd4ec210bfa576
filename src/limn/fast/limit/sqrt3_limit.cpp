#include "limn/fast/limit/sqrt3_limit.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "limn/fast/layout/sqrt3_patches.h"
#include "limn/fast/limit/sqrt3_limit_site.h"
#include "limn/fast/sites/sqrt3_tables.h"
#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

using Form = LinearForm<double>;

constexpr Index kEdge = LimitSite::kEdge, kRim = LimitSite::kRim;
// Rings round a vertex that are read, if need be more of them, and rows along a side. Those of the
// last edge must not differ.
constexpr Index kFewest = 2 * kEdge, kMost = 4 * kEdge;
constexpr Index kWidest = 4;  // edges that sums may reach

/// Old points for number_points (zones.h), also past the ends of boundary sides, along the
/// boundary.
struct SidePoints {
  const Sqrt3Level& level;
  [[nodiscard]] Index n() const { return level.side(); }
  [[nodiscard]] Index point(Index h, Index x, Index y) const {
    const Mesh& mesh = level.odd.control();
    if (x == 0 && y > n()) return point(mesh.prev(h), n() - y, 0);
    if (y == 0 && x < 0) return level.old_point(before(mesh, h), x + n(), 0);
    if (y == 0 && x > n()) return level.old_point(after(mesh, h), x - n(), 0);
    return level.old_point(h, x, y);
  }
  [[nodiscard]] Index point_along(EdgeCode code, Index x) const {
    return Sqrt3OldPoints{level}.point_along(code, x);
  }

 private:
  /// Of boundary half-edges.
  static Index before(const Mesh& mesh, Index h) {
    for (Index next = mesh.rotate(h); next != kNone; next = mesh.rotate(h)) h = next;
    return mesh.prev(h);
  }
  static Index after(const Mesh& mesh, Index h) {
    h = mesh.next(h);
    while (mesh.twin(h) != kNone) h = mesh.next(mesh.twin(h));
    return h;
  }
};

class LimitPlanner {
 public:
  LimitPlanner(const Sqrt3Control& control, int level, LimitReader& reader)
      : control_(control), level_(control.mesh, level), reader_(reader) {}

  Result<std::optional<StepPlan>> make() {
    using Found = std::optional<StepPlan>;
    for (const auto read : {&LimitPlanner::read_plane, &LimitPlanner::read_sides,
                            &LimitPlanner::read_kinds, &LimitPlanner::read_near}) {
      const Result<bool> found = (this->*read)();
      // a coarse mesh may have no regular vertex to fail at
      if (!found && level_.side() > kEdge) return found.error();
      if (!found || !*found) return Found();
    }
    return Found(plan());
  }

 private:
  using Known = Result<bool>;  // whether there are sums that can be used
  /// Limits at a vertex of some kind, and up to so many rings round it.
  struct Zone {
    Index size = 0;
    ZoneTable table;
  };

  /// On which points are read up to `seen` rings.
  [[nodiscard]] LimitSite site(Index sectors, bool open, Index seen) const {
    return {control_.split, level_.step, sectors, open, seen / kEdge + reach_ + kRim};
  }

  Known read_plane() {
    const LimitSite plane = site(6, false, 0);
    const auto read = plane.read(reader_, {SectorPoint{}});
    if (!read) return read.error();
    if (!*read) return false;
    interior_ = plane.on_plane_from((*read)->front(), {});
    Index far = 0;
    for (const Form& form : (*read)->front())
      for (const auto& [vertex, weight] : form.terms) far = std::max(far, plane.ring(vertex));
    reach_ = (far + kEdge - 1) / kEdge;
    return true;
  }

  /// Along a straight boundary.
  Known read_sides() {
    constexpr Index kFar = 3 * kEdge;  // from the middle vertex, so that sums stay in two sectors
    if (control_.sides.empty()) return true;
    const LimitSite straight = site(3, true, kFar + kMost);
    std::vector<SectorPoint> points;
    for (Index y = 0; y <= kMost; ++y)
      if (is_old(level_.step, kFar + y % 3, y)) points.push_back({0, kFar + y % 3, y});
    const auto read = straight.read(reader_, points);
    if (!read) return read.error();
    if (!*read) return false;
    std::map<Index, LimitStencils> rows;
    Index depth = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [sector, x, y] = points[i];
      rows[y] = straight.on_plane_from((**read)[i], {x, y});
      const auto regular = straight.shifted(interior_, points[i]);
      if (y > 0 && !(regular && same_limit((**read)[i], *regular))) depth = y;
    }
    if (depth > kMost - kEdge) return false;
    for (auto& [y, sums] : rows)
      if (y <= depth) sides_.emplace(y, std::move(sums));
    return true;
  }

  Known read_kinds() {
    for (const ZoneGroup& group : control_.groups) {
      const bool open = group.kind.open;
      const Index sectors = group.kind.faces;
      if (sectors == 0) continue;
      Zone& zone = zones_[open ? 1 : 0][sectors];
      Known found = read_zone(sectors, open, kFewest, zone);
      if (found && *found && zone.size > kFewest - kEdge)
        found = read_zone(sectors, open, kMost, zone);
      if (!found || !*found) return found;
      if (zone.size > kMost - kEdge || !fits(group.kind, zone)) return false;
    }
    return true;
  }

  /// The old points up to a ring, the middle first; or those of sector 0 alone.
  [[nodiscard]] std::vector<SectorPoint> points_round(Index sectors, bool open, Index ring) const {
    std::vector<SectorPoint> points{{}};
    for (Index s = 0; s < sectors; ++s)
      for (Index x = 1; x <= ring; ++x)
        for (Index y = 0; x + y <= ring; ++y)
          if (is_old(level_.step, x, y)) points.push_back({s, x, y});
    for (Index y = 1; open && y <= ring; ++y)  // the last spoke
      if (is_old(level_.step, 0, y)) points.push_back({sectors - 1, 0, y});
    return points;
  }

  Known read_zone(Index sectors, bool open, Index seen, Zone& zone) {
    const LimitSite star = site(sectors, open, seen);
    // the sectors of a star are alike
    std::vector<SectorPoint> points = points_round(open ? sectors : 1, open, seen);
    auto read = star.read(reader_, points);
    if (!read) return read.error();
    if (!*read) return false;
    zone.size = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto expected = usual(star, points[i], open ? sectors - 1 : kNone);
      if (!expected || !same_limit((**read)[i], *expected))
        zone.size = std::max(zone.size, points[i].x + points[i].y);
    }
    if (zone.size > 0 && !open) {
      points = points_round(sectors, open, zone.size);
      read = star.read(reader_, points);
      if (!read) return read.error();
      if (!*read) return false;
    }
    std::vector<Form> forms;
    std::vector<SectorPoint> targets;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].x + points[i].y > zone.size) continue;
      targets.push_back(points[i]);
      forms.insert(forms.end(), (**read)[i].begin(), (**read)[i].end());
    }
    zone.table = zone_table(forms, star.places(), sectors, std::move(targets));
    return true;
  }

  /// What patches and side rows make there; `last` is a fan's last sector.
  [[nodiscard]] std::optional<LimitForms> usual(const LimitSite& star, const SectorPoint& point,
                                                Index last) const {
    const auto& [sector, x, y] = point;
    const bool first_side = last != kNone && sector == 0 && x > 0 && sides_.contains(y);
    const bool last_side = last != kNone && sector == last && y > 0 && sides_.contains(x);
    if (first_side && last_side) return std::nullopt;
    if (first_side) return star.shifted(sides_.at(y), point, SideRow::first);
    if (last_side) return star.shifted(sides_.at(x), point, SideRow::last);
    return star.shifted(interior_, point);
  }

  /// Whether a zone ends, and its sums do, before another's begins.
  [[nodiscard]] bool fits(const VertexKind& kind, const Zone& zone) const {
    const Index side = level_.side();
    const bool alone = level_.n() == 1;
    if (alone && kind.open && kind.faces == 1 && zone.size < kEdge)  // its triangle's centroid
      return std::all_of(zone.table.sources.begin(), zone.table.sources.end(), [&](const auto& p) {
        // that across the triangle's third side, and the next vertices along the boundary
        return (p.x <= side && p.y <= side) || (p.x * p.y == 0 && p.x + p.y <= 2 * side);
      });
    if (2 * zone.size + kEdge > side) return false;
    // neighbours see one another's control vertices, and no more (read_near)
    return std::all_of(zone.table.sources.begin(), zone.table.sources.end(), [&](const auto& p) {
      return p.x + p.y < side || (alone && p.x + p.y == side);
    });
  }

  /// Where control vertices are neighbours: whether they do without each other's surroundings. The
  /// sums are read again where all that is beyond the neighbours is cut off.
  Known read_near() {
    if (level_.n() > 1) return true;
    const Mesh& mesh = control_.mesh;
    const bool lone = std::any_of(control_.sides.begin(), control_.sides.end(), [&](Index h) {
      return mesh.twin(mesh.next(h)) == kNone && mesh.twin(mesh.prev(h)) == kNone;
    });
    if (lone && level_.step == Sqrt3Step::thirds) return false;  // its centroid is in three zones
    for (const ZoneGroup& group : control_.groups) {
      const bool open = group.kind.open;
      const Index sectors = group.kind.faces;
      if (sectors == 0) continue;
      std::vector<LimitForms> read;
      for (const Index rings : {reach_ + kRim, Index{1}}) {
        const Mesh near =
            open ? fan(Lattice::triangle, sectors, rings) : star(Lattice::triangle, sectors, rings);
        auto limit = reader_.read(near, 0, !open, {0});
        if (!limit || !limit->front()) return false;
        for (Form& form : *limit->front()) drop_rounding(form);
        read.push_back(*limit->front());
      }
      if (!same_limit(read[0], read[1])) return false;
    }
    return true;
  }

  StepPlan plan() {
    StepPlan plan;
    std::vector<Stencil> local(interior_.begin(), interior_.end());
    for (Stencil& stencil : local) {
      for (Tap& tap : stencil) tap.place = to_local(level_.step, tap.place);
      std::sort(stencil.begin(), stencil.end(),
                [](const Tap& p, const Tap& q) { return p.place < q.place; });
    }
    plan.patches =
        plan_sqrt3_patches(level_, std::move(local), control_.faces, Sqrt3Made::same_level);
    for (const auto& [y, sums] : sides_) add_side_row(y, sums, plan.rows);
    const SidePoints points{level_};
    for (const ZoneGroup& group : control_.groups) {
      const bool open = group.kind.open;
      const Index sectors = group.kind.faces;
      const ZoneTable& table = sectors == 0 ? isolated() : zones_[open ? 1 : 0].at(sectors).table;
      plan.rows.push_back(zone_rows(table, group, points, points, false));
    }
    return plan;
  }

  /// The points in row y of boundary sides but for those in zones.
  void add_side_row(Index y, const LimitStencils& sums, std::vector<RowPlan>& plans) const {
    auto [table, places] = limit_rows(sums);
    const Mesh& mesh = control_.mesh;
    const auto zone_of = [&](Index v) { return zones_[1].at(mesh.valence(v) - 1).size; };
    std::vector<Index> sources, targets;
    const SidePoints points{level_};
    const Index side = level_.side();
    for (const Index h : control_.sides) {
      const Index left = zone_of(mesh.origin(h)), right = zone_of(mesh.target(h));
      for (Index x = 1; x + y < side; ++x) {
        if (!is_old(level_.step, x, y) || x + y <= left || side - x <= right) continue;
        for (const Offset& place : places) {
          sources.push_back(points.point(h, x + place.a, y + place.b));
          assert(sources.back() != kNone);
        }
        targets.push_back(level_.old_point(h, x, y));
      }
    }
    if (!targets.empty())
      plans.push_back(
          {std::move(table), HugeArray<Index>(sources), HugeArray<Index>(targets), false});
  }

  /// It stays, without tangents.
  static const ZoneTable& isolated() {
    static const ZoneTable table{0, {SectorPoint{}}, {SectorPoint{}}, isolated_limit_rows()};
    return table;
  }

  const Sqrt3Control& control_;
  Sqrt3Level level_;
  LimitReader& reader_;
  Index reach_ = kWidest;  // edges that a regular vertex's sums reach
  LimitStencils interior_;
  std::map<Index, LimitStencils> sides_;        // by row
  std::array<std::map<Index, Zone>, 2> zones_;  // of interior, boundary vertices, by faces
};

}  // namespace

Result<std::optional<StepPlan>> plan_sqrt3_limit(const Sqrt3Control& control, int level,
                                                 LimitReader& reader) {
  return LimitPlanner(control, level, reader).make();
}

}  // namespace limn::fast
