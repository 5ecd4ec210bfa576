#pragma once
/// Smooth surfaces in closed form for the tests of pictures.

#include <cmath>
#include <map>
#include <numbers>

#include "limn/figure/space/surface_scene.h"

namespace limn::test {

/// The point and the normal at parameters (s, t) in [0, 1]².
struct SurfacePoint {
  figure::SpaceVector at, normal;
};

/// Vertices in one place become one: a closed surface has no seam.
inline figure::SmoothSurface welded(const figure::SmoothSurface& surface) {
  figure::SmoothSurface result;
  std::map<std::array<long, 3>, int> places;
  std::vector<int> place;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    std::array<long, 3> rounded{};
    for (std::size_t c = 0; c < 3; ++c) rounded[c] = std::lround(1e9 * surface.vertices[v][c]);
    const auto [at, is_new] = places.try_emplace(rounded, static_cast<int>(result.vertices.size()));
    place.push_back(at->second);
    if (!is_new) continue;
    result.vertices.push_back(surface.vertices[v]);
    result.normals.push_back(surface.normals[v]);
  }
  for (const auto& [i, j, k] : surface.triangles) {
    const std::array<int, 3> triangle = {place[i], place[j], place[k]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      result.triangles.push_back(triangle);
  }
  return result;
}

/// A grid of columns × rows quads in two triangles each, over parameters in [0, 1]².
template <class Function>
figure::SmoothSurface sampled_surface(int columns, int rows, Function function) {
  figure::SmoothSurface surface;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const SurfacePoint point = function(double(i) / columns, double(j) / rows);
      surface.vertices.push_back(point.at);
      surface.normals.push_back(point.normal);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({a, c, d});
    }
  }
  return welded(surface);
}

/// z = f(x, y) on [−1, 1]²; `field` gives {z, its slope in x, its slope in y}.
template <class Field>
figure::SmoothSurface height_surface(int cells, Field field) {
  return sampled_surface(cells, cells, [&](double s, double t) -> SurfacePoint {
    const double x = 2 * s - 1, y = 2 * t - 1;
    const auto [z, slope_x, slope_y] = field(x, y);
    return {{x, y, z}, {-slope_x, -slope_y, 1}};
  });
}

/// Of radius 1 about the origin; the poles are on the z axis.
inline figure::SmoothSurface sphere(int cells) {
  return sampled_surface(2 * cells, cells, [](double s, double t) -> SurfacePoint {
    const double a = 2 * std::numbers::pi * s, b = std::numbers::pi * (t - 0.5);
    const figure::SpaceVector at = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a),
                                    std::sin(b)};
    return {at, at};
  });
}

/// Of radii 1 and `thin` about the z axis.
inline figure::SmoothSurface torus(int cells, double thin) {
  return sampled_surface(2 * cells, cells, [thin](double s, double t) -> SurfacePoint {
    const double a = 2 * std::numbers::pi * s, b = 2 * std::numbers::pi * t;
    const figure::SpaceVector normal = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a),
                                        std::sin(b)};
    return {figure::sum({std::cos(a), std::sin(a), 0}, normal, thin), normal};
  });
}

inline figure::SmoothSurface saddle(int cells) {
  return height_surface(cells, [](double x, double y) {
    return figure::SpaceVector{0.4 * (x * x - y * y), 0.8 * x, -0.8 * y};
  });
}

}  // namespace limn::test
