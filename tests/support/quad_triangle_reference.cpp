#include "support/quad_triangle_reference.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace limn::test {
namespace {

using Vertex = std::size_t;

/// The mesh that was cut, as a list of faces.
struct CutFaces {
  std::vector<double> values;
  std::vector<std::vector<Vertex>> faces;
};

CutFaces cut(const Mesh& mesh, const std::vector<double>& old) {
  CutFaces result{old, {}};
  const auto vertices = static_cast<Vertex>(mesh.vertex_count());
  result.values.resize(vertices + static_cast<Vertex>(mesh.edge_count()), 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Vertex> corners, middles;  // middles[i] is between corners i and i + 1
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
      corners.push_back(static_cast<Vertex>(mesh.origin(h)));
      middles.push_back(vertices + static_cast<Vertex>(mesh.edge(h)));
    }
    const std::size_t count = corners.size();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      result.values[middles[i]] = (old[corners[i]] + old[corners[(i + 1) % count]]) / 2;
      sum += old[corners[i]];
    }
    if (count == 3) {
      for (std::size_t i = 0; i < 3; ++i)
        result.faces.push_back({corners[i], middles[i], middles[(i + 2) % 3]});
      result.faces.push_back(middles);
      continue;
    }
    const Vertex center = result.values.size();
    result.values.push_back(sum / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      result.faces.push_back({corners[i], middles[i], center, middles[(i + count - 1) % count]});
  }
  return result;
}

/// What is round each vertex.
struct Round {
  std::multiset<Vertex>
      sides;  // the other end of each face's side there: an inner edge comes twice
  std::vector<Vertex> opposite;
};

}  // namespace

std::vector<double> quad_triangle_reference_step(const Mesh& mesh, const std::vector<double>& old,
                                                 double own) {
  const CutFaces made = cut(mesh, old);
  std::vector<Round> round(made.values.size());
  for (const std::vector<Vertex>& face : made.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      round[face[i]].sides.insert(face[(i + 1) % face.size()]);
      round[face[i]].sides.insert(face[(i + face.size() - 1) % face.size()]);
      if (face.size() == 4) round[face[i]].opposite.push_back(face[(i + 2) % 4]);
    }
  std::vector<double> fresh = made.values;
  for (Vertex v = 0; v < fresh.size(); ++v) {
    const Round& at = round[v];
    double weights = 1, sum = made.values[v], rim = 0, neighbours = 0, corners = 0, n = 0;
    std::size_t on_rim = 0;
    for (auto side = at.sides.begin(); side != at.sides.end(); side = at.sides.upper_bound(*side)) {
      if (at.sides.count(*side) % 2 != 0) {
        ++on_rim;
        rim += made.values[*side];
      }
      // two edges may join the same vertices, one twice for each
      const auto edges = static_cast<double>((at.sides.count(*side) + 1) / 2);
      weights += edges / 2;
      sum += edges * made.values[*side] / 2;
      neighbours += edges * made.values[*side];
      n += edges;
    }
    for (const Vertex w : at.opposite) {
      weights += 1.0 / 4;
      sum += made.values[w] / 4;
      corners += made.values[w];
    }
    if (at.sides.empty()) continue;
    fresh[v] = on_rim > 0 ? made.values[v] / 2 + rim / 4 : sum / weights;
    if (on_rim > 0) continue;
    if (at.opposite.empty()) {
      const double lambda = 3 / 8. + std::cos(2 * std::numbers::pi / n) / 4;
      const double self = 1 - 2 * (5 / 8. - lambda * lambda);  // half of it comes from neighbours
      fresh[v] += own * (self * made.values[v] + (1 - self) / n * neighbours - fresh[v]);
    } else if (static_cast<double>(at.opposite.size()) == n) {
      const double mean = (n - 3) / n * made.values[v] + (2 * neighbours + corners) / (n * n);
      fresh[v] += own * (mean - fresh[v]);
    }
  }
  return fresh;
}

}  // namespace limn::test
