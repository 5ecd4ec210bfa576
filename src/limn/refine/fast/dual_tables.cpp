#include "limn/refine/fast/dual_tables.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/fast/walk_hull.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"

namespace limn::fast {
namespace {

constexpr Index kRegular = 4;      // sides of a regular centre
constexpr Index kFirstRings = 6;   // of the regular star on which the rule's reach is found
constexpr Index kLargestGrid = 8;  // a rule that needs a finer one is left to the plain engine

using Form = LinearForm<double>;

Error too_far(const Scheme& scheme) {
  return Error{fmt::format("the rules of scheme '{}' look too far", scheme.name)};
}

/// One step of a face star.
class Site {
 public:
  Site(const Scheme& scheme, Index sides, Index rings)
      : scheme_(scheme),
        sides_(sides),
        step_(star_step(*scheme.split, sides, static_cast<int>(rings))) {
    while (face_star_size(sides, rings_) < step_.coarse.vertex_count()) ++rings_;
  }

  /// What the rule of a fine point sees; nothing where it meets the rim.
  [[nodiscard]] std::vector<SectorPoint> seen(const SectorPoint& fine) const {
    std::vector<SectorPoint> points;
    for (const Index v : corner_hull(scheme_, step_.coarse, step_.images[image(fine)])) {
      points.push_back(dual_point(sides_, v));
      if (dual_ring(points.back()) == rings_) return {};
    }
    return points;
  }

  /// Vertices of the face in which a fine point lies.
  [[nodiscard]] Index degree(const SectorPoint& fine) const {
    return step_.coarse.degree(step_.coarse.face(step_.images[image(fine)]));
  }

  /// The forms of fine points over the coarse vertices.
  Result<std::vector<Form>> forms(RuleTables<double>& tables,
                                  const std::vector<SectorPoint>& fine) const {
    const Births& births = step_.fine.births;
    if (Status status = tables.prepare(step_.coarse, births); !status) return status.error();
    std::vector<Index> vertices;
    vertices.reserve(fine.size());
    for (const SectorPoint& point : fine) vertices.push_back(step_.images[image(point)]);
    return refine_values_at(scheme_, step_.coarse, births, tables,
                            unit_forms<double>(step_.coarse.vertex_count()), vertices);
  }

 private:
  [[nodiscard]] std::size_t image(const SectorPoint& fine) const {
    return static_cast<std::size_t>(dual_vertex(sides_, fine));
  }

  const Scheme& scheme_;
  Index sides_;
  StarStep step_;
  Index rings_ = 1;  // of the coarse star, margin and all
};

class TableMaker {
 public:
  TableMaker(const Scheme& scheme, const Mesh& control)
      : scheme_(scheme), control_(control), rules_(scheme, Boundary::left_out) {}

  Result<DualTables> make() {
    if (Status status = read_interior(); !status) return status.error();
    std::set<Index> sides{kRegular};
    for (Index f = 0; f < control_.face_count(); ++f) sides.insert(control_.degree(f));
    for (Index v = 0; v < control_.vertex_count(); ++v)
      if (!control_.is_isolated(v) && !control_.is_boundary_vertex(v))
        sides.insert(control_.valence(v));
    Index rings = tables_.halo;
    for (const Index n : sides) {
      if (Status status = read_zone(n); !status) return status.error();
      rings = std::max(rings, tables_.zones.at(n).rings);
    }
    if (!tables_.own_face && control_.has_boundary()) {
      Result<DualRims> rims = read_dual_rims(scheme_, control_, tables_.halo);
      if (!rims) return rims.error();
      tables_.rims = std::move(*rims);
      rings = std::max(rings, 2 * tables_.halo);
    }
    while (tables_.smallest_grid < rings) tables_.smallest_grid *= 2;
    if (tables_.smallest_grid > kLargestGrid) return too_far(scheme_);
    return std::move(tables_);
  }

 private:
  Status read_interior() {
    const Site star(scheme_, kRegular, kFirstRings);
    std::vector<SectorPoint> classes;
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) classes.push_back({0, x, y});
    tables_.own_face = true;
    for (const SectorPoint& fine : classes) {
      const std::vector<SectorPoint> seen = star.seen(fine);
      if (seen.empty()) return too_far(scheme_);
      if (std::ssize(seen) > star.degree(fine)) tables_.own_face = false;
      see(fine, seen);
    }
    const Result<std::vector<Form>> forms = star.forms(rules_, classes);
    if (!forms) return forms.error();
    for (std::size_t c = 0; c < kClasses; ++c)
      for (const auto& [vertex, weight] : (*forms)[c].terms)
        if (weight != 0)
          tables_.interior[c].push_back({dual_on_plane(dual_point(kRegular, vertex)), weight});
    for (Stencil& stencil : tables_.interior)
      std::sort(stencil.begin(), stencil.end(),
                [](const Tap& p, const Tap& q) { return p.place < q.place; });
    return Done{};
  }

  /// What the points of a class see says how deep halo and zones are. A patch's points must not see
  /// places that are beyond both sides at a centre, which the plane alone has.
  void see(const SectorPoint& fine, const std::vector<SectorPoint>& seen) {
    for (const SectorPoint& point : seen) {
      const Offset place = dual_on_plane(point);
      tables_.halo = std::max({tables_.halo, -place.a, -place.b, place.a, place.b});
      for (Index x = fine.x; x / 2 + place.a < 0; x += 2)
        for (Index y = fine.y; y / 2 + place.b < 0; y += 2)
          tables_.zone = std::max({tables_.zone, x + 1, y + 1});
    }
  }

  Status read_zone(Index n) {
    if (n < 3 || n > kLargestDualTable)
      return Error{fmt::format("no table for a face or vertex of {} sides", n)};
    const Site star(scheme_, n, tables_.zone + tables_.halo);
    DualZone zone;
    for (Index s = 0; s < n; ++s)
      for (Index y = 0; y < tables_.zone; ++y)
        for (Index x = 0; x < tables_.zone; ++x) zone.targets.push_back({s, x, y});
    // what is seen from the other sectors is the same, turned
    for (Index i = 0; i < tables_.zone * tables_.zone; ++i) {
      const std::vector<SectorPoint> seen = star.seen(zone.targets[static_cast<std::size_t>(i)]);
      if (seen.empty()) return too_far(scheme_);
      for (const SectorPoint& point : seen) zone.rings = std::max(zone.rings, dual_ring(point));
    }
    const Result<std::vector<Form>> forms = star.forms(rules_, zone.targets);
    if (!forms) return forms.error();
    fill_zone(zone, *forms, [n](Index v) { return dual_point(n, v); });
    tables_.zones.emplace(n, std::move(zone));
    return Done{};
  }

  const Scheme& scheme_;
  const Mesh& control_;
  RuleTables<double> rules_;
  DualTables tables_;
};

}  // namespace

Result<DualTables> read_dual_tables(const Scheme& scheme, const Mesh& control) {
  return TableMaker(scheme, control).make();
}

}  // namespace limn::fast
