#include "limn/fast/families/sqrt3_family.h"

#include <algorithm>

#include "limn/fast/layout/sqrt3_patches.h"
#include "limn/fast/limit/sqrt3_limit.h"
#include "limn/fast/plain/sqrt3_plain_order.h"
#include "limn/fast/sites/sqrt3_tables.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {
namespace {

constexpr Index kFaceChunk = 32768;  // refined faces that one call of a parallel loop writes

/// The points along boundary sides but for those in zones.
void add_side_rows(const Sqrt3Level& level, const Sqrt3Tables& tables,
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
      : control_(control), split_(*scheme.split), plain_(levels) {
    if (control.face_count() == 0) return;
    std::vector<VertexKind> kinds = vertex_kinds(control);
    Result<std::array<Sqrt3Tables, 2>> read =
        read_sqrt3_stencils(scheme, kinds, boundary_sides(control));
    if (!read) return;
    tables_ = std::move(*read);
    while (plain_ > 0 && fits(plain_ - 1)) --plain_;
    groups_ = group_vertices(tables_[0].stars, tables_[0].fans, std::move(kinds), control);
    faces_ = HugeArray<TriangleTopology>(static_cast<std::size_t>(control.face_count()));
    parallel_for_each(control.face_count(), [&](Index f) {
      faces_[static_cast<std::size_t>(f)] = triangle_topology(control, f);
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
    const Sqrt3Level step(control_, level);
    const auto i = static_cast<std::size_t>(step.step);
    StepPlan plan;
    plan.patches =
        plan_sqrt3_patches(step, {tables_[i].interior.begin(), tables_[i].interior.end()}, faces_,
                           Sqrt3Made::next_level);
    add_side_rows(step, tables_[i], sides_, plan.rows);
    const bool overlap = zones_meet(tables_[i].reach, step.side());
    for (const ZoneGroup& group : groups_) {
      const ZoneTable& table = table_of(group, tables_[i]);
      plan.rows.push_back(
          zone_rows(table, group, Sqrt3OldPoints{step}, Sqrt3NewPoints{step}, overlap));
    }
    return plan;
  }

  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    if (groups_.empty()) return std::optional<StepPlan>();
    return plan_sqrt3_limit({control_, split_, groups_, sides_, faces_}, level, reader);
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
  const Split& split_;
  int plain_;
  std::array<Sqrt3Tables, 2> tables_;  // by Sqrt3Step
  std::vector<ZoneGroup> groups_;      // with the tables of the first kind of step
  HugeArray<TriangleTopology> faces_;
  std::vector<Index> sides_;  // half-edges on the boundary
};

}  // namespace

std::unique_ptr<Family> make_sqrt3_family(const Scheme& scheme, const Mesh& control, int levels) {
  return std::make_unique<Sqrt3Family>(scheme, control, levels);
}

}  // namespace limn::fast
