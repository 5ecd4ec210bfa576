#include "limn/fast/sites/sharp_steps.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <unordered_map>

#include "limn/mesh/index.h"

namespace limn::fast {
namespace {

using mesh::at;

/// Whether a crease or the boundary lies on the edge of h.
bool cuts(const Mesh& mesh, const Sharpness& sharpness, Index h) {
  return sharpness_of_edge(mesh, sharpness, mesh.edge(h)) > 0;
}

/// How sharp places are in one step, as numbers: equal ones are alike.
class Classes {
 public:
  enum : char16_t { smooth = 0, stays = 1, first_that_ends = 2 };

  char16_t of(double sharpness) {
    const double here = in_one_step(sharpness);
    if (!(here > 0)) return smooth;
    if (here >= kInfinitelySharp) return stays;
    const auto place = std::find(ends_.begin(), ends_.end(), here) - ends_.begin();
    if (place == std::ssize(ends_)) ends_.push_back(here);
    return static_cast<char16_t>(first_that_ends + place);
  }
  [[nodiscard]] double value(char16_t number) const {
    if (number < first_that_ends) return number == stays ? kInfinitelySharp : 0;
    return ends_[number - first_that_ends];
  }
  /// What ends where nothing else does is as though it stayed, if it is sharp for the whole step.
  [[nodiscard]] bool is_whole(char16_t number) const {
    return number < first_that_ends || value(number) == kWholeStep;
  }
  /// Whether numbers do not go as far.
  [[nodiscard]] bool too_many() const { return ends_.size() > 60000; }

 private:
  std::vector<double> ends_;
};

/// What is sharp at a control vertex, by classes: of itself, then of its spokes.
using Key = std::u16string;

/// The key turned so that of those that turning leads to it is the greatest; returns by how many
/// spokes.
std::size_t turn(Key& key) {
  const std::size_t spokes = key.size() - 1;
  const auto spoke = [&](std::size_t from, std::size_t i) { return key[1 + (from + i) % spokes]; };
  std::size_t best = 0;
  for (std::size_t from = 1; from < spokes; ++from)
    for (std::size_t i = 0; i < spokes; ++i) {
      const char16_t here = spoke(from, i), there = spoke(best, i);
      if (here == there) continue;
      if (here > there) best = from;
      break;
    }
  std::rotate(key.begin() + 1, key.begin() + 1 + static_cast<std::ptrdiff_t>(best), key.end());
  return best;
}

/// The zones of a side's ends; a point on the side is in those of either side of it.
class EndZones {
 public:
  EndZones(const Reach& reach, const Mesh& mesh, const Sharpness& sharpness, Index h)
      : lattice_(plane_lattice(mesh)) {
    own_ = ends(reach, mesh, sharpness, h);
    other_ = ends(reach, mesh, sharpness, mesh.twin(h));
    std::swap(other_[0], other_[1]);
  }

  /// Whether they have the point (x, y) of a side's frame, on its left.
  [[nodiscard]] bool have(Index side, Index x, Index y) const {
    const Index back = mirrored(lattice_, side, x, y);
    if (own_[0]->has(x, y) || own_[1]->has(y, back)) return true;
    return y == 0 && (other_[0]->has(x, 0) || other_[1]->has(back, 0));
  }

 private:
  using Two = std::array<const Zone*, 2>;
  static Lattice plane_lattice(const Mesh& mesh) {
    return mesh.uniform_degree() == 3 ? Lattice::triangle : Lattice::quad;
  }
  static Two ends(const Reach& reach, const Mesh& mesh, const Sharpness& sharpness, Index h) {
    return {&zone_between(reach, true, cuts(mesh, sharpness, mesh.prev(h))),
            &zone_between(reach, true, cuts(mesh, sharpness, mesh.next(h)))};
  }

  Lattice lattice_;
  Two own_, other_;
};

/// The old points that a row weighs, of a side's point (x, y); `code` is the side's. Beyond the
/// side they are given in the frame of the half-edge there.
void add_sources(const GridLayout& layout, Index h, EdgeCode code, const SideRow& row, Index x,
                 std::vector<Index>& sources) {
  const Mesh& mesh = layout.control();
  for (const Offset& place : row.sources) {
    const Index a = x + place.a, b = row.y + place.b;
    if (b == 0 && 0 <= a && a <= layout.side())  // most are so
      sources.push_back(a == 0               ? mesh.origin(h)
                        : a == layout.side() ? mesh.target(h)
                                             : layout.point_along(code, a / layout.unit()));
    else if (b >= 0)
      sources.push_back(layout.point_beyond(h, a, b));
    else
      sources.push_back(layout.point_beyond(mesh.twin(h), layout.side() - a, -b));
    assert(sources.back() != kNone);
  }
}

}  // namespace

BoundarySides sharp_sides(const Mesh& control, const Sharpness& sharpness) {
  BoundarySides sides = boundary_sides(control);
  if (!sharpness.any()) return sides;
  for (Index f = 0; f < control.face_count(); ++f) {
    unsigned fixed = 0, all = 0;
    for (Index h = control.face_begin(f), k = 0; h < control.face_begin(f + 1); ++h, ++k) {
      const unsigned bit = 1U << static_cast<unsigned>(k);
      if (control.twin(h) == kNone) fixed |= bit;
      if (cuts(control, sharpness, h)) all |= bit;
    }
    sides[fixed] = true;
    for (unsigned mask = 0; all != fixed && mask < sides.size(); ++mask)
      if ((mask & fixed) == fixed && (mask & ~all) == 0) sides[mask] = true;
  }
  // a single sharp vertex, too, is seen from a boundary's rules
  sides[1] = true;
  return sides;
}

Sharpness after_steps(Sharpness sharpness, int steps) {
  for (; steps > 0; --steps)
    for (std::vector<double>* list : {&sharpness.edges, &sharpness.vertices})
      for (double& s : *list) s = after_step(s);
  return sharpness;
}

class SharpSteps::Maker {
 public:
  Maker(const Scheme& scheme, const GridCycle& cycle, const StencilTables& tables,
        const Mesh& control, const std::vector<ZoneGroup>& groups)
      : mesh_(control), groups_(groups), read_(scheme, cycle, tables) {}

  /// Finds the places where something is sharp: later there are no others.
  void find_places(const Sharpness& sharpness) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const ZoneGroup& group = groups_[g];
      const auto sectors = at(group.kind.sectors);
      for (std::size_t i = 0; i < group.vertices.size() && sectors > 0; ++i) {
        bool sharp = !sharpness.vertices.empty() && sharpness.vertices[at(group.vertices[i])] > 0;
        for (std::size_t k = i * sectors; k < (i + 1) * sectors; ++k)
          sharp = sharp || sharpness.edges[at(group.codes[k] >> 1)] > 0;
        if (sharp) places_.push_back({g, i});
      }
    }
    edges_.assign(sharpness.edges.size(), Classes::smooth);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (sharpness.edges[e] > 0) sharp_edges_.push_back(static_cast<Index>(e));
  }

  Result<Level> make(Sharpness sharpness) {
    Level level;
    level.sharpness = std::move(sharpness);
    Classes classes;
    for (const Index e : sharp_edges_) edges_[at(e)] = classes.of(level.sharpness.edges[at(e)]);
    if (Status status = find_strips(classes, level); !status) return status.error();
    if (Status status = find_zones(classes, level); !status) return status.error();
    return level;
  }

 private:
  /// A vertex of a group.
  struct Place {
    std::size_t group = 0, index = 0;
  };

  Status find_strips(const Classes& classes, Level& level) {
    std::map<double, std::vector<Index>> sides;
    for (const Index e : sharp_edges_) {
      const char16_t number = edges_[at(e)];
      if (number == Classes::smooth) continue;
      sides[classes.is_whole(number) ? kInfinitelySharp : classes.value(number)].push_back(
          mesh_.halfedge_of_edge(e));
    }
    for (auto& [sharp, list] : sides) {
      const auto rows = read_.strip(sharp);
      if (!rows) return rows.error();
      level.strips.push_back({**rows, std::move(list)});
    }
    return Done{};
  }

  Status find_zones(Classes& classes, Level& level) {
    std::array<std::unordered_map<Key, std::size_t>, 2> zones_of;  // closed, open
    Key key;
    for (const Place& place : places_) {
      const ZoneGroup& group = groups_[place.group];
      const bool open = group.kind.open;
      if (!find_key(level.sharpness, place, classes, key)) continue;
      const std::size_t turned = open ? 0 : turn(key);
      const auto [found, fresh] = zones_of[open ? 1 : 0].try_emplace(key, level.zones.size());
      if (fresh) {
        SharpPattern pattern{open, classes.value(key[0]), {}};
        for (std::size_t s = 1; s < key.size(); ++s)
          pattern.spokes.push_back(classes.value(key[s]));
        const auto table = read_.zone(pattern);
        if (!table) return table.error();
        level.zones.push_back({**table, {group.kind, {}, {}, {}, {}}});
      }
      Zones& zones = level.zones[found->second];
      if (!zones.table.targets.empty()) add(place, turned, zones.group);
    }
    if (classes.too_many()) return Error{"too many kinds of sharpness for tables"};
    std::erase_if(level.zones, [](const Zones& zones) { return zones.group.vertices.empty(); });
    return Done{};
  }

  /// False where nothing is sharp any more.
  bool find_key(const Sharpness& sharpness, const Place& place, Classes& classes, Key& key) const {
    const ZoneGroup& group = groups_[place.group];
    const auto sectors = at(group.kind.sectors);
    const Index v = group.vertices[place.index];
    key.clear();
    key.push_back(sharpness.vertices.empty() ? char16_t{Classes::smooth}
                                             : classes.of(sharpness.vertices[at(v)]));
    for (std::size_t k = place.index * sectors; k < (place.index + 1) * sectors; ++k)
      key.push_back(edges_[at(group.codes[k] >> 1)]);
    const auto is_whole = [&](char16_t number) { return classes.is_whole(number); };
    if (std::all_of(key.begin(), key.end(), is_whole))
      for (char16_t& number : key) number = std::min<char16_t>(number, Classes::stays);
    return std::any_of(key.begin(), key.end(), [](char16_t number) { return number > 0; });
  }

  void add(const Place& place, std::size_t turned, ZoneGroup& to) const {
    const ZoneGroup& group = groups_[place.group];
    const auto sectors = at(group.kind.sectors);
    to.vertices.push_back(group.vertices[place.index]);
    for (std::size_t s = 0; s < sectors; ++s) {
      const std::size_t k = place.index * sectors + (s + turned) % sectors;
      to.sectors.push_back(group.sectors[k]);
      to.codes.push_back(group.codes[k]);
      to.ends.push_back(group.ends[k]);
    }
  }

  const Mesh& mesh_;
  const std::vector<ZoneGroup>& groups_;
  SharpTables read_;
  std::vector<Place> places_;
  std::vector<Index> sharp_edges_;  // the same of edges
  std::vector<char16_t> edges_;     // classes of all edges at the level
};

Result<SharpSteps> SharpSteps::make(const Scheme& scheme, const GridCycle& cycle,
                                    const StencilTables& tables, const Mesh& control,
                                    const std::vector<ZoneGroup>& groups,
                                    const Sharpness& sharpness, int first, int last) {
  SharpSteps steps(tables.reach, control, first);
  Maker maker(scheme, cycle, tables, control, groups);
  Sharpness left{sharpness.edges, sharpness.vertices, {}, {}};
  left.edges.resize(at(control.edge_count()), 0);
  for (Index e = 0; e < control.edge_count(); ++e)
    if (control.is_boundary_edge(e)) left.edges[at(e)] = 0;  // these are no creases
  left = after_steps(std::move(left), first);
  maker.find_places(left);
  for (int level = first; level < last && left.any(); ++level) {
    Sharpness next = after_steps(left, 1);
    Result<Level> made = maker.make(std::move(left));
    if (!made) return made.error();
    steps.levels_.push_back(*std::move(made));
    left = std::move(next);
  }
  return steps;
}

void SharpSteps::add_rows(int level, const GridLayout& old_points, const GridLayout& new_points,
                          std::vector<RowPlan>& plans) const {
  const auto index = at(level - first_);
  if (index >= levels_.size()) return;
  const Level& of = levels_[index];
  for (const Strips& strips : of.strips)
    for (const SideRow& row : strips.rows) {
      SideRows made;
      for (const Index h : strips.sides) {
        add_side(of, row, h, old_points, new_points, made);
        if (row.y > 0) add_side(of, row, control_->twin(h), old_points, new_points, made);
      }
      if (!made.targets.empty())
        plans.push_back({row.table, base::HugeArray<Index>(made.sources),
                         base::HugeArray<Index>(made.targets), false});
    }
  const bool overlap = reach_.zones_meet(new_points.side());
  for (const Zones& zones : of.zones)
    plans.push_back(zone_rows(zones.table, zones.group, old_points, new_points, overlap));
}

void SharpSteps::add_side(const Level& of, const SideRow& row, Index h,
                          const GridLayout& old_points, const GridLayout& new_points,
                          SideRows& made) const {
  const Index side = new_points.side();
  const EdgeCode code = edge_code(*control_, h);
  std::optional<EndZones> ends;
  if (std::max(reach_.fan_zone.size, reach_.corner_zone.size) > 0)
    ends.emplace(reach_, *control_, of.sharpness, h);
  for (Index x = row.phase; mirrored(new_points.lattice(), side, x, row.y) > 0; x += row.period) {
    if (x == 0 || (ends && ends->have(side, x, row.y))) continue;
    add_sources(old_points, h, code, row, x, made.sources);
    made.targets.push_back(row.y == 0 ? new_points.point_along(code, x)
                                      : new_points.point(h, x, row.y));
  }
}

}  // namespace limn::fast
