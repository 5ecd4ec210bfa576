#pragma once
/// Masks of shipped schemes.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "limn/regular/regular_mask.h"

namespace limn::test {

/// With "name=expression" parameters set.
inline Mask mask_of(const std::string& name, const std::vector<std::string>& parameters = {}) {
  Scheme scheme = find_scheme(name).value();
  const Status set = set_parameters(scheme, parameters);
  EXPECT_TRUE(set.ok()) << set.error().text();
  return regular_mask(scheme).value();
}

}  // namespace limn::test
