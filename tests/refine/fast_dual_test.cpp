// The quick engine on dual splits: numbers, faces and rows of corners, against the plain engine.

#include <numeric>

#include "limn/base/parallel.h"
#include "limn/refine/fast/dual_layout.h"
#include "limn/refine/fast/dual_tables.h"
#include "refine/fast_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Scheme parsed(const std::string& rules) {
  const Result<Scheme> scheme =
      parse_scheme("split = \"quad-dual\"\nsource = \"a test\"\n" + rules, "test.toml");
  EXPECT_TRUE(scheme.ok()) << (scheme ? "" : scheme.error().text());
  return *scheme;
}

/// partner[v] is the vertex of `polygons` at the place of v of `mesh`, which the plain engine made
/// of so many faces: their images are the first of both. Fails the test where the meshes differ.
std::vector<Index> match(const Mesh& mesh, const Polygons& polygons, Index faces) {
  std::vector<Index> partner(static_cast<std::size_t>(mesh.vertex_count()), kNone);
  const Result<Mesh> built = Mesh::build(polygons);
  EXPECT_TRUE(built.ok()) << (built ? "" : built.error().text());
  if (!built || built->vertex_count() != mesh.vertex_count() ||
      built->face_count() != mesh.face_count()) {
    ADD_FAILURE() << "sizes differ";
    return partner;
  }
  std::vector<Index> image(static_cast<std::size_t>(mesh.halfedge_count()), kNone), queue;
  bool same = true;
  const auto meet = [&](Index h, Index k) {
    if (h == kNone || k == kNone) {
      same = same && h == k;
    } else if (image[h] == kNone) {
      image[h] = k;
      queue.push_back(h);
    } else {
      same = same && image[h] == k;
    }
  };
  for (Index f = 0; f < faces; ++f) meet(mesh.face_begin(f), built->face_begin(f));
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index h = queue[i], k = image[h];
    Index& at = partner[mesh.origin(h)];
    same = same && (at == kNone || at == built->origin(k));
    at = built->origin(k);
    meet(mesh.next(h), built->next(k));
    meet(mesh.twin(h), built->twin(k));
  }
  EXPECT_TRUE(same) << "connectivity differs";
  EXPECT_EQ(std::ssize(queue), mesh.halfedge_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) partner[v] = v;  // the last of both
  return partner;
}

/// Both engines on random positions: the same mesh, the same points to rounding; or the same error.
/// Returns how many steps the quick engine left to the plain one, or -1.
int expect_same_dual(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const auto plain = refine(scheme, control, points, levels);
  const auto quick = FastRefiner::make(scheme, control, levels);
  EXPECT_EQ(plain.ok(), quick.ok());
  if (!plain || !quick) {
    if (!plain && !quick) EXPECT_EQ(plain.error().text(), quick.error().text());
    return -1;
  }
  EXPECT_EQ(quick->vertex_count(), plain->mesh.vertex_count());
  EXPECT_EQ(quick->face_count(), plain->mesh.face_count());
  EXPECT_EQ(quick->corner_count(), plain->mesh.halfedge_count());
  const std::vector<Point3> doubles = as_points(evaluate<double>(*quick, points));
  const std::vector<Point3> floats = as_points(evaluate<float>(*quick, points));
  Polygons polygons;
  polygons.positions = doubles;
  polygons.corners.resize(static_cast<std::size_t>(quick->corner_count()));
  quick->write_faces(polygons.corners);
  polygons.face_begin.resize(static_cast<std::size_t>(quick->face_count()) + 1);
  quick->write_face_begin(polygons.face_begin);
  // two edges between the same vertices are more than polygons can tell
  if (!is_simple(plain->mesh)) return quick->plain_steps();
  const std::vector<Index> partner = match(plain->mesh, polygons, control.face_count());
  double worst = 0, worst_float = 0;
  for (Index v = 0; v < plain->mesh.vertex_count(); ++v) {
    if (partner[v] == kNone) return -1;
    worst = std::max(worst, distance(plain->values[v], doubles[partner[v]]));
    worst_float = std::max(worst_float, distance(plain->values[v], floats[partner[v]]));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_float, 1e-5);
  return quick->plain_steps();
}

std::vector<Mesh> bodies() {
  std::vector<Mesh> meshes{tetrahedron(),
                           cube(),
                           icosahedron(),
                           torus(Lattice::quad, 3, 4),
                           torus(Lattice::triangle, 3, 4),
                           pillow(3),
                           pillow(5)};
  return meshes;
}

/// Meshes with boundary whose faces have all kinds of corners.
std::vector<Mesh> open_meshes() {
  std::vector<Mesh> meshes{must_build(3, {{0, 1, 2}}), must_build(6, {{0, 1, 2, 3}, {1, 0, 4, 5}}),
                           must_build(7, {{0, 1, 2, 3}, {4, 5, 6}})};
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    for (const Index n : {3, 4, 5, 9}) {
      meshes.push_back(star(lattice, n, 1));
      meshes.push_back(star(lattice, n, 2));
      meshes.push_back(fan(lattice, n - 2, 2));
      meshes.push_back(face_star(n, 2));
    }
    meshes.push_back(tree(lattice, 2));
  }
  return meshes;
}

// --- parts ----------------------------------------------------------------------------------

/// Every point has a number of its own, and isolated vertices the last.
TEST(FastDualLayout, NumbersEachPointOnce) {
  std::vector<Mesh> meshes = open_meshes();
  for (const Mesh& mesh : bodies()) meshes.push_back(mesh);
  for (const Mesh& mesh : meshes) {
    const fast::DualCorners corners(mesh);
    for (const Index n : {1, 2, 4}) {
      const fast::DualLayout layout(corners, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index y = 0; y < n; ++y)
          for (Index x = 0; x < n; ++x) {
            const bool there = corners.is_whole(h) || (x == 0 && y == 0) ||
                               (y == 0 && corners.has_x_arm(h)) || (x == 0 && corners.has_y_arm(h));
            if (there) ++met[layout.point(h, x, y)];
          }
      for (std::size_t i = 0; i < met.size(); ++i)
        EXPECT_EQ(met[i], static_cast<Index>(i) < layout.isolated_begin() ? 1 : 0);
      EXPECT_EQ(layout.vertex_count() - layout.isolated_begin(), isolated_count(mesh));
    }
  }
}

TEST(FastDualLayout, WritesRowsAndColumns) {
  for (const Mesh& mesh : open_meshes()) {
    const fast::DualCorners corners(mesh);
    const fast::DualLayout layout(corners, 4);
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      for (Index i = 0; i < (corners.is_whole(h) ? 4 : 1); ++i) {
        std::array<Index, 4> row{}, column{};
        if (corners.has_x_arm(h)) layout.row(h, i, row.data());
        if (corners.has_y_arm(h)) layout.column(h, i, column.data());
        for (Index t = 0; t < 4; ++t) {
          if (corners.has_x_arm(h)) EXPECT_EQ(row[t], layout.point(h, t, i));
          if (corners.has_y_arm(h)) EXPECT_EQ(column[t], layout.point(h, i, t));
        }
      }
  }
}

/// The sizes say how much is written, before anything is.
TEST(FastDualLayout, WritesAsManyFacesAsItSays) {
  for (const Mesh& mesh : open_meshes()) {
    const fast::DualCorners corners(mesh);
    for (const Index n : {1, 2, 8}) {
      const fast::DualLayout layout(corners, n);
      std::vector<Index> faces(static_cast<std::size_t>(layout.corner_count()) + 1, -7);
      layout.write_faces(faces.data());
      EXPECT_EQ(std::count(faces.begin(), faces.end(), -7), 1);
      EXPECT_EQ(faces.back(), -7);
      std::vector<Index> begin(static_cast<std::size_t>(layout.face_count()) + 2, -7);
      layout.write_face_begin(begin.data());
      EXPECT_EQ(begin.back(), -7);
      EXPECT_EQ(begin[begin.size() - 2], layout.corner_count());
      EXPECT_TRUE(std::is_sorted(begin.begin(), begin.end() - 1));
    }
  }
}

TEST(FastDualPlaces, AreThoseOfTheStar) {
  for (const Index sides : {3, 4, 7}) {
    const Mesh mesh = face_star(sides, 4);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      EXPECT_EQ(fast::dual_vertex(sides, fast::dual_point(sides, v)), v);
    for (Index h = 0; h < mesh.halfedge_count() && sides == 4; ++h) {
      const fast::Offset from = fast::dual_on_plane(fast::dual_point(sides, mesh.origin(h)));
      const fast::Offset to = fast::dual_on_plane(fast::dual_point(sides, mesh.target(h)));
      EXPECT_EQ(std::abs(to.a - from.a) + std::abs(to.b - from.b), 1);
    }
  }
}

// --- rules ----------------------------------------------------------------------------------

/// A rule of the face alone whose weights differ by place and by number of corners.
constexpr const char* kNear = R"toml(
[[corner]]
when = "n == 5"
round = "((k == 0)*n/3 + 2/3 + cos(2*pi*k/n)/5 - cos(4*pi*k/n)/7)/n"

[[corner]]
when = "n == 4"
self = "1/8"
round = "((k == 0)*n/4 + 5/8 + cos(2*pi*k/n)/3 + cos(4*pi*k/n)/11)/n"

[[corner]]
round = "((k == 0)*n/2 + 1/2 + cos(2*pi*k/n)/9)/n"
)toml";

/// Rules that look beyond the face, one vertex or two.
constexpr const char* kWide = R"toml(
[roles.corner]
beyond = "fev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
beyond = "1/32"
)toml";
constexpr const char* kWider = R"toml(
[roles.corner]
past = "fevfev"
opposite = "efev"

[[corner]]
when = "n < 5"
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
past = "1/32"
opposite = "1/64"

[[corner]]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
past = "1/16"
)toml";

constexpr const char* kFar = R"toml(
[roles.corner]
straight = "vefev"
outward = "fevefev"
skew = "vefevev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)*3/32"
straight = "1/64"
outward = "1/64"
skew = "1/64"
)toml";
constexpr const char* kFarther = R"toml(
[roles.corner]
straight = "vefevefev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
straight = "1/32"
)toml";

TEST(FastDualTables, SeeHowFarRulesLook) {
  const Mesh mesh = cube();
  const fast::DualTables near = fast::read_dual_tables(shipped("doo-sabin"), mesh).value();
  EXPECT_TRUE(near.own_face);
  EXPECT_EQ(near.halo, 1);
  EXPECT_EQ(near.zone, 1);
  EXPECT_EQ(near.smallest_grid, 1);
  EXPECT_EQ(near.interior[0].size(), 4U);
  EXPECT_EQ(near.zones.at(3).table.terms.size(), 9U);
  const fast::DualTables wide = fast::read_dual_tables(parsed(kWide), mesh).value();
  EXPECT_FALSE(wide.own_face);
  EXPECT_GT(wide.zone, 1);
}

// --- both engines ---------------------------------------------------------------------------

TEST(FastDual, IsThePlainEngineOnBodies) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (const Mesh& mesh : bodies())
      for (int levels = 0; levels <= 5; ++levels) {
        SCOPED_TRACE(levels);
        const bool thin = mesh.max_valence() == 2;
        EXPECT_EQ(expect_same_dual(scheme, mesh, levels, 5), thin ? std::min(levels, 1) : 0);
      }
}

TEST(FastDual, IsThePlainEngineOnOpenMeshes) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (const Mesh& mesh : open_meshes())
      for (int levels = 0; levels <= 4; ++levels) {
        SCOPED_TRACE(levels);
        EXPECT_GE(expect_same_dual(scheme, mesh, levels, 6), 0);
      }
}

TEST(FastDual, IsThePlainEngineOnRandomMeshes) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(seed);
      const auto levels = static_cast<int>(1 + seed % 4);
      EXPECT_GE(expect_same_dual(scheme, RandomMesh(seed).polygons(), levels, seed), 0);
      EXPECT_GE(expect_same_dual(scheme, RandomMesh(seed).triangles(), levels, seed), 0);
    }
}

/// Every number of sides, of faces and of vertices.
TEST(FastDual, IsThePlainEngineRoundEveryCentre) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30}) {
      SCOPED_TRACE(n);
      for (const Mesh& mesh : {star(Lattice::quad, n, 2), star(Lattice::triangle, n, 2),
                               face_star(n, 3), fan(Lattice::quad, n, 2)})
        EXPECT_EQ(expect_same_dual(scheme, mesh, 3, 3), 0);
    }
}

/// Beyond what has a table, and in meshes that do not grow.
TEST(FastDual, LeavesToThePlainEngineWhatItMust) {
  const Scheme& scheme = shipped("doo-sabin");
  EXPECT_EQ(expect_same_dual(scheme, fan(Lattice::quad, 1, 1), 2, 1), 2);
  for (const Index vertices : {0, 3})
    EXPECT_EQ(expect_same_dual(scheme, must_build(vertices, {}), 3, 1), 3);
  EXPECT_EQ(expect_same_dual(scheme, star(Lattice::triangle, 1001, 1), 2, 1), 2);
}

/// The plain engine makes the steps until centres are far enough apart, and no more.
TEST(FastDualRules, MayLookBeyondTheFace) {
  for (const char* rules : {kWide, kWider, kFar}) {
    const Scheme scheme = parsed(rules);
    // a mesh without inner edges does not grow; one of valence 2 is regular a step later
    const auto most = [&](const Mesh& mesh) {
      if (boundary_edges(mesh) == mesh.edge_count()) return 5;
      return (rules == kFar ? 3 : 2) + (mesh.has_boundary() || mesh.max_valence() > 2 ? 0 : 1);
    };
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(seed);
      const Mesh mesh = RandomMesh(seed).polygons();
      const auto levels = static_cast<int>(1 + seed % 5);
      EXPECT_GE(expect_same_dual(scheme, mesh, levels, seed), 0);
    }
    for (const Mesh& mesh : bodies())
      for (int levels = 0; levels <= 5; ++levels)
        EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), most(mesh));
    for (const Mesh& mesh : open_meshes())
      for (int levels = 0; levels <= 5; ++levels)
        EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), most(mesh));
  }
}

TEST(FastDualRules, MayLookFar) {
  const Scheme scheme = parsed(kFarther);
  for (const Mesh& mesh : {cube(), tetrahedron(), fan(Lattice::quad, 3, 2),
                           star(Lattice::quad, 5, 1), face_star(3, 2), tree(Lattice::quad, 1)})
    for (int levels = 0; levels <= 5; ++levels)
      EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), 4);
}

/// Whatever the weights: each mutant moves some of them.
TEST(FastDualRules, MayHaveAnyWeights) {
  unsigned seed = 0;
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear), parsed(kWide)})
    for (const RuleMutant& mutant : rule_mutants(scheme)) {
      SCOPED_TRACE(mutant.change);
      ++seed;
      expect_same_dual(mutant.scheme, RandomMesh(seed).polygons(), 3, seed);
      expect_same_dual(mutant.scheme, cube(), 4, seed);
    }
}

TEST(FastDual, GivesTheSameBitsOnOneThreadAndMany) {
  const Mesh closed = torus(Lattice::triangle, 30, 31);
  const Mesh open = star(Lattice::quad, 7, 12);
  for (const Mesh* control : {&closed, &open}) {
    const FastRefiner refiner = FastRefiner::make(shipped("doo-sabin"), *control, 4).value();
    const std::vector<Point3> points = random_points(control->vertex_count(), 1);
    const auto faces = [&] {
      std::vector<Index> all(static_cast<std::size_t>(refiner.corner_count()));
      refiner.write_faces(all);
      std::vector<Index> begin(static_cast<std::size_t>(refiner.face_count()) + 1);
      refiner.write_face_begin(begin);
      all.insert(all.end(), begin.begin(), begin.end());
      return all;
    };
    set_thread_limit(1);
    const std::vector<float> one = evaluate<float>(refiner, points);
    const std::vector<Index> faces_of_one = faces();
    for (const int threads : {2, 0}) {
      set_thread_limit(threads);
      EXPECT_EQ(evaluate<float>(refiner, points), one);
      EXPECT_EQ(faces(), faces_of_one);
    }
    set_thread_limit(0);
  }
}

TEST(FastDual, SaysWhereAllFacesAreQuads) {
  const Scheme& scheme = shipped("doo-sabin");
  const auto corners = [&](const Mesh& mesh, int levels) {
    return FastRefiner::make(scheme, mesh, levels).value().corners_per_face();
  };
  EXPECT_EQ(corners(torus(Lattice::quad, 4, 5), 3), 4);
  EXPECT_EQ(corners(star(Lattice::quad, 4, 2), 2), 4);
  EXPECT_EQ(corners(cube(), 1), 0);
  EXPECT_EQ(corners(torus(Lattice::triangle, 4, 5), 1), 0);
}

TEST(FastDual, RefusesWhatThePlainEngineRefuses) {
  const Scheme& scheme = shipped("doo-sabin");
  expect_same_dual(scheme, cube(), -1, 1);
  expect_same_dual(scheme, cube(), 40, 1);
  EXPECT_FALSE(FastRefiner::make(scheme, cube(), 40).ok());
  // found out when a mesh has such a face
  const Scheme small = parsed("[corner]\nself = \"1 + (n > 24)/8\"\n");
  expect_same_dual(small, face_star(30, 1), 2, 1);
  expect_same_dual(small, face_star(30, 2), 2, 1);
  expect_same_dual(small, star(Lattice::quad, 30, 2), 2, 1);
  EXPECT_FALSE(FastRefiner::make(small, face_star(30, 2), 2).ok());
}

}  // namespace
}  // namespace limn::test
