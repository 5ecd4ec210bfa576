#include "same_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/core.h>

namespace limn::peers {
namespace {

double distance(Point3 a, Point3 b) {
  const Point3 d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

double diagonal(const std::vector<Point3>& points) {
  if (points.empty()) return 0;
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

/// Points sorted by x; each can be taken once.
class Pairing {
 public:
  explicit Pairing(const std::vector<Point3>& points)
      : points_(points), by_x_(points.size()), taken_(points.size(), false) {
    std::iota(by_x_.begin(), by_x_.end(), 0);
    std::sort(by_x_.begin(), by_x_.end(),
              [&](Index a, Index b) { return points_[a].x < points_[b].x; });
  }

  /// The nearest point within `radius` that is not taken yet, which is then taken; or kNone.
  Index take_nearest(Point3 p, double radius) {
    auto i = std::lower_bound(by_x_.begin(), by_x_.end(), p.x - radius,
                              [&](Index a, double x) { return points_[a].x < x; });
    Index nearest = kNone;
    for (double least = radius; i != by_x_.end() && points_[*i].x <= p.x + radius; ++i) {
      const double d = distance(points_[*i], p);
      if (taken_[*i] || d > least) continue;
      least = d;
      nearest = *i;
    }
    if (nearest != kNone) taken_[nearest] = true;
    return nearest;
  }

  [[nodiscard]] double least_distance(Point3 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Point3& q : points_) least = std::min(least, distance(p, q));
    return least;
  }

 private:
  const std::vector<Point3>& points_;
  std::vector<Index> by_x_;
  std::vector<bool> taken_;
};

/// Faces as cycles that start at their smallest corner, sorted.
std::vector<std::vector<Index>> cycles(const Polygons& mesh, const std::vector<Index>& names) {
  std::vector<std::vector<Index>> result;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> cycle;
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
      cycle.push_back(names[mesh.corners[c]]);
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    result.push_back(std::move(cycle));
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::string difference(const Polygons& ours, const Polygons& theirs, double tolerance) {
  if (ours.vertex_count() != theirs.vertex_count())
    return fmt::format("{} vertices, theirs {}", ours.vertex_count(), theirs.vertex_count());
  if (ours.face_count() != theirs.face_count())
    return fmt::format("{} faces, theirs {}", ours.face_count(), theirs.face_count());
  const double size = diagonal(ours.positions);
  Pairing pairing(ours.positions);
  std::vector<Index> partner;
  for (const Point3& p : theirs.positions) {
    partner.push_back(pairing.take_nearest(p, tolerance * size));
    if (partner.back() == kNone)
      return fmt::format("their vertex {} at ({}, {}, {}) is {:.3g} of the size from all of ours",
                         partner.size() - 1, p.x, p.y, p.z, pairing.least_distance(p) / size);
  }
  std::vector<Index> same(ours.positions.size());
  std::iota(same.begin(), same.end(), 0);
  if (cycles(ours, same) != cycles(theirs, partner)) return "the faces join other vertices";
  return {};
}

}  // namespace limn::peers
