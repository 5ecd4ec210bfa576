#pragma once
/// Families of schemes to tune, and short ways to do it.

#include <gtest/gtest.h>

#include <string>

#include "limn/tune/solve.h"
#include "support/shipped.h"

namespace limn::test {

/// Loop's scheme with a parameter g in its vertex rule: `beta` in n, lambda and g. A default
/// without n makes g one number for all valences.
inline Scheme loop_with(const std::string& beta, const std::string& range = "[\"-2\", \"2\"]",
                        const std::string& value = "1/n") {
  return parse_scheme("split = \"triangle-dyadic\"\nextends = \"loop\"\n[let]\nweight = \"" + beta +
                          "\"\n[parameter.g]\ndefault = \"" + value + "\"\nrange = " + range +
                          "\n[vertex]\nself = \"1 - n*weight\"\nring = \"weight\"\n",
                      "family.toml")
      .value();
}

inline ValenceSolutions solved(const Scheme& scheme, const std::string& name,
                               const std::string& requirement, int n,
                               const std::string& between = {}) {
  FreedScheme freed = FreedScheme::make(scheme, name).value();
  const SearchRange range = SearchRange::parse(between.empty() ? "0,1" : between).value();
  return solve_at(freed, Requirement::parse(requirement, scheme).value(), n,
                  between.empty() ? nullptr : &range)
      .value();
}

/// Those that hold.
inline std::vector<double> holding(const ValenceSolutions& solutions) {
  std::vector<double> values;
  for (const Solution& solution : solutions.solutions)
    if (solution.holds == Truth::yes) values.push_back(solution.value);
  return values;
}

inline ValenceRange ranged(const Scheme& scheme, const std::string& name,
                           const std::string& requirement, int n, Reach reach = Reach::automatic) {
  FreedScheme freed = FreedScheme::make(scheme, name, reach).value();
  return range_at(freed, Requirement::parse(requirement, scheme).value(), n).value();
}

}  // namespace limn::test
