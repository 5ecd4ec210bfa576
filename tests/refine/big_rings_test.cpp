// What is summed round very many neighbours at once, against the sums one by one.

#include <gtest/gtest.h>

#include <numeric>

#include "fast/fast_check.h"
#include "limn/base/parallel.h"
#include "limn/refine/big_rings.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(Correlate, IsTheSumOneByOne) {
  for (const Index n : {1, 2, 3, 200, 257}) {
    const std::vector<Point3> values = random_points(n, 1);
    std::vector<double> weights;
    for (const Point3& p : random_points(n, 2)) weights.push_back(p.x / n);
    const std::vector<Point3> sums = refine::correlate(weights, values);
    for (Index m = 0; m < n; ++m) {
      Point3 sum;
      for (Index k = 0; k < n; ++k) refine::add_scaled(sum, weights[k], values[(m + k) % n]);
      EXPECT_LT(distance(sums[m], sum), 1e-14) << n << ' ' << m;
    }
  }
}

/// One step, all at once.
std::vector<Point3> step(const Scheme& scheme, const Mesh& mesh, const std::vector<Point3>& points,
                         const std::vector<Index>* wanted = nullptr) {
  const Births births = scheme.split->apply(mesh, 0).births;
  refine::RuleTables<double> tables(scheme);
  EXPECT_TRUE(tables.prepare(mesh, births).ok());
  if (wanted == nullptr) return refine::refine_values(scheme, mesh, births, tables, points);
  return refine::refine_values_at(scheme, mesh, births, tables, points, *wanted);
}

class BigRings : public testing::TestWithParam<std::string> {};

TEST_P(BigRings, AreTheSumsOneByOne) {
  const Scheme& scheme = shipped(GetParam());
  if (scheme.mask || scheme.factors) GTEST_SKIP() << "no rules off the regular lattice";
  for (const Index n : {refine::kBigRing - 1, refine::kBigRing, refine::kBigRing + 89}) {
    const Mesh mesh = refine::split_star(*scheme.split, n, refine::least_star_rings(*scheme.split));
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 5);
    const std::vector<Point3> quick = step(scheme, mesh, points);
    std::vector<Index> all(quick.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<Point3> plain = step(scheme, mesh, points, &all);  // one vertex at a time
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_LT(distance(quick[i], plain[i]), 2e-14) << n << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, BigRings, testing::ValuesIn(shipped_schemes()),
                         [](const auto& info) { return test_name(info.param); });

/// Two poles with big rings, whose edges meet in vertices that have small ones.
TEST(BigRingsOf, TwoPolesAreTheSumsOneByOne) {
  const Scheme& scheme = shipped("butterfly-modified");
  const Index n = refine::kBigRing + 3;
  Faces faces;
  for (Index i = 0; i < n; ++i) {
    faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  const Mesh mesh = must_build(n + 2, faces);
  const std::vector<Point3> points = random_points(n + 2, 9);
  const std::vector<Point3> quick = step(scheme, mesh, points);
  std::vector<Index> all(quick.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Point3> plain = step(scheme, mesh, points, &all);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_LT(distance(quick[i], plain[i]), 2e-14) << i;
}

/// n² products would take minutes here.
TEST(BigRingsOf, AreTheSameBitsOnAnyThreadsAndTakeNoSquareOfTheirSize) {
  for (const char* name : {"butterfly-modified", "doo-sabin"}) {
    const Scheme& scheme = shipped(name);
    const Mesh mesh =
        refine::split_star(*scheme.split, 100000, refine::least_star_rings(*scheme.split));
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 7);
    const std::vector<Point3> many = step(scheme, mesh, points);
    set_thread_limit(1);
    const std::vector<Point3> one = step(scheme, mesh, points);
    set_thread_limit(0);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(many[i].x, one[i].x);
      ASSERT_EQ(many[i].y, one[i].y);
      ASSERT_EQ(many[i].z, one[i].z);
    }
  }
}

}  // namespace
}  // namespace limn::test
