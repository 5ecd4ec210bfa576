// A mesh made in pieces has the bits of the same mesh made as a whole.

#include "limn/fast/fast_pieces.h"

#include <algorithm>
#include <cstring>

#include "fast/families.h"
#include "limn/fast/fast_refiner.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// Bits, so that a not-a-number and the sign of a zero count.
std::vector<std::uint64_t> bits_of(const std::vector<Point3>& points) {
  const std::span<const double> numbers = numbers_of(points);
  std::vector<std::uint64_t> bits(numbers.size());
  if (!bits.empty()) std::memcpy(bits.data(), numbers.data(), numbers.size_bytes());
  return bits;
}

struct Whole {
  std::vector<Point3> positions, normals;
  std::vector<Index> corners, begin;
};

/// All pieces put together; each vertex and each face must come once.
Whole together(fast::FastPieces& pieces, bool normals) {
  Whole whole;
  const auto vertices = static_cast<std::size_t>(pieces.vertex_count());
  whole.positions.resize(vertices);
  whole.normals.resize(normals ? vertices : 0);
  std::vector<int> times(vertices, 0);
  fast::StepPiece piece;  // its memory is used again
  const auto put = [&](Index p) {
    pieces.make_vertices(p, piece);
    std::size_t at = 0;
    for (const fast::Extent& extent : piece.extents)
      for (Index v = extent.first; v < extent.first + extent.count; ++v, at += 3) {
        const auto to = static_cast<std::size_t>(v);
        ++times[to];
        const double* const p3 = &piece.positions[at];
        whole.positions[to] = {p3[0], p3[1], p3[2]};
        if (!normals) continue;
        const double* const n3 = &piece.normals[at];
        whole.normals[to] = {n3[0], n3[1], n3[2]};
      }
  };
  for (Index group = pieces.groups() - 1; group >= 0; --group) {
    const fast::FastPieces::Range range = pieces.enter(group);
    for (Index p = range.last - 1; p >= range.first; --p) put(p);
  }
  EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
  fast::FacePiece faces;
  for (Index p = 0; p < pieces.face_pieces(); ++p) {
    pieces.make_faces(p, faces);
    EXPECT_EQ(faces.first, static_cast<Index>(whole.begin.size()));
    for (Index f = 0; f < faces.count; ++f)
      whole.begin.push_back(pieces.corners_per_face() > 0
                                ? pieces.corners_per_face() * (faces.first + f)
                                : faces.begin[static_cast<std::size_t>(f)]);
    whole.corners.insert(whole.corners.end(), faces.corners.begin(), faces.corners.end());
  }
  whole.begin.push_back(static_cast<Index>(whole.corners.size()));
  return whole;
}

/// Whether there were pieces; if so, they are compared.
bool expect_same_pieces(const Scheme& scheme, const Mesh& control, int levels, Index most) {
  const std::vector<Point3> points = random_points(control.vertex_count(), 3);
  auto pieces = fast::FastPieces::make(scheme, control, numbers_of(points), levels,
                                       {.most = most, .whole_bytes = most < 200 ? 0 : 64e6});
  const Result<Polygons> whole = fast_refine(scheme, control, points, levels);
  if (pieces && !*pieces) {  // whoever asks the plain engine will know of faults
    if (whole) EXPECT_EQ(FastRefiner::make(scheme, control, levels)->plain_steps(), levels);
    return false;
  }
  EXPECT_EQ(pieces.ok(), whole.ok());
  if (!pieces || !whole) {
    if (!pieces && !whole) EXPECT_EQ(pieces.error().text(), whole.error().text());
    return false;
  }
  const Whole made = together(**pieces, false);
  EXPECT_EQ(bits_of(made.positions), bits_of(whole->positions));
  EXPECT_EQ(made.corners, whole->corners);
  EXPECT_EQ(made.begin, whole->face_begin);
  return true;
}

bool expect_same_limit_pieces(const Scheme& scheme, const Mesh& control, int levels, Index most) {
  const std::vector<Point3> points = random_points(control.vertex_count(), 3);
  const Result<FastRefiner> refiner = FastRefiner::make(scheme, control, levels);
  const Result<std::optional<FastLimitMesh>> whole =
      refiner ? approx_fast_limit_mesh(scheme, *refiner, points)
              : Result<std::optional<FastLimitMesh>>(refiner.error());
  bool found = false;
  for (const bool limit : {true, false}) {
    auto pieces =
        fast::FastPieces::make(scheme, control, numbers_of(points), levels,
                               {.limit = limit, .normals = true, .most = most, .whole_bytes = 0});
    if (pieces && !*pieces) continue;
    EXPECT_EQ(pieces.ok(), whole.ok());
    if (!pieces || !whole) continue;
    found = true;
    EXPECT_TRUE(whole->has_value());
    if (!*whole) return false;
    const Whole made = together(**pieces, true);
    EXPECT_EQ(bits_of(made.positions),
              bits_of(limit ? (*whole)->limit : (*whole)->refined.positions));
    EXPECT_EQ(bits_of(made.normals), bits_of((*whole)->normals));
    EXPECT_EQ(made.corners, (*whole)->refined.corners);
  }
  return found;
}

class FastPiecesOf : public testing::TestWithParam<std::string> {
 protected:
  const Scheme& scheme_ = shipped(GetParam());
};

std::vector<std::string> fast_schemes() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes())
    if (has_fast_layout(shipped(name))) names.push_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastPiecesOf, testing::ValuesIn(fast_schemes()),
                         [](const auto& info) { return test_name(info.param); });

TEST_P(FastPiecesOf, HaveTheBitsOfTheWhole) {
  int compared = 0;
  for (const Index most : {1, 200})
    compared +=
        expect_same_pieces(scheme_, mesh::torus(scheme_.split->lattice, 7, 6), 3, most) ? 1 : 0;
  EXPECT_EQ(compared, 2);
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Mesh mesh = random_control(*scheme_.split, seed);
    const int levels = 1 + static_cast<int>(seed % 4);
    for (const Index most : {1, 70, 300}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", pieces of " << most);
      compared += expect_same_pieces(scheme_, mesh, levels, most) ? 1 : 0;
    }
  }
}

TEST_P(FastPiecesOf, HaveTheBitsOfTheWholeLimit) {
  const Mesh closed = mesh::torus(scheme_.split->lattice, 5, 6);
  int compared = expect_same_limit_pieces(scheme_, closed, 3, 100) ? 1 : 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mesh mesh = random_control(*scheme_.split, seed);
    for (const Index most : {1, 300}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", pieces of " << most);
      compared += expect_same_limit_pieces(scheme_, mesh, 3, most) ? 1 : 0;
    }
  }
  if (compared == 0) GTEST_SKIP() << "no quick limit at this level";
}

TEST(FastPieces, AreTheSameInManyThreads) {
  const Scheme& loop = shipped("loop");
  const Mesh mesh = mesh::torus(Lattice::triangle, 20, 20);
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
  fast::FastPieces pieces =
      *fast::FastPieces::make(loop, mesh, numbers_of(points), 4, {.most = 1000, .whole_bytes = 0})
           .value();
  EXPECT_GT(pieces.groups(), 5);
  EXPECT_GT(pieces.face_pieces(), 20);
  const Whole whole = together(pieces, false);
  for (Index group = 0; group < pieces.groups(); ++group) {
    const fast::FastPieces::Range range = pieces.enter(group);
    base::parallel_for(
        range.first, range.last,
        [&](Index first, Index last) {
          fast::StepPiece piece;
          for (Index p = first; p < last; ++p) {
            pieces.make_vertices(p, piece);
            const double* from = piece.positions.data();
            for (const fast::Extent& e : piece.extents) {
              ASSERT_EQ(std::memcmp(&whole.positions[static_cast<std::size_t>(e.first)], from,
                                    static_cast<std::size_t>(e.count) * sizeof(Point3)),
                        0);
              from += 3 * e.count;
            }
          }
        },
        1);
  }
}

/// A piece of a mesh in a sensible order is few stretches of the file.
TEST(FastPieces, HaveFewExtents) {
  for (const std::string name : {"loop", "catmull-clark", "sqrt3", "doo-sabin"}) {
    const Scheme& scheme = shipped(name);
    const Mesh mesh = mesh::torus(scheme.split->lattice, 20, 20);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
    fast::FastPieces pieces = *fast::FastPieces::make(scheme, mesh, numbers_of(points), 4,
                                                      {.most = 4000, .whole_bytes = 0})
                                   .value();
    fast::StepPiece piece;
    for (Index group = 0; group < pieces.groups(); ++group) {
      const fast::FastPieces::Range range = pieces.enter(group);
      for (Index p = range.first; p < range.last; ++p) {
        pieces.make_vertices(p, piece);
        EXPECT_LE(piece.extents.size(), 3U) << name;
      }
    }
  }
}

TEST(FastPieces, AreNoneWhereThePlainEngineMakesAllSteps) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 4, 4);
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
  EXPECT_FALSE(fast::FastPieces::make(shipped("loop"), mesh, numbers_of(points), 0).value());
  EXPECT_FALSE(fast::FastPieces::make(shipped("loop"), mesh, numbers_of(points), 40).ok());
}

}  // namespace
}  // namespace limn::test
