// The quick engine against the plain one: one suite over all families, each with every shipped
// scheme of its split and with rules that look farther than these.

#include <array>
#include <cmath>
#include <limits>

#include "fast/families.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// A shipped scheme, or rules of a test on a split.
struct Case {
  std::string name;
  const char* split = nullptr;
  std::string rules;

  [[nodiscard]] Scheme scheme() const {
    return split == nullptr ? shipped(name) : rules_on(split, rules);
  }
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<Case> cases() {
  std::vector<Case> cases;
  for (const std::string& name : shipped_schemes())
    if (has_fast_layout(shipped(name))) cases.push_back({name, nullptr, {}});
  const std::string boundary = kQuadBoundary;
  cases.push_back({"wide-triangles", "triangle-dyadic", kWideTriangles});
  cases.push_back({"wide-quads", "quad-dyadic", kWideQuads + boundary});
  cases.push_back({"four-point", "quad-dyadic", kFourPoint + boundary});
  cases.push_back({"faces", "quad-dyadic", kFaces + boundary});
  cases.push_back({"wide-sqrt3", "sqrt3", kWideSqrt3});
  cases.push_back({"wide-sqrt2", "quad-sqrt2", kWideSqrt2});
  cases.push_back({"wide-ternary", "triangle-ternary", kWideTernary});
  cases.push_back({"ternary-quads", "quad-ternary", kTernaryQuads});
  cases.push_back({"near-dual", "quad-dual", kNear});
  cases.push_back({"wide-dual", "quad-dual", kWideDual});
  cases.push_back({"farther-dual", "quad-dual", kFarther});
  return cases;
}

class FastFamily : public testing::TestWithParam<Case> {
 protected:
  const Scheme scheme_ = GetParam().scheme();

  int check(const Mesh& mesh, int levels, unsigned seed) const {
    SCOPED_TRACE(testing::Message() << levels << " levels, seed " << seed);
    return expect_same(scheme_, mesh, levels, seed, start_of(*scheme_.split));
  }
  [[nodiscard]] Lattice lattice() const { return scheme_.split->lattice; }
  [[nodiscard]] bool any_polygons() const { return scheme_.split->any_polygons; }
  [[nodiscard]] bool only_quads() const { return !any_polygons() && lattice() == Lattice::quad; }
  /// Ternary steps give nine faces for each.
  [[nodiscard]] int at_most(int levels) const {
    return std::min(levels, scheme_.split->dilation.growth() > 4 ? 2 : levels);
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, FastFamily, testing::ValuesIn(cases()),
                         [](const auto& info) { return test_name(info.param.name); });

TEST_P(FastFamily, IsThePlainEngineOnBodies) {
  std::vector<Mesh> meshes{tetrahedron(), icosahedron(), mesh::torus(Lattice::triangle, 3, 4)};
  if (any_polygons()) meshes = bodies();
  if (only_quads()) meshes = {cube(), mesh::torus(Lattice::quad, 3, 4), band(3, 1), band(4, 2)};
  for (const Mesh& mesh : meshes)
    for (int levels = 0; levels <= at_most(4); ++levels) check(mesh, levels, 5);
}

TEST_P(FastFamily, IsThePlainEngineOnRandomMeshes) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    check(random_control(*scheme_.split, seed), at_most(static_cast<int>(1 + seed % 4)), seed);
    if (any_polygons()) check(random_quads(seed), static_cast<int>(seed % 5), seed);
  }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST_P(FastFamily, IsThePlainEngineRoundEveryValence) {
  for (const Index n : {3, 4, 5, 6, 7, 8, 9, 12, 30})
    for (const Index rings : {1, 2}) {
      check(mesh::star(lattice(), n, rings), at_most(3), 3);
      check(mesh::fan(lattice(), n, rings), at_most(3), 4);
      if (any_polygons()) check(mesh::face_star(n, rings), 3, 5);
    }
  for (const Index faces : {1, 2, 3}) check(mesh::fan(lattice(), faces, 1), at_most(4), 6);
}

TEST_P(FastFamily, IsThePlainEngineOnOpenMeshes) {
  if (!any_polygons()) GTEST_SKIP() << "only for splits that take polygons";
  for (const Mesh& mesh : open_meshes())
    for (int levels = 0; levels <= 3; ++levels) check(mesh, levels, 6);
}

/// Whatever the weights: each mutant moves some of them, or gives a rule a role that it had not.
TEST_P(FastFamily, MayHaveAnyWeights) {
  if (GetParam().name == "faces") GTEST_SKIP() << "k counts from any of a vertex's edges";
  std::mt19937 random(7);
  std::vector<RuleMutant> mutants = rule_mutants(scheme_);
  std::shuffle(mutants.begin(), mutants.end(), random);
  mutants.resize(std::min<std::size_t>(mutants.size(), 12));
  for (const RuleMutant& mutant : mutants) {
    SCOPED_TRACE(mutant.change);
    const auto same = [&](const Mesh& mesh, int levels) {
      expect_same(mutant.scheme, mesh, levels, 1, start_of(*scheme_.split));
    };
    same(random_control(*scheme_.split, static_cast<unsigned>(random())), at_most(3));
    same(mesh::fan(lattice(), 7, 2), 2);
    same(mesh::fan(lattice(), 1, 2), at_most(3));
  }
}

/// Zones that overlap, too, are made in one order.
TEST_P(FastFamily, GivesTheSameBitsOnOneThreadAndMany) {
  for (const Mesh& mesh : {mesh::torus(lattice(), 30, 31), mesh::fan(lattice(), 9, 12)})
    if (FastRefiner::make(scheme_, mesh, 3).ok()) expect_same_bits(scheme_, mesh, 3);
}

/// Multiplied by a power of two, control points of such a size have the same refined points and
/// limits, so multiplied, though sums of a few of them are infinite.
template <class Real>
void expect_to_reach_the_end_of_the_range(const Scheme& scheme, const Mesh& mesh) {
  const Result<FastRefiner> refiner = FastRefiner::make(scheme, mesh, 2);
  if (!refiner) return;
  const Real factor = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent - 2);
  std::vector<Real> small, large;
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 3);
  for (const double number : numbers_of(points)) {
    small.push_back(static_cast<Real>(number));
    large.push_back(small.back() * factor);
  }
  const std::size_t numbers = 3 * static_cast<std::size_t>(refiner->vertex_count());
  const auto made = [&](const std::vector<Real>& control) {
    std::vector<Real> fine(numbers), limits(numbers), normals(numbers);
    refiner->template evaluate<Real>(control, fine);
    if (const auto limit = approx_fast_limit(scheme, *refiner); limit && *limit) {
      FastRefiner::Scratch<Real> scratch;
      refiner->template evaluate_limit<Real>(**limit, control, limits, normals, scratch);
    }
    return std::array{fine, limits, normals};
  };
  auto [fine, limits, normals] = made(small);
  for (std::vector<Real>* points : {&fine, &limits})
    for (Real& x : *points) x *= factor;
  const auto [far_fine, far_limits, far_normals] = made(large);
  EXPECT_EQ(far_fine, fine);
  EXPECT_EQ(far_limits, limits);
  for (std::size_t i = 0; i < numbers; ++i) EXPECT_NEAR(far_normals[i], normals[i], 1e-3);
}

TEST_P(FastFamily, ReachesTheEndOfTheRange) {
  for (const Mesh& mesh : {mesh::torus(lattice(), 4, 5), mesh::fan(lattice(), 7, 2)}) {
    expect_to_reach_the_end_of_the_range<float>(scheme_, mesh);
    expect_to_reach_the_end_of_the_range<double>(scheme_, mesh);
  }
}

TEST_P(FastFamily, RefusesWhatThePlainEngineRefuses) {
  check(cube(), -1, 1);
  check(icosahedron(), 40, 1);
  if (!any_polygons()) check(cube(), 2, 1);
}

TEST_P(FastFamily, TakesMeshesWithoutFaces) {
  for (const Index vertices : {0, 3}) expect_to_stay(scheme_, vertices);
}

/// Beyond what has a table, the plain engine makes all steps.
TEST_P(FastFamily, LeavesLargeValencesToThePlainEngine) {
  const Mesh mesh = mesh::star(Lattice::triangle, 1001, 1);
  if (!FastRefiner::make(scheme_, mesh, 1).ok()) GTEST_SKIP() << "no rule for such a mesh";
  EXPECT_EQ(check(mesh, 1, 1), 1);
}

}  // namespace
}  // namespace limn::test
