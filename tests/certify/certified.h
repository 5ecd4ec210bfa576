#pragma once
/// A certificate of a scheme, for tests.

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "limn/certify/certify.h"

namespace limn::certify {

inline std::vector<int> valences(int first, int last) {
  std::vector<int> result(static_cast<std::size_t>(last - first + 1));
  std::iota(result.begin(), result.end(), first);
  return result;
}

inline Certificate certified(const Scheme& scheme, int first, int last) {
  Result<Certificate> certificate = certify(scheme, valences(first, last));
  EXPECT_TRUE(certificate.ok()) << certificate.error().text();
  return certificate ? *certificate : Certificate{};
}

}  // namespace limn::certify
