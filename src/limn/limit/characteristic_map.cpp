#include "limn/limit/characteristic_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/limit/judge_characteristic_map.h"
#include "limn/refine/star_step.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn {
namespace {

constexpr int kMoreRings = 2;  // than control the surface: what depends on the rim stays outside

std::vector<Point3> plane_points(const FrequencyBlocks& blocks, const Eigenvectors& vectors) {
  const auto coordinates = spatial_vectors(blocks, 1, vectors.right.col(0));
  std::vector<Point3> points;
  for (std::size_t v = 0; v < coordinates[0].size(); ++v)
    points.push_back({coordinates[0][v], coordinates[1][v], 0});
  return points;
}

/// Signed area of a face over the square of its distance from the centre, with which areas grow.
double relative_area(const StarSurface& surface, Index f) {
  const Mesh& mesh = surface.mesh;
  double twice = 0;
  double x = 0;
  double y = 0;
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
    const Point3& a = surface.positions[mesh.origin(h)];
    const Point3& b = surface.positions[mesh.target(h)];
    twice += a.x * b.y - a.y * b.x;
    x += a.x / mesh.degree(f);
    y += a.y / mesh.degree(f);
  }
  return twice / (x * x + y * y);
}

/// Of the faces; but not of the one round the centre of a dual split, which is at no distance.
double smallest_relative_area(const StarSurface& surface) {
  double sum = 0;
  double count = 0;
  double smallest = 1e300;
  for (Index f = 0; f < surface.mesh.face_count(); ++f) {
    const double area = relative_area(surface, f);
    if (!(std::abs(area) < 1e6)) continue;
    sum += std::abs(area);
    count += 1;
    smallest = std::min(smallest, area);
  }
  return smallest * count / sum;
}

/// How often the boundary of the image goes round the centre.
double winding_number(const StarSurface& surface) {
  const Mesh& mesh = surface.mesh;
  double angle = 0;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (mesh.twin(h) != kNone) continue;
    const Point3& a = surface.positions[mesh.origin(h)];
    const Point3& b = surface.positions[mesh.target(h)];
    angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return angle / (2 * std::numbers::pi);
}

struct Signs {
  Index positive = 0, negative = 0, unsure = 0;  ///< Jacobians; the normal looks up, down, nowhere
};

Signs signs_of(const StarSurface& surface) {
  Signs signs;
  for (const Point3& normal : surface.normals)
    ++(normal.z > 0 ? signs.positive : normal.z < 0 ? signs.negative : signs.unsure);
  return signs;
}

/// Eigenvectors have no sign: a map that is turned over in most places is turned back.
void orient(CharacteristicMap& map) {
  const Signs signs = signs_of(map.image);
  map.turned_over = signs.negative > signs.positive;
  if (!map.turned_over) return;
  for (Point3& p : map.net_points) p.y = -p.y;
  for (Point3& p : map.image.positions) p.y = -p.y;
  for (Point3& normal : map.image.normals) normal = {-normal.x, normal.y, -normal.z};
}

void judge(CharacteristicMap& map) {
  const Signs signs = signs_of(map.image);
  const auto points = map.image.normals.size();
  map.regular = Truth::undecided;
  map.smallest_area = 0;
  if (signs.positive == 0) {
    map.reason = "it is degenerate: the Jacobian cannot be told from 0 at any point";
    return;
  }
  map.smallest_area = smallest_relative_area(map.image);
  const double winding = winding_number(map.image);
  if (signs.negative > 0) {
    map.regular = Truth::no;
    map.reason = fmt::format("it folds: the Jacobian changes its sign, at {} of {} points",
                             signs.negative, points);
  } else if (map.smallest_area < -1e-9) {
    map.regular = Truth::no;
    map.reason = "it folds: a face of the image is turned over";
  } else if (std::abs(winding - 1) > 1e-6) {
    map.regular = Truth::no;
    map.reason = fmt::format("the image goes round the centre {:.3g} times", winding);
  } else if (signs.unsure > 0 || map.smallest_area < 1e-9) {
    map.reason = "a Jacobian or the area of a face could not be told from 0";
  } else {
    map.regular = Truth::yes;
    map.reason =
        fmt::format("no fold found: the Jacobian has one sign at {} sampled points", points);
  }
}

}  // namespace

void limit::judge_characteristic_map(CharacteristicMap& map) {
  orient(map);
  judge(map);
}

Result<CharacteristicMap> approx_characteristic_map(const Scheme& scheme, int n, int steps) {
  const Result<FrequencyBlocks> near = FrequencyAnalysis(scheme).blocks(n);
  if (!near) return near.error();
  const Eigencomponents components = approx_eigencomponents(*near);
  const Eigenvalue& leader = components.spectra[1].eigenvalues.front();
  if (!components.tangent || !(*components.tangent > 0) || leader.multiplicity > 1)
    return Error{
        fmt::format("scheme '{}' has no characteristic map at valence {}: frequency 1 is "
                    "not led by a simple positive eigenvalue",
                    scheme.name, n)};
  const int rings = near->rings + kMoreRings;
  const Result<FrequencyBlocks> wide = FrequencyAnalysis(scheme, rings).blocks(n);
  if (!wide) return wide.error();
  CharacteristicMap map;
  map.valence = n;
  map.eigenvalue = *components.tangent;
  map.net = refine::split_star(*scheme.split, n, near->rings);
  map.net_points = plane_points(*near, approx_eigenvectors(*near, leader));
  Result<StarSurface> image = approx_star_surface(
      scheme, n, rings, plane_points(*wide, approx_eigenvectors(*wide, leader)), steps);
  if (!image) return image.error();
  map.image = std::move(*image);
  limit::judge_characteristic_map(map);
  return map;
}

}  // namespace limn
