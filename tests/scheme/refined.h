#pragma once
/// Refining in tests of schemes: a scheme given as text, values that tell every weight apart.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "limn/refine/refine.h"
#include "limn/scheme/scheme.h"

namespace limn::test {

/// The scheme that the text denotes; a failure of the test, and Loop, where there is none.
inline Scheme must_parse(const std::string& text) {
  Result<Scheme> scheme = parse_scheme(text, "new.toml");
  if (scheme) return *std::move(scheme);
  ADD_FAILURE() << scheme.error().text();
  return find_scheme("loop").value();
}

inline std::vector<double> random_values(const Mesh& mesh, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::vector<double> values(static_cast<std::size_t>(mesh.vertex_count()));
  for (double& value : values) value = static_cast<double>(random() % 1'000'000) / 1e6;
  return values;
}

inline Result<refine::Refined<double>> refined(const Scheme& scheme, const Mesh& mesh,
                                               int levels = 1) {
  return refine::refine<double>(scheme, mesh, random_values(mesh), levels);
}

inline void expect_same_refinement(const Scheme& a, const Scheme& b, const Mesh& mesh,
                                   int levels = 1) {
  const Result<refine::Refined<double>> left = refined(a, mesh, levels);
  const Result<refine::Refined<double>> right = refined(b, mesh, levels);
  ASSERT_TRUE(left.ok()) << left.error().text();
  ASSERT_TRUE(right.ok()) << right.error().text();
  ASSERT_EQ(left->values.size(), right->values.size());
  for (std::size_t i = 0; i < left->values.size(); ++i)
    ASSERT_NEAR(left->values[i], right->values[i], 1e-12) << a.name << " at vertex " << i;
}

}  // namespace limn::test
