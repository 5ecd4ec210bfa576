#include "limn/fast/sites/sharp_steps.h"

#include <algorithm>
#include <cassert>

namespace limn::fast {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether a crease or the boundary lies on the edge of h.
bool cuts(const Mesh& mesh, const Sharpness& sharpness, Index h) {
  return sharpness_of_edge(mesh, sharpness, mesh.edge(h)) > 0;
}

/// The pattern turned so that of those that turning leads to it is the greatest; returns by how
/// many spokes.
std::size_t turn(SharpPattern& pattern) {
  if (pattern.open) return 0;
  const std::vector<double> spokes = pattern.spokes;
  std::vector<double> turned = spokes;
  std::size_t best = 0;
  for (std::size_t k = 1; k < spokes.size(); ++k) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (turned <= pattern.spokes) continue;
    pattern.spokes = turned;
    best = k;
  }
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

/// The old points that a row weighs, of a side's point (x, y). Beyond the side they are given in
/// the frame of the half-edge there.
void add_sources(const GridLayout& layout, Index h, const SideRow& row, Index x,
                 std::vector<Index>& sources) {
  const Mesh& mesh = layout.control();
  for (const Offset& place : row.sources) {
    const Index a = x + place.a, b = row.y + place.b;
    sources.push_back(b >= 0 ? layout.point_beyond(h, a, b)
                             : layout.point_beyond(mesh.twin(h), layout.side() - a, -b));
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
    for (unsigned mask = 0; mask < sides.size(); ++mask)
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
        const Mesh& control)
      : lattice_(cycle.lattice),
        reach_(tables.reach),
        mesh_(control),
        read_(scheme, cycle, tables) {}

  Result<Level> make(Sharpness sharpness) {
    Level level;
    level.sharpness = std::move(sharpness);
    if (Status status = find_strips(level); !status) return status.error();
    if (Status status = find_zones(level); !status) return status.error();
    return level;
  }

 private:
  Status find_strips(Level& level) {
    std::map<double, std::vector<Index>> sides;
    touched_.assign(at(mesh_.vertex_count()), false);
    for (Index e = 0; e < std::ssize(level.sharpness.edges); ++e) {
      const Index h = mesh_.halfedge_of_edge(e), twin = mesh_.twin(h);
      const double sharp = level.sharpness.edges[at(e)];
      if (twin == kNone || !(sharp > 0)) continue;
      touched_[at(mesh_.origin(h))] = touched_[at(mesh_.target(h))] = true;
      std::vector<Index>& list = sides[in_one_step(sharp)];
      list.push_back(h);
      list.push_back(twin);
    }
    for (auto& [sharp, list] : sides) {
      const auto rows = read_.strip(sharp);
      if (!rows) return rows.error();
      level.strips.push_back({**rows, std::move(list)});
    }
    return Done{};
  }

  Status find_zones(Level& level) {
    const std::vector<double>& own = level.sharpness.vertices;
    for (std::size_t v = 0; v < own.size(); ++v)
      if (own[v] > 0) touched_[v] = true;
    std::map<SharpPattern, std::size_t> group_of;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (!touched_[at(v)] || mesh_.is_isolated(v)) continue;
      SharpPattern pattern = pattern_at(level.sharpness, v);
      std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(turn(pattern)),
                  ring_.end());
      const auto [found, fresh] = group_of.try_emplace(std::move(pattern), level.zones.size());
      if (fresh) {
        const auto table = read_.zone(found->first);
        if (!table) return table.error();
        const StarShape kind{lattice_, static_cast<Index>(std::ssize(ring_)), found->first.open};
        level.zones.push_back({**table, {kind, {}, {}, {}, {}}});
      }
      Zones& zones = level.zones[found->second];
      if (!zones.table.targets.empty()) add(v, zones.group);
    }
    std::erase_if(level.zones, [](const Zones& zones) { return zones.group.vertices.empty(); });
    return Done{};
  }

  /// Fills ring_, too: with the half-edges out of v.
  SharpPattern pattern_at(const Sharpness& sharpness, Index v) {
    SharpPattern pattern;
    pattern.open = mesh_.is_boundary_vertex(v);
    if (!sharpness.vertices.empty()) pattern.own = in_one_step(sharpness.vertices[at(v)]);
    ring_.clear();
    const Index first = mesh_.halfedge_of_vertex(v);
    Index h = first;
    do {
      const Index e = mesh_.edge(h);
      const bool states = !sharpness.edges.empty() && !mesh_.is_boundary_edge(e);
      pattern.spokes.push_back(states ? in_one_step(sharpness.edges[at(e)]) : 0);
      ring_.push_back(h);
      h = mesh_.rotate(h);
    } while (h != first && h != kNone);
    return pattern;
  }

  void add(Index v, ZoneGroup& group) const {
    group.vertices.push_back(v);
    for (const Index h : ring_) {
      group.sectors.push_back(h);
      group.codes.push_back(edge_code(mesh_, h));
      group.ends.push_back(mesh_.target(h));
    }
  }

  Lattice lattice_;
  const Reach& reach_;
  const Mesh& mesh_;
  SharpTables read_;
  std::vector<bool> touched_;  // vertices where something is sharp
  std::vector<Index> ring_;
};

Result<SharpSteps> SharpSteps::make(const Scheme& scheme, const GridCycle& cycle,
                                    const StencilTables& tables, const Mesh& control,
                                    const Sharpness& sharpness, int first, int last) {
  SharpSteps steps(tables.reach, control, first);
  Maker maker(scheme, cycle, tables, control);
  Sharpness left = after_steps({sharpness.edges, sharpness.vertices, {}, {}}, first);
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
  const Index side = new_points.side();
  for (const Strips& strips : of.strips)
    for (const SideRow& row : strips.rows) {
      std::vector<Index> sources, targets;
      for (const Index h : strips.sides) {
        if (row.y == 0 && !leads(*control_, h)) continue;
        const EndZones ends(reach_, *control_, of.sharpness, h);
        for (Index x = row.phase; mirrored(new_points.lattice(), side, x, row.y) > 0;
             x += row.period) {
          if (x == 0 || ends.have(side, x, row.y)) continue;
          add_sources(old_points, h, row, x, sources);
          targets.push_back(new_points.point(h, x, row.y));
        }
      }
      if (!targets.empty())
        plans.push_back({row.table, HugeArray<Index>(sources), HugeArray<Index>(targets), false});
    }
  const bool overlap = reach_.zones_meet(side);
  for (const Zones& zones : of.zones)
    plans.push_back(zone_rows(zones.table, zones.group, old_points, new_points, overlap));
}

}  // namespace limn::fast
