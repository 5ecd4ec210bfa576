// Meshes that are no surfaces, cut into sheets, against OpenSubdiv, which refines them as they are.
//
// OpenSubdiv takes an edge of more than two faces for a crease, and a vertex where sheets meet for
// a corner, unless two such edges go on there as a crease. A cut mesh has boundaries instead, whose
// rule is that of a crease, and `repair` tells the corners and the creases that are left. limn and
// OpenSubdiv refine the cut mesh with these as OpenSubdiv does the mesh as it is.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "limn/mesh/mesh.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/cuts.h"
#include "limn/refine/refine.h"
#include "peer_test.h"
#include "stated.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 2;

Polygons joined(const Polygons& polygons) {
  return mesh::repair(polygons, {.weld = 1e-9}).value().polygons;
}

Polygons refined_by(const std::unique_ptr<Peer>& peer) {
  peer->refine(kLevels);
  return peer->polygons();
}

/// What is sharp in a cut mesh, for OpenSubdiv.
PeerTags tags_of_cut(const mesh::Repaired& cut) {
  PeerTags tags;
  tags.edges = cut.sharp_edges;
  tags.edge_sharpness.assign(cut.sharp_edges.size(), kInfinitelySharp);
  tags.corners = cut.sharp_vertices;
  tags.corner_sharpness.assign(cut.sharp_vertices.size(), kInfinitelySharp);
  return tags;
}

/// What is stated of the mesh as it was, for the cut one.
Sharpness sharpness_of(const Mesh& mesh, const mesh::Repaired& cut, const PeerTags& tags) {
  Sharpness sharpness;
  EXPECT_TRUE(apply_tags(mesh, mesh::source_of(cut, {}), stated_by(tags), sharpness).ok());
  mesh::hold_cuts(mesh, mesh::cuts_of(cut), sharpness);
  mesh::apply_boundary_mode(mesh, boundary_mode_of(tags), mesh::cuts_of(cut), sharpness);
  return sharpness;
}

/// The cut mesh refined by limn, its copies joined again.
Polygons refined_by_us(const char* scheme, const mesh::Repaired& cut, const PeerTags& tags = {}) {
  const Mesh mesh = Mesh::build(cut.polygons).value();
  const auto fine = refine::refine(find_scheme(scheme).value(), mesh, cut.polygons.positions,
                                   kLevels, {}, sharpness_of(mesh, cut, tags))
                        .value();
  return joined(without(fine.mesh.polygons(fine.values), fine.sharpness.holes));
}

/// Sheets of `columns` faces, closed to rings, that start from one closed curve.
Polygons rosette(Index sheets, Index columns, Index rows, bool triangles, std::mt19937& random) {
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  Polygons mesh;
  const auto add_ring = [&](Index sheet, Index row) {
    for (Index c = 0; c < columns; ++c) {
      const double angle = 6.283185307179586 * c / columns,
                   tilt = 6.283185307179586 * sheet / sheets;
      const double radius = 3 + row * std::cos(tilt);
      mesh.positions.push_back({radius * std::cos(angle) + noise(random),
                                radius * std::sin(angle) + noise(random),
                                row * std::sin(tilt) + noise(random)});
    }
    return mesh.vertex_count() - columns;
  };
  const auto add_face = [&](std::initializer_list<Index> corners) {
    mesh.corners.insert(mesh.corners.end(), corners);
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  };
  const Index curve = add_ring(0, 0);
  for (Index sheet = 0; sheet < sheets; ++sheet)
    for (Index row = 0, below = curve; row < rows; ++row) {
      const Index above = add_ring(sheet, row + 1);
      for (Index c = 0; c < columns; ++c) {
        const Index d = (c + 1) % columns;
        if (triangles) {
          add_face({below + c, below + d, above + d});
          add_face({below + c, above + d, above + c});
        } else {
          add_face({below + c, below + d, above + d, above + c});
        }
      }
      below = above;
    }
  return mesh;
}

struct Subject {
  Method method;
  const char* scheme;
  bool triangles;
};
constexpr Subject kSubjects[] = {{Method::loop, "loop", true},
                                 {Method::catmull_clark, "catmull-clark", false}};

TEST(PeersNonManifold, SheetsAlongACurveAreRefinedAsOpenSubdivDoes) {
  std::mt19937 random(2026);
  for (const auto& [method, name, triangles] : kSubjects)
    for (const Index sheets : {3, 4, 5}) {
      const Polygons mesh = rosette(sheets, 3 + sheets, 2, triangles, random);
      const mesh::Repaired cut = mesh::repair(mesh, {.cut = true}).value();
      EXPECT_TRUE(cut.sharp_vertices.empty());
      EXPECT_EQ(difference(refined_by_us(name, cut), refined_by(opensubdiv_peer(method, mesh))), "")
          << name << ", " << sheets << " sheets";
    }
}

/// A mesh some vertices of which are made one, so that sheets meet at edges and vertices, but which
/// has no other faults.
Polygons pinched(const Polygons& clean, std::mt19937& random) {
  Polygons mesh = clean;
  for (unsigned k = 2 + random() % 6; k > 0; --k) {
    Polygons tried = mesh;
    // two edges, or two vertices, become one
    const auto corner = [&] { return static_cast<std::size_t>(random() % tried.corners.size()); };
    const Index from = tried.corners[corner()], to = tried.corners[corner()];
    for (Index& v : tried.corners)
      if (v == from) v = to;
    const mesh::MeshFaults faults = mesh::find_mesh_faults(tried);
    const bool only_sheets =
        std::all_of(faults.list.begin(), faults.list.end(), [](const mesh::MeshFault& fault) {
          return fault.kind == mesh::MeshFault::Kind::crowded_edge ||
                 fault.kind == mesh::MeshFault::Kind::several_fans;
        });
    if (only_sheets) mesh = std::move(tried);
  }
  // no vertices that lost their faces
  std::vector<Index> number(mesh.positions.size(), kNone);
  std::vector<Point3> positions;
  for (Index& v : mesh.corners) {
    if (number[v] == kNone) {
      number[v] = static_cast<Index>(positions.size());
      positions.push_back(mesh.positions[v]);
    }
    v = number[v];
  }
  mesh.positions = std::move(positions);
  return mesh;
}

ControlMesh random_control(bool triangles, std::mt19937& random) {
  const std::vector<ControlMesh> meshes = triangles ? open_triangles() : open_polygons();
  return meshes[random() % meshes.size()];
}

/// Whether each copy of a vertex that is no corner has both edges of the crease. A sheet that has
/// one of them, or none, cannot know where the crease goes: there cutting is no equal of
/// OpenSubdiv's.
bool creases_are_whole(const mesh::Repaired& cut) {
  const Mesh mesh = Mesh::build(cut.polygons).value();
  std::vector<int> copies(cut.vertex_of.size(), 0), sharp_edges(copies);
  for (const Index v : cut.vertex_of) ++copies[v];
  for (const auto& edge : cut.sharp_edges)
    for (const Index v : edge) ++sharp_edges[v];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (copies[cut.vertex_of[v]] < 2) continue;
    if (std::binary_search(cut.sharp_vertices.begin(), cut.sharp_vertices.end(), v)) continue;
    if (sharp_edges[v] != (mesh.is_boundary_vertex(v) ? 0 : 2)) return false;
    if (!mesh.is_boundary_vertex(v)) continue;
    const Index next = mesh.halfedge_of_vertex(v);
    const Index before = other_boundary_flag(mesh, {next, false}).halfedge;
    if (cut.vertex_of[mesh.target(next)] == cut.vertex_of[mesh.origin(before)]) return false;
  }
  return true;
}

RC_GTEST_PROP(PeersNonManifold, ACutMeshWithItsCornersIsTheMeshToOpenSubdiv, (unsigned seed)) {
  std::mt19937 random(seed);
  for (const auto& [method, name, triangles] : kSubjects) {
    const ControlMesh control = random_control(triangles, random);
    RC_PRE(control.polygons.face_count() < 400);
    const Polygons mesh = pinched(control.polygons, random);
    const mesh::Repaired cut = mesh::repair(mesh, {.cut = true}).value();
    RC_ASSERT(Mesh::build(cut.polygons).ok());
    if (!creases_are_whole(cut)) continue;
    // joined too: two faces back to back have points in one place
    const Polygons theirs = joined(refined_by(opensubdiv_peer(method, mesh)));
    const Polygons cut_theirs =
        joined(refined_by(opensubdiv_peer(method, cut.polygons, tags_of_cut(cut))));
    for (const Polygons& found : {cut_theirs, refined_by_us(name, cut)}) {
      const std::string apart = difference(found, theirs);
      RC_LOG() << control.name << ": " << apart;
      RC_ASSERT(apart.empty());
    }
  }
}

/// Tags of some of its edges and vertices, and a boundary mode.
PeerTags random_tags(const Polygons& mesh, bool fractions, std::mt19937& random) {
  constexpr std::array<float, 5> kSharpness{1, 2, 10, 0.5F, 1.25F};
  const auto sharpness = [&] { return kSharpness.at(random() % (fractions ? 5 : 3)); };
  PeerTags tags;
  std::set<std::array<Index, 2>> edges;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      const Index next = c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
      const auto [a, b] = std::minmax(mesh.corners[c], mesh.corners[next]);
      if (edges.insert({a, b}).second && random() % 6 == 0) {
        tags.edges.push_back({a, b});
        tags.edge_sharpness.push_back(sharpness());
      }
    }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (random() % 15 != 0) continue;
    tags.corners.push_back(v);
    tags.corner_sharpness.push_back(sharpness());
  }
  tags.boundary = static_cast<int>(random() % 3);
  return tags;
}

RC_GTEST_PROP(PeersNonManifold, ACutMeshWithTagsIsTheMeshToOpenSubdiv, (unsigned seed)) {
  std::mt19937 random(seed);
  for (const auto& [method, name, triangles] : kSubjects) {
    const ControlMesh control = random_control(triangles, random);
    RC_PRE(control.polygons.face_count() < 400);
    const Polygons mesh = pinched(control.polygons, random);
    const bool fractions = random() % 2 != 0;
    const PeerTags tags = random_tags(mesh, fractions, random);
    const mesh::Repaired cut = mesh::repair(mesh, {.cut = true}).value();
    if (!creases_are_whole(cut)) continue;
    const std::string apart = difference(refined_by_us(name, cut, tags),
                                         joined(refined_by(opensubdiv_peer(method, mesh, tags))),
                                         fractions ? 1e-6 : 1e-12);  // it blends in floats
    RC_LOG() << control.name << ", boundary mode " << tags.boundary << ": " << apart;
    RC_ASSERT(apart.empty());
  }
}

/// Three quads on two edges that go on, each with another sheet.
TEST(PeersNonManifold, CopiesOfOneFaceAreNoCorners) {
  const std::vector<Point3> places{{-1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                   {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Polygons pages{places, {0, 4, 8, 12}, {0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 2, 5}};
  const Polygons part{places, {0, 4, 8, 11, 14}, {0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 5, 1, 2, 5}};
  PeerTags crease;
  crease.edges = {{1, 5}};
  for (const float sharpness : {0.5F, 1.0F, 10.0F})
    for (const int boundary : {1, 2}) {
      crease.edge_sharpness = {sharpness};
      crease.boundary = boundary;
      PeerTags plain;
      plain.boundary = boundary;
      const mesh::Repaired cut = mesh::repair(pages, {.cut = true}).value();
      EXPECT_EQ(
          difference(refined_by_us("catmull-clark", cut, plain),
                     joined(refined_by(opensubdiv_peer(Method::catmull_clark, pages, plain)))),
          "");
      const mesh::Repaired other = mesh::repair(part, {.cut = true}).value();
      EXPECT_EQ(
          difference(refined_by_us("catmull-clark", other, crease),
                     joined(refined_by(opensubdiv_peer(Method::catmull_clark, part, crease)))),
          "")
          << sharpness;
    }
}

TEST(PeersNonManifold, TheCasesKeepTheirCorners) {
  // three pages on an edge, and two faces that touch at a vertex
  const std::vector<Point3> places{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  const Polygons book{places, {0, 3, 6, 9}, {0, 1, 2, 0, 1, 3, 0, 1, 4}};
  const Polygons touching{places, {0, 3, 6}, {0, 1, 2, 0, 3, 4}};
  for (const Polygons& mesh : {book, touching}) {
    const mesh::Repaired cut = mesh::repair(mesh, {.cut = true}).value();
    for (const auto& [method, name, triangles] : kSubjects) {
      const Polygons theirs = refined_by(opensubdiv_peer(method, mesh));
      EXPECT_EQ(
          difference(joined(refined_by(opensubdiv_peer(method, cut.polygons, tags_of_cut(cut)))),
                     theirs),
          "")
          << name;
      EXPECT_EQ(difference(refined_by_us(name, cut), theirs), "") << name;
    }
  }
}

}  // namespace
}  // namespace limn::peers
