/// What a survey finds: against counts made otherwise, and faults that are put in.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "damage.h"
#include "limn/mesh/repair/survey.h"

namespace limn::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RC_GTEST_PROP(SurveyLaws, OfAMeshCountsWhatTheMeshHas, (unsigned seed)) {
  std::mt19937 random(seed);
  const Mesh mesh = RandomMesh(seed).polygons();
  const mesh::MeshSurvey found = mesh::survey_mesh(placed(mesh, random));
  RC_ASSERT(found.refinable);
  RC_ASSERT(found.vertices == mesh.vertex_count() && found.faces == mesh.face_count());
  RC_ASSERT(found.edges == mesh.edge_count());
  RC_ASSERT(found.euler == euler_characteristic(mesh));
  RC_ASSERT(found.boundary_loops == boundary_loops(mesh));
  RC_ASSERT(found.boundary_edges == boundary_edges(mesh));
  RC_ASSERT(static_cast<Index>(found.isolated.size()) == isolated_count(mesh));
  std::map<Index, Index> valences;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v)) ++valences[mesh.valence(v)];
  RC_ASSERT(found.valences == valences);
  RC_ASSERT(found.degenerate.empty() && found.coincident.empty() && found.not_finite.empty());
  for (const Index v : found.valence_two)
    RC_ASSERT(mesh.valence(v) == 2 && !mesh.is_boundary_vertex(v));
  RC_ASSERT(found.orientable);
}

std::size_t count(const mesh::MeshSurvey& survey, mesh::MeshFault::Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(survey.faults.list.begin(), survey.faults.list.end(),
                    [kind](const mesh::MeshFault& fault) { return fault.kind == kind; }));
}

/// Faults of every kind, as many as chance wants, each with a part of the mesh of its own.
RC_GTEST_PROP(SurveyLaws, FindsAllFaultsThatArePutIn, (unsigned seed)) {
  std::mt19937 random(seed);
  const Polygons clean = placed(RandomMesh(seed).polygons(), random);
  Faces faces = faces_of(clean);
  std::vector<Point3> positions = clean.positions;
  const std::size_t isolated_before = mesh::survey_mesh(clean).isolated.size();
  std::map<std::string, std::size_t> put;
  const auto vertex = [&] {
    positions.push_back(random_places(1, random).front());
    return static_cast<Index>(positions.size()) - 1;
  };
  for (unsigned k = random() % 12; k > 0; --k) {
    const Index a = vertex(), b = vertex(), c = vertex();
    switch (random() % 8) {
      case 0:
        faces.insert(faces.end(), {{a, b, c}, {b, c, a}});
        ++put["copy"];
        break;
      case 1:
        faces.insert(faces.end(), {{a, b, c}, {b, a, vertex()}, {a, b, vertex()}});
        ++put["crowded"];
        break;
      case 2:
        faces.insert(faces.end(), {{a, b, c}, {a, b, vertex()}});
        ++put["flipped"];
        break;
      case 3: {
        const Index d = vertex(), e = vertex();
        faces.insert(faces.end(), {{a, b, c}, {a, d, e}});
        ++put["bow-tie"];
        break;
      }
      case 4:
        faces.push_back({a, b, c, b});
        ++put["repeated"];
        break;
      case 5:
        positions[static_cast<std::size_t>(b)] = positions[static_cast<std::size_t>(a)];
        faces.push_back({a, b, c});
        ++put["coincident"];
        ++put["flat"];
        break;
      case 6:
        positions[static_cast<std::size_t>(c)].y = random() % 2 == 0 ? kInfinity : -NAN;
        faces.push_back({a, b, c});
        ++put["infinite"];
        break;
      default:
        positions[static_cast<std::size_t>(c)].x = 1e39;
        put["isolated"] += 3;
        ++put["enormous"];
    }
  }
  Polygons broken = make_polygons(static_cast<Index>(positions.size()), faces);
  broken.positions = positions;
  const mesh::MeshSurvey found = mesh::survey_mesh(broken);
  using Kind = mesh::MeshFault::Kind;
  RC_ASSERT(count(found, Kind::repeated_face) == put["copy"]);
  RC_ASSERT(count(found, Kind::crowded_edge) == put["crowded"]);
  RC_ASSERT(count(found, Kind::flipped_edge) == put["flipped"]);
  RC_ASSERT(count(found, Kind::several_fans) == put["bow-tie"]);
  RC_ASSERT(count(found, Kind::repeated_corner) == put["repeated"]);
  RC_ASSERT(found.degenerate.size() == put["repeated"] + put["flat"]);
  RC_ASSERT(found.coincident.size() == put["coincident"]);
  RC_ASSERT(found.not_finite.size() == put["infinite"]);
  RC_ASSERT(found.isolated.size() == isolated_before + put["isolated"]);
  RC_ASSERT(found.enormous.size() == put["enormous"]);
  const bool blocked = put["copy"] + put["crowded"] + put["flipped"] + put["bow-tie"] +
                           put["repeated"] + put["infinite"] >
                       0;
  RC_ASSERT(found.refinable == !blocked);
}

RC_GTEST_PROP(SurveyLaws, LoopsOfRubbleAreThoseOfTheCutMesh, (unsigned seed)) {
  for (unsigned k = 0; k < 100; ++k) {
    Polygons broken = rubble(seed + k);
    const mesh::MeshFaults faults = mesh::find_mesh_faults(broken);
    const bool only_sheets =
        std::all_of(faults.list.begin(), faults.list.end(), [](const mesh::MeshFault& fault) {
          return fault.kind == mesh::MeshFault::Kind::several_fans;
        });
    if (!only_sheets) continue;
    const Polygons cut = mesh::repair(broken, {.cut = true}).value().polygons;
    RC_ASSERT(mesh::survey_mesh(broken).boundary_loops == boundary_loops(Mesh::build(cut).value()));
  }
}

TEST(Survey, GenusAndParts) {
  std::mt19937 random(1);
  const mesh::MeshSurvey ring = mesh::survey_mesh(placed(mesh::torus(Lattice::quad, 4, 5), random));
  EXPECT_EQ(ring.euler, 0);
  EXPECT_EQ(ring.genus, 1);
  EXPECT_EQ(ring.components, 1);
  EXPECT_EQ(ring.boundary_loops, 0);
  Faces faces = faces_of(polygons_of(cube()));
  const Faces more = faces;
  for (auto face : more) {
    for (Index& v : face) v += 8;
    faces.push_back(face);
  }
  faces.pop_back();
  Polygons two = make_polygons(16, faces);
  two.positions = random_places(16, random);
  const mesh::MeshSurvey found = mesh::survey_mesh(two);
  EXPECT_EQ(found.components, 2);
  EXPECT_EQ(found.genus, 0);
  EXPECT_EQ(found.euler, 3);
  EXPECT_EQ(found.boundary_loops, 1);
  EXPECT_EQ(found.degrees, (std::map<Index, Index>{{4, 11}}));
}

Polygons at(const std::vector<Point3>& positions, const Faces& faces) {
  Polygons polygons = make_polygons(static_cast<Index>(positions.size()), faces);
  polygons.positions = positions;
  return polygons;
}

TEST(Survey, ShapesOfFacesAtAnySize) {
  for (const double size : {1.0, 1e-200, 1e200, 1.7e308}) {
    const double h = size / 2;
    const mesh::MeshSurvey concave = mesh::survey_mesh(
        at({{0, size, 0}, {0, 0, 0}, {size, 0, 0}, {h / 2, h / 2, 0}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(concave.concave, (std::vector<Index>{0})) << size;
    EXPECT_TRUE(concave.bent.empty()) << size;
    const mesh::MeshSurvey bent = mesh::survey_mesh(
        at({{-h, -h, 0}, {h, -h, h / 4}, {h, h, 0}, {-h, h, h / 4}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(bent.bent, (std::vector<Index>{0})) << size;
    EXPECT_NEAR(bent.most_bent, (1.0 / 16) / std::sqrt(2 + 1.0 / 64), 0.003) << size;
    EXPECT_TRUE(bent.concave.empty()) << size;
    const mesh::MeshSurvey flat = mesh::survey_mesh(
        at({{0, 0, 0}, {h, h, h}, {size, size, size}, {h / 2, h / 2, h / 2}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(flat.degenerate, (std::vector<Index>{0})) << size;
  }
}

TEST(Survey, ABoxOfSixSheetsLooksUnwelded) {
  Polygons box;
  const Mesh whole = cube();
  for (const auto& face : faces_of(polygons_of(whole))) {
    for (const Index v : face) {
      box.corners.push_back(box.vertex_count());
      // the cube's vertices: 0 … 3 below, 4 … 7 above, counterclockwise
      const double x = v % 4 == 1 || v % 4 == 2 ? 1 : 0, y = v % 4 >= 2 ? 1 : -0.0;
      box.positions.push_back({x, y, v < 4 ? 0.0 : 1.0});
    }
    box.face_begin.push_back(static_cast<Index>(box.corners.size()));
  }
  const mesh::MeshSurvey found = mesh::survey_mesh(box);
  EXPECT_EQ(found.coincident.size(), 16U);
  EXPECT_EQ(found.seams.edges, 12);
  EXPECT_EQ(found.seams.vertices, 16);
  EXPECT_EQ(mesh::open_seams(Mesh::build(box).value(), box.positions).edges, 12);
  EXPECT_EQ(found.components, 6);
}

TEST(Survey, NearlyCoincidentIsTold) {
  const mesh::MeshSurvey found = mesh::survey_mesh(
      at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-9, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 1, 4}}));
  EXPECT_EQ(found.near, (std::vector<Index>{3}));
  EXPECT_TRUE(found.coincident.empty());
}

}  // namespace
}  // namespace limn::test
