// Laws of refinement with sharpness, for every shipped scheme that can take it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "limn/refine/linear_form.h"
#include "limn/refine/refine.h"
#include "refine/crease_meshes.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// What tells a face from others, whatever its number and where it begins: the sums of its corners'
/// coordinates, and of their squares.
using Shape = std::array<double, 6>;

void add_shapes(const Polygons& mesh, std::vector<Shape>& shapes) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Shape shape{};
    for (Index c = mesh.face_begin[at(f)]; c < mesh.face_begin[at(f) + 1]; ++c) {
      const Point3 p = mesh.positions[at(mesh.corners[at(c)])];
      const Shape of_corner{p.x, p.y, p.z, p.x * p.x, p.y * p.y, p.z * p.z};
      for (std::size_t i = 0; i < shape.size(); ++i) shape[i] += of_corner[i];
    }
    shapes.push_back(shape);
  }
}

double difference(std::vector<Shape> a, std::vector<Shape> b) {
  if (a.size() != b.size()) return HUGE_VAL;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double most = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t i = 0; i < a[f].size(); ++i)
      most = std::max(most, std::abs(a[f][i] - b[f][i]));
  return most;
}

class Creases : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Scheme& scheme() const { return shipped(GetParam()); }
};

TEST_P(Creases, AreBoundariesOfTheMeshCutThere) {
  std::mt19937 random(5);
  int compared = 0;
  for (unsigned seed = 1; compared < 6; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<bool> inside = region(mesh, random);
    if (inside.empty()) continue;
    const Polygons whole = mesh.polygons(random_points(mesh.vertex_count(), seed));
    const Result<Mesh> parts[] = {Mesh::build(part_of(whole, inside, false)),
                                  Mesh::build(part_of(whole, inside, true))};
    if (!parts[0] || !parts[1]) continue;
    const int levels = scheme().split->boundary_rests() ? 4 : 2;
    std::vector<Shape> cut, joined;
    bool refined = true;  // some schemes have no rule for some boundaries
    for (const bool which : {false, true}) {
      const auto part = refine::refine(scheme(), parts[which ? 1 : 0].value(),
                                       part_of(whole, inside, which).positions, levels);
      refined = refined && part.ok();
      if (part) add_shapes(part->mesh.polygons(part->values), cut);
    }
    if (!refined) continue;
    const auto ours =
        refine::refine(scheme(), mesh, whole.positions, levels, {}, rim_of(mesh, inside));
    ASSERT_TRUE(ours.ok()) << ours.error().text();
    EXPECT_EQ(ours->mesh.check(), "");
    add_shapes(ours->mesh.polygons(ours->values), joined);
    EXPECT_LT(difference(cut, joined), 1e-13) << "seed " << seed;
    ++compared;
  }
}

TEST_P(Creases, OfIntegerSharpnessAreThatManyInfiniteStepsAndThenSmoothOnes) {
  if (scheme().split->boundary_rests()) GTEST_SKIP() << "takes infinite sharpness only";
  int compared = 0;
  for (unsigned seed = 1; seed < 9; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const Sharpness sharpness = random_sharpness(mesh, seed, 0.4, true);
    const auto faded = refine::refine(scheme(), mesh, points, 3, {}, made_equal(sharpness, 2));
    const auto sharp = refine::refine(scheme(), mesh, points, 2, {}, made_equal(sharpness, 10));
    if (!sharp) continue;  // no rule for some boundary
    ++compared;
    ASSERT_TRUE(faded.ok()) << faded.error().text();
    const auto smooth = refine::refine(scheme(), sharp->mesh, sharp->values, 1).value();
    EXPECT_FALSE(faded->sharpness.any());
    ASSERT_EQ(faded->values.size(), smooth.values.size());
    for (std::size_t v = 0; v < smooth.values.size(); ++v)
      ASSERT_LT(distance(faded->values[v], smooth.values[v]), 1e-13) << "seed " << seed;
  }
  EXPECT_GT(compared, 0);
}

/// Whether rules weigh new vertices of faces that are others where a corner is smooth: what is a
/// mean of two such rules is then no mean of their values.
bool weighs_faces_seen_from_corners(const Scheme& scheme) {
  if (!scheme.rule(RuleKind::face_end)) return false;
  for (const std::optional<Rule>& rule : scheme.rules)
    if (rule)
      for (const RuleCase& one : *rule)
        for (const Weight& weight : one.weights)
          if (weight.walk.reads_face) return true;
  return false;
}

TEST_P(Creases, OfOneFractionAreThatPartOfACreaseAndTheRestSmooth) {
  if (weighs_faces_seen_from_corners(scheme())) GTEST_SKIP();
  if (scheme().split->boundary_rests()) GTEST_SKIP() << "takes infinite sharpness only";
  int compared = 0;
  for (unsigned seed = 1; seed < 9; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const Sharpness sharpness = random_sharpness(mesh, seed, 0.4, true);
    const auto sharp = refine::refine(scheme(), mesh, points, 1, {}, made_equal(sharpness, 10));
    const auto smooth = refine::refine(scheme(), mesh, points, 1);
    if (!sharp || !smooth) continue;  // no rule for some boundary
    const auto both =
        refine::refine(scheme(), mesh, points, 1, {}, made_equal(sharpness, 0.3)).value();
    EXPECT_FALSE(both.sharpness.any());
    for (std::size_t v = 0; v < both.values.size(); ++v)
      ASSERT_LT(distance(both.values[v], 0.3 * sharp->values[v] + 0.7 * smooth->values[v]), 1e-13)
          << "seed " << seed << ", vertex " << v;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST_P(Creases, WeighTheSameForEveryKindOfValue) {
  int compared = 0;
  for (unsigned seed = 1; seed < 5; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    Sharpness sharpness = random_sharpness(mesh, seed, 0.4, false);
    if (seed % 2 == 0) sharpness.method = CreaseMethod::chaikin;
    if (scheme().split->boundary_rests()) sharpness = made_equal(sharpness, kInfinitelySharp);
    std::vector<refine::LinearForm<double>> forms;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      forms.push_back(refine::LinearForm<double>::unit(v));
    const auto fine = refine::refine(scheme(), mesh, points, 2, {}, sharpness);
    if (!fine) continue;  // no rule for some boundary
    ++compared;
    const auto weights = refine::refine(scheme(), mesh, forms, 2, {}, sharpness).value();
    ASSERT_EQ(fine->values.size(), weights.values.size());
    for (std::size_t v = 0; v < fine->values.size(); ++v) {
      Point3 sum;
      double all = 0;
      for (const auto& [index, weight] : weights.values[v].terms) {
        sum = sum + weight * points[at(index)];
        all += weight;
      }
      EXPECT_NEAR(all, 1, 1e-13);
      EXPECT_LT(distance(sum, fine->values[v]), 1e-12);
    }
  }
  EXPECT_GT(compared, 0);
}

TEST_P(Creases, CornersRest) {
  unsigned seed = 3;
  const Mesh mesh = control_mesh(scheme(), seed);
  const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
  Sharpness sharpness;
  sharpness.vertices.assign(at(mesh.vertex_count()), kInfinitelySharp);
  const auto fine = refine::refine(scheme(), mesh, points, 2, {}, sharpness);
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_EQ(fine->values[v], points[v]);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Creases, ::testing::ValuesIn(schemes_that_take_creases()),
                         [](const auto& one) { return test_name(one.param); });

// --- what is refused --------------------------------------------------------------------------

std::string refusal(const std::string& scheme, const Sharpness& sharpness) {
  const Status status = refine::check_takes_sharpness(shipped(scheme), sharpness);
  return status ? "" : status.error().message;
}

TEST(Sharpness, IsRefusedByDualSplits) {
  EXPECT_EQ(
      refusal("doo-sabin", one_infinite_vertex()),
      "doo-sabin takes no sharp edges or vertices: its split, quad-dual, has no boundary that "
      "stays in place");
  EXPECT_EQ(refusal("doo-sabin", {}), "");
}

TEST(Sharpness, IsRefusedWithoutBoundaryRules) {
  EXPECT_EQ(refusal("box-spline-quad", one_infinite_vertex()),
            "box-spline-quad takes no sharp edges or vertices: it has no boundary.vertex rule");
}

TEST(Sharpness, MustBeInfiniteWhereTheBoundaryRests) {
  for (const std::string name : {"sqrt3", "four-eight"}) {
    EXPECT_NE(refusal(name, {{}, {9.5}, {}, {}}).find("infinite sharpness only"),
              std::string::npos);
    EXPECT_NE(refusal(name, {{}, {}, {true}, {}}).find("takes no holes"), std::string::npos);
    EXPECT_EQ(refusal(name, one_infinite_vertex()), "");
  }
}

TEST(Sharpness, MoreThanAHandfulOfSchemesTakeIt) {
  const std::vector<std::string> names = schemes_that_take_creases();
  for (const std::string name : {"loop", "catmull-clark", "butterfly", "butterfly-modified",
                                 "sqrt3", "four-eight", "laplacian-loop"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

}  // namespace
}  // namespace limn::test
