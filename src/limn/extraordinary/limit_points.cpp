#include "limn/extraordinary/limit_points.h"

#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/extraordinary/limit_curvature.h"
#include "limn/extraordinary/limit_sites.h"
#include "limn/mesh/lattice.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"

namespace limn {
namespace {

constexpr int kMostSteps = 12;  // until a neighbourhood is regular; each halves its faces
constexpr int kMargin = 3;      // rings round a neighbourhood, so that a cut does not reach it
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Point3 normalized(const Point3& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : Point3{};
}

/// The sum of the faces' normals round a vertex, or that of one face, by their areas.
Point3 normal_of_faces(const Mesh& mesh, const std::vector<Point3>& values, Index start,
                       bool face) {
  Point3 sum;
  Index h = start;
  do {
    const Index last = face ? h : mesh.prev(h);
    const Point3 from = values[mesh.origin(face ? mesh.prev(h) : h)];
    sum = sum + (face ? cross(values[mesh.origin(h)] - from, values[mesh.target(h)] - from)
                      : cross(values[mesh.target(h)] - from, values[mesh.origin(last)] - from));
    h = face ? mesh.next(h) : mesh.rotate(h);
  } while (h != kNone && h != start);
  return normalized(sum);
}

/// What is measured at vertices of one kind: their stencils, and where these apply.
struct Kind {
  LimitStencil limit;
  std::optional<CurvatureStencil> curvature;
  Pattern pattern;
};

Point3 weighted(const std::vector<double>& weights, const std::vector<Index>& vertices,
                const std::vector<Point3>& values) {
  Point3 sum;
  for (std::size_t i = 0; i < weights.size(); ++i) add_scaled(sum, weights[i], values[vertices[i]]);
  return sum;
}

/// t1 × t2 as a unit vector; zero where rounding of the points is all there is to it.
Point3 normal_of(const Point3& t1, const Point3& t2, const std::vector<Index>& vertices,
                 const std::vector<Point3>& values) {
  double size = 0;
  for (const Index v : vertices)
    size = std::max({size, std::abs(values[v].x), std::abs(values[v].y), std::abs(values[v].z)});
  const Point3 normal = cross(t1, t2);
  const double rounding = 1e-14 * size * std::sqrt(dot(t1, t1) + dot(t2, t2));
  return dot(normal, normal) > rounding * rounding ? normalized(normal) : Point3{};
}

/// Principal curvatures of u t1 + v t2 + cup (u² + v²) + saddle1 (u² − v²) + saddle2 2uv at 0.
LimitPoints::Curvatures principal(const Point3& t1, const Point3& t2, const Point3& cup,
                                  const Point3& saddle1, const Point3& saddle2) {
  const Point3 normal = normalized(cross(t1, t2));
  Eigen::Matrix2d first;
  Eigen::Matrix2d second;
  first << dot(t1, t1), dot(t1, t2), dot(t1, t2), dot(t2, t2);
  const double c = 2 * dot(normal, cup);
  const double s = 2 * dot(normal, saddle1);
  const double m = 2 * dot(normal, saddle2);
  second << c + s, m, m, c - s;
  if (!(first.determinant() > 0)) return {kNaN, kNaN};
  const Eigen::Vector2d values =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(second, first).eigenvalues();
  return {values(1), values(0)};
}

class Evaluator {
 public:
  Evaluator(const Scheme& scheme, const LimitOptions& options, LimitPoints& out)
      : scheme_(scheme),
        dual_(scheme.split->births_corners),
        options_(options),
        analysis_(scheme),
        out_(out) {}

  Status run(const Mesh& control, const std::vector<Point3>& control_values,
             const std::vector<Index>& vertices) {
    RuleTables<double> tables(scheme_, options_.boundary ? Boundary::refined : Boundary::left_out);
    int step = options_.steps_made;
    LimitPatch patch;
    if (dual_) {
      Result<LimitPatch> first =
          dual_patch(scheme_, control, control_values, vertices, step++, tables);
      if (!first) return first.error();
      patch = std::move(*first);
    } else {
      patch.sites = limit_sites(control, vertices);
    }
    bool in_patch = dual_;
    for (int round = 0; round < kMostSteps; ++round) {
      const Mesh& mesh = in_patch ? patch.mesh : control;
      const std::vector<Point3>& values = in_patch ? patch.values : control_values;
      if (Status status = prepare(mesh, patch.sites); !status) return status;
      evaluate(mesh, values, step, patch.sites);
      if (patch.sites.empty()) return Done{};
      if (options_.progress) options_.progress(static_cast<int>(patch.sites.size()));
      Result<LimitPatch> next =
          refined_patch(scheme_, mesh, values, patch.sites, rings_ + kMargin, step++, tables);
      if (!next) return next.error();
      patch = std::move(*next);
      in_patch = true;
    }
    return Error{fmt::format("no limit points at vertex {}: after {} steps its surroundings are "
                             "still not regular",
                             patch.sites.front().result, kMostSteps),
                 {},
                 {},
                 0,
                 0};
  }

 private:
  [[nodiscard]] bool at_boundary(const Mesh& mesh, Index at) const {
    return !dual_ && mesh.is_boundary_vertex(at);
  }
  /// Edges at an interior vertex, corners of a face, or faces at a boundary vertex.
  [[nodiscard]] int size_of(const Mesh& mesh, Index at) const {
    if (dual_) return mesh.degree(mesh.face(at));
    return mesh.valence(at) - (mesh.is_boundary_vertex(at) ? 1 : 0);
  }
  std::map<int, Kind>& kinds(bool boundary) { return kinds_[boundary ? 1 : 0]; }

  Status prepare(const Mesh& mesh, const std::vector<LimitSite>& sites) {
    for (const LimitSite& site : sites) {
      const bool boundary = at_boundary(mesh, site.at);
      const int size = size_of(mesh, site.at);
      if (kinds(boundary).count(size) > 0) continue;
      Result<Kind> kind = make_kind(boundary, size);
      if (!kind) {
        kind.error().message =
            fmt::format("vertex {}: {}", site.result, std::move(kind.error().message));
        return kind.error();
      }
      kinds(boundary).emplace(size, std::move(*kind));
    }
    return Done{};
  }

  Result<Kind> make_kind(bool boundary, int size) {
    Result<LimitStencil> limit = boundary ? approx_boundary_limit_stencil(scheme_, size)
                                          : approx_limit_stencil(analysis_, size);
    if (!limit) return limit.error();
    std::optional<CurvatureStencil> curvature;
    if (options_.curvatures && !boundary) {
      Result<std::optional<CurvatureStencil>> found =
          approx_curvature_stencil(scheme_, analysis_, size);
      if (!found) return found.error();
      curvature = std::move(*found);
    }
    const int rings = std::max(limit->rings, curvature ? curvature->rings : 0);
    rings_ = std::max(rings_, rings);
    // What is inside must be regular: rules that look from an edge's end see one ring farther.
    const int shape = rings + (scheme_.rule(RuleKind::edge_end) ? 1 : 0);
    const Split& split = *scheme_.split;
    Pattern pattern =
        boundary
            ? Pattern(fan(split.lattice, size, shape), fan_size(split.lattice, size, shape - 1))
            : Pattern(split_star(split, size, shape), split_star_size(split, size, shape - 1));
    return Kind{std::move(*limit), std::move(curvature), std::move(pattern)};
  }

  /// Does the sites where the mesh is standard; leaves the others.
  void evaluate(const Mesh& mesh, const std::vector<Point3>& values, int step,
                std::vector<LimitSite>& sites) {
    std::vector<char> done(sites.size(), 0);
    const bool boundary_rests = scheme_.split->trisects_boundary && step % 2 != 0;
    parallel_for(std::size_t{0}, sites.size(), [&](std::size_t first, std::size_t last) {
      std::vector<Index> vertices;
      for (std::size_t i = first; i < last; ++i) {
        const Index at = sites[i].at;
        const bool boundary = at_boundary(mesh, at);
        if (boundary && boundary_rests) continue;
        const Kind& kind = kinds_[boundary ? 1 : 0].at(size_of(mesh, at));
        const Index start = dual_ ? at : mesh.halfedge_of_vertex(at);
        if (!kind.pattern.match(mesh, start, vertices)) continue;
        apply(kind, mesh, values, start, vertices, sites[i].result);
        done[i] = 1;
      }
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sites.size(); ++i)
      if (done[i] == 0) sites[kept++] = sites[i];
    sites.resize(kept);
  }

  void apply(const Kind& kind, const Mesh& mesh, const std::vector<Point3>& values, Index start,
             const std::vector<Index>& vertices, Index result) {
    out_.positions[result] = weighted(kind.limit.position, vertices, values);
    const Point3 t1 = weighted(kind.limit.first_tangent, vertices, values);
    const Point3 t2 = weighted(kind.limit.second_tangent, vertices, values);
    out_.normals[result] = kind.limit.first_tangent.empty()
                               ? normal_of_faces(mesh, values, start, dual_)
                               : normal_of(t1, t2, vertices, values);
    if (!kind.curvature) return;
    out_.curvatures[result] = principal(t1, t2, weighted(kind.curvature->cup, vertices, values),
                                        weighted(kind.curvature->first_saddle, vertices, values),
                                        weighted(kind.curvature->second_saddle, vertices, values));
  }

  const Scheme& scheme_;
  bool dual_;
  const LimitOptions& options_;
  FrequencyAnalysis analysis_;
  LimitPoints& out_;
  std::map<int, Kind> kinds_[2];  // interior, boundary; by size_of
  int rings_ = 1;                 // of the widest of them
};

}  // namespace

Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Point3>& values,
                                        const LimitOptions& options) {
  LimitPoints out;
  out.positions.resize(values.size());
  out.normals.resize(values.size());
  if (options.curvatures) out.curvatures.assign(values.size(), {kNaN, kNaN});
  std::vector<Index> vertices = options.vertices;
  if (vertices.empty()) {
    vertices.resize(values.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  for (const Index v : vertices)
    if (mesh.is_isolated(v)) out.positions[v] = values[v];
  Evaluator evaluator(scheme, options, out);
  if (Status status = evaluator.run(mesh, values, vertices); !status) return status.error();
  return out;
}

}  // namespace limn
