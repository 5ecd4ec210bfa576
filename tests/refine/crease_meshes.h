#pragma once
/// Random meshes with creases, for tests of what every scheme that takes them shall do.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {

inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

inline Sharpness one_infinite_vertex() { return {{}, {kInfinitelySharp}, {}, {}}; }

inline bool takes_creases(const Scheme& scheme) {
  return refine::check_takes_sharpness(scheme, one_infinite_vertex()).ok();
}

inline std::vector<std::string> schemes_that_take_creases() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes())
    if (takes_creases(shipped(name))) names.push_back(name);
  return names;
}

/// A random mesh, without the vertices of valence 2 that some schemes have no rule for.
inline Mesh control_mesh(const Scheme& scheme, unsigned& seed) {
  for (;; ++seed) {
    Mesh mesh =
        scheme.split->any_polygons ? RandomMesh(seed).polygons() : RandomMesh(seed).triangles();
    bool good = true;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      good = good && (mesh.is_isolated(v) || mesh.is_boundary_vertex(v) || mesh.valence(v) >= 3);
    if (good) return mesh;
  }
}

inline std::vector<Point3> random_points(Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point3> points;
  for (Index i = 0; i < count; ++i)
    points.push_back({uniform(random), uniform(random), uniform(random)});
  return points;
}

inline double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Of some edges and vertices.
inline Sharpness random_sharpness(const Mesh& mesh, unsigned seed, double share, bool whole) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Sharpness sharpness;
  const auto value = [&] { return whole ? 1 + std::floor(3 * unit(random)) : 3 * unit(random); };
  for (Index e = 0; e < mesh.edge_count(); ++e)
    sharpness.edges.push_back(unit(random) < share ? value() : 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    sharpness.vertices.push_back(unit(random) < share / 3 ? value() : 0);
  return sharpness;
}

/// All that is sharp, as sharp as that.
inline Sharpness made_equal(Sharpness sharpness, double value) {
  for (std::vector<double>* list : {&sharpness.edges, &sharpness.vertices})
    for (double& s : *list) s = s > 0 ? value : 0;
  return sharpness;
}

/// Faces near one of them: a region whose rim meets nothing, so that no vertex has more than two
/// sharp edges; empty where there is none.
inline std::vector<bool> region(const Mesh& mesh, std::mt19937& random) {
  std::vector<bool> inside(at(mesh.face_count()), false);
  std::vector<Index> reached{
      static_cast<Index>(random() % static_cast<unsigned>(mesh.face_count()))};
  const std::size_t size = 1 + random() % (inside.size() / 2 + 1);
  for (std::size_t i = 0; i < reached.size() && i < size; ++i) {
    if (inside[at(reached[i])]) continue;
    inside[at(reached[i])] = true;
    for (Index h = mesh.face_begin(reached[i]); h < mesh.face_begin(reached[i] + 1); ++h)
      if (mesh.twin(h) != kNone) reached.push_back(mesh.face(mesh.twin(h)));
  }
  std::vector<Index> sharp(at(mesh.vertex_count()), 0);
  bool any = false;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), t = mesh.twin(h);
    if (t != kNone && inside[at(mesh.face(h))] == inside[at(mesh.face(t))]) continue;
    any = any || t != kNone;
    ++sharp[at(mesh.origin(h))];
    ++sharp[at(mesh.target(h))];
  }
  const bool simple = std::all_of(sharp.begin(), sharp.end(), [](Index n) { return n <= 2; });
  return any && simple ? inside : std::vector<bool>();
}

inline Sharpness rim_of(const Mesh& mesh, const std::vector<bool>& inside) {
  Sharpness sharpness;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), t = mesh.twin(h);
    const bool rim = t != kNone && inside[at(mesh.face(h))] != inside[at(mesh.face(t))];
    sharpness.edges.push_back(rim ? kInfinitelySharp : 0);
  }
  return sharpness;
}

/// The faces inside (or outside), as a mesh of its own.
inline Polygons part_of(const Polygons& whole, const std::vector<bool>& inside, bool which) {
  Polygons part;
  std::vector<Index> number(whole.positions.size(), kNone);
  for (Index f = 0; f < whole.face_count(); ++f) {
    if (inside[at(f)] != which) continue;
    for (Index c = whole.face_begin[at(f)]; c < whole.face_begin[at(f) + 1]; ++c) {
      Index& v = number[at(whole.corners[at(c)])];
      if (v == kNone) {
        v = part.vertex_count();
        part.positions.push_back(whole.positions[at(whole.corners[at(c)])]);
      }
      part.corners.push_back(v);
    }
    part.face_begin.push_back(static_cast<Index>(part.corners.size()));
  }
  return part;
}

}  // namespace limn::test
