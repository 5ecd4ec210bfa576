#include "limn/fast/limit/grid_limit.h"

#include <algorithm>

namespace limn::fast {
namespace {

StepPlan make_plan(const GridControl& control, const GridStep& step, const LimitTables& tables) {
  StepPlan plan;
  std::vector<Stencil> local(tables.interior.begin(), tables.interior.end());
  for (Stencil& stencil : local) {
    for (Tap& tap : stencil) tap.place = step.step.to_local(tap.place);
    std::sort(stencil.begin(), stencil.end(),
              [](const Tap& p, const Tap& q) { return p.place < q.place; });
  }
  const GridLayout& points = step.old_points;
  plan.patches = plan_patches(step, std::move(local), control.faces, Made::same_level);
  const auto zone_of = [&](Index faces) {
    return Zone{tables.zones[1].at(faces).size, points.lattice() == Lattice::quad};
  };
  add_side_rows(tables.sides, control.sides, zone_of, points, points, plan.rows);
  static const ZoneTable isolated{0, {SectorPoint{}}, {SectorPoint{}}, isolated_limit_rows()};
  for (const ZoneGroup& group : control.groups) {
    const Index sectors = group.kind.faces;
    if (sectors == 0) {
      plan.rows.push_back(zone_rows(isolated, group, points, points, false));
      continue;
    }
    for (const ZoneTable& table : tables.zones[group.kind.open ? 1 : 0].at(sectors).tables)
      plan.rows.push_back(zone_rows(table, group, points, points, false));
  }
  return plan;
}

}  // namespace

Result<std::optional<StepPlan>> plan_grid_limit(const GridControl& control, int level,
                                                int steps_made, LimitReader& reader) {
  const Mesh& mesh = control.mesh;
  const bool lone = std::any_of(control.sides.begin(), control.sides.end(), [&](Index h) {
    return mesh.twin(mesh.next(h)) == kNone && mesh.twin(mesh.prev(h)) == kNone;
  });
  LimitControl limit{control.split, control.cycle, {}, !control.sides.empty(), lone};
  for (const ZoneGroup& group : control.groups)
    if (group.kind.faces > 0)
      limit.kinds.push_back({control.cycle.lattice, group.kind.faces, group.kind.open});
  const auto tables = read_limit_tables(limit, level, steps_made, reader);
  if (!tables) return tables.error();
  if (!*tables) return std::optional<StepPlan>();
  return std::optional(make_plan(control, GridStep(mesh, control.cycle, level), **tables));
}

}  // namespace limn::fast
