#include "limn/fast/sites/sharp_tables.h"

#include <algorithm>
#include <cmath>

#include "limn/mesh/index.h"
#include "limn/refine/crease_stencils.h"

namespace limn::fast {
namespace {

using Form = refine::LinearForm<double>;

using mesh::at;

/// What a new vertex weighs, in old ones.
template <class Stencils>
Form form_of(const Stencils& stencils, Index fresh) {
  std::vector<std::pair<Index, double>> parts;
  stencils.visit(fresh, [&](refine::Source source, double weight) {
    if (!source.is_face) return parts.emplace_back(source.index, weight), void();
    stencils.visit(stencils.faces_at() + source.index, [&](refine::Source of_face, double inner) {
      parts.emplace_back(of_face.index, weight * inner);
    });
  });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Form form;
  for (const auto& [vertex, weight] : parts) {
    if (form.terms.empty() || form.terms.back().first != vertex) form.terms.emplace_back(vertex, 0);
    form.terms.back().second += weight;
  }
  std::erase_if(form.terms, [](const auto& term) { return term.second == 0; });
  return form;
}

constexpr double kRounding = 1e-14;  // of weights

/// Whether two forms differ by more than rounding.
bool differ(const Form& a, const Form& b) {
  Form difference = a;
  refine::add_scaled(difference, -1.0, b);
  return std::any_of(difference.terms.begin(), difference.terms.end(),
                     [](const auto& term) { return std::abs(term.second) > kRounding; });
}

/// The sharpness of a site whose spokes are sharp from the centre to the rim.
Sharpness sharpness_of(const Site& site, const SharpPattern& pattern) {
  const Mesh& mesh = site.mesh(0);
  Sharpness sharpness;
  sharpness.vertices.resize(at(mesh.vertex_count()));
  sharpness.vertices[0] = pattern.own;
  const auto on_spoke = [](const SectorPoint& p) { return p.y == 0; };
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    SectorPoint a = site.place(0, mesh.origin(h)), b = site.place(0, mesh.target(h));
    if (a.x == 0 && a.y == 0) std::swap(a, b);
    const bool along = on_spoke(a) && on_spoke(b) && (b.x == 0 || a.sector == b.sector);
    sharpness.edges.push_back(along ? pattern.spokes[at(a.sector)] : 0);
  }
  return sharpness;
}

}  // namespace

SharpTables::SharpTables(const Scheme& scheme, const GridCycle& cycle, const StencilTables& tables)
    : scheme_(scheme), cycle_(cycle), tables_(tables), rules_(scheme) {}

Site SharpTables::site(Index sectors, bool open, Index more) const {
  return {*scheme_.split,
          cycle_,
          {cycle_.lattice, sectors, open},
          rings_of_site(cycle_, {&tables_, 1}, more)};
}

std::vector<SectorPoint> SharpTables::points_round(const SharpPattern& pattern) const {
  const auto sectors = static_cast<Index>(pattern.spokes.size());
  const auto is_sharp = [&](Index spoke) {
    if (pattern.open && (spoke == 0 || spoke == sectors)) return true;
    return pattern.spokes[at(spoke % sectors)] > 0;
  };
  const auto zone = [&](Index sector) -> const Zone& {
    return zone_between(tables_.reach, is_sharp(sector), is_sharp(sector + 1));
  };
  std::vector<SectorPoint> points(1);
  for (Index s = 0; s < sectors; ++s) {
    const Index before = s > 0 ? s - 1 : pattern.open ? 0 : sectors - 1;
    for (Index x = 1; x <= std::max(zone(s).size, zone(before).size); ++x)
      points.push_back({s, x, 0});
    for (Index x = 1; x <= zone(s).size; ++x)
      for (Index y = 1; zone(s).has(x, y); ++y) points.push_back({s, x, y});
  }
  for (Index y = 1; pattern.open && y <= zone(sectors - 1).size; ++y)
    points.push_back({sectors - 1, 0, y});
  return points;
}

Result<SharpTables::Forms> SharpTables::read(const Site& site, const SharpPattern& pattern,
                                             const std::vector<SectorPoint>& points) {
  const Mesh& mesh = site.mesh(0);
  const Sharpness sharpness = sharpness_of(site, pattern);
  const Result<refine::CreaseStep> step =
      refine::CreaseStep::make(*scheme_.split, mesh, sharpness, 0);
  if (!step) return step.error();
  if (Status status = refine::prepare_tables(rules_, *step); !status) return status.error();
  if (Status status = rules_.prepare(mesh, site.births(0)); !status) return status.error();
  const refine::CreaseStencils<double> sharp(scheme_, *step, rules_);
  const refine::StepStencils<double> smooth(scheme_, mesh, site.births(0), rules_);
  Forms result;
  for (const SectorPoint& point : points) {
    const Index fresh = site.new_vertex(0, point);
    Form form = form_of(sharp, fresh);
    if (!differ(form, form_of(smooth, fresh))) continue;
    result.points.push_back(point);
    result.forms.push_back(std::move(form));
  }
  return result;
}

Result<const ZoneTable*> SharpTables::zone(const SharpPattern& pattern) {
  const auto found = zones_.find(pattern);
  if (found != zones_.end()) return &found->second;
  const auto sectors = static_cast<Index>(pattern.spokes.size());
  auto kept = sites_.find({sectors, pattern.open});
  if (kept == sites_.end())
    kept = sites_.emplace(std::pair(sectors, pattern.open), site(sectors, pattern.open, 0)).first;
  const Site& round = kept->second;
  Result<Forms> read = this->read(round, pattern, points_round(pattern));
  if (!read) return read.error();
  ZoneTable table = zone_table(read->forms, round, 0, std::move(read->points));
  return &zones_.emplace(pattern, std::move(table)).first->second;
}

Result<const std::vector<SideRow>*> SharpTables::strip(double sharpness) {
  const auto found = strips_.find(sharpness);
  if (found != strips_.end()) return &found->second;
  const Index sectors = plane_sectors(cycle_.lattice);
  SharpPattern straight{false, 0, std::vector<double>(at(sectors))};
  straight.spokes[0] = straight.spokes[at(half_plane_sectors(cycle_.lattice))] = sharpness;
  std::vector<SectorPoint> points;
  for (Index y = 0; y <= tables_.reach.strip_depth; ++y)
    for (Index x = 0; x < cycle_.cut; ++x) points.push_back({0, x, y});
  const Site plane = site(sectors, false, tables_.reach.strip_depth + cycle_.edge());
  Result<Forms> read = this->read(plane, straight, points);
  if (!read) return read.error();
  std::vector<SideRow> rows;
  for (std::size_t i = 0; i < read->forms.size(); ++i)
    rows.push_back(side_row({&read->forms[i], 1}, plane, 0, read->points[i], cycle_.cut));
  return &strips_.emplace(sharpness, std::move(rows)).first->second;
}

}  // namespace limn::fast
