#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

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
    std::vector<Point3> points(plan.positions.size() / 3);
    plan.refiner->evaluate<double>(numbers_of(control), numbers_of(points));
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
mesh::EdgePaths lines_of(LoadedPlan& plan) {
  const Scheme& scheme = plan.scheme->scheme;
  const std::vector<Point3> control = random_points(plan.mesh->points.size());
  const Result<refine::Refined<Point3>> plain =
      refine::refine(scheme, plan.mesh->mesh, control, plan.levels, {}, plan.sharpness);
  if (!plain) return {};
  const std::vector<std::uint32_t> match = matched(plain->values, refined_points(plan, control));
  if (match.empty()) return {};
  mesh::EdgePaths lines = mesh::edge_paths(*scheme.split, plan.mesh->mesh, plan.levels);
  for (Index& vertex : lines.vertices) vertex = static_cast<Index>(match[vertex]);
  return lines;
}

LinesAnswer PageCore::lines(int plan) {
  LinesAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->plans.find(plan);
    if (!found) return found.error();
    std::optional<mesh::EdgePaths>& lines = (*found)->lines;
    if (!lines) lines = lines_of(**found);
    made.vertices.assign(lines->vertices.begin(), lines->vertices.end());
    made.begin.assign(lines->begin.begin(), lines->begin.end());
    for (const mesh::EdgePaths::Segment& segment : lines->segments)
      for (const Index point : {segment.from, segment.to})
        made.segments.push_back(static_cast<std::uint32_t>(point));
    return Json::object();
  });
  return made;
}

}  // namespace limn::page
