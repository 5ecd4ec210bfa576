#include "limn/fast/families/dual_steps.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "limn/base/parallel.h"
#include "limn/fast/layout/dual_frame.h"

namespace limn::fast {
namespace {

constexpr Index kNumberGrain = 16384;  // numbers that one call of a parallel loop makes

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
      plan_arms(false);
      plan_arms(true);
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

  /// Rims have no inner points. Each arm reads itself and the line beside it, up to the first
  /// points beyond the edge's midpoint.
  void plan_arms(bool along_x) {
    const std::vector<Index>& arms = along_x ? corners_.x_arms() : corners_.y_arms();
    if (arms.empty()) return;
    RowPlan plan;
    plan.table = arm_table(along_x);
    plan.sources = HugeArray<Index>(arms.size() * static_cast<std::size_t>(plan.table.sources));
    plan.targets = HugeArray<Index>(arms.size() * static_cast<std::size_t>(plan.table.targets()));
    parallel_for(
        Index{0}, static_cast<Index>(arms.size()),
        [&](Index first, Index last) {
          for (std::ptrdiff_t i = first; i < last; ++i) {
            const Index h = arms[static_cast<std::size_t>(i)];
            Index* sources = plan.sources.data() + i * plan.table.sources;
            Index* targets = plan.targets.data() + i * plan.table.targets();
            if (along_x)
              number_x_arm(h, sources, targets);
            else
              number_y_arm(h, sources, targets);
          }
        },
        std::max<Index>(1, kNumberGrain / (4 * n_)));
    plan_.rows.push_back(std::move(plan));
  }

  /// Sources are the arm's points 0 … n, then those beside it; targets its points 1 … 2n-1.
  [[nodiscard]] RowTable arm_table(bool along_x) const {
    RowTable table;
    table.sources = 2 * (n_ + 1);
    for (Index t = 1; t < 2 * n_; ++t) {
      for (const auto& [place, weight] :
           tables_.interior[along_x ? class_of(t, 0) : class_of(0, t)]) {
        const Index along = t / 2 + (along_x ? place.a : place.b);
        const Index aside = along_x ? place.b : place.a;
        assert(along >= 0 && along <= n_ && (aside == 0 || aside == -1));
        table.terms.push_back({static_cast<int>(along - aside * (n_ + 1)), weight});
      }
      table.row_begin.push_back(static_cast<int>(table.terms.size()));
    }
    return table;
  }

  void number_y_arm(Index h, Index* sources, Index* targets) const {
    const Index twin = mesh_.twin(h);
    coarse_.column(h, 0, sources);
    sources[n_] = coarse_.point(mesh_.next(twin), n_ - 1, 0);
    coarse_.row(mesh_.next(h), 0, sources + n_ + 1);
    sources[2 * n_ + 1] = coarse_.point(twin, 0, n_ - 1);
    for (Index t = 1; t < 2 * n_; ++t) *targets++ = fine_.point(h, 0, t);
  }

  void number_x_arm(Index h, Index* sources, Index* targets) const {
    const Index below = mesh_.prev(h), twin = mesh_.twin(below);
    coarse_.row(h, 0, sources);
    sources[n_] = coarse_.point(twin, 0, n_ - 1);
    coarse_.column(below, 0, sources + n_ + 1);
    sources[2 * n_ + 1] = coarse_.point(mesh_.next(twin), n_ - 1, 0);
    for (Index t = 1; t < 2 * n_; ++t) *targets++ = fine_.point(h, t, 0);
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
