#pragma once
/// The quick limit beside what the plain way finds on the same refined mesh.

#include <gtest/gtest.h>

#include "fast/fast_check.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_limit.h"
#include "limn/limit/limit_points.h"

namespace limn::test {

template <class Real>
void expect_limit(const FastRefiner& refiner, const FastRefiner::Limit& limit,
                  const std::vector<Point3>& control, const LimitPoints& expected, double tolerance,
                  double normal_tolerance) {
  std::vector<Real> positions(3 * static_cast<std::size_t>(refiner.vertex_count()), Real(7e7));
  std::vector<Real> normals = positions;
  FastRefiner::Scratch<Real> scratch;
  refiner.evaluate_limit<Real>(limit, as_numbers<Real>(control), positions, normals, scratch);
  const std::vector<Point3> p = as_points(positions), n = as_points(normals);
  for (std::size_t v = 0; v < p.size(); ++v) {
    EXPECT_LT(distance(p[v], expected.positions[v]), tolerance) << v;
    EXPECT_LT(distance(n[v], expected.normals[v]), normal_tolerance) << v;
  }
}

/// Positions and normals, by one thread and by more.
inline void expect_same_limit_bits(const Scheme& scheme, const Mesh& control, int levels) {
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const auto limit = approx_fast_limit(scheme, refiner).value();
  ASSERT_TRUE(limit);
  const std::vector<float> points = as_numbers<float>(random_points(control.vertex_count(), 1));
  const auto evaluated = [&](int threads) {
    set_thread_limit(threads);
    std::vector<float> both(6 * static_cast<std::size_t>(refiner.vertex_count()));
    const std::span<float> all(both);
    FastRefiner::Scratch<float> scratch;
    refiner.evaluate_limit<float>(*limit, points, all.first(all.size() / 2),
                                  all.last(all.size() / 2), scratch);
    return both;
  };
  const std::vector<float> one = evaluated(1);
  for (const int threads : {2, 5, 0}) EXPECT_EQ(evaluated(threads), one);
  set_thread_limit(0);
}

}  // namespace limn::test
