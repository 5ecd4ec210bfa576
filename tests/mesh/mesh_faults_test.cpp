/// Every fault of polygons, found and worded.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/mesh_limits.h"
#include "random_mesh.h"

namespace limn::test {
namespace {

using Kind = mesh::MeshFault::Kind;

std::map<Kind, int> census(const Polygons& polygons) {
  std::map<Kind, int> counts;
  for (const mesh::MeshFault& fault : mesh::find_mesh_faults(polygons).list) ++counts[fault.kind];
  return counts;
}

/// What `build_mesh` says of an OBJ file.
Error said(const std::string& obj) {
  const MeshFile file = parse_mesh_file(obj, "obj", "m.obj").value();
  const Result<Mesh> mesh = mesh::build_mesh(file.polygons, file.source);
  return mesh.ok() ? Error{} : mesh.error();
}

std::string points(int count) {
  std::string text;
  for (int v = 0; v < count; ++v) text += "v " + std::to_string(v) + " 0 0\n";
  return text;
}

TEST(MeshFaults, ARepeatedFaceIsCalledRepeated) {
  const Error once = said(points(3) + "f 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(once.text(),
            "m.obj:5: face 2 is face 1 once more (remove the repeated faces: --repair does; "
            "vertices, faces and corners count from 1, as in the file)");
  EXPECT_EQ(said(points(3) + "f 1 2 3\nf 3 1 2\n").message, "face 2 is face 1 once more");
  // Turned over it is a closed surface of two faces; on a larger surface it is a copy.
  EXPECT_EQ(said(points(3) + "f 1 2 3\nf 3 2 1\n").message, "");
  EXPECT_EQ(said(points(4) + "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\nf 3 2 1\n").message,
            "face 5 is face 1 once more, turned over");
  EXPECT_EQ(census(make_polygons(4, {{0, 1, 2, 3}, {1, 2, 3, 0}, {3, 2, 1, 0}, {0, 3, 2, 1}})),
            (std::map<Kind, int>{{Kind::repeated_face, 2}}));
}

TEST(MeshFaults, AreLinesInAFileWithoutLinesToo) {
  Error binary = said(points(4) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n");
  binary.line = 0;
  EXPECT_NE(binary.text().find(":\n  3 edges are run through"), std::string::npos) << binary.text();
  EXPECT_EQ((Error{"no scheme is called 'a\nb'"}.text()), "no scheme is called 'a\\nb'");
}

TEST(MeshFaults, SpeaksInTheNumbersAndLinesOfTheFile) {
  EXPECT_EQ(
      said(points(5) + "f 1 2 3\nf 1 2 4\nf 1 2 5\n").message,
      "the edge between vertices 1 and 2 lies in 3 faces (1, 2 and 3), but on a surface it lies "
      "in at most 2");
  EXPECT_EQ(
      said(points(5) + "\nf 1 2 3\nf 1 4 5\n").message,
      "the faces round vertex 1 form more than one fan (faces 1 apart from 2): the surface only "
      "touches itself there");
  EXPECT_EQ(said(points(5) + "\nf 1 2 3\nf 1 4 5\n").line, 7);
  const Error flipped = said(points(4) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n");
  EXPECT_EQ(
      flipped.message,
      "3 faults keep the mesh from being a surface:\n"
      "  3 edges are run through in the same direction by both their faces: reverse the corners "
      "of face 4 (line 8): --orient does\n"
      "    faces 1 (line 5) and 4 (line 8) both run from vertex 1 to vertex 3: one of them is "
      "flipped\n"
      "    faces 2 (line 6) and 4 (line 8) both run from vertex 4 to vertex 1: one of them is "
      "flipped\n"
      "    faces 3 (line 7) and 4 (line 8) both run from vertex 3 to vertex 4: one of them is "
      "flipped\n ");
  const Error moebius = said(points(6) + "f 1 2 5 4\nf 2 3 6 5\nf 3 4 1 6\n");
  EXPECT_NE(moebius.message.find("one-sided"), std::string::npos);
  EXPECT_NE(moebius.hint.find("must be cut open"), std::string::npos);
  EXPECT_EQ(moebius.hint.find("reverse"), std::string::npos);
  EXPECT_NE(moebius.hint.find("--cut does"), std::string::npos);
}

TEST(MeshFaults, AllAtOnceWithTheFirstFewOfEachKind) {
  // one of each kind that a file can have; no fault is the consequence of another
  std::string obj = points(30) +
                    "f 1 2 3\nf 1 2 3\nf 4 5 6\nf 5 4 7\nf 4 5 8\nf 9 10 11\nf 9 10 12\n"
                    "f 13 14 15\nf 13 16 17\nf 20 21 22 21\n";
  const MeshFile file = parse_mesh_file(obj, "obj", "m.obj").value();
  EXPECT_EQ(census(file.polygons), (std::map<Kind, int>{{Kind::repeated_corner, 1},
                                                        {Kind::repeated_face, 1},
                                                        {Kind::crowded_edge, 1},
                                                        {Kind::flipped_edge, 1},
                                                        {Kind::several_fans, 1}}));
  const std::string message = said(obj).message;
  EXPECT_EQ(message.substr(0, message.find('\n')), "5 faults keep the mesh from being a surface:");
  for (const char* part : {"face 10 (line 40) meets vertex 21 twice", "face 2 (line 32) is face 1",
                           "between vertices 4 and 5 lies in 3 faces", "round vertex 13"})
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;

  for (int k = 0; k < 20; ++k) obj += "f 1 2 3\n";
  const std::string more = said(obj).message;
  EXPECT_NE(more.find("21 faces are repeated"), std::string::npos) << more;
  EXPECT_NE(more.find("and 16 more"), std::string::npos) << more;
  EXPECT_LT(more.size(), 2500U);
}

TEST(MeshFaults, FacetsOfStlKeepTheirNumbers) {
  const auto facet = [](const char* corners) {
    return std::string("facet normal 0 0 0 outer loop ") + corners + " endloop endfacet\n";
  };
  const MeshFile file =
      parse_mesh_file("solid\n" + facet("vertex 0 0 0 vertex 0 0 0 vertex 1 0 0") +
                          facet("vertex 0 0 0 vertex 1 0 0 vertex 0 1 0") +
                          facet("vertex 1 0 0 vertex 0 1 0 vertex 0 0 0") + "endsolid\n",
                      "stl", "m.stl")
          .value();
  const Result<Mesh> mesh = mesh::build_mesh(file.polygons, file.source);
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().message, "face 2 is face 1 once more");
  EXPECT_EQ(mesh.error().line, 4);
}

TEST(MeshFaults, IsolatedVerticesAreNamedAsInTheFile) {
  const MeshFile file =
      parse_mesh_file("v 9 9 9\n" + points(3) + "f 2 3 4\n", "obj", "m.obj").value();
  Warnings warnings;
  ASSERT_TRUE(mesh::build_mesh(file.polygons, file.source, &warnings).ok());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0].text(),
      "m.obj:1: vertex 1 belongs to no face (it is kept and stays where it is; vertices count "
      "from 1, as in the file)");
}

TEST(MeshFaults, TooManyIsSaidWithoutHavingThem) {
  constexpr std::size_t most = 2147483646;
  EXPECT_FALSE(mesh::too_many(most, most, most).has_value());
  EXPECT_EQ(mesh::too_many(most + 1, 1, 3)->message, "2^31 - 1 vertices or more");
  EXPECT_EQ(mesh::too_many(3, 1, most + 1)->message, "2^31 - 1 corners or more");
  EXPECT_EQ(mesh::too_many(3, std::size_t{1} << 40, 3)->message, "2^31 - 1 faces or more");
}

/// Few vertices and many faces: every fault is frequent.
Polygons soup(unsigned seed) {
  std::mt19937 random(seed);
  const int vertices = 3 + static_cast<int>(random() % 8),
            faces = 1 + static_cast<int>(random() % 9);
  Faces list;
  for (int f = 0; f < faces; ++f) {
    std::vector<Index> face(2 + random() % 3 + (random() % 4 != 0 ? 1 : 0));
    for (Index& v : face) v = static_cast<Index>(random() % static_cast<unsigned>(vertices));
    list.push_back(face);
  }
  return make_polygons(vertices, list);
}

RC_GTEST_PROP(MeshFaultLaws, NoneExactlyWhereBuildAccepts, (unsigned seed)) {
  for (unsigned k = 0; k < 200; ++k) {
    const Polygons polygons = soup(seed + k);
    RC_ASSERT(mesh::find_mesh_faults(polygons).list.empty() == Mesh::build(polygons).ok());
  }
  const Polygons good = polygons_of(RandomMesh(seed).polygons());
  RC_ASSERT(mesh::find_mesh_faults(good).list.empty());
}

/// The kinds of faults that a map counts: faces by their own corners, then edges without the
/// faces that those leave out.
RC_GTEST_PROP(MeshFaultLaws, CountsAgreeWithMapsOfFacesAndEdges, (unsigned seed)) {
  for (unsigned k = 0; k < 100; ++k) {
    const Polygons polygons = soup(seed + k);
    std::map<Kind, int> expected;
    std::map<std::pair<Index, Index>, std::pair<int, int>> edges;  // runs up and down
    std::set<std::vector<Index>> seen;
    bool has_pillow = false;
    for (auto face : faces_of(polygons)) {
      const std::set<Index> different(face.begin(), face.end());
      if (face.size() < 3) ++expected[Kind::few_corners];
      if (different.size() < face.size())
        expected[Kind::repeated_corner] += static_cast<int>(face.size() - different.size());
      if (face.size() < 3 || different.size() < face.size()) continue;
      face = from_smallest(face);
      if (!seen.insert(face).second) {
        ++expected[Kind::repeated_face];
        continue;
      }
      std::vector<Index> back(face.rbegin(), face.rend());
      has_pillow = has_pillow || seen.count(from_smallest(back)) > 0;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Index v = face[i], w = face[(i + 1) % face.size()];
        ++(v < w ? edges[{v, w}].first : edges[{w, v}].second);
      }
    }
    if (has_pillow) continue;  // whether the second is a copy depends on the edges
    for (const auto& [ends, runs] : edges) {
      if (runs.first + runs.second > 2)
        ++expected[Kind::crowded_edge];
      else if (runs.first == 2 || runs.second == 2)
        ++expected[Kind::flipped_edge];
    }
    std::map<Kind, int> found = census(polygons);
    found.erase(Kind::several_fans);
    std::erase_if(expected, [](const auto& entry) { return entry.second == 0; });
    RC_ASSERT(found == expected);
  }
}

RC_GTEST_PROP(MeshFaultLaws, ReversingWhatIsNamedOrientsTheMesh, (unsigned seed)) {
  Faces faces = faces_of(polygons_of(RandomMesh(seed).polygons()));
  std::mt19937 random(seed);
  Index vertices = 0;
  for (auto& face : faces) {
    for (const Index v : face) vertices = std::max(vertices, v + 1);
    if (random() % 3 == 0) std::reverse(face.begin(), face.end());
  }
  const mesh::MeshFaults faults = mesh::find_mesh_faults(make_polygons(vertices, faces));
  for (const mesh::MeshFault& fault : faults.list) {
    if (fault.kind == Kind::repeated_face) return;  // two faces back to back, one of them turned
    RC_ASSERT(fault.kind == Kind::flipped_edge);
    RC_ASSERT(!fault.one_sided);
  }
  for (const Index f : faults.to_reverse)
    std::reverse(faces[static_cast<std::size_t>(f)].begin(),
                 faces[static_cast<std::size_t>(f)].end());
  RC_ASSERT(2 * faults.to_reverse.size() <= faces.size());
  RC_ASSERT(Mesh::build(make_polygons(vertices, faces)).ok());
}

TEST(MeshFaults, AHundredThousandFaultsTakeNoTime) {
  Faces faces(100000, {0, 1, 2});
  EXPECT_EQ(mesh::find_mesh_faults(make_polygons(3, faces)).list.size(), 99999U);
  for (Index f = 0; f < 100000; ++f) faces[static_cast<std::size_t>(f)] = {0, f + 1, f + 2};
  std::reverse(faces[500].begin(), faces[500].end());
  EXPECT_EQ(mesh::find_mesh_faults(make_polygons(100002, faces)).to_reverse,
            (std::vector<Index>{500}));
}

}  // namespace
}  // namespace limn::test
