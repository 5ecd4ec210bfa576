#pragma once
/// The quick engine beside the plain one: the vertices of both refined meshes are matched by
/// walking both in step, from a half-edge for each control face on.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/fast/fast_refiner.h"
#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"

namespace limn::test {

/// Rules of a test on a split.
inline Scheme rules_on(const std::string& split, const std::string& rules) {
  const Result<Scheme> scheme =
      parse_scheme("split = \"" + split + "\"\nsource = \"a test\"\n" + rules, "test.toml");
  EXPECT_TRUE(scheme.ok()) << (scheme ? "" : scheme.error().text());
  return *scheme;
}

/// A ring of so many quads, so many rows wide.
inline Mesh band(Index around, Index rows) {
  Faces faces;
  for (Index y = 0; y < rows; ++y)
    for (Index x = 0; x < around; ++x) {
      const Index next = (x + 1) % around, low = y * around, high = low + around;
      faces.push_back({low + x, low + next, high + next, high + x});
    }
  return must_build((rows + 1) * around, faces);
}

inline std::vector<Point3> random_points(Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> one(-1, 1);
  std::vector<Point3> points(static_cast<std::size_t>(count));
  for (Point3& p : points) p = {one(random), one(random), one(random)};
  return points;
}

/// Half-edges of two meshes that are at the same place.
using Starts = std::vector<std::pair<Index, Index>>;

/// partner[v] is the vertex of `mesh` at the place of v of `other`, each part of which has a start.
/// Fails the test where the meshes differ.
inline std::vector<Index> match(const Mesh& other, const Mesh& mesh, const Starts& starts) {
  std::vector<Index> partner(static_cast<std::size_t>(other.vertex_count()), kNone);
  if (other.vertex_count() != mesh.vertex_count() || other.face_count() != mesh.face_count()) {
    ADD_FAILURE() << "sizes differ";
    return partner;
  }
  std::vector<Index> image(static_cast<std::size_t>(other.halfedge_count()), kNone);
  std::vector<Index> queue;
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
  for (const auto& [h, k] : starts) meet(h, k);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index h = queue[i], k = image[h];
    Index& at = partner[other.origin(h)];
    same = same && (at == kNone || at == mesh.origin(k));
    at = mesh.origin(k);
    meet(other.next(h), mesh.next(k));
    meet(other.twin(h), mesh.twin(k));
  }
  EXPECT_TRUE(same) << "connectivity differs";
  EXPECT_EQ(std::ssize(queue), other.halfedge_count());
  for (Index v = 0; v < other.vertex_count(); ++v)
    if (other.is_isolated(v)) partner[v] = v;  // they are control vertices, or the last of both
  return partner;
}

inline double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Numbers as points.
template <class Real>
std::vector<Point3> as_points(const std::vector<Real>& numbers) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    points.push_back({double(numbers[i]), double(numbers[i + 1]), double(numbers[i + 2])});
  return points;
}

template <class Real>
std::vector<Real> as_numbers(const std::vector<Point3>& points) {
  std::vector<Real> numbers;
  for (const Point3& p : points)
    for (const double c : {p.x, p.y, p.z}) numbers.push_back(static_cast<Real>(c));
  return numbers;
}

template <class Real>
std::vector<Real> evaluate(const FastRefiner& refiner, const std::vector<Point3>& control) {
  std::vector<Real> fine(3 * static_cast<std::size_t>(refiner.vertex_count()), Real(7e7));
  const std::vector<Real> numbers = as_numbers<Real>(control);
  refiner.evaluate<Real>(numbers, fine);
  return fine;
}

/// Where both engines keep the faces of each control face together, begun at its first corner; or
/// those of each of its corners, where the first step takes other polygons than the later ones.
inline Starts start_each_face(const Mesh& control, int /*levels*/, const Mesh& quick) {
  const Index patches = control.uniform_degree() == quick.uniform_degree()
                            ? control.face_count()
                            : control.halfedge_count();
  Starts starts;
  for (Index p = 0; p < patches; ++p) {
    const Index h = quick.face_begin(p * (quick.face_count() / patches));
    starts.emplace_back(h, h);
  }
  return starts;
}

/// What is sharp of two meshes; `partner` takes the first one's vertices to the other's.
inline void expect_same_tags(const SharpnessTags& a, const SharpnessTags& b,
                             const std::vector<Index>& partner) {
  using Crease = std::pair<std::set<Index>, double>;
  const auto vertices = [&](const SharpnessTags::Crease& crease, bool take) {
    std::set<Index> ends;
    for (const Index v : crease.vertices) ends.insert(take ? partner[v] : v);
    return ends;
  };
  std::vector<Crease> creases, others;
  for (const auto& crease : a.creases)
    creases.emplace_back(vertices(crease, true), crease.sharpness.at(0));
  for (const auto& crease : b.creases)
    others.emplace_back(vertices(crease, false), crease.sharpness.at(0));
  std::sort(creases.begin(), creases.end());
  std::sort(others.begin(), others.end());
  ASSERT_EQ(creases.size(), others.size());
  for (std::size_t i = 0; i < creases.size(); ++i) {
    EXPECT_EQ(creases[i].first, others[i].first);
    EXPECT_NEAR(creases[i].second, others[i].second, 1e-12);
  }
  std::map<Index, double> corners, other_corners;
  for (const auto& corner : a.corners) corners[partner[corner.vertex]] = corner.sharpness;
  for (const auto& corner : b.corners) other_corners[corner.vertex] = corner.sharpness;
  EXPECT_EQ(corners, other_corners);
  if (!creases.empty()) EXPECT_EQ(a.method, b.method);
}

/// Starts for the plain engine's mesh and the quick one's.
using StartMaker = std::function<Starts(const Mesh& control, int levels, const Mesh& quick)>;

/// Both engines on random positions: the same mesh, the same points to rounding; or the same error.
/// Returns how many steps the quick engine left to the plain one, or -1.
inline int expect_same(const Scheme& scheme, const Mesh& control, int levels, unsigned seed,
                       const StartMaker& start = start_each_face, const Sharpness& sharpness = {}) {
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const auto plain = refine::refine(scheme, control, points, levels, {}, sharpness);
  const auto quick = FastRefiner::make(scheme, control, levels, sharpness);
  EXPECT_EQ(plain.ok(), quick.ok());
  if (!plain || !quick) {
    if (!plain && !quick) EXPECT_EQ(plain.error().text(), quick.error().text());
    return -1;
  }
  // a vertex of two faces keeps two edges between its neighbours, which polygons cannot tell apart
  if (!is_simple(plain->mesh)) return quick->plain_steps();
  EXPECT_EQ(quick->corner_count(), plain->mesh.halfedge_count());
  Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(quick->vertex_count()));
  polygons.corners.resize(static_cast<std::size_t>(quick->corner_count()));
  quick->write_faces(polygons.corners);
  polygons.face_begin.resize(static_cast<std::size_t>(quick->face_count()) + 1);
  quick->write_face_begin(polygons.face_begin);
  const Result<Mesh> mesh = Mesh::build(polygons);
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : mesh.error().text());
  if (!mesh) return -1;
  const std::vector<Index> partner = match(plain->mesh, *mesh, start(control, levels, *mesh));
  const std::vector<Point3> doubles = as_points(evaluate<double>(*quick, points));
  const std::vector<Point3> floats = as_points(evaluate<float>(*quick, points));
  const bool keeps_vertices = !scheme.split->is_dual();
  double worst = 0, worst_float = 0;
  for (Index v = 0; v < plain->mesh.vertex_count(); ++v) {
    if (partner[v] == kNone) return -1;
    worst = std::max(worst, distance(plain->values[v], doubles[partner[v]]));
    worst_float = std::max(worst_float, distance(plain->values[v], floats[partner[v]]));
    if (keeps_vertices && v < control.vertex_count()) EXPECT_EQ(partner[v], v);
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_float, 1e-5);
  expect_same_tags(tags_of(plain->mesh, plain->sharpness), quick->sharp_tags(), partner);
  return quick->plain_steps();
}

/// All that a refiner makes, by one thread and by more.
inline void expect_same_bits(const Scheme& scheme, const Mesh& control, int levels) {
  const std::vector<Point3> points = random_points(control.vertex_count(), 1);
  const auto make = [&](int threads) {
    set_thread_limit(threads);
    const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
    std::vector<Index> corners(static_cast<std::size_t>(refiner.corner_count()));
    refiner.write_faces(corners);
    std::vector<Index> begin(static_cast<std::size_t>(refiner.face_count()) + 1);
    refiner.write_face_begin(begin);
    return std::tuple(evaluate<float>(refiner, points), std::move(corners), std::move(begin));
  };
  const auto one = make(1);
  for (const int threads : {2, 0}) EXPECT_EQ(make(threads), one);
  set_thread_limit(0);
}

/// A mesh without faces stays as it is.
inline void expect_to_stay(const Scheme& scheme, Index vertices) {
  const auto refiner = FastRefiner::make(scheme, must_build(vertices, {}), 3);
  ASSERT_TRUE(refiner.ok());
  EXPECT_EQ(refiner->vertex_count(), vertices);
  EXPECT_EQ(refiner->face_count(), 0);
  const std::vector<Point3> points = random_points(vertices, 1);
  EXPECT_EQ(as_points(evaluate<double>(*refiner, points)), points);
}

}  // namespace limn::test
