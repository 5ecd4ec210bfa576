#include "limn/fast/limit/kite_limit.h"

#include "limn/fast/layout/kite_patches.h"

namespace limn::fast {
namespace {

/// Where a vertex's sums are over its own faces.
Result<std::optional<RimTables>> read_rims(const KiteControl& control, int level,
                                           LimitReader& reader) {
  const Result<Index> rings = reader.regular_rings(false);
  if (!rings) return rings.error();
  if (!control.own_face || *rings > 1) return std::optional<RimTables>();
  const ReadRim read = [&](const Site& site,
                           const std::vector<SectorPoint>& points) -> Result<RimForms> {
    std::vector<Index> vertices;
    for (const SectorPoint& point : points) vertices.push_back(site.old_vertex(0, point));
    const auto found = reader.read(site.mesh(0), level, false, vertices);
    if (!found) return found.error();
    RimForms all;
    for (const std::optional<LimitForms>& forms : *found) {
      if (!forms) return RimForms();
      all.insert(all.end(), forms->begin(), forms->end());
    }
    return all;
  };
  std::set<RimPattern> patterns;
  for (const auto& [pattern, faces] : control.groups.rims) patterns.insert(pattern);
  const LatticeStep step(control.cycle, 0);
  return make_rim_tables(control.split, control.cycle, patterns, 1, step.edge, step.first(), read);
}

}  // namespace

Result<std::optional<StepPlan>> plan_kite_limit(const KiteControl& control, const KiteLayout& at,
                                                int level, LimitReader& reader) {
  using Found = std::optional<StepPlan>;
  LimitControl limit{control.split, control.cycle, {}, false, false};
  for (const Index sides : control.groups.sides) limit.kinds.push_back({Lattice::quad, sides});
  int steps = 0;
  while (power(control.cycle.cut, steps) < at.n()) ++steps;
  const auto tables = read_limit_tables(limit, steps, level, reader);
  if (!tables) return tables.error();
  if (!*tables) return Found();
  const LimitTables& found = **tables;
  const LatticeStep step(control.cycle, 0);
  StepPlan plan;
  std::vector<Stencil> local(found.interior.begin(), found.interior.end());
  for (Stencil& stencil : local)
    for (Tap& tap : stencil) tap.place = step.to_local(tap.place);
  std::vector<FinePoint> points;
  for (Index y = 0; y < at.n(); ++y)
    for (Index x = 0; x < at.n(); ++x) points.push_back({0, {x, y}});
  std::optional<PatchPlan> patches = plan_kite_patches(at, at, std::move(points), std::move(local));
  if (!patches) return Found();
  plan.patches = *std::move(patches);
  const KiteLevel here{at, step.edge};
  for (const KiteCentres& centres : control.groups.centres)
    for (const ZoneTable& table : found.zones[0].at(centres.sides).tables)
      plan.rows.push_back(centre_rows(table, centres, here, here, false));
  if (at.kites().has_rims()) {
    const auto rims = read_rims(control, level, reader);
    if (!rims) return rims.error();
    if (!*rims) return Found();
    add_rim_rows(**rims, control.groups, here, here, plan.rows);
  }
  add_isolated_limits(at.isolated(), plan.rows);
  return Found(std::move(plan));
}

}  // namespace limn::fast
