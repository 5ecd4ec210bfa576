/// Repair: laws over random meshes and rubble, and single faults.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "damage.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/repair/places.h"
#include "limn/mesh/repair/survey.h"

namespace limn::test {
namespace {

const mesh::RepairOptions kEverything = mesh::RepairOptions::everything();
const mesh::RepairOptions kCut{.cut = true}, kOrient{.orient = true};

mesh::Repaired must_repair(const Polygons& polygons, const mesh::RepairOptions& options) {
  return mesh::repair(polygons, options).value();
}

Index done(const mesh::Repaired& repaired, const std::string& what) {
  for (const mesh::RepairStep& step : repaired.done)
    if (step.what == what) return step.count;
  return 0;
}

/// What is there is told rightly.
void check_sources(const Polygons& from, const mesh::Repaired& to) {
  const Polygons& mesh = to.polygons;
  RC_ASSERT(to.vertex_of.size() == mesh.positions.size());
  RC_ASSERT(to.face_of.size() == static_cast<std::size_t>(mesh.face_count()));
  RC_ASSERT(to.corner_of.size() == mesh.corners.size());
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      const Index corner = to.corner_of[c];
      if (corner == kNone) continue;
      const Index face = to.face_of[f];
      RC_ASSERT(corner >= from.face_begin[face] && corner < from.face_begin[face + 1]);
      RC_ASSERT(from.positions[from.corners[corner]] == mesh.positions[mesh.corners[c]]);
    }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    RC_ASSERT(from.positions[static_cast<std::size_t>(to.vertex_of[v])] == mesh.positions[v]);
}

RC_GTEST_PROP(RepairLaws, OfACleanMeshChangesNothing, (unsigned seed)) {
  std::mt19937 random(seed);
  const Polygons clean = placed(RandomMesh(seed).polygons(), random);
  const mesh::Repaired repaired = must_repair(clean, kEverything);
  RC_ASSERT(repaired.polygons == clean);
  RC_ASSERT(repaired.done.empty());
  RC_ASSERT(repaired.sharp_vertices.empty() && repaired.sharp_edges.empty());
}

RC_GTEST_PROP(RepairLaws, OfRubbleMakesAMeshAndTwiceIsOnce, (unsigned seed)) {
  for (unsigned k = 0; k < 200; ++k) {
    const Polygons broken = rubble(seed + k);
    const Result<mesh::Repaired> repaired = mesh::repair(broken, kEverything);
    if (!repaired) continue;  // nothing is left
    RC_LOG() << "rubble " << seed + k;
    check_sources(broken, *repaired);
    RC_ASSERT(Mesh::build(repaired->polygons).ok());
    RC_ASSERT(mesh::survey_mesh(repaired->polygons).refinable);
    const mesh::Repaired again = must_repair(repaired->polygons, kEverything);
    RC_ASSERT(again.polygons == repaired->polygons);
  }
}

RC_GTEST_PROP(RepairLaws, OfTrianglesLeavesNoneWithoutArea, (unsigned seed)) {
  for (unsigned k = 0; k < 100; ++k) {
    const Polygons broken = rubble(seed + k);
    const Result<mesh::Repaired> repaired = mesh::repair(broken, kEverything);
    if (!repaired || repaired->polygons.corners.size() !=
                         3 * static_cast<std::size_t>(repaired->polygons.face_count()))
      continue;
    const std::size_t flat = mesh::survey_mesh(repaired->polygons).degenerate.size();
    RC_ASSERT(flat == 0 || flat == static_cast<std::size_t>(repaired->polygons.face_count()));
  }
}

RC_GTEST_PROP(RepairLaws, CuttingKeepsFacesAndTheirDirection, (unsigned seed)) {
  for (unsigned k = 0; k < 100; ++k) {
    const Polygons broken = rubble(seed + k);
    const mesh::Repaired cut = must_repair(broken, kCut);
    RC_ASSERT(named_by(cut.polygons, cut.vertex_of) == faces_of(broken));
    RC_ASSERT(cut.polygons.vertex_count() >= broken.vertex_count());
    for (const mesh::MeshFault& fault : mesh::find_mesh_faults(cut.polygons).list) {
      RC_ASSERT(fault.kind != mesh::MeshFault::Kind::crowded_edge);
      RC_ASSERT(fault.kind != mesh::MeshFault::Kind::several_fans);
      RC_ASSERT(!fault.one_sided);
    }
  }
}

/// Sheets are as few as can be: corners that a face apart from edges of more than two joins stay
/// joined.
RC_GTEST_PROP(RepairLaws, CuttingTakesApartNothingElse, (unsigned seed)) {
  for (unsigned k = 0; k < 100; ++k) {
    const Polygons broken = rubble(seed + k);
    const mesh::MeshFaults faults = mesh::find_mesh_faults(broken);
    const bool copies =
        std::any_of(faults.list.begin(), faults.list.end(), [](const mesh::MeshFault& fault) {
          return fault.kind == mesh::MeshFault::Kind::repeated_face;
        });
    if (copies) continue;                     // which are faces of a sheet, too
    std::set<std::pair<Index, Index>> pairs;  // of faces that an edge of two joins
    for (const mesh::MeshFault& fault : faults.list)
      if (fault.kind == mesh::MeshFault::Kind::flipped_edge && !fault.one_sided)
        pairs.insert(std::minmax(fault.faces[0], fault.faces[1]));
    std::set<std::pair<Index, Index>> kept;
    for (const mesh::MeshFault& fault :
         mesh::find_mesh_faults(must_repair(broken, kCut).polygons).list)
      if (fault.kind == mesh::MeshFault::Kind::flipped_edge)
        kept.insert(std::minmax(fault.faces[0], fault.faces[1]));
    RC_ASSERT(std::includes(kept.begin(), kept.end(), pairs.begin(), pairs.end()));
  }
}

RC_GTEST_PROP(RepairLaws, WeldingUndoesTakingFacesApart, (unsigned seed)) {
  std::mt19937 random(seed);
  const Polygons clean = placed(RandomMesh(seed).polygons(), random);
  Polygons apart;  // each face with vertices of its own
  for (const auto& face : faces_of(clean)) {
    for (const Index v : face) {
      apart.corners.push_back(apart.vertex_count());
      apart.positions.push_back(clean.positions[static_cast<std::size_t>(v)]);
    }
    apart.face_begin.push_back(static_cast<Index>(apart.corners.size()));
  }
  const mesh::Repaired welded = must_repair(apart, {.weld = 0.0});
  check_sources(apart, welded);
  const auto positions = [](const Polygons& mesh) {
    std::vector<std::vector<std::array<double, 3>>> faces;
    for (const auto& face : faces_of(mesh)) {
      auto& list = faces.emplace_back();
      for (const Index v : face) {
        const Point3& p = mesh.positions[static_cast<std::size_t>(v)];
        list.push_back({p.x, p.y, p.z});
      }
    }
    return faces;
  };
  RC_ASSERT(positions(welded.polygons) == positions(clean));
  const Mesh mesh = Mesh::build(clean).value();
  RC_ASSERT(welded.polygons.vertex_count() == mesh.vertex_count() - isolated_count(mesh));
  RC_ASSERT(done(welded, "vertices_welded") ==
            apart.vertex_count() - welded.polygons.vertex_count());
}

RC_GTEST_PROP(RepairLaws, PlacesAreNearAndApart, (unsigned seed)) {
  std::mt19937 random(seed);
  std::vector<Point3> points = random_places(1 + static_cast<Index>(random() % 60), random);
  const double distance = std::pow(2.0, -static_cast<double>(random() % 6));
  const std::vector<Index> place = mesh::places_of(points, distance);
  const auto apart = [&](Index i, Index k) {
    return std::hypot(points[i].x - points[k].x, points[i].y - points[k].y,
                      points[i].z - points[k].z);
  };
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    RC_ASSERT(place[i] <= i && place[place[i]] == place[i]);
    RC_ASSERT(apart(i, place[i]) <= distance);
    for (Index k = 0; k < i; ++k) {
      if (place[k] != k) continue;
      if (place[i] == i) RC_ASSERT(apart(i, k) > distance);  // by brute force
      RC_ASSERT(apart(i, place[i]) <= apart(i, k) || place[i] == i);
    }
  }
}

/// By trying all ways to reverse faces.
RC_GTEST_PROP(RepairLaws, OrientingReversesTheFewest, (unsigned seed)) {
  std::mt19937 random(seed);
  const Polygons clean = placed(RandomMesh(seed).polygons(), random);
  RC_PRE(clean.face_count() <= 12);
  Faces faces = faces_of(clean);
  for (auto& face : faces)
    if (random() % 2 == 0) std::reverse(face.begin(), face.end());
  const Polygons broken = with_faces(clean, faces);
  bool only_flipped = true;
  for (const mesh::MeshFault& fault : mesh::find_mesh_faults(broken).list)
    only_flipped = only_flipped && fault.kind == mesh::MeshFault::Kind::flipped_edge;
  RC_PRE(only_flipped);
  const mesh::Repaired oriented = must_repair(broken, kOrient);
  RC_ASSERT(Mesh::build(oriented.polygons).ok());
  Index fewest = clean.face_count();
  for (unsigned way = 0; way < 1U << static_cast<unsigned>(clean.face_count()); ++way) {
    const auto count = static_cast<Index>(__builtin_popcount(way));
    if (count >= fewest) continue;
    Faces tried = faces;
    for (std::size_t f = 0; f < tried.size(); ++f)
      if ((way >> f & 1U) != 0) std::reverse(tried[f].begin(), tried[f].end());
    if (Mesh::build(with_faces(clean, tried)).ok()) fewest = count;
  }
  RC_ASSERT(done(oriented, "faces_reversed") == fewest);
}

Polygons at(const std::vector<Point3>& positions, const Faces& faces) {
  Polygons polygons = make_polygons(static_cast<Index>(positions.size()), faces);
  polygons.positions = positions;
  return polygons;
}

TEST(Repair, FacesThatMeetAVertexTwiceAreCutThere) {
  std::mt19937 random(1);
  const Polygons eight = at(random_places(6, random), {{0, 1, 2, 0, 3, 4},  // two loops
                                                       {0, 1, 1, 5},    // a corner at once again
                                                       {1, 2, 1},       // nothing
                                                       {2, 3, 4, 3}});  // there and back
  const mesh::Repaired repaired = must_repair(eight, {.drop = true});
  EXPECT_EQ(faces_of(repaired.polygons), (Faces{{0, 1, 2}, {0, 3, 4}, {0, 1, 5}}));
  EXPECT_EQ(repaired.face_of, (std::vector<Index>{0, 0, 1}));
  EXPECT_EQ(done(repaired, "degenerate_faces_dropped"), 2);
  EXPECT_EQ(done(repaired, "faces_cut"), 2);
}

TEST(Repair, WeldingCollapsesCornersOnlyWhereItJoins) {
  const Polygons cap = at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1e-9}, {5, 5, 5}},
                          {{0, 1, 2, 3}, {1, 2, 3}, {0, 1, 1, 4}});
  const mesh::Repaired repaired = must_repair(cap, {.weld = 1e-6});
  EXPECT_EQ(faces_of(repaired.polygons), (Faces{{0, 1, 2}, {0, 1, 1, 3}}));
  EXPECT_EQ(repaired.vertex_of, (std::vector<Index>{0, 1, 2, 4}));
  EXPECT_EQ(must_repair(cap, {.weld = 0.0}).polygons, cap);
  EXPECT_EQ(must_repair(cap, {.weld = 1e-30}).polygons, cap);
}

TEST(Repair, AFlatTriangleGoesWithoutACrack) {
  // a square of two triangles, one side of which is halved by a flat one
  const Polygons square = at({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 0}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {4, 0, 5}, {1, 4, 5}});
  const mesh::Repaired repaired = must_repair(square, kEverything);
  EXPECT_EQ(done(repaired, "flat_faces_dropped"), 1);
  const Mesh mesh = Mesh::build(repaired.polygons).value();
  EXPECT_EQ(boundary_loops(mesh), 1);
  EXPECT_EQ(mesh.face_count(), 5);  // the neighbour is cut in two
  EXPECT_TRUE(mesh::survey_mesh(repaired.polygons).degenerate.empty());
  EXPECT_EQ(std::count(repaired.corner_of.begin(), repaired.corner_of.end(), kNone) > 0, true);
}

TEST(Repair, AMeshOfFlatFacesIsKept) {
  const Polygons line = at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_EQ(must_repair(line, kEverything).polygons, line);
}

TEST(Repair, VerticesWithoutAFaceStayIfTheyHadNone) {
  std::mt19937 random(2);
  const Polygons polygons = at(random_places(6, random), {{1, 2, 3}, {4, 4, 5}});
  const mesh::Repaired repaired = must_repair(polygons, kEverything);
  EXPECT_EQ(repaired.vertex_of, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(done(repaired, "vertices_dropped"), 2);
}

TEST(Repair, ThreePagesAreThreeSheets) {
  std::mt19937 random(3);
  const Polygons book = at(random_places(5, random), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const mesh::Repaired cut = must_repair(book, kCut);
  EXPECT_EQ(faces_of(cut.polygons), (Faces{{0, 1, 2}, {5, 7, 3}, {6, 8, 4}}));
  EXPECT_EQ(cut.vertex_of, (std::vector<Index>{0, 1, 2, 3, 4, 0, 0, 1, 1}));
  // the edge ends on the boundary, so both ends are corners
  EXPECT_EQ(cut.sharp_vertices, (std::vector<Index>{0, 1, 5, 6, 7, 8}));
  EXPECT_EQ(done(cut, "edges_cut"), 1);
  EXPECT_EQ(done(cut, "vertices_cut"), 2);
}

TEST(Repair, AnEdgeThatOneSheetHasTwiceIsACrease) {
  // a fourth page on an edge of a cube that both ends of the page's edge join to one fan
  Faces faces = faces_of(polygons_of(cube()));
  faces.push_back({0, 1, 8});
  std::mt19937 random(4);
  const Polygons winged = at(random_places(9, random), faces);
  const mesh::Repaired cut = must_repair(winged, kCut);
  ASSERT_TRUE(Mesh::build(cut.polygons).ok());
  EXPECT_EQ(cut.sharp_edges, (std::vector<std::array<Index, 2>>{{0, 1}}));
  EXPECT_EQ(cut.sharp_vertices, (std::vector<Index>{0, 1, 9, 10}));
}

TEST(Repair, TwoConesThatTouchAreTwo) {
  Faces faces;
  for (Index apex : {1, 5})
    for (Index k = 0; k < 4; ++k) faces.push_back({0, apex + k, apex + (k + 1) % 4});
  std::mt19937 random(5);
  const mesh::Repaired cut = must_repair(at(random_places(9, random), faces), kCut);
  EXPECT_EQ(cut.polygons.vertex_count(), 10);
  EXPECT_EQ(cut.sharp_vertices, (std::vector<Index>{0, 9}));
  EXPECT_TRUE(Mesh::build(cut.polygons).ok());
}

Faces moebius(Index quads) {
  Faces faces;
  for (Index k = 0; k + 1 < quads; ++k) faces.push_back({2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2});
  faces.push_back({2 * quads - 2, 2 * quads - 1, 0, 1});
  return faces;
}

TEST(Repair, AMoebiusBandIsCutOnceAndNoFaceOfItReversed) {
  std::mt19937 random(6);
  const Polygons band = at(random_places(10, random), moebius(5));
  for (const mesh::RepairOptions& options : {kCut, kEverything}) {
    const mesh::Repaired cut = must_repair(band, options);
    const Mesh mesh = Mesh::build(cut.polygons).value();
    EXPECT_EQ(cut.polygons.vertex_count(), 12);
    EXPECT_EQ(boundary_loops(mesh), 1);
    EXPECT_EQ(done(cut, "faces_reversed"), 0);
    EXPECT_EQ(done(cut, "one_sided_edges_cut"), 1);
  }
  EXPECT_FALSE(Mesh::build(must_repair(band, kOrient).polygons).ok());
}

TEST(Repair, AKleinBottleIsCutToATube) {
  // a torus of which one seam is glued the other way round
  constexpr Index n = 5, m = 4;
  Faces faces;
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < m; ++k) {
      const auto at_column = [&](Index column, Index row) {
        return column < n ? column * m + row % m : (m - row % m) % m;
      };
      faces.push_back(
          {at_column(i, k), at_column(i + 1, k), at_column(i + 1, k + 1), at_column(i, k + 1)});
    }
  std::mt19937 random(7);
  const Polygons bottle = at(random_places(n * m, random), faces);
  EXPECT_FALSE(mesh::survey_mesh(bottle).orientable);
  const mesh::Repaired cut = must_repair(bottle, kEverything);
  const Mesh mesh = Mesh::build(cut.polygons).value();
  EXPECT_EQ(boundary_loops(mesh), 2);
  EXPECT_EQ(mesh.vertex_count(), n * m + m);
  EXPECT_EQ(euler_characteristic(mesh), 0);
}

TEST(Repair, NothingLeftIsRefusedAndWrongCornersAreLeft) {
  std::mt19937 random(8);
  const Result<mesh::Repaired> none =
      mesh::repair(at(random_places(2, random), {{0, 1, 0}}), kEverything);
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().message.find("no face is left"), std::string::npos);
  const Polygons wrong = at(random_places(3, random), {{0, 1, 2}, {0, 1, 7}, {0, -1, 2, 2}});
  const mesh::Repaired repaired = must_repair(wrong, kEverything);
  EXPECT_EQ(repaired.polygons, wrong);
}

TEST(Repair, NumbersOfTheFileGoAlong) {
  std::mt19937 random(9);
  MeshSource source;
  source.first = 1;
  source.vertex_lines = {1, 2, 3, 4, 5, 6};
  source.face_lines = {7, 8, 9};
  const Polygons polygons = at(random_places(6, random), {{0, 0, 1}, {1, 2, 3}, {1, 4, 5}});
  const mesh::Repaired repaired = must_repair(polygons, kEverything);
  const MeshSource mended = mesh::source_of(repaired, source);
  EXPECT_EQ(mended.face_line(0), 8);
  EXPECT_EQ(mended.file_face(1), 2);
  EXPECT_EQ(mended.vertex_line(0), 2);                                     // vertex 1 of the file
  EXPECT_EQ(mended.file_vertex(repaired.polygons.vertex_count() - 1), 1);  // its copy
}

}  // namespace
}  // namespace limn::test
