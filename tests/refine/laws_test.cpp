// Laws of refinement, for every shipped scheme on random closed and open meshes.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <complex>

#include "limn/base/parallel.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/random_points.h"
#include "support/reference_step.h"
#include "support/shipped.h"
#include "support/valences.h"

namespace limn::test {
namespace {

bool is_mask_only(const Scheme& scheme) { return scheme.name.starts_with("box-spline"); }

Mesh control_mesh(const Scheme& scheme, unsigned seed) {
  if (is_mask_only(scheme))
    return mesh::torus(scheme.split->lattice, 3 + static_cast<Index>(seed % 5),
                       3 + static_cast<Index>(seed / 5 % 5));
  for (;; ++seed) {
    Mesh mesh = random_control(*scheme.split, seed);
    if (!has_inner_vertex_of_valence_two(mesh)) return mesh;
  }
}

/// Steps of one scheme, its tables made once.
class Refiner {
 public:
  explicit Refiner(const Scheme& scheme) : scheme_(scheme), tables_(scheme) {}

  template <class Value>
  refine::Refined<Value> step(const Mesh& mesh, const std::vector<Value>& values, int step) {
    SplitResult split = scheme_.split->apply(mesh, step);
    const Status status = tables_.prepare(mesh, split.births);
    if (!status) throw std::runtime_error(status.error().text());
    std::vector<Value> fresh = refine::refine_values(scheme_, mesh, split.births, tables_, values);
    return {std::move(split.mesh), std::move(fresh)};
  }

  /// Two steps: sqrt3 refines the boundary in the second.
  template <class Value>
  std::vector<Value> twice(const Mesh& mesh, const std::vector<Value>& values) {
    const refine::Refined<Value> once = step(mesh, values, 0);
    return step(once.mesh, once.values, 1).values;
  }

 private:
  const Scheme& scheme_;
  refine::RuleTables<double> tables_;
};

class Laws : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Scheme& scheme() const { return shipped(GetParam()); }
};

// --- affine maps ----------------------------------------------------------------------------

Point3 affine(Point3 p) {
  return {2 * p.x - 3 * p.y + p.z + 5, p.y - 4 * p.z - 7, p.x + p.y + p.z + 2};
}

TEST_P(Laws, AffineMapsCommute) {
  Refiner refiner(scheme());
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    std::vector<Point3> mapped(points.size());
    std::transform(points.begin(), points.end(), mapped.begin(), affine);
    const std::vector<Point3> fine = refiner.twice(mesh, points);
    const std::vector<Point3> fine_mapped = refiner.twice(mesh, mapped);
    for (std::size_t i = 0; i < fine.size(); ++i)
      RC_ASSERT(distance(affine(fine[i]), fine_mapped[i]) < 1e-12);
    for (const double one : refiner.twice(mesh, std::vector<double>(points.size(), 1)))
      RC_ASSERT(std::abs(one - 1) < 1e-14);
  }));
}

// --- symmetry -------------------------------------------------------------------------------

/// Points in an order that depends on their places alone. (Equal points stay neighbours.)
std::vector<Point3> in_order(std::vector<Point3> points) {
  std::sort(points.begin(), points.end(),
            [](Point3 a, Point3 b) { return a.x + a.y + a.z < b.x + b.y + b.z; });
  return points;
}

bool same_set(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  const std::vector<Point3> left = in_order(a), right = in_order(b);
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (!(distance(left[i], right[i]) < 1e-12)) return false;
  return true;
}

/// The same mesh with other numbers, other first corners and another order of faces.
refine::Refined<Point3> renumbered(const Mesh& mesh, const std::vector<Point3>& points,
                                   unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> name(points.size());
  std::iota(name.begin(), name.end(), 0);
  std::shuffle(name.begin(), name.end(), random);
  Faces faces = faces_of(polygons_of(mesh));
  std::shuffle(faces.begin(), faces.end(), random);
  for (auto& face : faces) {
    for (Index& v : face) v = name[static_cast<std::size_t>(v)];
    const auto turn = static_cast<std::ptrdiff_t>(random() % face.size());
    std::rotate(face.begin(), face.begin() + turn, face.end());
  }
  std::vector<Point3> moved(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    moved[static_cast<std::size_t>(name[v])] = points[v];
  return {must_build(mesh.vertex_count(), faces), std::move(moved)};
}

Mesh mirrored(const Mesh& mesh) {
  Faces faces = faces_of(polygons_of(mesh));
  for (auto& face : faces) std::reverse(face.begin(), face.end());
  return must_build(mesh.vertex_count(), faces);
}

TEST_P(Laws, NumbersFirstCornersAndOrientationDoNotMatter) {
  Refiner refiner(scheme());
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const std::vector<Point3> fine = refiner.twice(mesh, points);
    const refine::Refined<Point3> other = renumbered(mesh, points, seed);
    RC_ASSERT(same_set(fine, refiner.twice(other.mesh, other.values)));
    RC_ASSERT(same_set(fine, refiner.twice(mirrored(mesh), points)));
  }));
}

// --- values of other kinds ------------------------------------------------------------------

TEST_P(Laws, PositionsComplexNumbersAndLinearFormsRefineAlike) {
  Refiner refiner(scheme());
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    std::vector<std::complex<double>> numbers;
    numbers.reserve(points.size());
    for (const Point3& p : points) numbers.emplace_back(p.x, p.y);
    for (const int step : {0, 1}) {
      const auto fine = refiner.step(mesh, points, step).values;
      const auto waves = refiner.step(mesh, numbers, step).values;
      const auto forms =
          refiner.step(mesh, refine::unit_forms<double>(mesh.vertex_count()), step).values;
      RC_ASSERT(forms.size() == fine.size());
      for (std::size_t i = 0; i < fine.size(); ++i) {
        Point3 sum;
        for (const auto& [vertex, weight] : forms[i].terms)
          sum = sum + weight * points[static_cast<std::size_t>(vertex)];
        RC_ASSERT(distance(sum, fine[i]) < 1e-13);
        RC_ASSERT(std::abs(waves[i] - std::complex<double>(fine[i].x, fine[i].y)) < 1e-13);
      }
    }
  }));
}

TEST_P(Laws, RandomMeshesRefineAsTheLiteratureSays) {
  Refiner refiner(scheme());
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    std::vector<double> values;
    for (const Point3& p : random_points(mesh.vertex_count(), seed)) values.push_back(p.x);
    for (const int step : {0, 1}) {
      const Births births = scheme().split->apply(mesh, step).births;
      const auto expected = reference_step(scheme().name, std::nullopt, mesh, births, values);
      const auto fine = refiner.step(mesh, values, step).values;
      RC_ASSERT(fine.size() == expected.size());
      for (std::size_t i = 0; i < fine.size(); ++i)
        RC_ASSERT(std::abs(fine[i] - expected[i]) < 1e-12);
    }
  }));
}

// --- locality -------------------------------------------------------------------------------

/// The old vertices that each new one is born from.
std::vector<std::vector<Index>> parents(const Mesh& mesh, const Births& births) {
  std::vector<std::vector<Index>> all;
  all.reserve(static_cast<std::size_t>(births.from_vertices + births.from_edges));
  for (Index v = 0; v < births.from_vertices; ++v) all.push_back({v});
  for (Index i = 0; i < births.from_edges; ++i) {
    const EdgeChild child = edge_child(mesh, births, i);
    const Index v = mesh.origin(child.halfedge), w = mesh.target(child.halfedge);
    all.push_back({v, w});
    if (child.third) all.back().push_back(child.at_target ? w : v);
  }
  for (Index i = 0; i < births.from_faces; ++i) {
    const Index f = births.faces.empty() ? i : births.faces[i];
    all.emplace_back();
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      all.back().push_back(mesh.origin(h));
  }
  for (Index h = 0; h < births.from_corners; ++h) all.push_back({mesh.origin(h)});
  for (const Index v : births.isolated) all.push_back({v});
  return all;
}

TEST_P(Laws, AVertexMovesOnlyWhatIsBornNextToIt) {
  Refiner refiner(scheme());
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const auto moved = static_cast<Index>(seed % static_cast<unsigned>(mesh.vertex_count()));
    std::vector<double> bump(static_cast<std::size_t>(mesh.vertex_count()), 0);
    bump[static_cast<std::size_t>(moved)] = 1;
    std::set<Index> near{moved};  // the vertices that share a face with it
    // what is seen from a face's corner may be weighed as the face's new vertex
    for (int times = scheme().rule(RuleKind::face_end) ? 2 : 1; times > 0; --times) {
      const std::set<Index> inner = near;
      for (const auto& face : faces_of(polygons_of(mesh)))
        if (std::any_of(face.begin(), face.end(), [&](Index v) { return inner.contains(v); }))
          near.insert(face.begin(), face.end());
    }
    for (const int step : {0, 1}) {
      const auto born = parents(mesh, scheme().split->apply(mesh, step).births);
      const auto fine = refiner.step(mesh, bump, step).values;
      RC_ASSERT(born.size() == fine.size());
      for (std::size_t i = 0; i < fine.size(); ++i)
        RC_ASSERT(fine[i] == 0 || std::any_of(born[i].begin(), born[i].end(),
                                              [&](Index v) { return near.contains(v); }));
    }
  }));
}

// --- the regular lattice --------------------------------------------------------------------

/// Where a new vertex of the lattice lies: at the mean of its parents, of a third's the near one
/// twice; a corner's child half way from its vertex to the middle of its face.
std::vector<Point3> lattice_places(const Mesh& mesh, const Births& births,
                                   const std::vector<Point3>& at) {
  const auto mean = [&](const std::vector<Index>& vertices) {
    Point3 sum;
    for (const Index v : vertices) sum = sum + at[static_cast<std::size_t>(v)];
    return (1.0 / static_cast<double>(vertices.size())) * sum;
  };
  std::vector<Point3> places;
  for (const auto& vertices : parents(mesh, births)) places.push_back(mean(vertices));
  const std::size_t corners = places.size() - static_cast<std::size_t>(births.from_corners);
  const Faces faces = faces_of(polygons_of(mesh));
  for (Index h = 0; h < births.from_corners; ++h) {
    Point3& place = places[corners + static_cast<std::size_t>(h)];
    place = 0.5 * (place + mean(faces[static_cast<std::size_t>(mesh.face(h))]));
  }
  return places;
}

TEST_P(Laws, LinearFunctionsStayThemselvesOnTheLattice) {
  constexpr Index kSide = 12, kMargin = 4;
  const Mesh mesh = mesh::torus(scheme().split->lattice, kSide, kSide);
  std::vector<Point3> at;  // lifted to the plane: wrong only across the seam
  for (Index j = 0; j < kSide; ++j)
    for (Index i = 0; i < kSide; ++i) at.push_back({1.0 * i, 1.0 * j, 3.0 * i - 2.0 * j + 1});
  const SplitResult split = scheme().split->apply(mesh, 0);
  const std::vector<Point3> fine = Refiner(scheme()).step(mesh, at, 0).values;
  const auto born = parents(mesh, split.births);
  const std::vector<Point3> places = lattice_places(mesh, split.births, at);
  int compared = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const bool inner = std::all_of(born[i].begin(), born[i].end(), [&](Index v) {
      const Index x = v % kSide, y = v / kSide;
      return std::min(x, y) >= kMargin && std::max(x, y) < kSide - kMargin;
    });
    if (!inner) continue;
    ++compared;
    EXPECT_LT(distance(fine[i], places[i]), 1e-13);
  }
  EXPECT_GT(compared, 15);
}

// --- threads, and the driver ----------------------------------------------------------------

TEST_P(Laws, ThreadsDoNotChangeABit) {
  const Mesh mesh = is_mask_only(scheme()) ? mesh::torus(scheme().split->lattice, 40, 41)
                                           : mesh::star(scheme().split->lattice, 7, 20);
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 3);
  set_thread_limit(1);
  Refiner refiner(scheme());
  const std::vector<Point3> serial = refiner.twice(mesh, points);
  for (const int threads : {0, 2, 3}) {
    set_thread_limit(threads);
    EXPECT_EQ(refiner.twice(mesh, points), serial) << threads;
  }
  set_thread_limit(0);
}

TEST_P(Laws, RefineMakesTheStepsInTurn) {
  const Mesh mesh = control_mesh(scheme(), 5);
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 5);
  std::vector<int> steps;
  const auto fine = refine::refine<Point3>(scheme(), mesh, points, 2,
                                           [&](int done, int levels, const Mesh& made) {
                                             EXPECT_EQ(levels, 2);
                                             EXPECT_GT(made.vertex_count(), 0);
                                             steps.push_back(done);
                                           });
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  EXPECT_EQ(fine->values, Refiner(scheme()).twice(mesh, points));
  EXPECT_EQ(fine->mesh.vertex_count(), static_cast<Index>(fine->values.size()));
  EXPECT_EQ(steps, (std::vector<int>{1, 2}));
  const auto same = refine::refine<Point3>(scheme(), mesh, points, 0);
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same->values, points);
}

INSTANTIATE_TEST_SUITE_P(All, Laws, ::testing::ValuesIn(shipped_schemes()),
                         [](const auto& chosen) { return test_name(chosen.param); });

}  // namespace
}  // namespace limn::test
