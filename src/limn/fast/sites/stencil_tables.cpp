#include "limn/fast/sites/stencil_tables.h"

#include <algorithm>

#include <fmt/core.h>

namespace limn::fast {
namespace {

using Form = refine::LinearForm<double>;
using Places = std::vector<SectorPoint>;

class TableMaker {
 public:
  TableMaker(const Scheme& scheme, const GridCycle& cycle, const std::vector<StarShape>& kinds,
             const BoundarySides& sides)
      : scheme_(scheme),
        cycle_(cycle),
        kinds_(kinds),
        sides_(sides),
        closed_(scheme, refine::Boundary::left_out),
        open_(scheme, refine::Boundary::refined),
        tables_(static_cast<std::size_t>(cycle.steps)) {}

  Result<std::vector<StencilTables>> make() {
    for (int step = 0; step < cycle_.steps; ++step) {
      const std::optional<Reach> reach = find_reach(scheme_, cycle_, step, sides_);
      if (!reach) return Error{fmt::format("the rules of scheme '{}' look too far", scheme_.name)};
      of(step).reach = *reach;
    }
    if (Status status = read_interior(); !status) return status.error();
    if (!cycle_.offset && std::find(sides_.begin() + 1, sides_.end(), true) != sides_.end())
      if (Status status = read_strips(); !status) return status.error();
    for (const StarShape& kind : kinds_)
      if (Status status = read_zones(kind); !status) return status.error();
    return std::move(tables_);
  }

 private:
  StencilTables& of(int step) { return tables_[static_cast<std::size_t>(step)]; }

  Result<std::vector<Form>> read(const Site& site, int step, const Places& wanted) {
    return read_new_points(scheme_, site.shape().open ? open_ : closed_, site, step, wanted);
  }

  Status read_interior() {
    const Site site = this->site(plane_sectors(cycle_.lattice), false, cycle_.edge());
    for (int i = 0; i < cycle_.steps; ++i) {
      const LatticeStep step(cycle_, i);
      Places wanted;
      const Offset anchor{step.first(), step.first()};
      for (Index y = 0; y < step.edge; ++y)
        for (Index x = 0; x < step.edge; ++x)
          if (step.is_new(x, y) && step.anchor_of(x, y) == anchor) wanted.push_back({0, x, y});
      const Result<std::vector<Form>> forms = read(site, i, wanted);
      if (!forms) return forms.error();
      of(i).interior.resize(step.classes());
      for (std::size_t c = 0; c < wanted.size(); ++c) {
        Stencil& stencil = of(i).interior[step.class_of(wanted[c].x, wanted[c].y)];
        for (const auto& [vertex, weight] : (*forms)[c].terms)
          if (weight != 0)
            stencil.push_back(
                {step.to_local(on_plane(cycle_.lattice, site.place(i, vertex))), weight});
        std::sort(stencil.begin(), stencil.end(),
                  [](const Tap& p, const Tap& q) { return p.place < q.place; });
      }
    }
    return Done{};
  }

  Status read_strips() {
    Index depth = 0;
    for (const StencilTables& table : tables_) depth = std::max(depth, table.reach.strip_depth);
    const Site site = this->site(half_plane_sectors(cycle_.lattice), true, depth + cycle_.edge());
    for (int i = 0; i < cycle_.steps; ++i) {
      const LatticeStep step(cycle_, i);
      const Index rows = of(i).reach.strip_depth + 1;
      Places wanted;
      for (Index y = 0; y < rows; ++y)
        for (Index x = 0; x < cycle_.cut; ++x)
          if (step.is_new(x, y)) wanted.push_back({0, x, y});
      const Result<std::vector<Form>> forms = read(site, i, wanted);
      if (!forms) return forms.error();
      for (std::size_t c = 0; c < wanted.size(); ++c)
        of(i).strips.push_back(side_row({&(*forms)[c], 1}, site, i, wanted[c], cycle_.cut));
    }
    return Done{};
  }

  Status read_zones(const StarShape& kind) {
    const bool open = kind.open;
    const Index sectors = kind.sectors;
    if (sectors == 0) {  // it stays
      const ZoneTable identity{0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1}, {{0, 1.0}}}};
      for (StencilTables& tables : tables_) tables.stars[0].tables = {identity};
      return Done{};
    }
    if (sectors > kLargestTable ||
        (!open && sectors < fewest_sectors(cycle_.lattice, cycle_.offset)))
      return Error{fmt::format("no table for a place of {} faces", sectors)};
    const Site site = this->site(sectors, open, 0);
    for (int i = 0; i < cycle_.steps; ++i) {
      Places wanted = points_round(i, sectors, open);
      const Result<std::vector<Form>> forms = read(site, i, wanted);
      if (!forms) return forms.error();
      (open ? of(i).fans : of(i).stars)[sectors] = {
          of(i).reach.zone(sectors, open), {zone_table(*forms, site, i, std::move(wanted))}};
    }
    return Done{};
  }

  /// The new points of a zone, the centre first.
  Places points_round(int i, Index sectors, bool open) {
    const LatticeStep step(cycle_, i);
    const Zone zone = of(i).reach.zone(sectors, open);
    Places points;
    if (step.is_new(0, 0)) points.emplace_back();
    for (Index s = 0; s < sectors; ++s)
      for (Index x = 1; x <= zone.size; ++x)
        for (Index y = 0; zone.has(x, y); ++y)
          if (step.is_new(x, y)) points.push_back({s, x, y});
    for (Index y = 1; open && y <= zone.size; ++y)  // the last spoke
      if (step.is_new(0, y)) points.push_back({sectors - 1, 0, y});
    return points;
  }

  [[nodiscard]] Site site(Index sectors, bool open, Index more) const {
    return {*scheme_.split,
            cycle_,
            {cycle_.lattice, sectors, open},
            rings_of_site(cycle_, tables_, more)};
  }

  const Scheme& scheme_;
  const GridCycle& cycle_;
  const std::vector<StarShape>& kinds_;
  BoundarySides sides_;
  refine::RuleTables<double> closed_, open_;
  std::vector<StencilTables> tables_;  // by step
};

}  // namespace

Index rings_of_site(const GridCycle& cycle, std::span<const StencilTables> tables, Index more) {
  constexpr Index kMargin = 2;  // control edges, of which the rim is within
  Index seen = 0;
  for (const StencilTables& table : tables) {
    const Reach& reach = table.reach;
    const Index corner = reach.corner_zone.size * (cycle.lattice == Lattice::triangle ? 2 : 1);
    seen = std::max({seen, reach.star_zone.size, reach.fan_zone.size, corner, reach.star_rings,
                     reach.fan_rings, reach.corner_rings});
  }
  return (seen + more) / cycle.edge() + kMargin;
}

Result<std::vector<Form>> read_new_points(const Scheme& scheme, refine::RuleTables<double>& rules,
                                          const Site& site, int step,
                                          const std::vector<SectorPoint>& points) {
  const Mesh& mesh = site.mesh(step);
  const Births& births = site.births(step);
  if (Status status = rules.prepare(mesh, births); !status) return status.error();
  std::vector<Index> vertices;
  vertices.reserve(points.size());
  for (const SectorPoint& point : points) vertices.push_back(site.new_vertex(step, point));
  return refine::refine_values_at(scheme, mesh, births, rules,
                                  refine::unit_forms<double>(mesh.vertex_count()), vertices);
}

ZoneTable zone_table(std::span<const Form> forms, const Site& site, int step,
                     std::vector<SectorPoint> targets) {
  auto [rows, vertices] = to_rows(forms);
  ZoneTable table{site.shape().sectors, {}, std::move(targets), std::move(rows)};
  for (const Index v : vertices) table.sources.push_back(site.place(step, v));
  return table;
}

SideRow side_row(std::span<const Form> forms, const Site& site, int step, const SectorPoint& point,
                 Index period) {
  const Lattice lattice = site.shape().lattice;
  const Offset at = on_plane(lattice, point);
  auto [rows, vertices] = to_rows(forms);
  SideRow row{at.b, at.a, period, std::move(rows), {}};
  for (const Index v : vertices) {
    const Offset place = on_plane(lattice, site.place(step, v));
    row.sources.push_back({place.a - at.a, place.b - at.b});
  }
  return row;
}

Result<std::vector<StencilTables>> read_stencils(const Scheme& scheme, const GridCycle& cycle,
                                                 const std::vector<StarShape>& kinds,
                                                 const BoundarySides& sides) {
  return TableMaker(scheme, cycle, kinds, sides).make();
}

}  // namespace limn::fast
