#include "limn/fast/families/grid_family.h"

#include <algorithm>
#include <cassert>

#include "limn/base/parallel.h"
#include "limn/fast/limit/limit_tables.h"
#include "limn/fast/plain/plain_order.h"
#include "limn/fast/sites/sharp_steps.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {
namespace {

class GridFamily final : public Family {
 public:
  /// All steps are left to the plain engine where there are no tables.
  GridFamily(const Scheme& scheme, const GridCycle& cycle, const Mesh& control, int levels,
             Sharpness sharpness)
      : cycle_(cycle),
        split_(*scheme.split),
        control_(control),
        sharpness_(std::move(sharpness)),
        plain_(levels) {
    while (!is_grid(mesh()) && first_ < levels) refine_once();
    // the cycle begins with its first step
    while (first_ % cycle.steps != 0 && first_ < levels) refine_once();
    if (control.face_count() == 0 || !is_cycle_begun()) return;
    groups_ = group_vertices(mesh(), cycle.lattice);
    Result<std::vector<StencilTables>> read =
        read_stencils(scheme, cycle, kinds(), sharp_sides(mesh(), sharpness_));
    if (!read) return;
    tables_ = std::move(*read);
    while (plain_ > first_ && fits(plain_ - 1)) --plain_;
    if (!find_sharp_steps(scheme, levels)) {
      plain_ = levels;
      tables_.clear();
      return;
    }
    faces_ = PatchTopology(mesh(), corners());
    if (!mesh().has_boundary()) return;
    for (Index e = 0; e < mesh().edge_count(); ++e)
      if (mesh().is_boundary_edge(e)) sides_.push_back(mesh().halfedge_of_edge(e));
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    if (!is_cycle_begun())
      return {mesh().vertex_count(), mesh().face_count(), mesh().halfedge_count()};
    const GridLayout at = step(level).old_points;
    return {at.vertex_count(), at.face_count(), at.corner_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    StepPlan plan = this->plan(tables_of(level), step(level), Made::next_level);
    const GridStep grid = step(level);
    if (sharp_) sharp_->add_rows(level - first_, grid.old_points, grid.new_points, plan.rows);
    return plan;
  }

  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    if (tables_.empty() || level < first_ || sharpness_at(level).any())
      return std::optional<StepPlan>();
    LimitControl control{split_, cycle_, kinds(), !sides_.empty(), false};
    for (const Index h : sides_)
      control.lone = control.lone ||
                     (mesh().twin(mesh().next(h)) == kNone && mesh().twin(mesh().prev(h)) == kNone);
    const auto tables = read_limit_tables(control, level - first_, level, reader);
    if (!tables) return tables.error();
    if (!*tables) return std::optional<StepPlan>();
    return std::optional(plan(**tables, step(level), Made::same_level));
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (steps.size() < 2 || control_.face_count() == 0) return {};
    return grid_order(mesh(), cycle_, std::span(steps).subspan(static_cast<std::size_t>(first_)));
  }

  void write_faces(int level, std::span<Index> corners) const override {
    constexpr std::ptrdiff_t kChunk = 32768;  // faces that one call of the parallel loop writes
    if (!is_cycle_begun()) {
      for (Index h = 0; h < mesh().halfedge_count(); ++h) corners[h] = mesh().origin(h);
      return;
    }
    const GridLayout at = step(level).old_points;
    const std::ptrdiff_t faces = at.patch_faces();
    base::parallel_for(
        Index{0}, mesh().face_count(),
        [&](Index first, Index last) {
          write_face_blocks(level, first, last, corners.data() + first * this->corners() * faces);
        },
        std::max<std::ptrdiff_t>(1, kChunk / std::max<std::ptrdiff_t>(1, faces)));
    at.write_edge_faces(corners.data() + mesh().face_count() * this->corners() * faces);
  }

  [[nodiscard]] Index face_blocks(int level) const override {
    if (!is_cycle_begun() || has_halves()) return 1;
    const GridLayout at = step(level).old_points;  // faces on control edges are of no patch
    const bool all = at.face_count() == mesh().face_count() * at.patch_faces();
    return all ? std::max<Index>(1, mesh().face_count()) : 1;
  }

  void write_face_blocks(int level, Index first, Index last, Index* corners) const override {
    step(level).old_points.write_faces(first, last, corners);
  }

  /// Between full cycles, quads at a boundary are halved.
  [[nodiscard]] Index corners_per_face() const override {
    return is_cycle_begun() && !has_halves() ? corners() : 0;
  }

  void write_face_begin(int level, std::span<Index> begin) const override {
    if (is_cycle_begun()) return step(level).old_points.write_face_begin(begin.data());
    for (Index f = 0; f <= mesh().face_count(); ++f) begin[f] = mesh().face_begin(f);
  }

  [[nodiscard]] SharpnessTags sharp_tags(int level) const override {
    const Sharpness left = sharpness_at(level);
    SharpnessTags tags = tags_of(mesh(), left);
    if (!is_cycle_begun()) return tags;
    const GridLayout at = step(level).old_points;
    tags.creases.clear();
    for (Index e = 0; e < std::ssize(left.edges); ++e) {
      const Index h = mesh().halfedge_of_edge(e);
      const double sharp = left.edges[static_cast<std::size_t>(e)];
      if (!(sharp > 0) || mesh().is_boundary_edge(e)) continue;
      Index before = mesh().origin(h);
      for (Index t = 1; t <= at.n(); ++t) {
        const Index next = t < at.n() ? at.edge_point(h, t) : mesh().target(h);
        tags.creases.push_back({{before, next}, {sharp}, 0});
        before = next;
      }
    }
    return tags;
  }

 private:
  /// False where there are no tables of some place.
  bool find_sharp_steps(const Scheme& scheme, int levels) {
    if (!sharpness_.any()) return true;
    Result<SharpSteps> made = SharpSteps::make(scheme, cycle_, tables_.front(), mesh(), groups_,
                                               sharpness_, plain_ - first_, levels - first_);
    if (made) sharp_.emplace(std::move(*made));
    return made.ok();
  }
  /// Of the mesh's edges and vertices, what is left of it at a level.
  [[nodiscard]] Sharpness sharpness_at(int level) const {
    return after_steps(sharpness_, level - first_);
  }
  [[nodiscard]] StepPlan plan(const StencilTables& tables, const GridStep& step, Made made) const {
    const GridLayout& from = step.old_points;
    const GridLayout& to = made == Made::same_level ? from : step.new_points;
    StepPlan plan;
    plan.patches = plan_patches(step, tables.interior, faces_, made);
    add_side_rows(tables, sides_, from, to, plan.rows);
    const bool overlap = tables.reach.zones_meet(step.side());
    for (const ZoneGroup& group : groups_)
      for (const ZoneTable& table :
           (group.kind.open ? tables.fans : tables.stars).at(group.kind.sectors).tables)
        plan.rows.push_back(zone_rows(table, group, from, to, overlap));
    return plan;
  }

  [[nodiscard]] std::vector<StarShape> kinds() const {
    std::vector<StarShape> kinds;
    kinds.reserve(groups_.size());
    for (const ZoneGroup& group : groups_) kinds.push_back(group.kind);
    return kinds;
  }
  [[nodiscard]] Index corners() const { return cycle_.lattice == Lattice::triangle ? 3 : 4; }
  [[nodiscard]] bool is_grid(const Mesh& mesh) const {
    return mesh.uniform_degree() == corners() || mesh.face_count() == 0;
  }
  /// What is cut into grids, from level first_ on; or, where so few levels were asked for that
  /// there is nothing to be cut, the last of them.
  [[nodiscard]] const Mesh& mesh() const { return first_ > 0 ? refined_ : control_; }
  [[nodiscard]] bool has_halves() const {
    return cycle_.steps > 1 && corners() == 4 && mesh().has_boundary();
  }
  [[nodiscard]] bool is_cycle_begun() const {
    return is_grid(mesh()) && first_ % cycle_.steps == 0;
  }
  void refine_once() {
    SplitResult fine = split_.apply(mesh(), first_);
    if (sharpness_.any())
      sharpness_ = inherit(mesh(), sharpness_, child_sharpness(mesh(), sharpness_), fine);
    refined_ = std::move(fine.mesh);
    ++first_;
  }
  [[nodiscard]] GridStep step(int level) const {
    assert(level >= first_);
    return {mesh(), cycle_, level - first_};
  }
  [[nodiscard]] const StencilTables& tables_of(int level) const {
    return tables_[static_cast<std::size_t>((level - first_) % cycle_.steps)];
  }
  /// Whether vertices that are not regular lie far enough apart for the step from a level.
  [[nodiscard]] bool fits(int level) const {
    return step(level).side() >= tables_of(level).reach.smallest_side;
  }

  GridCycle cycle_;
  const Split& split_;
  const Mesh& control_;
  Mesh refined_;
  Sharpness sharpness_;  // of mesh()
  int first_ = 0;        // the level whose faces are the patches
  int plain_;
  std::vector<StencilTables> tables_;  // by the cycle's steps
  std::vector<ZoneGroup> groups_;
  PatchTopology faces_;
  std::optional<SharpSteps> sharp_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace

std::optional<GridCycle> grid_cycle(const Split& split) {
  const bool quads = split.lattice == Lattice::quad;
  if (split.is_dual()) {
    if (!quads || !split.births.corners || split.dilation.growth() != 4) return std::nullopt;
    return GridCycle{split.lattice, 2, 1, true};
  }
  if (split.births.thirds) {
    if (split.dilation.growth() != 9 || split.births.faces == quads ||
        split.births.corners != quads)
      return std::nullopt;
    return GridCycle{split.lattice, 3, 1};
  }
  if (split.births.edges) {
    if (split.dilation.growth() != 4 || split.births.faces != quads) return std::nullopt;
    return GridCycle{split.lattice, 2, 1};
  }
  const Index cut = split.odd_step_cut;
  if (!split.births.faces || cut != (quads ? 2 : 3) || split.dilation.growth() != cut)
    return std::nullopt;
  return GridCycle{split.lattice, cut, 2};
}

std::unique_ptr<Family> make_grid_family(const Scheme& scheme, const GridCycle& cycle,
                                         const Mesh& control, int levels, Sharpness sharpness) {
  return std::make_unique<GridFamily>(scheme, cycle, control, levels, std::move(sharpness));
}

}  // namespace limn::fast
