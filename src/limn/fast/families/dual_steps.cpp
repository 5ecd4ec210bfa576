#include "limn/fast/families/dual_steps.h"

#include <cassert>
#include <numeric>
#include <utility>

#include "limn/fast/layout/dual_frame.h"

namespace limn::fast {
namespace {

/// All fine points of a patch.
std::vector<FinePoint> fine_points(Index n) {
  std::vector<FinePoint> points;
  for (Index y = 0; y < 2 * n; ++y)
    for (Index x = 0; x < 2 * n; ++x) points.push_back({class_of(x, y), {x / 2, y / 2}});
  return points;
}

class StepPlanner {
 public:
  StepPlanner(const DualCorners& corners, const DualTables& tables, Index n)
      : corners_(corners),
        mesh_(corners.control()),
        tables_(tables),
        n_(n),
        coarse_(corners, n),
        fine_(corners, 2 * n) {}

  StepPlan plan() {
    plan_patches();
    if (tables_.own_face) {
      plan_arms();
    } else if (tables_.rims) {
      add_dual_rims(*tables_.rims, coarse_, fine_, plan_.rows);
    }
    for (const auto& [sides, zone] : tables_.zones) plan_zone(sides, zone);
    return std::move(plan_);
  }

 private:
  void plan_patches() {
    if (corners_.wholes().empty()) return;
    plan_.patches = frame_dual_patches(coarse_, fine_, tables_.halo);
    plan_.patches.shape.runs = {fine_points(n_)};
    plan_.patches.stencils.assign(tables_.interior.begin(), tables_.interior.end());
  }

  /// Rims have no inner points: their arms are the ends of lines, along which the regular stencils
  /// hold but at the first and last point.
  void plan_arms() {
    std::vector<Stencil> narrow;
    for (const Index x : {0, 1})
      for (const Index t : {0, 1}) {
        narrow.push_back(tables_.interior[class_of(x, t)]);
        for (Tap& tap : narrow.back()) std::swap(tap.place.a, tap.place.b);
      }
    add_dual_lines({narrow[0], narrow[1]}, narrow, 1, coarse_, fine_, plan_.rows);
  }

  /// The centres of so many sides. Regular ones are done by the patches but for rims' own points.
  void plan_zone(Index sides, const DualZone& zone) {
    std::vector<Index> faces, vertices;  // half-edges
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (mesh_.degree(f) == sides && wants_zone(f)) faces.push_back(mesh_.face_begin(f));
    if (sides != 4) vertices = vertices_of_sides(corners_, sides);
    if (faces.empty() && vertices.empty()) return;
    // between two centres lie 2n fine points
    plan_.rows.push_back(
        plan_dual_zones(zone, sides, faces, vertices, coarse_, fine_, tables_.zone > n_));
  }

  /// A regular face does at the boundary, for the sake of its rims' own points; but none where the
  /// rule sees the boundary.
  [[nodiscard]] bool wants_zone(Index f) const {
    bool whole = true;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      whole = whole && corners_.is_whole(h);
    return whole ? mesh_.degree(f) != 4 : tables_.own_face;
  }

  const DualCorners& corners_;
  const Mesh& mesh_;
  const DualTables& tables_;
  Index n_;
  DualLayout coarse_, fine_;
  StepPlan plan_;
};

/// Vertices that no face uses stay as they are.
void plan_isolated(const DualCorners& corners, Index from, Index to, StepPlan& plan) {
  const std::vector<Index>& isolated = corners.isolated();
  if (isolated.empty()) return;
  std::vector<Index> sources = isolated, targets(isolated.size());
  if (from != kNone) std::iota(sources.begin(), sources.end(), from);
  std::iota(targets.begin(), targets.end(), to);
  plan.rows.push_back(
      {{1, {0, 1}, {{0, 1.0}}}, HugeArray<Index>(sources), HugeArray<Index>(targets), false});
}

}  // namespace

StepPlan plan_first_dual_step(const DualCorners& corners, const DualTables& tables) {
  assert(tables.own_face);
  const Mesh& mesh = corners.control();
  const DualLayout fine(corners, 1);
  StepPlan plan;
  for (const auto& [sides, zone] : tables.zones) {
    std::vector<Index> sources, targets;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (mesh.degree(f) != sides) continue;
      const Index h = mesh.face_begin(f);
      for (const SectorPoint& p : zone.sources) sources.push_back(mesh.origin(h + p.sector));
      for (const SectorPoint& p : zone.targets) targets.push_back(fine.point(h + p.sector, 0, 0));
    }
    if (!sources.empty())
      plan.rows.push_back(
          {zone.table, HugeArray<Index>(sources), HugeArray<Index>(targets), false});
  }
  plan_isolated(corners, kNone, fine.isolated_begin(), plan);
  return plan;
}

StepPlan plan_dual_step(const DualCorners& corners, const DualTables& tables, Index n) {
  assert(n >= tables.smallest_grid);
  StepPlan plan = StepPlanner(corners, tables, n).plan();
  plan_isolated(corners, DualLayout(corners, n).isolated_begin(),
                DualLayout(corners, 2 * n).isolated_begin(), plan);
  return plan;
}

}  // namespace limn::fast
