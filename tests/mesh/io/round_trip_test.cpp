/// What is written reads back equal, bit by bit.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "limn/base/files/file.h"
#include "limn/base/parallel.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/io/stl_slivers.h"
#include "mesh/io/mesh_samples.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

WriteOptions with_normals(const Polygons& mesh) {
  WriteOptions options;
  options.normals.assign(mesh.positions.size(), Point3{0, 0.6, -0.8});
  return options;
}

RC_GTEST_PROP(RoundTrip, TextAndPlyKeepEveryDouble, ()) {
  const Polygons mesh = test::random_polygons(test::any_double(), 9);
  for (const std::string extension : {"obj", "off", "ply", "PLY"}) {
    for (const WriteOptions& options : {WriteOptions{}, with_normals(mesh)}) {
      const std::string text = *format_mesh(extension, mesh, options);
      Warnings warnings;
      const Result<Polygons> again = parse_mesh(text, extension, "memory", &warnings);
      RC_ASSERT(again.ok());
      RC_ASSERT(test::same_bits(*again, mesh));
      RC_ASSERT(warnings.size() == (options.normals.empty() ? 0u : 1u));
    }
  }
}

RC_GTEST_PROP(RoundTrip, StlKeepsFloatsAndTriangles, ()) {
  const Polygons mesh = test::random_polygons(test::any_float(), 3);
  std::vector<Point3> kept;  // the corners of the triangles that have three places
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    const Point3 p = mesh.positions[mesh.corners[c]], q = mesh.positions[mesh.corners[c + 1]],
                 r = mesh.positions[mesh.corners[c + 2]];
    if (p == q || q == r || r == p) continue;
    RC_PRE(!io::lie_on_a_line(p, q, r));
    kept.insert(kept.end(), {p, q, r});
  }
  const Result<Polygons> again = parse_mesh(*format_mesh("stl", mesh), "stl", "memory");
  RC_ASSERT(again.ok() == !kept.empty());
  if (!again) return;
  RC_ASSERT(again->corners.size() == kept.size());
  for (std::size_t c = 0; c < kept.size(); ++c)
    RC_ASSERT(again->positions[again->corners[c]] == kept[c]);  // but -0 is +0
  const std::string text = *format_mesh("stl", *again);
  RC_ASSERT(*format_mesh("stl", *parse_mesh(text, "stl", "memory")) == text);
}

/// More vertices and faces than are formatted at once, no two alike and no three on a line.
Polygons large_mesh() {
  constexpr Index kVertices = 150000, kFaces = 140000;
  Polygons mesh;
  for (Index v = 0; v < kVertices; ++v) {
    const double bent = v % 1000;
    mesh.positions.push_back({v / 3.0, -1.0 * v, bent * bent + 0.25});
  }
  for (Index f = 0; f < kFaces; ++f) {
    for (Index k = 0; k < 3 + f % 3; ++k) mesh.corners.push_back((f + 17 * k) % kVertices);
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  }
  return mesh;
}

TEST(RoundTrip, LargeMeshesKeepTheirOrder) {
  const Polygons mesh = large_mesh();
  for (const std::string extension : {"obj", "off", "ply"}) {
    const Result<Polygons> again = parse_mesh(*format_mesh(extension, mesh), extension, "memory");
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(*again, mesh) << extension;
  }
  const Polygons triangles = triangulated(mesh);
  const Result<Polygons> again = parse_mesh(*format_mesh("stl", mesh), "stl", "memory");
  ASSERT_TRUE(again.ok()) << again.error().text();
  ASSERT_EQ(again->corners.size(), triangles.corners.size());
  for (std::size_t c = 0; c < triangles.corners.size(); ++c)
    ASSERT_EQ(again->positions[again->corners[c]].y, mesh.positions[triangles.corners[c]].y) << c;
}

TEST(RoundTrip, OneThreadAndManyWriteTheSame) {
  const Polygons mesh = large_mesh();
  for (const std::string extension : {"obj", "off", "ply", "stl", "glb"}) {
    set_thread_limit(1);
    const std::string one = *format_mesh(extension, mesh, with_normals(mesh));
    set_thread_limit(0);
    EXPECT_TRUE(*format_mesh(extension, mesh, with_normals(mesh)) == one) << extension;
  }
}

TEST(RoundTrip, ThroughFiles) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"a.obj", "a.off", "a.ply", "A.OBJ"}) {
    ASSERT_TRUE(write_mesh(folder / name, test::cube()).ok());
    const Result<Polygons> mesh = read_mesh(folder / name);
    ASSERT_TRUE(mesh.ok()) << mesh.error().text();
    EXPECT_EQ(*mesh, test::cube());
  }
  EXPECT_TRUE(write_mesh(folder / "a.glb", test::cube()).ok());
  const Status unknown = write_mesh(folder / "a.xyz", test::cube());
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().file, folder / "a.xyz");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.xyz"));
}

TEST(RoundTrip, WhatWouldNotReadBackIsNotWritten) {
  Polygons mesh = test::cube();
  mesh.positions[5].y = std::numeric_limits<double>::quiet_NaN();
  for (const std::string extension : {"obj", "off", "ply", "stl", "glb"}) {
    const Result<std::string> text = format_mesh(extension, mesh);
    ASSERT_FALSE(text.ok());
    EXPECT_NE(text.error().message.find("vertex 5"), std::string::npos);
  }
  mesh.positions[5].y = 1e300;
  for (const std::string extension : {"stl", "glb"})
    EXPECT_FALSE(format_mesh(extension, mesh).ok());
  for (const std::string extension : {"obj", "off", "ply"})
    EXPECT_TRUE(format_mesh(extension, mesh).ok());
}

}  // namespace
}  // namespace limn
