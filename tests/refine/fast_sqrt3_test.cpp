// The quick engine's family of √3 against the plain engine, and its numbers.

#include "limn/refine/fast/sqrt3_layout.h"
#include "limn/refine/fast/sqrt3_reach.h"
#include "refine/fast_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

using fast::CentroidLayout;

/// The plain engine's meshes, and for each control face's first corner v the half-edge out of v on
/// the face's first edge (at odd levels, towards the middle of the small triangle there).
struct PlainLevels {
  PlainLevels(const Mesh& control, int levels) : mesh(control) {
    for (Index f = 0; f < control.face_count(); ++f) starts.push_back(3 * f);
    for (int step = 0; step < levels; ++step) {
      const SplitResult split = find_split("sqrt3")->apply(mesh, step);
      for (Index& h : starts)
        h = step % 2 == 0 ? turned_towards(split, mesh.face(h), mesh.origin(h)) : turned(split, h);
      mesh = split.mesh;
    }
  }

  /// The half-edge from v to the vertex born of face f.
  static Index turned_towards(const SplitResult& split, Index f, Index v) {
    const Births& births = split.births;
    if (!births.faces.empty())
      f = static_cast<Index>(std::find(births.faces.begin(), births.faces.end(), f) -
                             births.faces.begin());
    Index h = split.mesh.halfedge_of_vertex(v);
    while (split.mesh.target(h) != births.from_vertices + births.from_edges + f)
      h = split.mesh.rotate(h);
    return h;
  }

  /// Of the face on the right of h, which lies on the old edge; or the boundary edge.
  [[nodiscard]] Index turned(const SplitResult& split, Index h) const {
    const Index v = mesh.origin(h), right = mesh.twin(h);
    if (mesh.twin(mesh.next(right)) == kNone) return split.mesh.halfedge_of_vertex(v);
    return turned_towards(split, mesh.face(right), v);
  }

  Mesh mesh;
  std::vector<Index> starts;
};

/// partner[v] is the vertex of `quick` at the place of v of the plain engine's mesh.
std::vector<Index> match_sqrt3(const PlainLevels& plain, const Mesh& quick, bool odd) {
  const Mesh& mesh = plain.mesh;
  std::vector<Index> partner(static_cast<std::size_t>(mesh.vertex_count()), kNone);
  if (mesh.vertex_count() != quick.vertex_count() || mesh.face_count() != quick.face_count()) {
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
  const Index faces = std::ssize(plain.starts);
  const Index each = faces == 0 ? 0 : quick.face_count() / faces;
  for (Index f = 0; f < faces; ++f)  // at odd levels a face ends with the way back from its centroid
    meet(odd ? mesh.twin(plain.starts[f]) : plain.starts[f], 3 * f * each + (odd ? 2 : 0));
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index h = queue[i], k = image[h];
    Index& at = partner[mesh.origin(h)];
    same = same && (at == kNone || at == quick.origin(k));
    at = quick.origin(k);
    meet(mesh.next(h), quick.next(k));
    meet(mesh.twin(h), quick.twin(k));
  }
  EXPECT_TRUE(same) << "connectivity differs";
  EXPECT_EQ(std::ssize(queue), mesh.halfedge_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) partner[v] = v;  // they are control vertices
  return partner;
}

/// Both engines on random positions: the same mesh, the same points to rounding; or the same error.
/// Returns how many steps the quick engine left to the plain one, or -1.
int expect_same_sqrt3(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const auto plain = refine(scheme, control, points, levels);
  const auto quick = FastRefiner::make(scheme, control, levels);
  EXPECT_EQ(plain.ok(), quick.ok());
  if (!plain || !quick) {
    if (!plain && !quick) EXPECT_EQ(plain.error().text(), quick.error().text());
    return -1;
  }
  if (!is_simple(plain->mesh)) return quick->plain_steps();
  Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(quick->vertex_count()));
  polygons.corners.resize(static_cast<std::size_t>(quick->corner_count()));
  quick->write_faces(polygons.corners);
  for (Index f = 1; f <= quick->face_count(); ++f) polygons.face_begin.push_back(3 * f);
  const Result<Mesh> mesh = Mesh::build(polygons);
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : mesh.error().text());
  if (!mesh) return -1;
  const std::vector<Index> partner =
      match_sqrt3(PlainLevels(control, levels), *mesh, levels % 2 != 0);
  const std::vector<Point3> doubles = as_points(evaluate<double>(*quick, points));
  const std::vector<Point3> floats = as_points(evaluate<float>(*quick, points));
  double worst = 0, worst_float = 0;
  for (Index v = 0; v < plain->mesh.vertex_count(); ++v) {
    if (partner[v] == kNone) return -1;
    worst = std::max(worst, distance(plain->values[v], doubles[partner[v]]));
    worst_float = std::max(worst_float, distance(plain->values[v], floats[partner[v]]));
    // control vertices keep their numbers
    if (v < control.vertex_count()) EXPECT_EQ(partner[v], v);
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_float, 1e-5);
  return quick->plain_steps();
}

std::vector<Mesh> some_meshes() {
  std::vector<Mesh> meshes{icosahedron(), fan(Lattice::triangle, 1, 2), fan(Lattice::triangle, 1, 1)};
  for (unsigned seed = 0; seed < 12; ++seed) meshes.push_back(RandomMesh(seed).triangles());
  return meshes;
}

/// Every point of every patch has a number, every number a point; vertices keep theirs, and the
/// centroids of a patch are numbered as the grid's faces come.
TEST(Sqrt3Layout, NumbersEachPointOnce) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index f = 0; f < mesh.face_count(); ++f) {
        Index next = layout.centroid_begin(f);
        for (Index y = 0; y <= n; ++y)
          for (Index x = 0; x + y <= n; ++x) {
            EXPECT_EQ(layout.point(3 * f, 3 * x, 3 * y), layout.grid().point(3 * f, x, y));
            ++met[layout.point(3 * f, 3 * x, 3 * y)];
            if (x + y < n) EXPECT_EQ(layout.point(3 * f, 3 * x + 1, 3 * y + 1), next++);
            if (x + y + 1 < n) EXPECT_EQ(layout.point(3 * f, 3 * x + 2, 3 * y + 2), next++);
          }
        for (Index i = layout.centroid_begin(f); i < next; ++i) ++met[i];
        EXPECT_EQ(next - layout.centroid_begin(f), n * n);
      }
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.is_isolated(v)) met[v] = 1;
      EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
    }
}

TEST(Sqrt3Layout, TurnsFramesLooksBeyondSidesAndWritesColumns) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      const Index side = 3 * n;
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index x = 0; x <= side; ++x) {
          std::vector<Index> column;
          for (Index y = x % 3; x + y <= side; y += 3) {
            const Index point = layout.point(h, x, y);
            column.push_back(point);
            EXPECT_EQ(layout.point(mesh.next(h), y, side - x - y), point);
            if (y == 0) continue;
            const Index twin = mesh.twin(h);  // the mirror image's twin
            const Index beyond = twin == kNone ? kNone : layout.point(mesh.next(twin), y, x);
            EXPECT_EQ(layout.point_beyond(h, x + y, -y), beyond);
            EXPECT_EQ(layout.point_beyond(mesh.next(h), -y, side - x), beyond);
            EXPECT_EQ(layout.point_beyond(mesh.prev(h), side - x, x + y), beyond);
          }
          if (x == 0) continue;
          std::vector<Index> written(column.size() + 1, kNone);
          EXPECT_EQ(layout.column(h, x, written.data()) - written.data(), std::ssize(column));
          written.pop_back();
          EXPECT_EQ(written, column);
        }
    }
}

/// By definition, from places alone.
TEST(Sqrt3Layout, WritesFacesByHalfEdges) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      std::vector<Index> corners(3 * static_cast<std::size_t>(layout.face_count())), expected;
      layout.write_faces(0, mesh.face_count(), corners.data());
      for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto at = [&](Index x, Index y) { return layout.point_beyond(3 * f, x, y); };
        const auto triangle = [&](std::array<fast::Offset, 3> p) {
          const Index own = at((p[0].a + p[1].a + p[2].a) / 3, (p[0].b + p[1].b + p[2].b) / 3);
          for (std::size_t i = 0; i < 3; ++i) {
            const fast::Offset a = p[i], b = p[(i + 1) % 3], c = p[(i + 2) % 3];
            const fast::Offset far{a.a + b.a - c.a, a.b + b.b - c.b};
            const Index across = at((a.a + b.a + far.a) / 3, (a.b + b.b + far.b) / 3);
            expected.insert(expected.end(),
                            {at(a.a, a.b), across == kNone ? at(b.a, b.b) : across, own});
          }
        };
        for (Index y = 0; y < 3 * n; y += 3)
          for (Index x = 0; x + y < 3 * n; x += 3) {
            triangle({{{x, y}, {x + 3, y}, {x, y + 3}}});
            if (x + y + 3 < 3 * n) triangle({{{x + 3, y}, {x + 3, y + 3}, {x, y + 3}}});
          }
      }
      EXPECT_EQ(corners, expected);
    }
}

/// By hand: vertices look at the neighbours that their faces have, faces at their corners, so only
/// control vertices are not regular; at the boundary, the ends of edges look round the corner.
TEST(Sqrt3Reach, IsThatOfTheRules) {
  const fast::BoundarySides closed{true, false, false, false}, open{true, true, true, false};
  for (const fast::Sqrt3Step step : {fast::Sqrt3Step::centroids, fast::Sqrt3Step::thirds}) {
    const bool thirds = step == fast::Sqrt3Step::thirds;
    const auto inner = fast::find_sqrt3_reach(shipped("sqrt3"), step, closed).value();
    EXPECT_EQ(inner.star_zone, 0);
    EXPECT_EQ(inner.star_rings, thirds ? 2 : 3);
    EXPECT_EQ(inner.strip_depth, -1);
    EXPECT_EQ(inner.smallest_side, 3);
    const auto outer = fast::find_sqrt3_reach(shipped("sqrt3"), step, open).value();
    EXPECT_EQ(outer.strip_depth, thirds ? 1 : 0);
    EXPECT_EQ(outer.fan_zone, thirds ? 1 : 0);
    EXPECT_EQ(outer.corner_zone, thirds ? 1 : 0);
    EXPECT_EQ(outer.smallest_side, 3);
  }
}

TEST(Sqrt3Engine, IsThePlainEngineOnRegularBodies) {
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 3, 4)})
    for (int levels = 0; levels <= 5; ++levels) {
      SCOPED_TRACE(levels);
      EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh, levels, 5), 0);
    }
}

TEST(Sqrt3Engine, IsThePlainEngineOnRandomMeshes) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_sqrt3(shipped("sqrt3"), RandomMesh(seed).triangles(),
                      static_cast<int>(1 + seed % 5), seed);
  }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST(Sqrt3Engine, IsThePlainEngineRoundEveryValence) {
  for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30})
    for (const Index rings : {1, 2})
      for (const int levels : {1, 2, 3, 4}) {
        SCOPED_TRACE(n);
        EXPECT_EQ(
            expect_same_sqrt3(shipped("sqrt3"), star(Lattice::triangle, n, rings), levels, 3), 0);
        EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, n, rings), levels, 4),
                  0);
      }
  for (const Index faces : {1, 2, 3, 4})
    for (const Index rings : {1, 2})
      for (int levels = 0; levels <= 5; ++levels)
        expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, faces, rings), levels, 6);
}

/// A triangle alone sees itself on all sides, until it has been cut.
TEST(Sqrt3Engine, LeavesStepsToThePlainEngineOnlyForLoneTriangles) {
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 1, 1), 5, 1), 2);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 1, 2), 5, 1), 0);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 2, 1), 5, 1), 0);
}

}  // namespace
}  // namespace limn::test
