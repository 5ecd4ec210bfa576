#include "support/averaging_reference.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

namespace limn::test {
namespace {

using Quad = std::array<std::size_t, 4>;
using Side = std::pair<std::size_t, std::size_t>;

/// The mesh cut by quads, as lists; its values are at vertices.
struct CutMesh {
  std::vector<double> values;
  std::vector<Quad> quads;  // by the half-edge out of the corner that it is cut off
  std::vector<Side> rim;    // its boundary edges
  std::set<std::size_t> on_rim;
};

CutMesh cut(const Mesh& mesh, const std::vector<double>& old) {
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  const std::size_t faces_at = vertices + static_cast<std::size_t>(mesh.edge_count());
  CutMesh result;
  result.values.assign(faces_at + static_cast<std::size_t>(mesh.face_count()), 0);
  std::copy(old.begin(), old.end(), result.values.begin());
  std::map<Side, int> uses;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> sides;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) sides.push_back(h);
    const std::size_t middle = faces_at + static_cast<std::size_t>(f);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Index h = sides[i], before = sides[(i + sides.size() - 1) % sides.size()];
      const auto v = static_cast<std::size_t>(mesh.origin(h));
      const auto w = static_cast<std::size_t>(mesh.origin(sides[(i + 1) % sides.size()]));
      const std::size_t next = vertices + static_cast<std::size_t>(mesh.edge(h));
      const std::size_t last = vertices + static_cast<std::size_t>(mesh.edge(before));
      result.values[next] = (old[v] + old[w]) / 2;
      result.values[middle] += old[v] / static_cast<double>(sides.size());
      if (result.quads.size() <= static_cast<std::size_t>(h))
        result.quads.resize(static_cast<std::size_t>(h) + 1);
      const Quad quad{v, next, middle, last};
      result.quads[static_cast<std::size_t>(h)] = quad;
      for (std::size_t k = 0; k < 4; ++k) ++uses[std::minmax(quad[k], quad[(k + 1) % 4])];
    }
  }
  for (const auto& [side, count] : uses) {
    if (count > 1) continue;
    result.rim.push_back(side);
    result.on_rim.insert({side.first, side.second});
  }
  return result;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Values at the quads, and at the edges of the rim.
struct Averages {
  std::vector<double> of_quads, of_rim;
};

Averages to_faces(const CutMesh& mesh) {
  Averages averages;
  for (const Quad& quad : mesh.quads) {
    std::vector<double> corners;
    for (const std::size_t v : quad) corners.push_back(mesh.values[v]);
    averages.of_quads.push_back(mean(corners));
  }
  for (const auto& [v, w] : mesh.rim)
    averages.of_rim.push_back(mean({mesh.values[v], mesh.values[w]}));
  return averages;
}

void to_vertices(const Averages& averages, double stam, CutMesh& mesh) {
  std::vector<std::vector<double>> at(mesh.values.size());
  std::vector<double> smooth(mesh.values.size(), 0);  // twice the neighbours, and the opposites
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (std::size_t k = 0; k < 4; ++k) {
      const Quad& quad = mesh.quads[q];
      if (mesh.on_rim.contains(quad[k])) continue;
      at[quad[k]].push_back(averages.of_quads[q]);
      smooth[quad[k]] += mesh.values[quad[(k + 1) % 4]] + mesh.values[quad[(k + 3) % 4]] +
                         mesh.values[quad[(k + 2) % 4]];
    }
  for (std::size_t r = 0; r < mesh.rim.size(); ++r)
    for (const std::size_t v : {mesh.rim[r].first, mesh.rim[r].second})
      at[v].push_back(averages.of_rim[r]);
  std::vector<double> fresh = mesh.values;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].empty()) continue;
    fresh[v] = mean(at[v]);
    if (mesh.on_rim.contains(v)) continue;
    const auto n = static_cast<double>(at[v].size());
    fresh[v] += stam * ((n - 3) / n * mesh.values[v] + smooth[v] / (n * n) - fresh[v]);
  }
  mesh.values = fresh;
}

}  // namespace

std::vector<double> averaging_reference_step(int degree, double stam, const Mesh& mesh,
                                             const std::vector<double>& old) {
  CutMesh made = cut(mesh, old);
  Averages averages;
  for (int k = 1; k < degree; ++k) {
    if (k % 2 != 0)
      averages = to_faces(made);
    else
      to_vertices(averages, stam, made);
  }
  if (degree % 2 != 0) return made.values;
  std::vector<double> values = averages.of_quads;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) values.push_back(old[static_cast<std::size_t>(v)]);
  return values;
}

}  // namespace limn::test
