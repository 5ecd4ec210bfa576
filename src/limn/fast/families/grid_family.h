#pragma once
/// What the families of triangle-dyadic and quad-dyadic have in common: at each level the faces of
/// a mesh cut into grids. The mesh is the control mesh where all its faces have as many sides as
/// the grids' cells. Otherwise it is what the split makes of it, and the family's own: the first
/// step is left to the plain engine, and the grids are numbered from there on.

#include <algorithm>
#include <cassert>

#include "limn/fast/families/family.h"
#include "limn/fast/limit/limit_zones.h"
#include "limn/fast/plain/plain_steps.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {

/// `Grid` says what is different:
/// - kLattice, and kSides, of a patch;
/// - Layout: numbers (triangle_layout.h, quad_layout.h);
/// - Topology, `topology(mesh, face)`, and Frames(layout, halo) with `number(topology, out)`: the
///   numbers of a patch's frame;
/// - `frame_places(n, halo)`, `inner_places(n)`, `in_patch(n, side, place)`;
/// - `walk(mesh, h, n, visit)`: visit(x, y, vertex) for the points of a patch of n edges a side in
/// a
///   refined mesh, from its first half-edge on.
template <class Grid>
class GridFamily final : public Family {
  using Layout = typename Grid::Layout;

 public:
  /// Cost: the tables, some 0.1 ms for each valence in the mesh. All steps are left to the plain
  /// engine where there are no tables.
  GridFamily(const Scheme& scheme, const Mesh& control, int levels)
      : control_(control), plain_(levels) {
    if (!is_grid(control) && levels == 0) return;
    if (!is_grid(control)) {
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
    while (plain_ < levels && layout(plain_).n() < grid) ++plain_;
    groups_ = group_vertices(tables_, std::move(kinds), mesh());
    faces_ = HugeArray<Topology>(static_cast<std::size_t>(mesh().face_count()));
    parallel_for_each(mesh().face_count(), [&](Index f) {
      faces_[static_cast<std::size_t>(f)] = Grid::topology(mesh(), f);
    });
    if (!mesh().has_boundary()) return;
    for (Index e = 0; e < mesh().edge_count(); ++e)
      if (mesh().is_boundary_edge(e)) sides_.push_back(mesh().halfedge_of_edge(e));
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    if (level < first_ || !is_grid(mesh()))
      return {control_.vertex_count(), control_.face_count(), control_.halfedge_count()};
    const Layout at = layout(level);
    return {at.vertex_count(), at.face_count(), Grid::kSides * at.face_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    const Layout coarse = layout(level), fine = layout(level + 1);
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
    const Layout at = layout(level);
    return grid_limit_plan(groups_, sides_, at, Grid::kLattice, level, reader,
                           [&](std::vector<Stencil> stencils, Index halo) {
                             return patches(at, at, std::move(stencils), halo);
                           });
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (steps.size() < 2) return {};
    const Layout at = layout(plain_);
    const auto first = static_cast<std::size_t>(first_);
    std::vector<Index> order(static_cast<std::size_t>(at.vertex_count()), kNone);
    for (Index v = 0; v < mesh().vertex_count(); ++v) order[v] = v;
    for (Index side = 0; side < mesh().halfedge_count(); side += Grid::kSides) {
      Index row = side;
      for (std::size_t i = first; i < steps.size(); ++i)
        row = first_part(i == first ? mesh() : steps[i - 1].mesh, steps[i], row);
      Grid::walk(steps.back().mesh, row, at.n(),
                 [&](Index x, Index y, Index v) { order[at.point(side, x, y)] = v; });
    }
    return order;
  }

  void write_faces(int level, std::span<Index> corners) const override {
    constexpr std::ptrdiff_t kChunk = 32768;  // faces that one call of the parallel loop writes
    if (level < first_ || !is_grid(mesh())) {
      for (Index h = 0; h < control_.halfedge_count(); ++h) corners[h] = control_.origin(h);
      return;
    }
    const Layout at = layout(level);
    const std::ptrdiff_t faces = std::ptrdiff_t{at.n()} * at.n();
    parallel_for(
        Index{0}, mesh().face_count(),
        [&](Index first, Index last) {
          at.write_faces(first, last, corners.data() + first * Grid::kSides * faces);
        },
        std::max<std::ptrdiff_t>(1, kChunk / faces));
  }

  [[nodiscard]] Index corners_per_face() const override {
    return is_grid(mesh()) ? Grid::kSides : 0;
  }

  void write_face_begin(int /*level*/, std::span<Index> begin) const override {
    for (Index f = 0; f <= control_.face_count(); ++f) begin[f] = control_.face_begin(f);
  }

 private:
  using Topology = typename Grid::Topology;

  static bool is_grid(const Mesh& mesh) {
    return mesh.uniform_degree() == Grid::kSides || mesh.face_count() == 0;
  }
  /// What is cut into grids, from level first_ on; the control mesh if no level was asked for.
  [[nodiscard]] const Mesh& mesh() const { return first_ > 0 ? split_ : control_; }
  [[nodiscard]] Layout layout(int level) const {
    assert(level >= first_);
    // without faces nothing grows, whatever the level
    return {mesh(), mesh().face_count() == 0 ? 1 : Index{1} << (level - first_)};
  }

  /// The sides, and the inside. New points cut each old edge into `factor`, 1 or 2.
  static PatchShape make_shape(Index n, Index halo, Index factor) {
    PatchShape shape{Grid::frame_places(n, halo), Grid::inner_places(n), {}};
    const auto point = [&](Offset fine) {
      return FinePoint{factor == 1 ? 0 : class_of(fine.a, fine.b),
                       {fine.a / factor, fine.b / factor}};
    };
    const Index fine = factor * n;
    shape.runs.resize(static_cast<std::size_t>(Grid::kSides) + 1);
    for (Index side = 0; side < Grid::kSides; ++side)
      for (Index t = 1; t < fine; ++t)
        shape.runs[static_cast<std::size_t>(side)].push_back(
            point(Grid::in_patch(fine, side, {t, 0})));
    for (const Offset place : Grid::inner_places(fine)) shape.runs.back().push_back(point(place));
    return shape;
  }

  [[nodiscard]] PatchPlan patches(const Layout& coarse, const Layout& fine,
                                  std::vector<Stencil> stencils, Index halo) const {
    constexpr Index kPatchGrain = 2048;
    PatchPlan plan;
    plan.shape = make_shape(coarse.n(), halo, fine.n() / coarse.n());
    plan.stencils = std::move(stencils);
    plan.patches = mesh().face_count();
    plan.inner_begin = coarse.face_begin(0);
    const std::size_t frame = plan.shape.frame.size(), runs = plan.shape.runs.size();
    plan.frame = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * frame);
    plan.runs = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * runs);
    const typename Grid::Frames frames(coarse, halo);
    parallel_for(
        Index{0}, plan.patches,
        [&](Index first, Index last) {
          for (Index f = first; f < last; ++f) {
            const auto at = static_cast<std::size_t>(f);
            frames.number(faces_[at], plan.frame.data() + at * frame);
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
  HugeArray<Topology> faces_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace limn::fast
