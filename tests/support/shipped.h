#pragma once
/// Shipped schemes, each read once: reading proves every rule anew.

#include <algorithm>
#include <map>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn::test {

inline const Scheme& shipped(const std::string& name) {
  static std::map<std::string, Scheme> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second
                              : known.emplace(name, find_scheme(name).value()).first->second;
}

/// Of a test with a scheme's name (or one made like it) as its parameter.
inline std::string test_name(std::string scheme) {
  std::replace(scheme.begin(), scheme.end(), '-', '_');
  return scheme;
}

}  // namespace limn::test
