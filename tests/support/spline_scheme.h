#pragma once
/// Shipped schemes of stages, at a degree.

#include <gtest/gtest.h>

#include <string>

#include "support/shipped.h"

namespace limn::test {

/// b-spline-quad of a degree, with so much of Stam's weights.
inline Scheme spline_of_degree(int degree, const std::string& stam = "0") {
  Scheme scheme = shipped("b-spline-quad");
  EXPECT_TRUE(set_parameters(scheme, {"degree=" + std::to_string(degree), "stam=" + stam}).ok());
  return scheme;
}

}  // namespace limn::test
