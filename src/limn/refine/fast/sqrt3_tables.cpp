#include "limn/refine/fast/sqrt3_tables.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

using Form = LinearForm<double>;

constexpr std::array<Sqrt3Step, 2> kSteps{Sqrt3Step::centroids, Sqrt3Step::thirds};

/// The new points of a zone, the centre first.
std::vector<SectorPoint> zone_points(Sqrt3Step step, Index sectors, bool open, Sqrt3Zone zone) {
  std::vector<SectorPoint> points{{0, 0, 0}};
  for (Index s = 0; s < sectors; ++s)
    for (Index x = 1; x <= zone.size; ++x)
      for (Index y = 0; zone.has(x, y); ++y)
        if (is_new(step, x, y)) points.push_back({s, x, y});
  for (Index y = 1; open && y <= zone.size; ++y)  // the last spoke
    if (is_new(step, 0, y)) points.push_back({sectors - 1, 0, y});
  return points;
}

class TableMaker {
 public:
  TableMaker(const Scheme& scheme, const std::vector<VertexKind>& kinds, const BoundarySides& sides)
      : scheme_(scheme),
        kinds_(kinds),
        sides_(sides),
        closed_(scheme, Boundary::left_out),
        open_(scheme, Boundary::refined) {}

  Result<std::array<Sqrt3Tables, 2>> make() {
    for (const Sqrt3Step step : kSteps) {
      const std::optional<Sqrt3Reach> reach = find_sqrt3_reach(scheme_, step, sides_);
      if (!reach) return Error{fmt::format("the rules of scheme '{}' look too far", scheme_.name)};
      of(step).reach = *reach;
    }
    if (Status status = read_interior(); !status) return status.error();
    if (sides_[1] || sides_[2] || sides_[3])
      if (Status status = read_strips(); !status) return status.error();
    for (const VertexKind& kind : kinds_)
      if (Status status = read_zones(kind); !status) return status.error();
    return std::move(tables_);
  }

 private:
  Sqrt3Tables& of(Sqrt3Step step) { return tables_[static_cast<std::size_t>(step)]; }

  /// Forms of new points over site.mesh(step).
  Result<std::vector<Form>> read(const Sqrt3Site& site, bool open, Sqrt3Step step,
                                 const std::vector<SectorPoint>& wanted) {
    RuleTables<double>& rules = open ? open_ : closed_;
    const Mesh& mesh = site.mesh(step);
    const Births& births = site.births(step);
    if (Status status = rules.prepare(mesh, births); !status) return status.error();
    std::vector<Index> vertices;
    vertices.reserve(wanted.size());
    for (const SectorPoint& point : wanted) vertices.push_back(site.vertex(point));
    return refine_values_at(scheme_, mesh, births, rules, unit_forms<double>(mesh.vertex_count()),
                            vertices);
  }

  /// A form's vertices as places on the plane.
  static Stencil on_lattice(const Form& form, const Sqrt3Site& site) {
    Stencil stencil;
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) stencil.push_back({on_plane(Lattice::triangle, site.place(vertex)), weight});
    return stencil;
  }

  Status read_interior() {
    constexpr Index kRings = 3;
    const Sqrt3Site site(*scheme_.split, 6, false, kRings + rings_seen(0));
    for (const Sqrt3Step step : kSteps) {
      std::vector<SectorPoint> wanted(kSqrt3Classes);
      for (Index c = 0; c < kSqrt3Classes; ++c)
        wanted[static_cast<std::size_t>(c)] = {0, c, step == Sqrt3Step::centroids ? c : 0};
      const Result<std::vector<Form>> forms = read(site, false, step, wanted);
      if (!forms) return forms.error();
      for (std::size_t c = 0; c < wanted.size(); ++c) {
        Stencil& stencil = of(step).interior[c];  // their anchors are at (0, 0)
        stencil = on_lattice((*forms)[c], site);
        for (Tap& tap : stencil) tap.place = to_local(step, tap.place);
        std::sort(stencil.begin(), stencil.end(),
                  [](const Tap& p, const Tap& q) { return p.place < q.place; });
      }
    }
    return Done{};
  }

  Status read_strips() {
    const Index depth = std::max(of(kSteps[0]).reach.strip_depth, of(kSteps[1]).reach.strip_depth);
    const Sqrt3Site site(*scheme_.split, 3, true, rings_seen(depth + 3));
    for (const Sqrt3Step step : kSteps) {
      std::vector<SectorPoint> wanted;
      std::vector<Stencil>& strips = of(step).strips;
      for (Index y = 0; y <= of(step).reach.strip_depth; ++y)
        for (Index x = 0; x < 3; ++x)
          if (is_new(step, x, y)) wanted.push_back({0, x, y});
      strips.resize(3 * static_cast<std::size_t>(of(step).reach.strip_depth + 1));
      const Result<std::vector<Form>> forms = read(site, true, step, wanted);
      if (!forms) return forms.error();
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto& [sector, x, y] = wanted[i];
        Stencil& stencil = strips[static_cast<std::size_t>(3 * y + x)];
        stencil = on_lattice((*forms)[i], site);
        for (Tap& tap : stencil) tap.place = {tap.place.a - x, tap.place.b - y};
      }
    }
    return Done{};
  }

  Status read_zones(const VertexKind& kind) {
    const bool open = kind.open;
    const Index sectors = kind.faces;
    if (sectors == 0) return Done{};
    if (sectors > kLargestTable || (!open && sectors < 3))
      return Error{fmt::format("no table for vertex {} of {} faces", kind.vertices[0], sectors)};
    const Sqrt3Site site(*scheme_.split, sectors, open, rings_seen(0));
    for (const Sqrt3Step step : kSteps) {
      const std::vector<SectorPoint> wanted =
          zone_points(step, sectors, open, of(step).reach.zone(sectors, open));
      const Result<std::vector<Form>> forms = read(site, open, step, wanted);
      if (!forms) return forms.error();
      (open ? of(step).fans : of(step).stars)
          .emplace(sectors, zone_table(*forms, site, sectors, wanted));
    }
    return Done{};
  }

  /// Control edges to the rim of a site on which zones, and points of so many rings more, see as
  /// far as they look.
  [[nodiscard]] Index rings_seen(Index more) const {
    Index seen = 0;
    for (const Sqrt3Tables& table : tables_) {
      const Sqrt3Reach& reach = table.reach;
      seen = std::max({seen, reach.star_zone, reach.fan_zone, 2 * reach.corner_zone,
                       reach.star_rings, reach.fan_rings, reach.corner_rings});
    }
    constexpr Index kMargin = 2;  // of which Sqrt3Site::rim is within
    return (seen + more) / 3 + kMargin;
  }

  const Scheme& scheme_;
  const std::vector<VertexKind>& kinds_;
  BoundarySides sides_;
  RuleTables<double> closed_, open_;
  std::array<Sqrt3Tables, 2> tables_;
};

}  // namespace

ZoneTable zone_table(const std::vector<LinearForm<double>>& forms, const Sqrt3Site& site,
                     Index sectors, std::vector<SectorPoint> targets) {
  auto [rows, vertices] = to_rows(forms);
  ZoneTable table{sectors, {}, std::move(targets), std::move(rows)};
  for (const Index v : vertices) table.sources.push_back(site.place(v));
  return table;
}

Result<std::array<Sqrt3Tables, 2>> read_sqrt3_stencils(const Scheme& scheme,
                                                       const std::vector<VertexKind>& kinds,
                                                       const BoundarySides& sides) {
  return TableMaker(scheme, kinds, sides).make();
}

}  // namespace limn::fast
