// Meshes written in pieces, in any order: the bytes, and the faults, of write_mesh.

#include "limn/mesh/io/mesh_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "limn/base/parallel.h"
#include "limn/mesh/io/mesh_file.h"
#include "support/temporary_folder.h"

namespace limn::test {
namespace {

/// Faces of `each` corners, or of 3 to 300.
Polygons some_mesh(Index vertices, Index faces, Index each) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Polygons mesh;
  for (Index v = 0; v < vertices; ++v)
    mesh.positions.push_back({number(random), number(random), number(random)});
  for (Index f = 0; f < faces; ++f) {
    const Index degree = each > 0 ? each : 3 + f * 297 / faces;
    for (Index c = 0; c < degree; ++c)
      mesh.corners.push_back(static_cast<Index>(random() % static_cast<unsigned>(vertices)));
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  }
  return mesh;
}

/// Writes blocks of vertices and faces in a random order, in parallel.
Status write_mixed(const std::string& path, const Polygons& mesh, const WriteOptions& options,
                   Index each, Index largest) {
  constexpr Index kBlock = 97;
  const bool normals = !options.normals.empty();
  const mesh::MeshCounts counts{mesh.positions.size(), static_cast<std::size_t>(mesh.face_count()),
                                each, largest, normals};
  const Index vertex_blocks = (mesh.vertex_count() + kBlock - 1) / kBlock;
  const Index face_blocks = (mesh.face_count() + kBlock - 1) / kBlock;
  std::vector<Index> order(static_cast<std::size_t>(vertex_blocks + face_blocks));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  return mesh::write_mesh_pieces(path, counts, [&](mesh::MeshPieceSink& sink) {
    base::parallel_for(
        Index{0}, static_cast<Index>(order.size()),
        [&](Index i, Index /*last*/) {
          std::string memory;
          const Index block = order[static_cast<std::size_t>(i)];
          if (block < vertex_blocks) {
            const Index first = block * kBlock;
            const Index count = std::min(mesh.vertex_count() - first, kBlock);
            const auto at = 3 * static_cast<std::size_t>(first);
            sink.put_vertices(static_cast<std::size_t>(first), static_cast<std::size_t>(count),
                              numbers_of(mesh.positions).data() + at,
                              normals ? numbers_of(options.normals).data() + at : nullptr, memory);
          } else {
            const Index first = (block - vertex_blocks) * kBlock;
            const Index count = std::min(mesh.face_count() - first, kBlock);
            const Index corner = mesh.face_begin[static_cast<std::size_t>(first)];
            sink.put_faces(static_cast<std::size_t>(first), static_cast<std::size_t>(count),
                           static_cast<std::size_t>(corner), mesh.corners.data() + corner,
                           mesh.face_begin.data() + first, memory);
          }
        },
        1);
  });
}

TEST(MeshPieces, HaveTheBytesOfTheWhole) {
  const TemporaryFolder folder;
  for (const Index each : {3, 4, 5, 0})
    for (const bool normals : {false, true}) {
      const Polygons mesh = some_mesh(1000, 1500, each);
      WriteOptions options;
      if (normals) options.normals.assign(mesh.positions.rbegin(), mesh.positions.rend());
      ASSERT_TRUE(write_mixed(folder / "a.ply", mesh, options, each, each > 0 ? each : 299).ok());
      EXPECT_EQ(*base::read_file(folder / "a.ply"), *format_mesh("ply", mesh, options)) << each;
    }
}

TEST(MeshPieces, NameTheFirstVertexThatNoFileCanHold) {
  const TemporaryFolder folder;
  const double inf = std::numeric_limits<double>::infinity();
  Polygons mesh = some_mesh(1000, 10, 3);
  WriteOptions options;
  options.normals = mesh.positions;
  options.normals[3].y = std::numeric_limits<double>::quiet_NaN();
  const auto expect_same_error = [&] {
    const Status pieces = write_mixed(folder / "a.ply", mesh, options, 3, 3);
    ASSERT_FALSE(pieces.ok());
    EXPECT_EQ(pieces.error().text(), write_mesh(folder / "a.ply", mesh, options).error().text());
    EXPECT_FALSE(base::read_file(folder / "a.ply").ok());
  };
  expect_same_error();
  mesh.positions[990].x = inf;
  expect_same_error();
  mesh.positions[423].z = -inf;
  mesh.positions[421].z = inf;
  expect_same_error();
}

TEST(MeshPieces, GoIntoFilesOfOneFormat) {
  const TemporaryFolder folder;
  EXPECT_TRUE(mesh::takes_mesh_pieces(folder / "a.ply", "ply"));
  EXPECT_TRUE(mesh::takes_mesh_pieces(folder / "a", "PLY"));
  EXPECT_FALSE(mesh::takes_mesh_pieces(folder / "a.obj", "obj"));
  EXPECT_FALSE(mesh::takes_mesh_pieces("-", "ply"));
  EXPECT_FALSE(mesh::takes_mesh_pieces("/dev/null", "ply"));
}

}  // namespace
}  // namespace limn::test
