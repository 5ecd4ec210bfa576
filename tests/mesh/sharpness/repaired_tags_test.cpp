// Tags speak of the vertices of a file, also where repair has joined or copied them.

#include <gtest/gtest.h>

#include <algorithm>

#include "limn/mesh/mesh.h"
#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn {
namespace {

/// A cube of six quads without a common vertex: face f has the vertices 4f … 4f + 3.
Polygons loose_cube() {
  const Polygons cube{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
      {0, 4, 8, 12, 16, 20, 24},
      {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5}};
  Polygons loose;
  for (const Index v : cube.corners) {
    loose.corners.push_back(static_cast<Index>(loose.positions.size()));
    loose.positions.push_back(cube.positions[static_cast<std::size_t>(v)]);
  }
  loose.face_begin = cube.face_begin;
  return loose;
}

struct Applied {
  Mesh mesh;
  mesh::Repaired repaired;
  Sharpness sharpness;
};

Applied applied(const Polygons& polygons, const mesh::RepairOptions& options,
                const SharpnessTags& tags) {
  Applied result{{}, mesh::repair(polygons, options).value(), {}};
  result.mesh = Mesh::build(result.repaired.polygons).value();
  const Status status =
      apply_tags(result.mesh, mesh::source_of(result.repaired, {}), tags, result.sharpness);
  EXPECT_TRUE(status.ok()) << (status ? "" : status.error().message);
  return result;
}

std::vector<Index> sharp(const std::vector<double>& values) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] > 0) found.push_back(static_cast<Index>(i));
  return found;
}

/// Each edge of the cube is stated by the vertices of either of its faces.
TEST(RepairedTags, AJoinedVertexStandsForTheOneThatItWasJoinedWith) {
  const Polygons cube = loose_cube();
  std::vector<std::vector<Index>> edges;
  for (Index f = 0; f < 6; ++f)
    for (Index c = 0; c < 4; ++c) {
      SharpnessTags tags;
      tags.creases.push_back({{4 * f + c, 4 * f + (c + 1) % 4}, {2}});
      tags.corners.push_back({4 * f + c, 3});
      const Applied found = applied(cube, {.weld = 0.0}, tags);
      ASSERT_EQ(found.mesh.vertex_count(), 8);
      const std::vector<Index> corners = sharp(found.sharpness.vertices);
      ASSERT_EQ(corners.size(), 1U);
      EXPECT_EQ(found.repaired.polygons.positions[static_cast<std::size_t>(corners[0])],
                cube.positions[static_cast<std::size_t>(4 * f + c)]);
      edges.push_back(sharp(found.sharpness.edges));
      ASSERT_EQ(edges.back().size(), 1U);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size(); k += 2) EXPECT_EQ(edges[k], edges[k + 1]);
  EXPECT_EQ(std::unique(edges.begin(), edges.end()) - edges.begin(), 12);
}

/// Two faces that touch at vertex 0.
TEST(RepairedTags, ACutVertexStandsForAllItsCopies) {
  const Polygons touching{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {0, 3, 6}, {0, 1, 2, 0, 3, 4}};
  SharpnessTags tags;
  tags.corners.push_back({0, 2});
  const Applied found = applied(touching, {.cut = true}, tags);
  ASSERT_EQ(found.mesh.vertex_count(), 6);
  EXPECT_EQ(sharp(found.sharpness.vertices).size(), 2U);
}

TEST(RepairedTags, NumbersAreThoseOfTheFile) {
  SharpnessTags tags;
  tags.corners.push_back({24, 1});
  const mesh::Repaired repaired = mesh::repair(loose_cube(), {.weld = 0.0}).value();
  const Mesh mesh = Mesh::build(repaired.polygons).value();
  Sharpness sharpness;
  EXPECT_FALSE(apply_tags(mesh, mesh::source_of(repaired, {}), tags, sharpness).ok());
  tags.corners[0].vertex = 23;
  EXPECT_TRUE(apply_tags(mesh, mesh::source_of(repaired, {}), tags, sharpness).ok());
}

}  // namespace
}  // namespace limn
