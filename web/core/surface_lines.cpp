#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "limn/mesh/split/heritage.h"
#include "limn/refine/refine.h"
#include "page_state.h"

namespace limn::page {
namespace {

/// Control points at no special place, so that every refined vertex lies at one of its own.
std::vector<Point3> random_points(std::size_t count) {
  std::mt19937 random(1);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Point3> points(count);
  for (Point3& point : points) point = {next(), next(), next()};
  return points;
}

/// The edges of the mesh after so many steps that lie on edges of the control mesh.
std::vector<std::uint32_t> inherited_edges(const Split& split, Mesh mesh, int levels) {
  std::vector<bool> on_control(static_cast<std::size_t>(mesh.edge_count()), true);
  for (int step = 0; step < levels; ++step) {
    SplitResult fine = split.apply(mesh, step);
    const std::vector<Index> old = old_halfedges(mesh, fine);
    std::vector<bool> on(static_cast<std::size_t>(fine.mesh.edge_count()));
    for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
      const Index h = old[static_cast<std::size_t>(fine.mesh.halfedge_of_edge(e))];
      on[static_cast<std::size_t>(e)] =
          h != kNone && on_control[static_cast<std::size_t>(mesh.edge(h))];
    }
    on_control = std::move(on);
    mesh = std::move(fine.mesh);
  }
  std::vector<std::uint32_t> pairs;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!on_control[static_cast<std::size_t>(e)]) continue;
    const Index h = mesh.halfedge_of_edge(e);
    pairs.push_back(static_cast<std::uint32_t>(mesh.origin(h)));
    pairs.push_back(static_cast<std::uint32_t>(mesh.target(h)));
  }
  return pairs;
}

std::vector<std::size_t> by_place(const std::vector<Point3>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return points[a].x < points[b].x; });
  return order;
}

/// For each of the points the one of `to` in the same place; empty where they are not the same.
std::vector<std::uint32_t> matched(const std::vector<Point3>& points,
                                   const std::vector<Point3>& to) {
  if (points.size() != to.size()) return {};
  const std::vector<std::size_t> from_order = by_place(points), to_order = by_place(to);
  std::vector<std::uint32_t> match(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 apart = points[from_order[i]] - to[to_order[i]];
    if (!(dot(apart, apart) < 1e-18)) return {};
    match[from_order[i]] = static_cast<std::uint32_t>(to_order[i]);
  }
  return match;
}

/// Where refinement puts the plan's vertices if the control points are these.
std::vector<Point3> refined_points(LoadedPlan& plan, const std::vector<Point3>& control) {
  if (plan.refiner) {
    std::vector<Point3> points(plan.refined.positions.size());
    plan.refiner->evaluate<double>(numbers_of(control), numbers_of(points), plan.scratch);
    return points;
  }
  SurfaceOptions options;
  options.levels = plan.levels;
  options.sharpness = plan.sharpness;
  Result<RefinedSurface> surface =
      refine_surface(plan.scheme->scheme, plan.mesh->mesh, control, options);
  if (!surface || surface->polygons.corners != plan.refined.corners) return {};
  return std::move(surface->polygons.positions);
}

}  // namespace

// The engines number vertices in orders of their own; which edges lie on the control mesh's is
// known in the plain one's. So vertices are matched by where they lie.
std::vector<std::uint32_t> edges_on_surface(LoadedPlan& plan) {
  const Scheme& scheme = plan.scheme->scheme;
  if (!keeps_old_edges(*scheme.split) || !scheme.split->halves_edges()) return {};
  const std::vector<Point3> control = random_points(plan.mesh->points.size());
  const Result<Refined<Point3>> plain =
      refine(scheme, plan.mesh->mesh, control, plan.levels, {}, plan.sharpness);
  if (!plain) return {};
  const std::vector<std::uint32_t> match = matched(plain->values, refined_points(plan, control));
  if (match.empty()) return {};
  std::vector<std::uint32_t> lines = inherited_edges(*scheme.split, plan.mesh->mesh, plan.levels);
  for (std::uint32_t& vertex : lines) vertex = match[vertex];
  return lines;
}

}  // namespace limn::page
