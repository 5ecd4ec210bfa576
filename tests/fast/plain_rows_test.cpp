// The plain engine's steps, written down as rows, against the plain engine.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

#include "fast/fast_check.h"
#include "limn/base/parallel.h"
#include "limn/fast/plain/plain_steps.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

using fast::PlainRows;
using fast::PlainSteps;

constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

/// One step of a scheme, which both engines can make.
struct OneStep {
  const Scheme& scheme;
  const Mesh& mesh;
  Births births;
  refine::RuleTables<double> tables;

  OneStep(const Scheme& scheme, const Mesh& mesh, int step)
      : scheme(scheme),
        mesh(mesh),
        births(scheme.split->apply(mesh, step).births),
        tables(scheme) {}

  [[nodiscard]] std::optional<PlainRows> rows(std::vector<Index> places, std::size_t limit) const {
    refine::StepStencils<double> stencils(scheme, mesh, births, tables);
    stencils.prepare_all();
    return PlainRows::record(stencils, std::move(places), limit);
  }
};

template <class Real>
std::vector<Real> evaluate(const PlainRows& rows, const std::vector<Point3>& points) {
  std::vector<Real> old = as_numbers<Real>(points);
  old.push_back(0);
  std::vector<Real> fresh(3 * static_cast<std::size_t>(rows.vertex_count()), Real(7e7));
  rows.evaluate(old.data(), fresh.data());
  return fresh;
}

std::vector<Index> shuffled(Index count, unsigned seed) {
  std::vector<Index> places(static_cast<std::size_t>(count));
  std::iota(places.begin(), places.end(), 0);
  std::shuffle(places.begin(), places.end(), std::mt19937(seed));
  return places;
}

void expect_rows_of(const Scheme& scheme, const Mesh& mesh, int step, unsigned seed) {
  OneStep one(scheme, mesh, step);
  if (!one.tables.prepare(mesh, one.births)) return;
  const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
  const Index count = refine::StepStencils<double>(scheme, mesh, one.births, one.tables).count();
  std::vector<Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  // vertex by vertex the plain engine neither counts valences nor reads rings: it turns and walks
  const std::vector<Point3> plain =
      refine::refine_values_at(scheme, mesh, one.births, one.tables, points, all);
  const std::vector<Index> places = shuffled(count, seed);
  const auto rows = one.rows(places, kUnlimited);
  ASSERT_TRUE(rows.has_value());
  ASSERT_EQ(rows->vertex_count(), count);
  const std::vector<Point3> doubles = as_points(evaluate<double>(*rows, points));
  const std::vector<Point3> floats = as_points(evaluate<float>(*rows, points));
  for (Index i = 0; i < count; ++i) {
    EXPECT_LT(distance(doubles[places[i]], plain[i]), 1e-14) << i;
    EXPECT_LT(distance(floats[places[i]], plain[i]), 3e-6) << i;
  }
}

class FastPlainRows : public testing::TestWithParam<std::string> {};

TEST_P(FastPlainRows, AreThePlainEngineOnRandomMeshes) {
  const Scheme& scheme = shipped(GetParam());
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const int step : {0, 1}) {
      SCOPED_TRACE(seed);
      RandomMesh random(seed);
      if (scheme.split->any_polygons) expect_rows_of(scheme, random.polygons(), step, seed);
      expect_rows_of(scheme, random.triangles(), step, seed);
    }
}

TEST_P(FastPlainRows, AreThePlainEngineRoundEveryValence) {
  const Scheme& scheme = shipped(GetParam());
  for (const Index n : {3, 4, 5, 6, 7, 12, 70})
    for (const Index rings : {1, 2}) {
      SCOPED_TRACE(n);
      expect_rows_of(scheme, mesh::star(scheme.split->lattice, n, rings), 0, 3);
      expect_rows_of(scheme, mesh::fan(scheme.split->lattice, n, rings), 1, 4);
    }
}

/// Those that have rules: stages are no sums of one step.
std::vector<std::string> schemes_of_rules() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes())
    if (!shipped(name).stages) names.push_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastPlainRows, testing::ValuesIn(schemes_of_rules()),
                         [](const auto& info) { return test_name(info.param); });

/// More rows than a chunk has; recorded and made by one thread and by many.
TEST(FastPlainRowsOf, AreTheSameBitsOnOneThreadAndMany) {
  for (const char* name : {"butterfly-modified", "catmull-clark"}) {
    const Mesh mesh = mesh::torus(shipped(name).split->lattice, 70, 71);
    OneStep one(shipped(name), mesh, 0);
    ASSERT_TRUE(one.tables.prepare(mesh, one.births).ok());
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
    set_thread_limit(1);
    const std::optional<PlainRows> rows = one.rows({}, kUnlimited);
    const std::vector<float> once = evaluate<float>(*rows, points);
    for (const int threads : {2, 0}) {
      set_thread_limit(threads);
      const std::optional<PlainRows> again = one.rows({}, kUnlimited);
      EXPECT_EQ(again->bytes(), rows->bytes());
      EXPECT_EQ(evaluate<float>(*again, points), once);
    }
    set_thread_limit(0);
  }
}

/// Of a regular mesh all edges share one list of weights; a source comes once.
TEST(FastPlainRowsOf, ShareTheirWeights) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 80, 80);
  OneStep one(shipped("butterfly-modified"), mesh, 0);
  ASSERT_TRUE(one.tables.prepare(mesh, one.births).ok());
  const auto rows = one.rows({}, kUnlimited);
  const double edges = mesh.edge_count(), vertices = mesh.vertex_count();
  const double least = 4 * (edges * (8 + 1) + vertices * (1 + 1));
  EXPECT_GE(static_cast<double>(rows->bytes()), least);
  EXPECT_LE(static_cast<double>(rows->bytes()), least + 4096);
}

TEST(FastPlainRowsOf, KeepToTheirLimit) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 80, 80);
  OneStep one(shipped("loop"), mesh, 0);
  ASSERT_TRUE(one.tables.prepare(mesh, one.births).ok());
  for (const std::size_t limit :
       {std::size_t{0}, std::size_t{100000}, one.rows({}, kUnlimited)->bytes() / 2})
    EXPECT_FALSE(one.rows({}, limit).has_value()) << limit;
  EXPECT_TRUE(one.rows({}, 2 * one.rows({}, kUnlimited)->bytes()).has_value());
}

/// Where n edges weigh n points each, the plain engine steps in anew in each evaluation.
TEST(FastPlainRowsOf, AreNotWrittenDownRoundGreatValences) {
  const Scheme& scheme = shipped("butterfly-modified");
  for (const Index n : {20, 600}) {
    SCOPED_TRACE(n);
    const Mesh mesh = mesh::star(Lattice::triangle, n, 2);
    Result<PlainSteps> steps = PlainSteps::make(scheme, mesh, 1);
    ASSERT_TRUE(steps.ok());
    steps->write_down({});
    EXPECT_EQ(steps->splits().empty(), n == 20);
    expect_same(scheme, mesh, 2, 1);
  }
}

/// Steps in a row, the last one's vertices put elsewhere.
TEST(FastPlainRowsOf, FollowEachOther) {
  for (const char* name : {"butterfly-modified", "catmull-clark", "sqrt3", "doo-sabin"}) {
    SCOPED_TRACE(name);
    const Scheme& scheme = shipped(name);
    const Mesh mesh = RandomMesh(4).triangles();
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
    const auto plain = refine::refine(scheme, mesh, points, 3).value();
    Result<PlainSteps> steps = PlainSteps::make(scheme, mesh, 3);
    ASSERT_TRUE(steps.ok());
    const std::vector<Index> order = shuffled(plain.mesh.vertex_count(), 2);
    steps->write_down(order);
    EXPECT_TRUE(steps->splits().empty());
    EXPECT_EQ(steps->count(), 3);
    std::vector<double> fine(3 * order.size());
    steps->evaluate(as_numbers<double>(points).data(), fine.data());
    const std::vector<Point3> got = as_points(fine);
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_LT(distance(got[i], plain.values[order[i]]), 1e-13);
  }
}

}  // namespace
}  // namespace limn::test
