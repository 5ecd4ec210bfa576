// `limn refine` of meshes with sharp edges, corners and holes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "command/run_command.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn::test {
namespace {

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
const std::string kSquares =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n";

MeshFile read(const Folder& folder, const std::string& name) {
  return parse_mesh_file(folder.read(name), name.substr(name.rfind('.') + 1), name).value();
}

void expect_done(const Outcome& outcome) { EXPECT_EQ(outcome.code, 0) << outcome.err; }

TEST(Sharpness, OfObjTagsIsRefinedAndWhatIsLeftIsWritten) {
  const Folder folder;
  folder.write("cube.obj", kCube + "t crease 2/1/0 0 1 4.0\nt corner 1/1/0 3 10\n");
  const Outcome outcome = folder.limn("refine cube.obj -s catmull-clark -n 2 -o fine.obj --json");
  expect_done(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["sharp"]["edges"], 4);
  EXPECT_EQ(json["sharp"]["vertices"], 1);
  const MeshFile fine = read(folder, "fine.obj");
  ASSERT_EQ(fine.tags.creases.size(), 4U);  // the edge in four parts
  for (const SharpnessTags::Crease& crease : fine.tags.creases) {
    EXPECT_EQ(crease.sharpness, std::vector<double>{2});
    for (const Index v : crease.vertices) {
      const Point3 p = fine.polygons.positions[static_cast<std::size_t>(v)];
      EXPECT_NEAR(p.y, p.z, 1e-15);  // the edge is straight, and the mesh symmetric
    }
  }
  ASSERT_EQ(fine.tags.corners.size(), 1U);
  const auto corner = static_cast<std::size_t>(fine.tags.corners[0].vertex);
  EXPECT_EQ(fine.polygons.positions[corner], (Point3{1, 1, -1}));
  // two steps by two and one by four are the same
  expect_done(folder.limn("refine fine.obj -s catmull-clark -n 2 -o twice.obj"));
  expect_done(folder.limn("refine cube.obj -s catmull-clark -n 4 -o once.obj"));
  const Polygons once = read(folder, "once.obj").polygons,
                 twice = read(folder, "twice.obj").polygons;
  ASSERT_EQ(once.positions.size(), twice.positions.size());
  for (const Point3& p : once.positions)  // its edges have other numbers than the file's
    EXPECT_TRUE(std::any_of(twice.positions.begin(), twice.positions.end(),
                            [&](const Point3& q) { return dot(p - q, p - q) < 1e-28; }));
}

TEST(Sharpness, ThatAFormatCannotHoldIsWarnedOf) {
  const Folder folder;
  folder.write("cube.obj", kCube + "t crease 2/1/0 0 1 3\n");
  const Outcome outcome = folder.limn("refine cube.obj -s catmull-clark -n 2 -o fine.off");
  expect_done(outcome);
  EXPECT_NE(
      outcome.err.find("left out: what is still sharp, 4 edges and 0 vertices, which off files "
                       "cannot hold (write obj, which can)"),
      std::string::npos)
      << outcome.err;
  EXPECT_EQ(folder.limn("refine cube.obj -s catmull-clark -n 3 -o fine.off").err, "");
  EXPECT_EQ(folder.limn("refine cube.obj -s catmull-clark -n 2 -o fine.ply").err, "");
  EXPECT_EQ(read(folder, "fine.ply").tags.creases.size(), 4U);
}

TEST(Sharpness, IsLeftOutOnRequestAndByCommandsWithoutIt) {
  const Folder folder;
  folder.write("tags.obj", kCube + "t crease 2/1/0 0 1 3\n");
  folder.write("cube.obj", kCube);
  const Outcome outcome = folder.limn("refine tags.obj --no-tags -s catmull-clark -n 2 -o a.obj");
  expect_done(outcome);
  EXPECT_NE(outcome.err.find("left out: sharp edges and corners"), std::string::npos);
  expect_done(folder.limn("refine cube.obj -s catmull-clark -n 2 -o b.obj"));
  EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj"));
}

TEST(Sharpness, ByAngleKeepsACube) {
  const Folder folder;
  folder.write("cube.obj", kCube);
  expect_done(folder.limn("refine cube.obj --crease-angle 60 -s catmull-clark -n 3 -o fine.obj"));
  const MeshFile fine = read(folder, "fine.obj");
  for (const Point3& p : fine.polygons.positions)
    EXPECT_NEAR(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1, 1e-15);
  EXPECT_EQ(fine.tags.creases.size(), 12U * 8);
}

/// A prism.
TEST(SmoothTriangles, AreRefinedSoByOptionOrTags) {
  const Folder folder;
  const std::string prism =
      "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 3\nv 2 0 3\nv 0 2 3\n"
      "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n";
  folder.write("plain.obj", prism);
  folder.write("tags.obj", prism + "t smoothtriangles 0/0/1 smooth\n");
  folder.write("tags.toml", "triangles = \"smooth\"\n");
  const auto refined = [&](const std::string& arguments) {
    const Outcome outcome = folder.limn("refine " + arguments + " -n 1 -o fine.obj");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return folder.read("fine.obj");
  };
  const std::string scheme = " -s catmull-clark";
  const std::string smooth = refined("plain.obj --triangles smooth" + scheme);
  EXPECT_NE(smooth, refined("plain.obj" + scheme));
  EXPECT_EQ(smooth, refined("tags.obj" + scheme));
  EXPECT_EQ(smooth, refined("plain.obj --tags tags.toml" + scheme));
  EXPECT_EQ(refined("plain.obj" + scheme), refined("tags.obj --triangles catmullClark" + scheme));
  // the faces' centres, at heights 0 and 3/2, have 1/4 each, and with the triangle's 47/100 the
  // mean
  const auto has_height = [&](const std::string& arguments, double height) {
    refined(arguments + scheme);
    const std::vector<Point3> points = read(folder, "fine.obj").polygons.positions;
    return std::any_of(points.begin(), points.end(),
                       [&](const Point3& p) { return std::abs(p.z - height) < 1e-15; });
  };
  EXPECT_TRUE(has_height("plain.obj", 0.25 * 1.5));
  EXPECT_TRUE(has_height("plain.obj --triangles smooth", 0.36 * 1.5));
  EXPECT_FALSE(has_height("plain.obj --triangles smooth", 0.25 * 1.5));

  const Outcome warned = folder.limn("refine tags.obj -s doo-sabin -n 1 -o fine.obj");
  EXPECT_EQ(warned.code, 0);
  EXPECT_NE(warned.err.find("tags.obj:12: doo-sabin has no rule for smooth triangles, which are "
                            "refined like others"),
            std::string::npos)
      << warned.err;
  expect_refused(folder.limn("refine plain.obj -s doo-sabin --triangles smooth -n 1 -o fine.obj"),
                 "doo-sabin has no rule for smooth triangles");
  expect_refused(
      folder.limn("refine plain.obj -s catmull-clark --triangles round -n 1 -o fine.obj"),
      "--triangles");
}

TEST(Sharpness, OfATagsFileCountsAsTheMeshFileDoes) {
  const Folder folder;
  folder.write("cube.obj", kCube);
  folder.write("tags.obj", kCube + "t crease 3/1/0 0 1 3 10\nt corner 1/1/0 7 2.5\n");
  folder.write("tags.toml",
               "[[crease]]\nvertices = [1, 2, 4]\nsharpness = \"infinite\"\n"
               "[[corner]]\nvertices = [8]\nsharpness = 2.5\n");
  expect_done(folder.limn("refine cube.obj --tags tags.toml -s catmull-clark -n 3 -o a.obj"));
  expect_done(folder.limn("refine tags.obj -s catmull-clark -n 3 -o b.obj"));
  EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj"));
  folder.write("bad.toml", "[[crease]]\nvertices = [1, 8]\nsharpness = 1\n");
  expect_refused(folder.limn("refine cube.obj --tags bad.toml -s catmull-clark -o c.obj"),
                 "bad.toml:1: no edge joins the vertices 1 and 8 of a crease");
  expect_refused(folder.limn("refine cube.obj --tags none.toml -s catmull-clark -o c.obj"),
                 "none.toml");
}

TEST(Sharpness, OfTheBoundaryIsThatOfTheOptionOrTheTags) {
  const Folder folder;
  folder.write("plain.obj", kSquares);
  folder.write("tags.obj", kSquares + "t interpolateboundary 1/0/0 1\n");
  const auto has_corner = [&](const std::string& arguments) {
    expect_done(folder.limn("refine " + arguments + " -s catmull-clark -n 2 -o fine.obj"));
    const std::vector<Point3> points = read(folder, "fine.obj").polygons.positions;
    return std::find(points.begin(), points.end(), Point3{0, 0, 0}) != points.end();
  };
  EXPECT_FALSE(has_corner("plain.obj"));
  EXPECT_TRUE(has_corner("tags.obj"));
  EXPECT_FALSE(has_corner("tags.obj --boundary edgeOnly"));
  EXPECT_TRUE(has_corner("plain.obj --boundary edgeAndCorner"));
}

TEST(Sharpness, HolesAreNotWritten) {
  const Folder folder;
  folder.write("squares.obj", kSquares + "t hole 1/0/0 1\n");
  const Outcome outcome =
      folder.limn("refine squares.obj -s catmull-clark -n 1 -o fine.obj --json");
  expect_done(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["faces"], 4);
  EXPECT_EQ(json["vertices"], 9);
  EXPECT_EQ(read(folder, "fine.obj").polygons.face_count(), 4);
}

TEST(Sharpness, IsRefusedWhereASchemeCannotTakeIt) {
  const Folder folder;
  folder.write("cube.obj", kCube + "t crease 2/1/0 0 1 3\n");
  expect_refused(
      folder.limn("refine cube.obj -s doo-sabin -o fine.obj"),
      "doo-sabin takes no sharp edges or vertices: its split, quad-dual, has no boundary "
      "that stays in place");
  expect_refused(folder.limn("refine cube.obj -s four-eight -o fine.obj"),
                 "four-eight takes infinite sharpness only");
  expect_done(folder.limn("refine cube.obj -s catmull-clark -n 3 --limit -o fine.obj"));
  expect_done(folder.limn(
      "refine cube.obj --no-tags --crease-angle 60 -s catmull-clark -n 1 --limit -o fine.obj"));
  for (const Point3& p : read(folder, "fine.obj").polygons.positions)
    EXPECT_NEAR(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1, 1e-15);
  folder.write("bad.obj", kCube + "t crease 2/1/0 0 7 3\n");
  expect_refused(folder.limn("refine bad.obj -s catmull-clark -o fine.obj"),
                 "bad.obj:15: no edge joins the vertices 0 and 7 of a crease");
}

TEST(Sharpness, ThatStillFadesHasLimitPoints) {
  const Folder folder;
  folder.write("cube.obj", kCube + "t crease 2/1/0 0 1 3.5\n");
  expect_done(folder.limn("refine cube.obj -s catmull-clark -n 1 --limit -o early.obj"));
  expect_done(folder.limn("refine cube.obj -s catmull-clark -n 4 --limit -o late.obj"));
  const MeshFile early = read(folder, "early.obj");
  const std::vector<Point3> late = read(folder, "late.obj").polygons.positions;
  EXPECT_FALSE(early.tags.creases.empty());
  for (const Point3& p : early.polygons.positions)
    EXPECT_TRUE(std::any_of(late.begin(), late.end(),
                            [&](const Point3& q) { return dot(p - q, p - q) < 1e-20; }));
}

/// The numbers behind "vn" of each corner of each "f".
std::vector<Point3> corner_normals(const std::string& obj) {
  std::istringstream lines(obj);
  std::vector<Point3> normals, corners;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "vn") {
      Point3 n;
      words >> n.x >> n.y >> n.z;
      normals.push_back(n);
    } else if (word == "f") {
      while (words >> word)
        corners.push_back(normals.at(std::stoul(word.substr(word.rfind('/') + 1)) - 1));
    }
  }
  return corners;
}

TEST(Sharpness, GivesEachSideItsNormal) {
  const Folder folder;
  folder.write("cube.obj", kCube);
  const std::string how = "refine cube.obj --crease-angle 60 -s catmull-clark -n 1 --normals -o ";
  const Outcome obj = folder.limn(how + "fine.obj");
  expect_done(obj);
  EXPECT_EQ(obj.err, "");
  const std::vector<Point3> normals = corner_normals(folder.read("fine.obj"));
  ASSERT_EQ(normals.size(), 96U);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    EXPECT_NEAR(dot(normals[c], normals[c]), 1, 1e-12);
    EXPECT_LT(dot(normals[c] - normals[c - c % 4], normals[c] - normals[c - c % 4]), 1e-24);
  }
  const Outcome glb = folder.limn(how + "fine.glb");
  expect_done(glb);
  EXPECT_EQ(glb.err.find("normal"), std::string::npos) << glb.err;
  // a corner has three sides, the middle of an edge two, the middle of a face one
  EXPECT_EQ(read(folder, "fine.glb").polygons.positions.size(), 8U * 3 + 12 * 2 + 6);
  const Outcome ply = folder.limn(how + "fine.ply");
  expect_done(ply);
  EXPECT_NE(
      ply.err.find("20 vertices have a normal on each side, for which ply files have no place: "
                   "written as 0 0 0 (obj and glb have normals of corners)"),
      std::string::npos)
      << ply.err;
}

TEST(Sharpness, IsStatedByNamesOfFaces) {
  const Folder folder;
  const std::string cube =
      "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
      "g down\nf 1 3 4 2\ng up lid\nusemtl steel\nf 5 6 8 7\ng front\nf 1 2 6 5\ng back\n"
      "usemtl wood\nf 3 7 8 4\ng sides\nf 1 5 7 3\nf 2 4 8 6\n";
  folder.write("cube.obj", cube);
  const auto same = [&](const std::string& tags, const std::string& lines) {
    folder.write("tags.toml", tags);
    folder.write("tags.obj", cube + lines);
    const std::string rest = " -s catmull-clark -n 2 -o ";
    expect_done(folder.limn("refine cube.obj --tags tags.toml" + rest + "a.obj"));
    expect_done(folder.limn("refine tags.obj" + rest + "b.obj"));
    EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj")) << tags;
  };
  same("[[crease]]\ngroups = [\"lid\"]\nsharpness = 2.5\n", "t crease 5/1/0 4 5 7 6 4 2.5\n");
  same("[[crease]]\ngroups = [\"down\", \"front\"]\nsharpness = \"infinite\"\n",
       "t crease 2/1/0 0 1 10\n");
  same("[[corner]]\ngroups = [\"down\", \"front\", \"sides\"]\nsharpness = 10\n",
       "t corner 2/1/0 0 1 10\n");
  same("[[crease]]\nmaterials = [\"steel\", \"wood\"]\nsharpness = 1\n",
       "t crease 6/1/0 0 4 6 7 5 1 1\n");
  same("[[hole]]\ngroups = [\"back\"]\n", "t hole 1/0/0 3\n");
  folder.write("tags.toml", "[[hole]]\ngroups = [\"roof\"]\n");
  expect_refused(folder.limn("refine cube.obj --tags tags.toml -s catmull-clark -o c.obj"),
                 "tags.toml:1: no face has the name 'roof' among the groups (there are 'down', 'up "
                 "lid', 'front', 'back', 'sides')");
  folder.write("tags.toml", "[[crease]]\ngroups = [\"lid\"]\n");
  expect_refused(folder.limn("refine cube.obj --tags tags.toml -s catmull-clark -o c.obj"),
                 "[[crease]] needs one sharpness");
  folder.write("tags.toml", "[[hole]]\nobjects = [\"lid\"]\n");
  expect_refused(folder.limn("refine cube.obj --tags tags.toml -s catmull-clark -o c.obj"),
                 "the mesh has no object names, 'lid' is none of them");
}

}  // namespace
}  // namespace limn::test
