#include "limn/refine/fast/triangle_family.h"

#include <algorithm>

#include "limn/refine/fast/limit_zones.h"
#include "limn/refine/fast/plain_steps.h"
#include "limn/refine/fast/triangle_frame.h"
#include "limn/refine/fast/zones.h"

namespace limn::fast {
namespace {

constexpr Lattice kLattice = Lattice::triangle;
constexpr Index kPatchGrain = 2048;
constexpr Index kFaceChunk = 32768;  // refined faces that one call of a parallel loop writes

/// New points cut each old edge into `factor`, 1 or 2.
PatchShape make_shape(Index n, Index halo, Index factor) {
  PatchShape shape{frame_places(n, halo), inner_places(n), {}};
  const auto point = [&](Offset fine) {
    return FinePoint{factor == 1 ? 0 : class_of(fine.a, fine.b),
                     {fine.a / factor, fine.b / factor}};
  };
  const Index fine = factor * n;
  shape.runs.resize(4);  // the sides, and the inside
  for (Index side = 0; side < 3; ++side)
    for (Index t = 1; t < fine; ++t)
      shape.runs[static_cast<std::size_t>(side)].push_back(point(in_patch(fine, side, {t, 0})));
  for (const Offset place : inner_places(fine)) shape.runs[3].push_back(point(place));
  return shape;
}

/// The plain engine's vertices, by walking each control face row by row.
std::vector<Index> order_of(const TriangleLayout& layout, const std::vector<SplitResult>& steps) {
  const Mesh& control = layout.control();
  const Mesh& fine = steps.back().mesh;
  const Index n = layout.n();
  std::vector<Index> order(static_cast<std::size_t>(layout.vertex_count()), kNone);
  for (Index v = 0; v < control.vertex_count(); ++v) order[v] = v;
  for (Index side = 0; side < control.halfedge_count(); side += 3) {
    Index row = side;  // the half-edge from (0, y) to (1, y)
    for (std::size_t i = 0; i < steps.size(); ++i)
      row = first_part(i == 0 ? control : steps[i - 1].mesh, steps[i], row);
    for (Index y = 0; y < n; ++y) {
      Index h = row;
      for (Index x = 0; x + y < n; ++x) {
        order[layout.point(side, x, y)] = fine.origin(h);
        order[layout.point(side, x + 1, y)] = fine.target(h);
        // over the face that points down, into the next one that points up
        if (x + y + 1 < n) h = fine.next(fine.twin(fine.next(fine.twin(fine.next(h)))));
      }
      // the face that points down beside (0, y) has the next row's first edge opposite
      if (y + 1 < n) row = fine.twin(fine.prev(fine.twin(fine.next(row))));
    }
  }
  return order;
}

class TriangleFamily final : public Family {
 public:
  TriangleFamily(const Scheme& scheme, const Mesh& control, int levels)
      : control_(control), plain_(levels) {
    if (control.face_count() == 0) return;
    std::vector<VertexKind> kinds = vertex_kinds(control);
    Result<StencilTables> read = read_stencils(scheme, kinds);
    if (!read) return;
    tables_ = std::move(*read);
    const Index grid = std::max(tables_.reach.smallest_grid, tables_.halo);
    plain_ = 0;
    while (plain_ < levels && (Index{1} << plain_) < grid) ++plain_;
    groups_ = group_vertices(tables_, std::move(kinds), control);
    faces_ = HugeArray<FaceTopology>(static_cast<std::size_t>(control.face_count()));
    parallel_for_each(control.face_count(), [&](Index f) {
      faces_[static_cast<std::size_t>(f)] = face_topology(layout(0), f);
    });
    for (Index e = 0; e < control.edge_count(); ++e)
      if (control.is_boundary_edge(e)) sides_.push_back(control.halfedge_of_edge(e));
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    const TriangleLayout at = layout(level);
    return {at.vertex_count(), at.face_count(), 3 * at.face_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    const TriangleLayout coarse = layout(level), fine = layout(level + 1);
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
    const TriangleLayout at = layout(level);
    return grid_limit_plan(
        groups_, sides_, at, kLattice, level, reader,
        [&](std::vector<Stencil> stencils) { return patches(at, at, std::move(stencils), 1); });
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    return steps.size() > 1 ? order_of(layout(plain_), steps) : std::vector<Index>{};
  }

  void write_faces(int level, std::span<Index> corners) const override {
    const TriangleLayout at = layout(level);
    const std::ptrdiff_t patch = std::ptrdiff_t{3} * at.n() * at.n();
    parallel_for(
        Index{0}, control_.face_count(),
        [&](Index first, Index last) {
          at.write_faces(first, last, corners.data() + first * patch);
        },
        std::max<std::ptrdiff_t>(1, 3 * kFaceChunk / patch));
  }
  [[nodiscard]] Index corners_per_face() const override { return 3; }

 private:
  [[nodiscard]] TriangleLayout layout(int level) const {
    // without faces nothing grows, whatever the level
    return {control_, control_.face_count() == 0 ? 1 : Index{1} << level};
  }

  [[nodiscard]] PatchPlan patches(const TriangleLayout& coarse, const TriangleLayout& fine,
                                  std::vector<Stencil> stencils, Index halo) const {
    PatchPlan plan;
    plan.shape = make_shape(coarse.n(), halo, fine.n() / coarse.n());
    plan.stencils = std::move(stencils);
    plan.patches = control_.face_count();
    plan.inner_begin = coarse.face_begin(0);
    const std::size_t frame = plan.shape.frame.size(), runs = plan.shape.runs.size();
    plan.frame = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * frame);
    plan.runs = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * runs);
    const FrameNumbers numbers(coarse, halo);
    parallel_for(
        Index{0}, plan.patches,
        [&](Index first, Index last) {
          for (Index f = first; f < last; ++f) {
            const auto at = static_cast<std::size_t>(f);
            numbers.number(faces_[at], plan.frame.data() + at * frame);
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
  int plain_;
  StencilTables tables_;
  std::vector<ZoneGroup> groups_;
  HugeArray<FaceTopology> faces_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace

std::unique_ptr<Family> make_triangle_family(const Scheme& scheme, const Mesh& control,
                                             int levels) {
  return std::make_unique<TriangleFamily>(scheme, control, levels);
}

}  // namespace limn::fast
