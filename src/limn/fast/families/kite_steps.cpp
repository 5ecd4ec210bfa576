#include "limn/fast/families/kite_steps.h"

#include <cassert>
#include <numeric>

#include "limn/fast/layout/kite_patches.h"

namespace limn::fast {
namespace {

/// Vertices that no face uses stay as they are.
void plan_isolated(const std::vector<Index>& from, const std::vector<Index>& to, StepPlan& plan) {
  if (from.empty()) return;
  plan.rows.push_back(
      {{1, {0, 1}, {{0, 1.0}}}, HugeArray<Index>(from), HugeArray<Index>(to), false});
}

}  // namespace

Result<KiteTables> read_kite_tables(const Scheme& scheme, const GridCycle& cycle,
                                    const Kites& kites, const KiteGroups& groups) {
  std::vector<VertexKind> kinds;
  for (const Index sides : groups.sides) kinds.push_back({false, sides, {}});
  Result<std::vector<StencilTables>> interior =
      read_stencils(scheme, cycle, kinds, {true, kites.has_rims()});
  if (!interior) return interior.error();
  KiteTables tables{std::move(interior->front()), {}};
  if (!kites.has_rims()) return tables;
  std::set<RimPattern> patterns;
  for (const auto& [pattern, faces] : groups.rims) patterns.insert(pattern);
  Result<RimTables> rims = read_rims(scheme, cycle, patterns, tables.interior.reach);
  if (!rims) return rims.error();
  tables.rims = std::move(*rims);
  return tables;
}

StepPlan plan_first_kite_step(const Kites& kites, const KiteTables& tables) {
  assert(tables.own_face());
  const Mesh& mesh = kites.control();
  const KiteLayout fine(kites, 1);
  StepPlan plan;
  for (const auto& [sides, zone] : tables.interior.stars) {
    std::vector<Index> sources, targets;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (mesh.degree(f) != sides) continue;
      const Index h = mesh.face_begin(f);
      for (const SectorPoint& p : zone.sources) sources.push_back(mesh.origin(h + p.sector));
      for (const SectorPoint& p : zone.targets) targets.push_back(fine.point(h + p.sector, 0, 0));
    }
    if (!sources.empty())
      plan.rows.push_back({zone.rows, HugeArray<Index>(sources), HugeArray<Index>(targets), false});
  }
  plan_isolated(kites.isolated(), fine.isolated(), plan);
  return plan;
}

StepPlan plan_kite_step(const Kites& kites, const KiteGroups& groups, const GridCycle& cycle,
                        const KiteTables& tables, Index n) {
  const KiteLayout coarse(kites, n), fine(kites, 2 * n);
  const LatticeStep step(cycle, 0);
  std::vector<FinePoint> points;
  for (Index y = 1; y < step.edge * n; y += step.new_edge)
    for (Index x = 1; x < step.edge * n; x += step.new_edge)
      points.push_back({step.class_of(x, y), step.to_local(step.anchor_of(x, y))});
  StepPlan plan;
  std::optional<PatchPlan> patches =
      plan_kite_patches(coarse, fine, std::move(points), tables.interior.interior);
  assert(patches);
  plan.patches = *std::move(patches);
  const KiteLevel old{coarse, step.edge}, made{fine, step.new_edge};
  if (kites.has_rims()) add_rim_rows(tables.rims, groups, old, made, plan.rows);
  const bool overlap = tables.interior.reach.zones_meet(step.edge * n);
  for (const KiteCentres& centres : groups.centres)
    plan.rows.push_back(
        centre_rows(tables.interior.stars.at(centres.sides), centres, old, made, overlap));
  plan_isolated(coarse.isolated(), fine.isolated(), plan);
  return plan;
}

}  // namespace limn::fast
