// What limits cost round what has very many neighbours: no square of their number. And that what
// makes them cheap gives the same.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "fast/fast_check.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/ring_transform.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(RingTransform, IsTheSumOneByOne) {
  for (const std::size_t n : {1U, 2U, 3U, 511U, 512U, 521U, 1009U, 1024U}) {  // primes among them
    std::vector<double> values;
    for (const Point3& p : random_points(static_cast<Index>(n), 3)) values.push_back(p.x);
    const std::vector<std::complex<double>> sums = spectrum::ring_transform(values);
    ASSERT_EQ(sums.size(), n / 2 + 1);
    const double bound = 10 * 0x1p-53 * std::log2(4.0 * double(n)) * double(n);
    for (std::size_t omega = 0; omega <= n / 2; omega += 1 + n / 40) {
      std::complex<double> sum = 0;
      for (std::size_t k = 0; k < n; ++k)
        sum += values[k] * std::polar(1.0, 2 * M_PI * double(omega * k % n) / double(n));
      EXPECT_LT(std::abs(sums[omega] - sum), bound) << n << ' ' << omega;
    }
  }
}

// μ1 = 1/2 and μ2 = 1/4 at every valence, by the choice of the weights [Zorin, Schröder, Sweldens].
TEST(BigValences, HaveTheirClosedFormsEigenvalues) {
  FrequencyAnalysis analysis(shipped("butterfly-modified"));
  for (const int n : {511, 512, 601, 2000}) {
    const Eigencomponents found = approx_eigencomponents(analysis.blocks(n).value());
    EXPECT_NEAR(*found.tangent, 0.5, 1e-13) << n;
    EXPECT_NEAR(*found.saddle, 0.25, 1e-13) << n;
  }
}

TEST(BigValences, SomeFrequenciesAreThoseOfAll) {
  FrequencyAnalysis analysis(shipped("butterfly-modified"));
  const FrequencyBlocks all = analysis.blocks(9).value(), some = analysis.blocks(9, 3).value();
  ASSERT_EQ(all.blocks.size(), 5);
  ASSERT_EQ(some.blocks.size(), 3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(some.blocks[i], all.blocks[i]);
}

Mesh one_face(Index n) {
  std::vector<Index> corners;
  for (Index i = 0; i < n; ++i) corners.push_back(i);
  return must_build(n, {corners});
}

// The centre of a face is the mean of its corners after any step, so of the face's own.
TEST(SharedPlaces, AreTheLimitsOfAllTheirVertices) {
  const Mesh mesh = one_face(7);
  const auto points = random_points(7, 4);
  Point3 mean;
  for (const Point3& p : points) mean = mean + (1.0 / 7) * p;
  const LimitPoints all = approx_limit_points(shipped("doo-sabin"), mesh, points).value();
  for (Index v = 0; v < 7; ++v) {
    EXPECT_LT(distance(all.positions[v], mean), 1e-15) << v;
    LimitOptions options;
    options.vertices = {v};
    const LimitPoints one =
        approx_limit_points(shipped("doo-sabin"), mesh, points, options).value();
    EXPECT_LT(distance(one.normals[v], all.normals[v]), 1e-13) << v;
    EXPECT_NEAR(dot(all.normals[v], all.normals[v]), 1, 1e-14);
  }
}

Mesh bipyramid(Index n) {
  Faces faces;
  for (Index i = 0; i < n; ++i) {
    faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return must_build(n + 2, faces);
}

double seconds(const Scheme& scheme, const Mesh& mesh, bool curvatures, int runs) {
  LimitOptions options;
  options.curvatures = curvatures;
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 7);
  double least = INFINITY;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(approx_limit_points(scheme, mesh, points, options).ok());
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

// A square of their number would take minutes.
TEST(LimitCost, OfWeightsRoundManyIsNoSquare) {
  FrequencyAnalysis analysis(shipped("butterfly-modified"));
  const FrequencyBlocks blocks = analysis.blocks(400009, 3).value();  // a prime
  EXPECT_NEAR(std::abs(blocks.blocks[1].eigenvalues().cwiseAbs().maxCoeff()), 0.5, 1e-9);
}

// 8 log(8n) / log(n) is 10 or 11; a square would make it 64. The rest is for a busy machine.
TEST(LimitCost, GrowsAsTheValenceDoes) {
  constexpr Index kFew = 2000, kMany = 8 * kFew;
  for (const auto& [name, curvatures] :
       {std::pair{"doo-sabin", false}, std::pair{"butterfly-modified", true}}) {
    const Scheme& scheme = shipped(name);
    const double few = seconds(scheme, bipyramid(kFew), curvatures, 2);
    const double many = seconds(scheme, bipyramid(kMany), curvatures, 1);
    EXPECT_LT(many, 28 * few) << name << ' ' << few << ' ' << many;
  }
}

TEST(LimitCost, GrowsAsTheFaceDoes) {
  constexpr Index kFew = 4000, kMany = 8 * kFew;
  const double few = seconds(shipped("doo-sabin"), one_face(kFew), false, 2);
  const double many = seconds(shipped("doo-sabin"), one_face(kMany), false, 1);
  EXPECT_LT(many, 28 * few) << few << ' ' << many;
}

}  // namespace
}  // namespace limn::test
