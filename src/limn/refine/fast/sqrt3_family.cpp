#include "limn/refine/fast/sqrt3_family.h"

#include <algorithm>

#include "limn/refine/fast/sqrt3_layout.h"
#include "limn/refine/fast/sqrt3_plain_order.h"
#include "limn/refine/fast/sqrt3_tables.h"
#include "limn/refine/fast/triangle_frame.h"
#include "limn/refine/fast/zones.h"

namespace limn::fast {
namespace {

constexpr Index kPatchGrain = 2048;
constexpr Index kFaceChunk = 32768;  // refined faces that one call of a parallel loop writes

Sqrt3Step step_from(int level) { return level % 2 == 0 ? Sqrt3Step::centroids : Sqrt3Step::thirds; }

/// A step of a level; places are in its grid of thirds.
struct LevelStep {
  LevelStep(const Mesh& control, int level)
      : step(step_from(level)), odd(control, power_of_3(level / 2)), thirds(control, side()) {}

  [[nodiscard]] Index n() const { return odd.n(); }
  [[nodiscard]] Index side() const { return 3 * odd.n(); }
  /// Old points, also beyond the patch's sides.
  [[nodiscard]] Index old_point(Index h, Index x, Index y) const {
    return step == Sqrt3Step::thirds ? odd.point_beyond(h, x, y)
                                     : odd.grid().point_beyond(h, x / 3, y / 3);
  }
  [[nodiscard]] Index new_point(Index h, Index x, Index y) const {
    return step == Sqrt3Step::thirds ? thirds.point(h, x, y) : odd.point(h, x, y);
  }

  Sqrt3Step step;
  CentroidLayout odd;
  TriangleLayout thirds;
};

/// The two sides of a step for number_points (zones.h).
struct OldPoints {
  const LevelStep& level;
  [[nodiscard]] Index n() const { return level.side(); }
  [[nodiscard]] Index point(Index h, Index x, Index y) const { return level.old_point(h, x, y); }
  [[nodiscard]] Index point_along(EdgeCode code, Index x) const {
    return level.odd.grid().point_along(code, x / 3);
  }
};
struct NewPoints {
  const LevelStep& level;
  [[nodiscard]] Index n() const { return level.side(); }
  [[nodiscard]] Index point(Index h, Index x, Index y) const { return level.new_point(h, x, y); }
  [[nodiscard]] Index point_along(EdgeCode code, Index x) const {
    return level.step == Sqrt3Step::thirds ? level.thirds.point_along(code, x)
                                           : level.odd.grid().point_along(code, x / 3);
  }
};

/// What a patch's runs are, in the order of the numbers: its sides, what is inside of the grid, and
/// the grid's centroids.
enum class Run { side0, side1, side2, inside, centroids };

/// The patch's shape, and the numbers for it.
class Patches {
 public:
  Patches(const LevelStep& level, const Sqrt3Tables& tables, const HugeArray<FaceTopology>& faces)
      : level_(level), tables_(tables), faces_(faces), grid_frame_(level.odd.grid(), 0) {
    make_runs();
    find_halo();
    if (thirds()) {
      make_frame_of_thirds();
    } else {
      shape_.frame = frame_places(level_.n(), halo_ / 3);
      shape_.inner = inner_places(level_.n());
      grid_frame_ = {level.odd.grid(), halo_ / 3};
    }
  }

  PatchPlan plan() {
    const Mesh& control = level_.odd.control();
    PatchPlan plan;
    plan.stencils.assign(tables_.interior.begin(), tables_.interior.end());
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
    return plan;
  }

 private:
  [[nodiscard]] bool thirds() const { return level_.step == Sqrt3Step::thirds; }
  [[nodiscard]] Index side() const { return level_.side(); }

  void add_old(Offset p, std::vector<Offset>& places) const {
    places.push_back(to_local(level_.step, p));
  }

  void add_run(Run run, const std::vector<Offset>& points) {
    if (points.empty()) return;
    runs_.push_back(run);
    std::vector<FinePoint>& to = shape_.runs.emplace_back();
    for (const Offset p : points) {
      const auto c = static_cast<std::size_t>(sqrt3_class(level_.step, p));
      to.push_back({c, to_local(level_.step, anchor_of(level_.step, p))});
    }
    made_.insert(made_.end(), points.begin(), points.end());
  }

  void make_runs() {
    const Index last = side(), each = thirds() ? 1 : 3;  // the steps of the grid that is made
    std::vector<Offset> points;
    for (Index frame = 0; frame < 3; ++frame) {
      points.clear();
      for (Index t = each; t < last; t += each) points.push_back(in_patch(last, frame, {t, 0}));
      add_run(static_cast<Run>(frame), points);
    }
    points.clear();
    for (Index y = each; y < last; y += each)
      for (Index x = each; x + y < last; x += each) points.push_back({x, y});
    add_run(Run::inside, points);
    if (!thirds()) add_run(Run::centroids, centroids());
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
    for (const Offset p : made_) {
      const Offset anchor = anchor_of(level_.step, p);
      for (const Tap& tap : tables_.interior[sqrt3_class(level_.step, p)]) {
        const Offset at = from_local(tap.place);
        const Index x = anchor.a + at.a, y = anchor.b + at.b;
        const Index beyond = std::max({-x, -y, x + y - side()});
        if (x <= side() && y <= side() && x + y >= 0) halo_ = std::max(halo_, beyond);
      }
    }
  }

  [[nodiscard]] Offset from_local(Offset place) const {
    if (!thirds()) return {3 * place.a, 3 * place.b};
    return {2 * place.a + place.b, place.b - place.a};
  }

  /// In steps of thirds: the old points of the corners, the sides, the vertices inside, and rows
  /// beyond the sides; and the centroids, whose numbers follow one another.
  void make_frame_of_thirds() {
    const auto add = [&](Index frame, Offset p) {
      add_old(in_patch(side(), frame, p), shape_.frame);
    };
    for (Index i = 0; i < 3; ++i) add(i, {0, 0});
    for (Index i = 0; i < 3; ++i)
      for (Index t = 3; t < side(); t += 3) add(i, {t, 0});
    for (const Offset p : inner_places(level_.n())) add(0, {3 * p.a, 3 * p.b});
    for (Index i = 0; i < 3; ++i)
      for (Index r = 1; r <= halo_; ++r)
        for (Index y = r % 3; r + y <= side(); y += 3) add(i, {r + y, -r});
    for (const Offset p : centroids()) add_old(p, shape_.inner);
  }

  /// Numbers of the shape's frame for one patch, in its order.
  void number_frame(Index f, Index* out) const {
    const FaceTopology& face = faces_[static_cast<std::size_t>(f)];
    const TriangleLayout& grid = level_.odd.grid();
    grid_frame_.number(face, out);
    if (!thirds()) return;
    out += 3 * level_.n();
    for (Index i = 0; i < grid.face_size(); ++i) *out++ = grid.face_begin(f) + i;
    for (const FaceTopology::Neighbour& across : face.across)
      for (Index r = 1; r <= halo_; ++r)
        out = across.face == kNone ? std::fill_n(out, (side() - r - r % 3) / 3 + 1, face.corners[0])
                                   : level_.odd.column(3 * across.face + across.side, r, out);
  }

  void number_runs(Index f, Index* out) const {
    const TriangleLayout& made = thirds() ? level_.thirds : level_.odd.grid();
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

  const LevelStep& level_;
  const Sqrt3Tables& tables_;
  const HugeArray<FaceTopology>& faces_;
  PatchShape shape_;
  std::vector<Run> runs_;
  std::vector<Offset> made_;  // new points of all runs
  Index halo_ = 0;
  FrameNumbers grid_frame_;
};

/// The points along boundary sides but for those in zones.
void add_side_rows(const LevelStep& level, const Sqrt3Tables& tables,
                   const std::vector<Index>& sides, std::vector<RowPlan>& plans) {
  const Mesh& mesh = level.odd.control();
  const Index n = level.side();
  const auto zone_of = [&](Index v) { return tables.reach.zone(mesh.valence(v) - 1, true); };
  struct Strip {
    std::vector<Index> sources, targets;
  };
  std::vector<Strip> strips(tables.strips.size());
  for (const Index h : sides) {
    const Sqrt3Zone left = zone_of(mesh.origin(h)), right = zone_of(mesh.target(h));
    for (Index y = 0; y <= tables.reach.strip_depth; ++y)
      for (Index x = 1; x + y < n; ++x) {
        if (!is_new(level.step, x, y) || left.has(x, y) || right.has(y, n - x - y)) continue;
        const auto c = static_cast<std::size_t>(3 * y + x % 3);
        for (const Tap& tap : tables.strips[c]) {
          const Index source = level.old_point(h, x + tap.place.a, y + tap.place.b);
          assert(source != kNone);
          strips[c].sources.push_back(source);
        }
        strips[c].targets.push_back(level.new_point(h, x, y));
      }
  }
  for (std::size_t c = 0; c < strips.size(); ++c)
    if (!strips[c].targets.empty())
      plans.push_back({to_rows(tables.strips[c]), HugeArray<Index>(strips[c].sources),
                       HugeArray<Index>(strips[c].targets), false});
}

/// Whether zones of two vertices may have points in common.
bool zones_meet(const Sqrt3Reach& reach, Index side) {
  const Index zone = std::max({reach.star_zone, reach.fan_zone, 2 * reach.corner_zone});
  return 2 * zone >= side;
}

class Sqrt3Family final : public Family {
 public:
  Sqrt3Family(const Scheme& scheme, const Mesh& control, int levels)
      : control_(control), plain_(levels) {
    if (control.face_count() == 0) return;
    std::vector<VertexKind> kinds = vertex_kinds(control);
    Result<std::array<Sqrt3Tables, 2>> read =
        read_sqrt3_stencils(scheme, kinds, boundary_sides(control));
    if (!read) return;
    tables_ = std::move(*read);
    while (plain_ > 0 && fits(plain_ - 1)) --plain_;
    if (plain_ == levels) return;
    groups_ = group_vertices(tables_[0].stars, tables_[0].fans, std::move(kinds), control);
    const TriangleLayout grid(control, 1);
    faces_ = HugeArray<FaceTopology>(static_cast<std::size_t>(control.face_count()));
    parallel_for_each(control.face_count(), [&](Index f) {
      faces_[static_cast<std::size_t>(f)] = face_topology(grid, f);
    });
    for (Index e = 0; e < control.edge_count(); ++e)
      if (control.is_boundary_edge(e)) sides_.push_back(control.halfedge_of_edge(e));
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    const CentroidLayout at = layout(level);
    const Index vertices = is_odd(level) ? at.vertex_count() : at.grid().vertex_count();
    const Index faces = is_odd(level) ? at.face_count() : at.grid().face_count();
    return {vertices, faces, 3 * faces};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    const LevelStep step(control_, level);
    const auto i = static_cast<std::size_t>(step.step);
    StepPlan plan;
    plan.patches = Patches(step, tables_[i], faces_).plan();
    add_side_rows(step, tables_[i], sides_, plan.rows);
    const bool overlap = zones_meet(tables_[i].reach, step.side());
    for (const ZoneGroup& group : groups_) {
      const ZoneTable& table = table_of(group, tables_[i]);
      plan.rows.push_back({table.rows, number_points(group, OldPoints{step}, table.sources),
                           number_points(group, NewPoints{step}, table.targets), overlap});
    }
    return plan;
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (steps.size() < 2 || control_.face_count() == 0) return {};
    return sqrt3_plain_order(control_, steps);
  }

  void write_faces(int level, std::span<Index> corners) const override {
    const CentroidLayout at = layout(level);
    const std::ptrdiff_t triangles = std::ptrdiff_t{at.n()} * at.n() * (is_odd(level) ? 3 : 1);
    parallel_for(
        Index{0}, control_.face_count(),
        [&](Index first, Index last) {
          Index* out = corners.data() + 3 * triangles * first;
          if (is_odd(level))
            at.write_faces(first, last, out);
          else
            at.grid().write_faces(first, last, out);
        },
        std::max<std::ptrdiff_t>(1, kFaceChunk / triangles));
  }
  [[nodiscard]] Index corners_per_face() const override { return 3; }

 private:
  static bool is_odd(int level) { return level % 2 != 0; }

  [[nodiscard]] CentroidLayout layout(int level) const {
    // without faces nothing grows, whatever the level
    return {control_, control_.face_count() == 0 ? 1 : power_of_3(level / 2)};
  }

  /// A group's table for a step; an isolated vertex has but one.
  [[nodiscard]] const ZoneTable& table_of(const ZoneGroup& group, const Sqrt3Tables& tables) const {
    const Index sectors = group.kind.faces;
    if (sectors == 0) return *group.table;
    const bool open = group.kind.open;
    return (open ? tables.fans : tables.stars).at(sectors);
  }

  /// Whether vertices that are not regular lie far enough apart for the step.
  [[nodiscard]] bool fits(int level) const {
    const auto i = static_cast<std::size_t>(step_from(level));
    return 3 * power_of_3(level / 2) >= tables_[i].reach.smallest_side;
  }

  const Mesh& control_;
  int plain_;
  std::array<Sqrt3Tables, 2> tables_;  // by Sqrt3Step
  std::vector<ZoneGroup> groups_;      // with the tables of the first kind of step
  HugeArray<FaceTopology> faces_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace

std::unique_ptr<Family> make_sqrt3_family(const Scheme& scheme, const Mesh& control, int levels) {
  return std::make_unique<Sqrt3Family>(scheme, control, levels);
}

}  // namespace limn::fast
