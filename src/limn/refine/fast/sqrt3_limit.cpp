#include "limn/refine/fast/sqrt3_limit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "limn/mesh/lattice.h"
#include "limn/refine/fast/sqrt3_patches.h"
#include "limn/refine/fast/sqrt3_tables.h"

namespace limn::fast {
namespace {

using Form = LinearForm<double>;
using Sums = std::array<Stencil, 3>;  // position and two tangents, in thirds from their point

constexpr Index kEdge = 3;  // a grid edge, in thirds
// Rings round a vertex that are read, if need be more of them, and rows along a side. Those of the
// last edge must not differ.
constexpr Index kFewest = 2 * kEdge, kMost = 4 * kEdge;
constexpr Index kRim = 2;     // edges from a rim that sums must not come to
constexpr Index kWidest = 4;  // edges that sums may reach

/// Less of a weight comes from the rounding of eigenvectors.
double unit_of(const Form& form) {
  double largest = 0;
  for (const auto& [vertex, weight] : form.terms) largest = std::max(largest, std::abs(weight));
  return std::ldexp(largest, -42);
}

void clean(Form& form) {
  const double unit = unit_of(form);
  std::erase_if(form.terms, [&](const auto& term) { return std::abs(term.second) <= unit; });
}

double product(const Form& a, const Form& b) {
  double sum = 0;
  for (const auto& [vertex, weight] : a.terms) sum += weight * b.coefficient(vertex);
  return sum;
}

/// That a sum is x·u + y·v but for rounding.
bool is_combination(Form sum, double x, const Form& u, double y, const Form& v) {
  const double size = product(sum, sum);
  add_scaled(sum, -x, u);
  add_scaled(sum, -y, v);
  return product(sum, sum) <= 1e-20 * size;
}

/// The same positions and normals, whatever the tangents.
bool same_limit(const LimitForms& p, const LimitForms& q) {
  if (!is_combination(p[0], 1, q[0], 0, q[0])) return false;
  const double uu = product(q[1], q[1]), uv = product(q[1], q[2]), vv = product(q[2], q[2]);
  const double area = uu * vv - uv * uv;
  if (area <= 1e-12 * uu * vv) return false;
  std::array<std::array<double, 2>, 2> turn{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double u = product(p[i + 1], q[1]), v = product(p[i + 1], q[2]);
    turn[i] = {(u * vv - v * uv) / area, (v * uu - u * uv) / area};
    if (!is_combination(p[i + 1], turn[i][0], q[1], turn[i][1], q[2])) return false;
  }
  return turn[0][0] * turn[1][1] - turn[0][1] * turn[1][0] > 0;
}

/// A star or fan at one kind of level.
class LimitSite {
 public:
  /// Of so many rings of edges.
  LimitSite(const Split& split, Sqrt3Step step, Index sectors, bool open, Index rings)
      : step_(step),
        sectors_(sectors),
        open_(open),
        rings_(rings),
        site_(split, sectors, open, rings_) {}

  [[nodiscard]] const Sqrt3Site& places() const { return site_; }

  /// Nothing where a point has no sums, or they come near the rim.
  [[nodiscard]] Result<std::optional<std::vector<LimitForms>>> read(
      LimitReader& reader, const std::vector<SectorPoint>& points) const {
    using Found = std::optional<std::vector<LimitForms>>;
    std::vector<Index> vertices;
    vertices.reserve(points.size());
    for (const SectorPoint& point : points) vertices.push_back(site_.vertex(point));
    const int steps_made = step_ == Sqrt3Step::centroids ? 0 : 1;
    auto read = reader.read(site_.mesh(step_), steps_made, !open_, vertices);
    if (!read) return read.error();
    Found forms(std::in_place);
    for (std::optional<LimitForms>& limit : *read) {
      if (!limit) return Found();
      for (Form& form : *limit) {
        clean(form);
        for (const auto& [vertex, weight] : form.terms)
          if (ring(vertex) > kEdge * (rings_ - kRim)) return Found();
      }
      forms->push_back(std::move(*limit));
    }
    return forms;
  }

  /// How many thirds a vertex lies from the middle one.
  [[nodiscard]] Index ring(Index vertex) const {
    return site_.place(vertex).x + site_.place(vertex).y;
  }

  /// The sums at a point, in the frame of its sector; or (`last`) in the frame of a fan's last
  /// spoke, which leads to the middle. Nothing where they look past a sector that is next to it.
  [[nodiscard]] std::optional<LimitForms> shifted(const Sums& sums, const SectorPoint& point,
                                                  bool last = false) const {
    LimitForms forms;
    for (std::size_t i = 0; i < forms.size(); ++i)
      for (const auto& [step, weight] : sums[i]) {
        const Offset turned = last ? Offset{step.b, -step.a - step.b} : step;
        const auto at = beyond({point.sector, point.x + turned.a, point.y + turned.b});
        if (!at) return std::nullopt;
        add_scaled(forms[i], weight, Form::unit(site_.vertex(*at)));
      }
    return forms;
  }

 private:
  /// A place in a sector's frame, in the sector that it is in: as TriangleLayout::point_beyond.
  [[nodiscard]] std::optional<SectorPoint> beyond(SectorPoint place) const {
    auto& [sector, x, y] = place;
    const Index turn = x < 0 ? 1 : y < 0 ? -1 : 0;
    if (turn != 0) {
      place = {sector + turn, turn > 0 ? x + y : -y, turn > 0 ? -x : x + y};
      if (open_ && (sector < 0 || sector >= sectors_)) return std::nullopt;
      sector = (sector + sectors_) % sectors_;
    }
    if (x < 0 || y < 0) return std::nullopt;
    return place;
  }

  Sqrt3Step step_;
  Index sectors_;
  bool open_;
  Index rings_;
  Sqrt3Site site_;
};

/// A point's sums on the plane, rounded: so those that symmetry makes equal are.
Sums on_plane_from(const LimitForms& forms, const LimitSite& site, Offset point) {
  Sums sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double unit = unit_of(forms[i]);
    for (const auto& [vertex, weight] : forms[i].terms) {
      const Offset at = on_plane(Lattice::triangle, site.places().place(vertex));
      sums[i].push_back({{at.a - point.a, at.b - point.b}, unit * std::round(weight / unit)});
    }
  }
  return sums;
}

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
    interior_ = on_plane_from((*read)->front(), plane, {});
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
    std::map<Index, Sums> rows;
    Index depth = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [sector, x, y] = points[i];
      rows[y] = on_plane_from((**read)[i], straight, {x, y});
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
      if (zone.size > kMost - kEdge || !fits(zone)) return false;
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
    if (first_side) return star.shifted(sides_.at(y), point);
    if (last_side) return star.shifted(sides_.at(x), point, true);
    return star.shifted(interior_, point);
  }

  /// Whether a zone ends, and its sums do, before another's begins.
  [[nodiscard]] bool fits(const Zone& zone) const {
    if (2 * zone.size + kEdge > level_.side()) return false;
    // neighbours see one another's control vertices, and no more (read_near)
    const Index most = level_.n() == 1 ? level_.side() : level_.side() - 1;
    return std::all_of(zone.table.sources.begin(), zone.table.sources.end(),
                       [&](const SectorPoint& p) { return p.x + p.y <= most; });
  }

  /// Where control vertices are neighbours: whether they do without each other's surroundings. The
  /// sums are read again where all that is beyond the neighbours is cut off.
  Known read_near() {
    if (level_.n() > 1) return true;
    for (const ZoneGroup& group : control_.groups) {
      const bool open = group.kind.open;
      const Index sectors = group.kind.faces;
      if (sectors == 0) continue;
      std::vector<LimitForms> read;
      for (const Index rings : {reach_ + kRim, Index{1}}) {
        const Mesh mesh =
            open ? fan(Lattice::triangle, sectors, rings) : star(Lattice::triangle, sectors, rings);
        auto limit = reader_.read(mesh, 0, !open, {0});
        if (!limit || !limit->front()) return false;
        for (Form& form : *limit->front()) clean(form);
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
    const Sqrt3OldPoints points{level_};
    for (const ZoneGroup& group : control_.groups) {
      const bool open = group.kind.open;
      const Index sectors = group.kind.faces;
      const ZoneTable& table = sectors == 0 ? isolated() : zones_[open ? 1 : 0].at(sectors).table;
      plan.rows.push_back({table.rows, number_points(group, points, table.sources),
                           number_points(group, points, table.targets), false});
    }
    return plan;
  }

  /// The points in row y of boundary sides but for those in zones.
  void add_side_row(Index y, const Sums& sums, std::vector<RowPlan>& plans) const {
    std::map<Offset, int> slots;
    for (const Stencil& stencil : sums)
      for (const Tap& tap : stencil) slots.emplace(tap.place, 0);
    RowTable table;
    for (auto& [place, slot] : slots) slot = table.sources++;
    for (const Stencil& stencil : sums) {
      for (const Tap& tap : stencil) table.terms.push_back({slots.at(tap.place), tap.weight});
      table.row_begin.push_back(static_cast<int>(table.terms.size()));
    }
    const Mesh& mesh = control_.mesh;
    const auto zone_of = [&](Index v) { return zones_[1].at(mesh.valence(v) - 1).size; };
    std::vector<Index> sources, targets;
    const Index side = level_.side();
    for (const Index h : control_.sides) {
      const Index left = zone_of(mesh.origin(h)), right = zone_of(mesh.target(h));
      for (Index x = 1; x + y < side; ++x) {
        if (!is_old(level_.step, x, y) || x + y <= left || side - x <= right) continue;
        for (const auto& [place, slot] : slots) {
          sources.push_back(level_.old_point(h, x + place.a, y + place.b));
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
    static const ZoneTable table{
        0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1, 1, 1}, {{0, 1.0}}}};
    return table;
  }

  const Sqrt3Control& control_;
  Sqrt3Level level_;
  LimitReader& reader_;
  Index reach_ = kWidest;  // edges that a regular vertex's sums reach
  Sums interior_;
  std::map<Index, Sums> sides_;                 // by row
  std::array<std::map<Index, Zone>, 2> zones_;  // of interior, boundary vertices, by faces
};

}  // namespace

Result<std::optional<StepPlan>> plan_sqrt3_limit(const Sqrt3Control& control, int level,
                                                 LimitReader& reader) {
  return LimitPlanner(control, level, reader).make();
}

}  // namespace limn::fast
