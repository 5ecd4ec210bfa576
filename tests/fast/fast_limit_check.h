#pragma once
/// The quick limit beside what the plain way finds on the same refined mesh.

#include <gtest/gtest.h>

#include "fast/fast_check.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_refiner.h"
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

/// Of a control mesh after some levels: whether there is a plan; if so, it is compared.
inline bool expect_plain_limit(const Scheme& scheme, const Mesh& control, int levels,
                               unsigned seed = 1) {
  SCOPED_TRACE(testing::Message() << levels << " levels, seed " << seed);
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const auto limit = approx_fast_limit(scheme, refiner);
  if (limit && !*limit) return false;
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const std::vector<Point3> fine = as_points(evaluate<double>(refiner, points));
  const Result<Mesh> mesh = Mesh::build(refined_polygons(refiner, fine));
  if (!mesh) return false;  // a vertex of two faces keeps two edges between its neighbours
  LimitOptions options;
  options.steps_made = levels;
  const auto expected = approx_limit_points(scheme, *mesh, fine, options);
  EXPECT_EQ(limit.ok(), expected.ok());
  if (!limit || !expected) return false;
  expect_limit<double>(refiner, **limit, points, *expected, 1e-11, 1e-7);
  expect_limit<float>(refiner, **limit, points, *expected, 1e-5, 2e-2);
  return true;
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
