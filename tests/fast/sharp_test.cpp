// The quick engine against the plain one on meshes with sharpness: every shipped scheme whose split
// cuts sharp edges in each step, and rules that look farther than these.

#include <algorithm>
#include <cmath>

#include "fast/families.h"
#include "limn/refine/crease_step.h"
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

Sharpness one_infinite_vertex() { return {{}, {kInfinitelySharp}, {}, {}}; }

std::vector<Case> cases() {
  std::vector<Case> cases;
  for (const std::string& name : shipped_schemes()) {
    const Scheme scheme = shipped(name);
    if (refine::check_takes_sharpness(scheme, one_infinite_vertex()).ok() &&
        scheme.split->odd_step_cut == 0)
      cases.push_back({name, nullptr, {}});
  }
  const std::string boundary = kQuadBoundary;
  cases.push_back({"wide-triangles", "triangle-dyadic", kWideTriangles});
  cases.push_back({"wide-quads", "quad-dyadic", kWideQuads + boundary});
  cases.push_back({"four-point", "quad-dyadic", kFourPoint + boundary});
  cases.push_back({"faces", "quad-dyadic", kFaces + boundary});
  return cases;
}

/// How sharp something is.
using Value = std::function<double(std::mt19937& random)>;

double unit(std::mt19937& random) { return std::uniform_real_distribution<double>(0, 1)(random); }
double infinite(std::mt19937& /*random*/) { return kInfinitelySharp; }
double whole(std::mt19937& random) { return 1 + std::floor(3 * unit(random)); }
double fraction(std::mt19937& random) { return 3 * unit(random); }
/// Whatever ends in a step ends with the same sharpness.
double even(std::mt19937& random) { return std::floor(3 * unit(random)) + 0.4; }
double any(std::mt19937& random) { return unit(random) < 0.3 ? infinite(random) : even(random); }

Sharpness random_sharpness(const Mesh& mesh, unsigned seed, double edges, double vertices,
                           const Value& value) {
  std::mt19937 random(seed);
  Sharpness sharpness;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    sharpness.edges.push_back(unit(random) < edges ? value(random) : 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    sharpness.vertices.push_back(unit(random) < vertices ? value(random) : 0);
  return sharpness;
}

class FastSharp : public testing::TestWithParam<Case> {
 protected:
  const Scheme scheme_ = GetParam().scheme();

  int check(const Mesh& mesh, const Sharpness& sharpness, int levels, unsigned seed) const {
    SCOPED_TRACE(testing::Message() << levels << " levels, seed " << seed);
    return expect_same(scheme_, mesh, levels, seed, start_of(*scheme_.split), sharpness);
  }
  /// Meshes with and without boundary, some of them of other faces than the lattice's.
  [[nodiscard]] Mesh mesh(unsigned seed) const {
    if (!scheme_.split->any_polygons) return random_control(*scheme_.split, seed);
    return seed % 2 == 0 ? random_quads(seed) : random_control(*scheme_.split, seed);
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, FastSharp, testing::ValuesIn(cases()),
                         [](const auto& info) { return test_name(info.param.name); });

TEST_P(FastSharp, IsThePlainEngineForWhateverIsSharp) {
  const std::vector<Value> values{infinite, whole, even, any};
  int quick = 0;  // where the plain engine does not make all steps
  for (unsigned seed = 0; seed < 48; ++seed) {
    const Mesh control = mesh(seed);
    const double share = seed % 3 == 0 ? 0.05 : seed % 3 == 1 ? 0.25 : 0.7;
    const Sharpness sharpness =
        random_sharpness(control, seed, share, share / 4, values[seed % values.size()]);
    const auto levels = static_cast<int>(1 + seed / 4 % 4);
    const int plain = check(control, sharpness, levels, seed);
    if (plain >= 0 && plain < levels) ++quick;
  }
  RecordProperty("quick", quick);
  EXPECT_GE(quick, 15);
}

/// Fractions that differ: rules that look past creases are left to the plain engine, with a word.
TEST_P(FastSharp, IsThePlainEngineForFractionsOrSaysWhyNot) {
  for (unsigned seed = 0; seed < 16; ++seed) {
    const Mesh control = mesh(seed);
    const Sharpness sharpness = random_sharpness(control, seed, 0.3, 0.05, fraction);
    const int levels = static_cast<int>(1 + seed % 4);
    if (!why_no_fast_sharpness(scheme_, control, sharpness)) {
      check(control, sharpness, levels, seed);
    } else {
      const auto refused = FastRefiner::make(scheme_, control, levels, sharpness);
      ASSERT_FALSE(refused.ok());
      EXPECT_NE(refused.error().text().find("look past creases"), std::string::npos);
    }
  }
}

TEST_P(FastSharp, FadesByChaikinWhereThatIsEven) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Mesh control = mesh(seed);
    Sharpness sharpness =
        random_sharpness(control, seed, 0.3, 0, [](std::mt19937&) { return 2.25; });
    sharpness.method = CreaseMethod::chaikin;
    ASSERT_FALSE(why_no_fast_sharpness(scheme_, control, sharpness));
    check(control, sharpness, static_cast<int>(1 + seed % 4), seed);
  }
}

TEST_P(FastSharp, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Mesh control = mesh(2);
  const Sharpness sharpness = random_sharpness(control, 3, 0.3, 0.1, any);
  const std::vector<Point3> points = random_points(control.vertex_count(), 1);
  const auto make = [&](int threads) {
    set_thread_limit(threads);
    return evaluate<float>(FastRefiner::make(scheme_, control, 3, sharpness).value(), points);
  };
  const std::vector<float> one = make(1);
  for (const int threads : {2, 0}) EXPECT_EQ(make(threads), one);
  set_thread_limit(0);
}

TEST(FastSharpness, LeavesAsFewStepsToThePlainEngineAsWithoutIt) {
  for (const char* const name : {"loop", "catmull-clark"}) {
    const Scheme scheme = shipped(name);
    const Mesh control = mesh::torus(scheme.split->lattice, 6, 7);
    const Sharpness sharpness = random_sharpness(control, 1, 0.3, 0.1, any);
    EXPECT_EQ(FastRefiner::make(scheme, control, 3, sharpness)->plain_steps(),
              FastRefiner::make(scheme, control, 3)->plain_steps());
  }
}

TEST(FastSharpness, ChaikinsThatFadesUnevenlyIsRefused) {
  const Mesh control = mesh::torus(Lattice::quad, 4, 4);
  Sharpness sharpness = random_sharpness(control, 1, 1, 0, whole);
  sharpness.method = CreaseMethod::chaikin;
  const auto why = why_no_fast_sharpness(shipped("catmull-clark"), control, sharpness);
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("chaikin"), std::string::npos);
}

TEST(FastSharpness, SplitsThatDivideCreasesInEverySecondStepAreRefused) {
  const Mesh control = mesh::torus(Lattice::triangle, 4, 4);
  const Sharpness sharpness = random_sharpness(control, 1, 1, 0, infinite);
  EXPECT_TRUE(why_no_fast_sharpness(shipped("sqrt3"), control, sharpness));
}

}  // namespace
}  // namespace limn::test
