#include "limn/fast/limit/dual_limit.h"

#include <algorithm>
#include <array>

#include "limn/fast/layout/dual_frame.h"
#include "limn/fast/limit/dual_umbrella.h"
#include "limn/fast/limit/limit_sums.h"
#include "limn/fast/sites/dual_tables.h"

namespace limn::fast {
namespace {

using Found = std::optional<StepPlan>;

/// Whether the sums look no farther than the faces round a vertex.
Result<bool> sees_own_faces(LimitReader& reader) {
  const Result<Index> rings = reader.regular_rings(false);
  if (!rings) return rings.error();
  return *rings <= 1;
}

/// The three stencils of a regular vertex.
std::vector<Stencil> regular_stencils(const RowTable& table) {
  // an umbrella's vertices when all faces are quads
  constexpr std::array<Offset, 9> kPlaces{
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::vector<Stencil> stencils;
  for (int row = 0; row < table.targets(); ++row) {
    std::vector<double> weights(kPlaces.size(), 0.0);
    for (int i = table.row_begin[row]; i < table.row_begin[row + 1]; ++i)
      weights[table.terms[i].source] = table.terms[i].weight;
    stencils.push_back(rounded_stencil({kPlaces.begin(), kPlaces.end()}, std::move(weights)));
  }
  return stencils;
}

enum class Centre { face, vertex };

/// The point of a patch next to one of its centres.
struct CentrePoint {
  Centre centre;
  Index h;
};

class LimitPlanner {
 public:
  LimitPlanner(const DualLayout& at, int level, LimitReader& reader)
      : at_(at),
        corners_(at.corners()),
        mesh_(corners_.control()),
        n_(at.n()),
        level_(level),
        reader_(reader) {}

  Result<Found> plan() {
    for (const auto step :
         {&LimitPlanner::plan_patches, &LimitPlanner::plan_arms, &LimitPlanner::plan_corners}) {
      const Result<bool> done = (this->*step)();
      if (!done) return done.error();
      if (!*done) return Found();
    }
    add_isolated_limits(at_.isolated(), plan_.rows);
    return Found(std::move(plan_));
  }

 private:
  Result<bool> plan_patches() {
    if (corners_.wholes().empty()) return true;
    const Result<std::optional<RowTable>> table =
        read_umbrella(reader_, level_, {false, {4, 4, 4, 4}});
    if (!table) return table.error();
    if (!*table) return false;
    plan_.patches = plan_dual_limit_patches(at_, 1, regular_stencils(**table));
    return true;
  }

  /// An inner edge that begins at the boundary has an arm along it and one that goes on along its
  /// twin: of these 2n points all have two quads but for the first and last.
  Result<bool> plan_arms() {
    const std::vector<Index>& lines = corners_.y_arms();
    if (lines.empty() || n_ == 1) return true;
    const Result<std::optional<RowTable>> one = read_umbrella(reader_, level_, {true, {4, 4}});
    if (!one) return one.error();
    if (!*one) return false;
    RowPlan plan{line_table(**one), {}, {}, false};
    const Index length = 2 * n_, targets = length - 2;
    plan.sources = HugeArray<Index>(lines.size() * static_cast<std::size_t>(2 * length));
    plan.targets = HugeArray<Index>(lines.size() * static_cast<std::size_t>(targets));
    parallel_for_each(static_cast<Index>(lines.size()), [&](std::ptrdiff_t i) {
      const Index h = lines[static_cast<std::size_t>(i)];
      Index* source = plan.sources.data() + i * 2 * length;
      for (Index t = 0; t < length; ++t) {
        source[t] = at_.line_point(h, t, 0);
        source[t + length] = at_.line_point(h, t, -1);
      }
      std::copy_n(source + 1, targets, plan.targets.data() + i * targets);
    });
    plan_.rows.push_back(std::move(plan));
    return true;
  }

  /// Over the points of a line, then those beside it.
  [[nodiscard]] RowTable line_table(const RowTable& one) const {
    const int length = 2 * static_cast<int>(n_);
    // an umbrella's vertices from the one in the middle
    const std::array<int, 6> steps{0, 1, 1 + length, length, length - 1, -1};
    RowTable table;
    table.sources = 2 * length;
    for (int t = 1; t < length - 1; ++t)
      for (int row = 0; row < one.targets(); ++row) {
        for (int i = one.row_begin[row]; i < one.row_begin[row + 1]; ++i)
          table.terms.push_back({t + steps[one.terms[i].source], one.terms[i].weight});
        table.row_begin.push_back(static_cast<int>(table.terms.size()));
      }
    return table;
  }

  /// Points at centres that have not four sides, and rims' own points.
  Result<bool> plan_corners() {
    std::vector<CentrePoint> points;
    for (Index h = 0; h < mesh_.halfedge_count(); ++h) {
      if (!corners_.is_whole(h)) {
        points.push_back({Centre::face, h});
        continue;
      }
      const bool round_vertex = mesh_.valence(mesh_.origin(h)) != 4;
      if (mesh_.degree(mesh_.face(h)) != 4 || (n_ == 1 && round_vertex))
        points.push_back({Centre::face, h});
      if (n_ > 1 && round_vertex) points.push_back({Centre::vertex, h});
    }
    return add_umbrellas(
        points, level_, reader_, [this](const CentrePoint& p) { return umbrella(p); },
        [this](const CentrePoint& p, Index* out) { number(p, out); }, plan_.rows);
  }

  [[nodiscard]] Umbrella umbrella(const CentrePoint& p) const {
    if (!corners_.is_whole(p.h)) return rim_umbrella(p.h);
    const Index sides = mesh_.degree(mesh_.face(p.h)), valence = mesh_.valence(mesh_.origin(p.h));
    if (p.centre == Centre::vertex) return {false, {valence, 4, 4, 4}};
    return {false, {sides, 4, n_ > 1 ? 4 : valence, 4}};
  }

  [[nodiscard]] Umbrella rim_umbrella(Index h) const {
    Umbrella umbrella{true, {}};
    if (corners_.has_y_arm(h)) umbrella.degrees.push_back(4);
    umbrella.degrees.push_back(mesh_.degree(mesh_.face(h)));
    if (corners_.has_x_arm(h)) umbrella.degrees.push_back(4);
    return umbrella;
  }

  void number(const CentrePoint& p, Index* out) const {
    if (p.centre == Centre::vertex)
      number_at_vertex(p.h, out);
    else if (corners_.is_whole(p.h))
      number_at_face(p.h, out);
    else
      number_rim(p.h, out);
  }

  /// Counterclockwise from the control face's image, which begins at (-1, 0).
  void number_at_face(Index h, Index* out) const {
    const Index below = mesh_.prev(h);
    *out++ = at_.point(h, 0, 0);
    for (Index g = mesh_.next(h); g != h; g = mesh_.next(g)) *out++ = at_.point(g, 0, 0);
    *out++ = at_.line_point(below, 1, 0);
    *out++ = at_.line_point(below, 1, -1);
    if (n_ > 1) {
      *out++ = at_.point(h, 1, 1);
    } else {  // the vertex's face
      const Index last = mesh_.next(mesh_.twin(h));
      for (Index g = mesh_.rotate(mesh_.rotate(h)); g != last; g = mesh_.rotate(g))
        *out++ = at_.point(g, 0, 0);
    }
    *out++ = at_.line_point(h, 1, 0);
    *out++ = at_.line_point(h, 1, -1);
  }

  /// Counterclockwise from the vertex's face.
  void number_at_vertex(Index h, Index* out) const {
    const Index m = n_ - 1, before = mesh_.next(mesh_.twin(h)), after = mesh_.rotate(h);
    *out++ = at_.point(h, m, m);
    for (Index g = after; g != h; g = mesh_.rotate(g)) *out++ = at_.point(g, m, m);
    *out++ = at_.point(before, m, m - 1);
    *out++ = at_.point(h, m - 1, m);
    *out++ = at_.point(h, m - 1, m - 1);
    *out++ = at_.point(h, m, m - 1);
    *out++ = at_.point(after, m - 1, m);
  }

  /// Counterclockwise from the boundary.
  void number_rim(Index h, Index* out) const {
    const Index below = mesh_.prev(h);
    *out++ = at_.point(h, 0, 0);
    if (corners_.has_y_arm(h)) {
      *out++ = at_.line_point(h, 1, 0);
      *out++ = at_.line_point(h, 1, -1);
    }
    for (Index g = mesh_.next(h); g != h; g = mesh_.next(g)) *out++ = at_.point(g, 0, 0);
    if (corners_.has_x_arm(h)) {
      *out++ = at_.line_point(below, 1, 0);
      *out++ = at_.line_point(below, 1, -1);
    }
  }

  const DualLayout& at_;
  const DualCorners& corners_;
  const Mesh& mesh_;
  Index n_;
  int level_;
  LimitReader& reader_;
  StepPlan plan_;
};

/// The half-edges out of a vertex, turned so that its umbrella is the least of its turns.
std::vector<Index> fan_of(const Mesh& mesh, Index v) {
  std::vector<Index> fan;
  const Index first = mesh.halfedge_of_vertex(v);
  for (Index h = first; h != kNone && (fan.empty() || h != first); h = mesh.rotate(h))
    fan.push_back(h);
  if (mesh.is_boundary_vertex(v)) return fan;
  const auto degree = [&](Index h) { return mesh.degree(mesh.face(h)); };
  std::vector<Index> least = fan;
  for (std::size_t i = 1; i < least.size(); ++i) {
    std::rotate(fan.begin(), fan.begin() + 1, fan.end());
    if (std::lexicographical_compare(fan.begin(), fan.end(), least.begin(), least.end(),
                                     [&](Index g, Index h) { return degree(g) < degree(h); }))
      least = fan;
  }
  return least;
}

}  // namespace

Result<std::optional<StepPlan>> plan_dual_limit(const DualLayout& at, int level,
                                                LimitReader& reader) {
  const Result<bool> near = sees_own_faces(reader);
  if (!near) return near.error();
  if (!*near) return Found();
  return LimitPlanner(at, level, reader).plan();
}

Result<std::optional<StepPlan>> plan_control_dual_limit(const Mesh& mesh, int level,
                                                        LimitReader& reader) {
  const Result<bool> near = sees_own_faces(reader);
  if (!near) return near.error();
  if (!*near) return Found();
  std::vector<Index> vertices, isolated;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index valence = mesh.valence(v);
    if (valence > kLargestDualTable || (valence == 2 && !mesh.is_boundary_vertex(v)))
      return Found();
    (mesh.is_isolated(v) ? isolated : vertices).push_back(v);
  }
  const auto umbrella = [&](Index v) {
    Umbrella found{mesh.is_boundary_vertex(v), {}};
    for (const Index h : fan_of(mesh, v)) found.degrees.push_back(mesh.degree(mesh.face(h)));
    return found;
  };
  const auto number = [&](Index v, Index* out) {
    *out++ = v;
    for (const Index h : fan_of(mesh, v))
      for (Index g = mesh.next(h); g != mesh.prev(h); g = mesh.next(g)) *out++ = mesh.origin(g);
    if (mesh.is_boundary_vertex(v)) *out++ = mesh.origin(mesh.prev(fan_of(mesh, v).back()));
  };
  StepPlan plan;
  const Result<bool> done = add_umbrellas(vertices, level, reader, umbrella, number, plan.rows);
  if (!done) return done.error();
  if (!*done) return Found();
  add_isolated_limits(isolated, plan.rows);
  return Found(std::move(plan));
}

}  // namespace limn::fast
