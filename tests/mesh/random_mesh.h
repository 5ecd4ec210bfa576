#pragma once
/// Random valid meshes for tests, and what tests ask of a mesh. Everything follows from a seed,
/// so that rapidcheck can repeat a failure.

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "limn/mesh/lattice.h"
#include "limn/mesh/mesh.h"

namespace limn::test {

using Faces = std::vector<std::vector<Index>>;

inline Polygons make_polygons(Index vertices, const Faces& faces) {
  Polygons result;
  result.positions.resize(static_cast<std::size_t>(vertices));
  for (const auto& face : faces) {
    result.corners.insert(result.corners.end(), face.begin(), face.end());
    result.face_begin.push_back(static_cast<Index>(result.corners.size()));
  }
  return result;
}

inline Faces faces_of(const Polygons& polygons) {
  Faces faces;
  for (Index f = 0; f < polygons.face_count(); ++f)
    faces.emplace_back(polygons.corners.begin() + polygons.face_begin[f],
                       polygons.corners.begin() + polygons.face_begin[f + 1]);
  return faces;
}

inline Polygons polygons_of(const Mesh& mesh) {
  return mesh.polygons(std::vector<Point3>(static_cast<std::size_t>(mesh.vertex_count())));
}

/// The face as a list that starts at its smallest corner; cyclic equality becomes ==.
inline std::vector<Index> from_smallest(std::vector<Index> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

inline Mesh must_build(Index vertices, const Faces& faces) {
  return Mesh::build(make_polygons(vertices, faces)).value();
}

inline Mesh tetrahedron() { return must_build(4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}); }

inline Mesh cube() {
  return must_build(
      8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

inline Mesh icosahedron() {
  Faces faces;
  for (Index i = 0; i < 5; ++i) {
    const Index j = (i + 1) % 5;
    faces.push_back({0, 1 + i, 1 + j});
    faces.push_back({1 + i, 6 + i, 1 + j});
    faces.push_back({1 + j, 6 + i, 6 + j});
    faces.push_back({11, 6 + j, 6 + i});
  }
  return must_build(12, faces);
}

/// Two n-gons back to back: a closed surface whose vertices all have valence 2.
inline Mesh pillow(Index n) {
  std::vector<Index> front(static_cast<std::size_t>(n));
  std::iota(front.begin(), front.end(), 0);
  std::vector<Index> back(front.rbegin(), front.rend());
  return must_build(n, {front, back});
}

class RandomMesh {
 public:
  explicit RandomMesh(unsigned seed) : random_(seed) {}

  Mesh triangles() {
    const Mesh seed = base();
    vertices_ = seed.vertex_count();
    faces_ = faces_of(triangulated(polygons_of(seed)));
    // a fan may run an edge along one that is there already; then take another seed
    if (!Mesh::build(make_polygons(vertices_, faces_))) return triangles();
    if (chance(2)) remove_faces();
    return disguised();
  }

  /// Triangles beside other faces: those of a mesh of polygons, some of which are cut in two.
  Mesh mixed() {
    const Mesh seed = polygons();
    vertices_ = seed.vertex_count();
    faces_ = faces_of(polygons_of(seed));
    for (std::size_t f = 0, count = faces_.size(); f < count; ++f) {
      if (faces_[f].size() < 4 || chance(2)) continue;
      Faces cut = faces_;
      cut[f] = {faces_[f][0], faces_[f][1], faces_[f][2]};
      cut.push_back(faces_[f]);
      cut.back().erase(cut.back().begin() + 1);
      take_if_valid(std::move(cut));
    }
    return disguised();
  }

  Mesh polygons() {
    const Mesh seed = base();
    vertices_ = seed.vertex_count();
    faces_ = faces_of(polygons_of(seed));
    if (chance(2)) remove_faces();
    if (chance(2)) merge_faces();
    return disguised();
  }

 private:
  Index below(Index n) { return static_cast<Index>(random_() % static_cast<unsigned>(n)); }
  bool chance(Index one_in) { return below(one_in) == 0; }

  Mesh base() {
    const Lattice lattice = chance(2) ? Lattice::triangle : Lattice::quad;
    switch (below(9)) {
      case 0: return tetrahedron();
      case 1: return cube();
      case 2: return icosahedron();
      case 3: return mesh::torus(lattice, 3 + below(4), 3 + below(4));
      case 4: return mesh::star(lattice, 3 + below(6), 1 + below(3));
      case 5: return mesh::face_star(3 + below(6), 1 + below(3));
      case 6: return mesh::tree(lattice, below(3));
      case 7: return pillow(3 + below(4));
      default: return mesh::torus(lattice, 3 + below(3), 3 + below(3));
    }
  }

  /// Puts `faces` in place of the current ones if they make a mesh.
  void take_if_valid(Faces faces) {
    if (!faces.empty() && Mesh::build(make_polygons(vertices_, faces))) faces_ = std::move(faces);
  }

  void remove_faces() {
    for (Index i = 1 + below(6); i > 0; --i) {
      Faces fewer = faces_;
      fewer.erase(fewer.begin() + below(static_cast<Index>(fewer.size())));
      take_if_valid(std::move(fewer));
    }
  }

  void merge_faces() {
    for (Index i = 1 + below(6); i > 0; --i) {
      const Mesh mesh = must_build(vertices_, faces_);
      const Index h = below(mesh.halfedge_count()), t = mesh.twin(h);
      if (t == kNone) continue;
      std::vector<Index> merged;
      for (Index k = mesh.next(h); k != h; k = mesh.next(k)) merged.push_back(mesh.origin(k));
      for (Index k = mesh.next(t); k != t; k = mesh.next(k)) merged.push_back(mesh.origin(k));
      Faces fewer;
      for (Index f = 0; f < mesh.face_count(); ++f)
        if (f != mesh.face(h) && f != mesh.face(t))
          fewer.push_back(faces_[static_cast<std::size_t>(f)]);
      fewer.push_back(merged);
      take_if_valid(std::move(fewer));
    }
  }

  /// The same surface with other numbers, and sometimes with vertices that no face uses.
  Mesh disguised() {
    if (chance(3)) vertices_ += 1 + below(2);
    std::vector<Index> name(static_cast<std::size_t>(vertices_));
    std::iota(name.begin(), name.end(), 0);
    std::shuffle(name.begin(), name.end(), random_);
    std::shuffle(faces_.begin(), faces_.end(), random_);
    for (auto& face : faces_) {
      for (Index& v : face) v = name[v];
      std::rotate(face.begin(), face.begin() + below(static_cast<Index>(face.size())), face.end());
    }
    return must_build(vertices_, faces_);
  }

  std::mt19937 random_;
  Index vertices_ = 0;
  Faces faces_;
};

inline Index isolated_count(const Mesh& mesh) {
  Index count = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) count += mesh.is_isolated(v);
  return count;
}

/// V - E + F, isolated vertices aside.
inline Index euler_characteristic(const Mesh& mesh) {
  return mesh.vertex_count() - isolated_count(mesh) - mesh.edge_count() + mesh.face_count();
}

inline Index boundary_loops(const Mesh& mesh) {
  std::vector<bool> met(static_cast<std::size_t>(mesh.halfedge_count()), false);
  Index loops = 0;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (mesh.twin(h) != kNone || met[h]) continue;
    ++loops;
    for (Index k = h; !met[k];) {
      met[k] = true;
      k = mesh.next(k);
      while (mesh.twin(k) != kNone) k = mesh.next(mesh.twin(k));
    }
  }
  return loops;
}

inline Index boundary_edges(const Mesh& mesh) {
  Index count = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) count += mesh.is_boundary_edge(e);
  return count;
}

/// No two edges join the same vertices, so that polygons alone determine the mesh.
inline bool is_simple(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> seen;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (!seen.insert(std::minmax({mesh.origin(h), mesh.target(h)})).second) return false;
  }
  return true;
}

/// Everything that the accessors tell, for comparing meshes bit for bit.
inline std::array<std::vector<Index>, 5> snapshot(const Mesh& mesh) {
  std::array<std::vector<Index>, 5> all;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    all[0].push_back(mesh.origin(h));
    all[1].push_back(mesh.twin(h));
    all[2].push_back(mesh.edge(h));
    all[3].push_back(mesh.face(h));
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) all[4].push_back(mesh.halfedge_of_vertex(v));
  return all;
}

/// Quads only, with other numbers than a split gives where that is possible.
inline Mesh random_quads(unsigned seed) {
  const Mesh mesh = RandomMesh(seed).polygons();
  return mesh.uniform_degree() == 4 ? mesh : find_split("quad-dyadic")->apply(mesh, 0).mesh;
}

/// Any mesh that the split takes.
inline Mesh random_control(const Split& split, unsigned seed) {
  if (split.mixed && seed % 4 != 0) return RandomMesh(seed).mixed();
  if (split.any_polygons) return RandomMesh(seed).polygons();
  return split.lattice == Lattice::quad ? random_quads(seed) : RandomMesh(seed).triangles();
}

}  // namespace limn::test
