#include "control_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include "limn/mesh/lattice.h"
#include "limn/mesh/split/split.h"
#include "mesh/random_mesh.h"

namespace limn::peers {
namespace {

using test::Faces;

constexpr double kTurn = 6.283185307179586;

/// A mesh under edits; each keeps it plain.
class Editor {
 public:
  Editor(Polygons polygons, unsigned seed)
      : positions_(std::move(polygons.positions)),
        faces_(test::faces_of(polygons)),
        random_(seed) {}

  /// Tries to flip `count` random inner edges between triangles.
  Editor& flip(int count, Index max_valence) {
    Mesh mesh = build(faces_);
    // vertices whose faces are not those in `mesh` any more: it is built anew only near them
    std::vector<bool> changed(positions_.size());
    for (; count > 0; --count) {
      const Index h = below(mesh.halfedge_count());
      if (is_near(mesh, h, changed)) {
        mesh = build(faces_);
        changed.assign(positions_.size(), false);
      }
      const Index t = mesh.twin(h);
      if (t == kNone) continue;
      const Index a = mesh.origin(h), b = mesh.origin(t);
      const Index c = mesh.origin(mesh.prev(h)), d = mesh.origin(mesh.prev(t));
      if (std::max(mesh.valence(c), mesh.valence(d)) >= max_valence) continue;
      if (!can_lose_edge(mesh, a) || !can_lose_edge(mesh, b) || adjacent(mesh, c, d)) continue;
      faces_[mesh.face(h)] = {a, d, c};
      faces_[mesh.face(t)] = {b, c, d};
      for (const Index v : {a, b, c, d}) changed[v] = true;
    }
    return *this;
  }

  Editor& remove_faces(int count) {
    for (; count > 0; --count) {
      Faces fewer = faces_;
      fewer.erase(fewer.begin() + below(static_cast<Index>(fewer.size())));
      take_if_plain(std::move(fewer));
    }
    return *this;
  }

  /// Tries to join the faces at `count` random inner edges.
  Editor& merge_faces(int count, Index max_degree) {
    for (; count > 0; --count) {
      const Mesh mesh = build(faces_);
      const Index h = below(mesh.halfedge_count());
      const Index t = mesh.twin(h);
      if (t == kNone) continue;
      std::vector<Index> merged;
      for (Index k = mesh.next(h); k != h; k = mesh.next(k)) merged.push_back(mesh.origin(k));
      for (Index k = mesh.next(t); k != t; k = mesh.next(k)) merged.push_back(mesh.origin(k));
      if (static_cast<Index>(merged.size()) > max_degree) continue;
      Faces fewer = faces_;
      fewer[mesh.face(h)] = merged;
      fewer.erase(fewer.begin() + mesh.face(t));
      take_if_plain(std::move(fewer));
    }
    return *this;
  }

  /// Moves every vertex by up to `most` along each axis.
  Editor& shake(double most) {
    std::uniform_real_distribution<double> by(-most, most);
    for (Point3& p : positions_) p = p + Point3{by(random_), by(random_), by(random_)};
    return *this;
  }

  [[nodiscard]] Polygons polygons() const {
    Polygons result;
    std::vector<Index> number(positions_.size(), kNone);  // faces may have left vertices alone
    for (const auto& face : faces_) {
      for (const Index v : face) {
        if (number[v] == kNone) {
          number[v] = result.vertex_count();
          result.positions.push_back(positions_[v]);
        }
        result.corners.push_back(number[v]);
      }
      result.face_begin.push_back(static_cast<Index>(result.corners.size()));
    }
    return result;
  }

 private:
  Index below(Index n) { return static_cast<Index>(random_() % static_cast<unsigned>(n)); }

  [[nodiscard]] Mesh build(const Faces& faces) const {
    return test::must_build(static_cast<Index>(positions_.size()), faces);
  }

  /// Whether a corner of the faces beside h is marked.
  static bool is_near(const Mesh& mesh, Index h, const std::vector<bool>& marked) {
    for (const Index side : {h, mesh.twin(h)}) {
      if (side == kNone) continue;
      Index k = side;
      do {
        if (marked[mesh.origin(k)]) return true;
        k = mesh.next(k);
      } while (k != side);
    }
    return false;
  }

  static bool can_lose_edge(const Mesh& mesh, Index v) {
    return mesh.valence(v) > (mesh.is_boundary_vertex(v) ? 2 : 3);
  }

  static bool adjacent(const Mesh& mesh, Index v, Index w) {
    const Index first = mesh.halfedge_of_vertex(v);
    Index h = first;
    do {
      if (mesh.target(h) == w || mesh.origin(mesh.prev(h)) == w) return true;
      h = mesh.rotate(h);
    } while (h != kNone && h != first);
    return false;
  }

  void take_if_plain(Faces faces) {
    std::swap(faces_, faces);
    if (!is_plain(polygons())) std::swap(faces_, faces);
  }

  std::vector<Point3> positions_;
  Faces faces_;
  std::mt19937 random_;
};

template <class Place>
Polygons placed(const Mesh& mesh, Place place) {
  std::vector<Point3> positions;
  for (Index v = 0; v < mesh.vertex_count(); ++v) positions.push_back(place(v));
  return mesh.polygons(positions);
}

Point3 on_sphere(Point3 p) { return 1 / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) * p; }

Polygons icosahedron() {
  return placed(test::icosahedron(), [](Index v) -> Point3 {
    if (v == 0) return {0, 0, 1};
    if (v == 11) return {0, 0, -1};
    const double angle = kTurn * (v <= 5 ? v - 1 : v - 5.5) / 5;
    return on_sphere({2 * std::cos(angle), 2 * std::sin(angle), v <= 5 ? 1.0 : -1.0});
  });
}

Polygons tetrahedron() {
  constexpr std::array<Point3, 4> kCorners{{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}};
  return placed(test::tetrahedron(), [&](Index v) { return kCorners[v]; });
}

Polygons cube() {
  return placed(test::cube(), [](Index v) -> Point3 {
    return {v % 4 == 1 || v % 4 == 2 ? 1.0 : 0.0, v % 4 >= 2 ? 1.0 : 0.0, v >= 4 ? 1.0 : 0.0};
  });
}

Polygons round_torus(Lattice lattice, Index nx, Index ny) {
  return placed(mesh::torus(lattice, nx, ny), [&](Index v) -> Point3 {
    const double along = kTurn * (v % nx) / nx, across = kTurn * (v / nx) / ny;
    const double radius = 2 + std::cos(across);
    return {radius * std::cos(along), radius * std::sin(along), std::sin(across)};
  });
}

/// nx by ny cells, flat.
Polygons grid(Lattice lattice, Index nx, Index ny) {
  Polygons result;
  for (Index v = 0; v < (nx + 1) * (ny + 1); ++v)
    result.positions.push_back(
        {static_cast<double>(v % (nx + 1)), static_cast<double>(v / (nx + 1)), 0});
  const auto add = [&](std::initializer_list<Index> face) {
    result.corners.insert(result.corners.end(), face);
    result.face_begin.push_back(static_cast<Index>(result.corners.size()));
  };
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      if (lattice == Lattice::quad) {
        add({a, b, c, d});
      } else {
        add({a, b, c});
        add({a, c, d});
      }
    }
  return result;
}

Polygons shaken(const Polygons& polygons, double most, unsigned seed) {
  return Editor(polygons, seed).shake(most).polygons();
}

/// Abstract meshes with random positions: nothing but connectivity and weights matters.
void add_random(std::vector<ControlMesh>& meshes, bool triangles, bool closed) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    test::RandomMesh random(seed);
    const Mesh mesh = triangles ? random.triangles() : random.polygons();
    const Polygons polygons = test::polygons_of(mesh);
    if (mesh.has_boundary() == closed || !is_plain(polygons)) continue;
    meshes.push_back({"random_mesh_" + std::to_string(seed), shaken(polygons, 1, seed)});
  }
}

}  // namespace

bool is_plain(const Polygons& polygons) {
  const Result<Mesh> mesh = Mesh::build(polygons);
  if (!mesh || mesh->face_count() == 0 || !test::is_simple(*mesh)) return false;
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    if (mesh->valence(v) < (mesh->is_boundary_vertex(v) ? 2 : 3)) return false;
  return true;
}

Polygons random_sphere(int levels, int flips, Index max_valence, unsigned seed) {
  Polygons sphere = icosahedron();
  for (; levels > 0; --levels) {
    const Mesh mesh = Mesh::build(sphere).value();
    std::vector<Point3> positions = sphere.positions;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const Index h = mesh.halfedge_of_edge(e);
      positions.push_back(
          on_sphere(sphere.positions[mesh.origin(h)] + sphere.positions[mesh.target(h)]));
    }
    sphere = find_split("triangle-dyadic")->apply(mesh, 0).mesh.polygons(std::move(positions));
  }
  return Editor(std::move(sphere), seed).flip(flips, max_valence).polygons();
}

Polygons cut_into_quads(const Polygons& polygons) {
  const Mesh mesh = Mesh::build(polygons).value();
  std::vector<Point3> positions = polygons.positions;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    positions.push_back(0.5 *
                        (polygons.positions[mesh.origin(h)] + polygons.positions[mesh.target(h)]));
  }
  for (Index f = 0; f < polygons.face_count(); ++f) {
    Point3 middle;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      middle = middle + 1.0 / mesh.degree(f) * polygons.positions[mesh.origin(h)];
    positions.push_back(middle);
  }
  return find_split("quad-dyadic")->apply(mesh, 0).mesh.polygons(std::move(positions));
}

std::vector<ControlMesh> closed_triangles() {
  std::vector<ControlMesh> meshes{
      {"tetrahedron", shaken(tetrahedron(), 0.3, 1)},
      {"icosahedron", shaken(icosahedron(), 0.2, 2)},
      {"torus", shaken(round_torus(Lattice::triangle, 7, 5), 0.1, 3)},
      {"sphere_of_many_valences", shaken(random_sphere(2, 400, 12, 4), 0.03, 5)}};
  add_random(meshes, true, true);
  return meshes;
}

std::vector<ControlMesh> open_triangles() {
  const Polygons holed = round_torus(Lattice::triangle, 9, 8);
  const Polygons square = grid(Lattice::triangle, 10, 10);
  std::vector<ControlMesh> meshes{
      {"torus_with_holes", Editor(holed, 6).remove_faces(25).shake(0.1).polygons()},
      {"disc_of_many_valences", Editor(square, 7).flip(400, 9).shake(0.3).polygons()},
      {"ragged_disc", Editor(square, 8).flip(60, 9).remove_faces(120).shake(0.3).polygons()},
      {"triangle", shaken(grid(Lattice::triangle, 1, 1), 0.2, 9)}};
  add_random(meshes, true, false);
  return meshes;
}

std::vector<ControlMesh> closed_polygons() {
  std::vector<ControlMesh> meshes{
      {"cube", shaken(cube(), 0.2, 11)},
      {"torus", shaken(round_torus(Lattice::quad, 7, 5), 0.1, 12)},
      {"quads_of_many_valences", shaken(cut_into_quads(random_sphere(1, 80, 9, 13)), 0.03, 14)},
      {"polygons",
       Editor(random_sphere(2, 100, 9, 15), 16).merge_faces(250, 9).shake(0.03).polygons()}};
  add_random(meshes, false, true);
  return meshes;
}

std::vector<ControlMesh> open_polygons() {
  const Polygons holed = round_torus(Lattice::quad, 9, 8);
  const Polygons square = grid(Lattice::quad, 10, 10);
  const Polygons triangles = grid(Lattice::triangle, 8, 8);
  std::vector<ControlMesh> meshes{
      {"torus_with_holes", Editor(holed, 17).remove_faces(15).shake(0.1).polygons()},
      {"ragged_disc", Editor(square, 18).remove_faces(60).shake(0.3).polygons()},
      {"disc_of_polygons",
       Editor(triangles, 19).flip(60, 9).merge_faces(80, 9).remove_faces(6).shake(0.2).polygons()},
      {"quad", shaken(grid(Lattice::quad, 1, 1), 0.2, 20)}};
  add_random(meshes, false, false);
  return meshes;
}

}  // namespace limn::peers
