#include "limn/refine/fast/quad_family.h"

#include <algorithm>
#include <cassert>

#include "limn/refine/fast/limit_zones.h"
#include "limn/refine/fast/plain_steps.h"
#include "limn/refine/fast/quad_frame.h"
#include "limn/refine/fast/zones.h"

namespace limn::fast {
namespace {

constexpr Lattice kLattice = Lattice::quad;
constexpr Index kPatchGrain = 2048;
constexpr Index kFaceChunk = 32768;  // refined faces that one call of a parallel loop writes

/// New points cut each old edge into `factor`, 1 or 2.
PatchShape make_shape(Index n, Index halo, Index factor) {
  PatchShape shape{quad_frame_places(n, halo), quad_inner_places(n), {}};
  const auto point = [&](Offset fine) {
    return FinePoint{factor == 1 ? 0 : class_of(fine.a, fine.b),
                     {fine.a / factor, fine.b / factor}};
  };
  const Index fine = factor * n;
  shape.runs.resize(5);  // the sides, and the inside
  for (Index side = 0; side < 4; ++side)
    for (Index t = 1; t < fine; ++t)
      shape.runs[static_cast<std::size_t>(side)].push_back(
          point(in_quad_patch(fine, side, {t, 0})));
  for (const Offset place : quad_inner_places(fine)) shape.runs[4].push_back(point(place));
  return shape;
}

/// The plain engine's vertices after steps `first` …, by walking each patch row by row. The layout
/// is that of the mesh before step `first`.
std::vector<Index> order_of(const QuadLayout& layout, const std::vector<SplitResult>& steps,
                            std::size_t first) {
  const Mesh& mesh = layout.control();
  const Mesh& fine = steps.back().mesh;
  const Index n = layout.n();
  std::vector<Index> order(static_cast<std::size_t>(layout.vertex_count()), kNone);
  for (Index v = 0; v < mesh.vertex_count(); ++v) order[v] = v;
  for (Index side = 0; side < mesh.halfedge_count(); side += 4) {
    Index row = side;  // the half-edge from (0, y) to (1, y)
    for (std::size_t i = first; i < steps.size(); ++i)
      row = first_part(i == first ? mesh : steps[i - 1].mesh, steps[i], row);
    for (Index y = 0; y < n; ++y) {
      Index h = row;
      for (Index x = 0; x < n; ++x) {
        const Index top = fine.next(fine.next(h));
        order[layout.point(side, x, y)] = fine.origin(h);
        order[layout.point(side, x + 1, y)] = fine.target(h);
        order[layout.point(side, x, y + 1)] = fine.target(top);
        order[layout.point(side, x + 1, y + 1)] = fine.origin(top);
        if (x + 1 < n) h = fine.next(fine.twin(fine.next(h)));
      }
      if (y + 1 < n) row = fine.twin(fine.next(fine.next(row)));
    }
  }
  return order;
}

class QuadFamily final : public Family {
 public:
  QuadFamily(const Scheme& scheme, const Mesh& control, int levels)
      : control_(control), plain_(levels) {
    const bool quads = control.uniform_degree() == 4 || control.face_count() == 0;
    if (!quads && levels == 0) return;
    if (!quads) {
      split_ = scheme.split->apply(control, 0).mesh;
      first_ = 1;
    }
    if (control.face_count() == 0) return;
    std::vector<VertexKind> kinds = vertex_kinds(mesh());
    Result<StencilTables> read = read_stencils(scheme, kinds);
    if (!read) return;
    tables_ = std::move(*read);
    const Index grid = std::max(tables_.reach.smallest_grid, tables_.halo);
    plain_ = first_;
    while (plain_ < levels && (Index{1} << (plain_ - first_)) < grid) ++plain_;
    groups_ = group_vertices(tables_, std::move(kinds), mesh());
    faces_ = HugeArray<QuadTopology>(static_cast<std::size_t>(mesh().face_count()));
    parallel_for_each(mesh().face_count(), [&](Index f) {
      faces_[static_cast<std::size_t>(f)] = quad_topology(layout(first_), f);
    });
    for (Index e = 0; e < mesh().edge_count(); ++e)
      if (mesh().is_boundary_edge(e)) sides_.push_back(mesh().halfedge_of_edge(e));
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    if (level < first_ || !has_quads())
      return {control_.vertex_count(), control_.face_count(), control_.halfedge_count()};
    const QuadLayout at = layout(level);
    return {at.vertex_count(), at.face_count(), 4 * at.face_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    const QuadLayout coarse = layout(level), fine = layout(level + 1);
    const Reach& reach = tables_.reach;
    const Index zone = std::max({reach.star_zone, reach.fan_zone, reach.corner_zone});
    StepPlan plan;
    plan.patches =
        patches(coarse, fine, {tables_.interior.begin(), tables_.interior.end()}, tables_.halo);
    add_strips(tables_, sides_, coarse, fine, plan.rows);
    add_zones(groups_, coarse, fine, zone >= coarse.n(), plan.rows);
    return plan;
  }

  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    if (groups_.empty() || level < first_) return std::optional<StepPlan>();
    const QuadLayout at = layout(level);
    return grid_limit_plan(
        groups_, sides_, at, kLattice, level, reader,
        [&](std::vector<Stencil> stencils) { return patches(at, at, std::move(stencils), 1); });
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (steps.size() < 2) return {};
    return order_of(layout(plain_), steps, static_cast<std::size_t>(first_));
  }

  void write_faces(int level, std::span<Index> corners) const override {
    if (!has_quads()) {
      for (Index h = 0; h < control_.halfedge_count(); ++h) corners[h] = control_.origin(h);
      return;
    }
    const QuadLayout at = layout(level);
    const std::ptrdiff_t patch = std::ptrdiff_t{4} * at.n() * at.n();
    parallel_for(
        Index{0}, mesh().face_count(),
        [&](Index first, Index last) {
          at.write_faces(first, last, corners.data() + first * patch);
        },
        std::max<std::ptrdiff_t>(1, 4 * kFaceChunk / patch));
  }

  [[nodiscard]] Index corners_per_face() const override { return has_quads() ? 4 : 0; }

  void write_face_begin(int /*level*/, std::span<Index> begin) const override {
    for (Index f = 0; f <= control_.face_count(); ++f) begin[f] = control_.face_begin(f);
  }

 private:
  /// What is cut into grids, from level first_ on.
  [[nodiscard]] const Mesh& mesh() const { return first_ > 0 ? split_ : control_; }
  /// Otherwise nothing is cut: no level was asked for.
  [[nodiscard]] bool has_quads() const {
    return mesh().uniform_degree() == 4 || mesh().face_count() == 0;
  }
  [[nodiscard]] QuadLayout layout(int level) const {
    assert(level >= first_);
    // without faces nothing grows, whatever the level
    return {mesh(), mesh().face_count() == 0 ? 1 : Index{1} << (level - first_)};
  }

  [[nodiscard]] PatchPlan patches(const QuadLayout& coarse, const QuadLayout& fine,
                                  std::vector<Stencil> stencils, Index halo) const {
    PatchPlan plan;
    plan.shape = make_shape(coarse.n(), halo, fine.n() / coarse.n());
    plan.stencils = std::move(stencils);
    plan.patches = mesh().face_count();
    plan.inner_begin = coarse.face_begin(0);
    const std::size_t frame = plan.shape.frame.size(), runs = plan.shape.runs.size();
    plan.frame = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * frame);
    plan.runs = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * runs);
    parallel_for(
        Index{0}, plan.patches,
        [&](Index first, Index last) {
          for (Index f = first; f < last; ++f) {
            const auto at = static_cast<std::size_t>(f);
            number_frame(coarse, faces_[at], halo, plan.frame.data() + at * frame);
            Index* run = plan.runs.data() + at * runs;
            for (const EdgeCode side : faces_[at].sides)
              *run++ = (side & 1) != 0 ? fine.edge_begin(side >> 1) : kNone;
            *run = fine.face_begin(f);
          }
        },
        kPatchGrain);
    return plan;
  }

  const Mesh& control_;
  Mesh split_;
  int first_ = 0;  // the level whose faces are the patches
  int plain_;
  StencilTables tables_;
  std::vector<ZoneGroup> groups_;
  HugeArray<QuadTopology> faces_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace

std::unique_ptr<Family> make_quad_family(const Scheme& scheme, const Mesh& control, int levels) {
  return std::make_unique<QuadFamily>(scheme, control, levels);
}

}  // namespace limn::fast
