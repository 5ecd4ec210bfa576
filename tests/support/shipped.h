#pragma once
/// Shipped schemes, each read once: reading proves every rule anew.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "limn/scheme/lattice_schemes.h"

namespace limn::test {

/// What follows the name of a scheme with both kinds of faces, for what it is on one kind.
inline constexpr std::string_view kOnTriangles = "-on-triangles", kOnQuads = "-on-quads";

inline const Scheme& shipped(const std::string& name) {
  static std::map<std::string, Scheme> known;
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  for (const std::string_view end : {kOnTriangles, kOnQuads})
    if (name.ends_with(end)) {
      const Scheme& both = shipped(name.substr(0, name.size() - end.size()));
      return known.emplace(name, scheme::lattice_schemes(both)[end == kOnQuads ? 1 : 0])
          .first->second;
    }
  return known.emplace(name, find_scheme(name).value()).first->second;
}

/// The shipped schemes, each with one lattice: what one with both kinds of faces is on either.
inline std::vector<std::string> lattice_names() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes()) {
    if (!shipped(name).split->mixed) {
      names.push_back(name);
      continue;
    }
    for (const std::string_view end : {kOnTriangles, kOnQuads})
      names.push_back(name + std::string(end));
  }
  return names;
}

/// Of a test with a scheme's name (or one made like it) as its parameter.
inline std::string test_name(std::string scheme) {
  std::replace(scheme.begin(), scheme.end(), '-', '_');
  return scheme;
}

}  // namespace limn::test
