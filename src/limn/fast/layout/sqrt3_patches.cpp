#include "limn/fast/layout/sqrt3_patches.h"

#include <algorithm>
#include <utility>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

constexpr Index kPatchGrain = 2048;

/// What a patch's runs are, in the order of the numbers: its sides, what is inside of the grid, and
/// the grid's centroids.
enum class Run { side0, side1, side2, inside, centroids };

/// The patch's shape, and the numbers for it.
class Patches {
 public:
  Patches(const Sqrt3Level& level, std::vector<Stencil> stencils,
          const HugeArray<TriangleTopology>& faces, Sqrt3Made made)
      : level_(level),
        stencils_(std::move(stencils)),
        faces_(faces),
        made_(made),
        grid_frame_(level.odd.grid(), 0) {
    make_runs();
    find_halo();
    if (thirds()) {
      make_frame_of_thirds();
    } else {
      shape_.frame = triangle_frame_places(level_.n(), halo_ / 3);
      shape_.inner = triangle_inner_places(level_.n());
      grid_frame_ = {level.odd.grid(), halo_ / 3};
    }
  }

  PatchPlan plan() {
    const Mesh& control = level_.odd.control();
    PatchPlan plan;
    plan.patches = control.face_count();
    plan.inner_begin = thirds() ? level_.odd.centroid_begin(0) : level_.odd.grid().face_begin(0);
    const std::size_t frame = shape_.frame.size(), runs = shape_.runs.size();
    plan.frame = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * frame);
    plan.runs = HugeArray<Index>(static_cast<std::size_t>(plan.patches) * runs);
    parallel_for(
        Index{0}, plan.patches,
        [&](Index first, Index last) {
          for (Index f = first; f < last; ++f) {
            number_frame(f, plan.frame.data() + static_cast<std::size_t>(f) * frame);
            number_runs(f, plan.runs.data() + static_cast<std::size_t>(f) * runs);
          }
        },
        kPatchGrain);
    plan.shape = std::move(shape_);
    plan.stencils = std::move(stencils_);
    return plan;
  }

 private:
  [[nodiscard]] bool thirds() const { return level_.step == Sqrt3Step::thirds; }
  [[nodiscard]] bool in_place() const { return made_ == Sqrt3Made::same_level; }
  [[nodiscard]] bool makes_thirds() const { return thirds() && !in_place(); }
  [[nodiscard]] Index side() const { return level_.side(); }

  void add_old(Offset p, std::vector<Offset>& places) const {
    places.push_back(to_local(level_.step, p));
  }

  void add_run(Run run, const std::vector<Offset>& points) {
    if (points.empty()) return;
    runs_.push_back(run);
    std::vector<FinePoint>& to = shape_.runs.emplace_back();
    for (const Offset p : points) {
      const std::size_t c = in_place() ? 0 : static_cast<std::size_t>(sqrt3_class(level_.step, p));
      to.push_back({c, to_local(level_.step, anchor_of(level_.step, p))});
    }
    points_.insert(points_.end(), points.begin(), points.end());
  }

  void make_runs() {
    const Index last = side(), each = makes_thirds() ? 1 : 3;  // the steps of the grid made
    std::vector<Offset> points;
    for (Index frame = 0; frame < 3; ++frame) {
      points.clear();
      for (Index t = each; t < last; t += each)
        points.push_back(in_triangle_patch(last, frame, {t, 0}));
      add_run(static_cast<Run>(frame), points);
    }
    points.clear();
    for (Index y = each; y < last; y += each)
      for (Index x = each; x + y < last; x += each) points.push_back({x, y});
    add_run(Run::inside, points);
    if (thirds() == in_place()) add_run(Run::centroids, centroids());
  }

  /// In the order of their numbers.
  [[nodiscard]] std::vector<Offset> centroids() const {
    std::vector<Offset> points;
    for (Index y = 0; y < side(); y += 3)
      for (Index x = 0; x + y < side(); x += 3) {
        points.push_back({x + 1, y + 1});
        if (x + y + 3 < side()) points.push_back({x + 2, y + 2});
      }
    return points;
  }

  /// Rows beyond the sides that new points take from, as far as the neighbours go: what looks
  /// farther is in a zone.
  void find_halo() {
    for (const Offset p : points_) {
      const Offset anchor = anchor_of(level_.step, p);
      for (std::size_t c = 0; c < stencils_.size(); ++c)
        if (in_place() || std::cmp_equal(c, sqrt3_class(level_.step, p)))
          for (const Tap& tap : stencils_[c]) see(anchor, from_local(tap.place));
    }
  }

  void see(Offset from, Offset step) {
    const Index x = from.a + step.a, y = from.b + step.b;
    const Index beyond = std::max({-x, -y, x + y - side()});
    if (x <= side() && y <= side() && x + y >= 0) halo_ = std::max(halo_, beyond);
  }

  [[nodiscard]] Offset from_local(Offset place) const {
    if (!thirds()) return {3 * place.a, 3 * place.b};
    return {2 * place.a + place.b, place.b - place.a};
  }

  /// In steps of thirds: the old points of the corners, the sides, the vertices inside, and rows
  /// beyond the sides; and the centroids, whose numbers follow one another.
  void make_frame_of_thirds() {
    const auto add = [&](Index frame, Offset p) {
      add_old(in_triangle_patch(side(), frame, p), shape_.frame);
    };
    for (Index i = 0; i < 3; ++i) add(i, {0, 0});
    for (Index i = 0; i < 3; ++i)
      for (Index t = 3; t < side(); t += 3) add(i, {t, 0});
    for (const Offset p : triangle_inner_places(level_.n())) add(0, {3 * p.a, 3 * p.b});
    for (Index i = 0; i < 3; ++i)
      for (Index r = 1; r <= halo_; ++r)
        for (Index y = r % 3; r + y <= side(); y += 3) add(i, {r + y, -r});
    for (const Offset p : centroids()) add_old(p, shape_.inner);
  }

  /// Numbers of the shape's frame for one patch, in its order.
  void number_frame(Index f, Index* out) const {
    const TriangleTopology& face = faces_[static_cast<std::size_t>(f)];
    const TriangleLayout& grid = level_.odd.grid();
    grid_frame_.number(face, out);
    if (!thirds()) return;
    out += 3 * level_.n();
    for (Index i = 0; i < grid.face_size(); ++i) *out++ = grid.face_begin(f) + i;
    for (const TriangleTopology::Neighbour& across : face.across)
      for (Index r = 1; r <= halo_; ++r)
        out = across.face == kNone ? std::fill_n(out, (side() - r - r % 3) / 3 + 1, face.corners[0])
                                   : level_.odd.column(3 * across.face + across.side, r, out);
  }

  void number_runs(Index f, Index* out) const {
    const TriangleLayout& made = makes_thirds() ? level_.thirds : level_.odd.grid();
    for (const Run run : runs_) {
      if (run == Run::inside) {
        *out++ = made.face_begin(f);
      } else if (run == Run::centroids) {
        *out++ = level_.odd.centroid_begin(f);
      } else {
        const EdgeCode side =
            faces_[static_cast<std::size_t>(f)].sides[static_cast<std::size_t>(run)];
        *out++ = (side & 1) != 0 ? made.edge_begin(side >> 1) : kNone;
      }
    }
  }

  const Sqrt3Level& level_;
  std::vector<Stencil> stencils_;
  const HugeArray<TriangleTopology>& faces_;
  Sqrt3Made made_;
  PatchShape shape_;
  std::vector<Run> runs_;
  std::vector<Offset> points_;  // new points of all runs
  Index halo_ = 0;
  TriangleFrames grid_frame_;
};

}  // namespace

PatchPlan plan_sqrt3_patches(const Sqrt3Level& level, std::vector<Stencil> stencils,
                             const HugeArray<TriangleTopology>& faces, Sqrt3Made made) {
  return Patches(level, std::move(stencils), faces, made).plan();
}

}  // namespace limn::fast
