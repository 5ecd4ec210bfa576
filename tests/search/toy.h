#pragma once
/// Studies and functions for tests of searches.

#include <string>
#include <vector>

#include "limn/search/method.h"
#include "limn/search/study.h"

namespace limn::test {

/// Loop's family with b and beta free at every valence of a short list.
inline const char* const kLoopStudy = R"toml(
title    = "Loop type"
scheme   = "loop-type"
valences = "4, 5, 6, 9"

[[free]]
name  = "b"
low   = "1/4"
high  = "1/2"
steps = 9

[[objective]]
value = "artifact(1/4, 0)"
goal  = "min"

[[objective]]
value = "holder_lower()"
goal  = "max"

[[require]]
that = "c1"

[method]
kind  = "grid"
batch = 4
)toml";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// The best value of `function` that a method finds, and how often it asked.
template <class Function>
std::pair<double, int> least(search::Method& method, Function function, int most) {
  double best = 1e300;
  int asked = 0;
  for (auto batch = method.next(); !batch.empty() && asked < most; batch = method.next()) {
    std::vector<std::vector<double>> worth;
    for (const search::UnitPoint& point : batch) {
      std::vector<double> x;
      for (const Rational& u : point) x.push_back(to_double(u));
      worth.push_back({function(x)});
      best = std::min(best, worth.back().front());
      ++asked;
    }
    method.tell(worth);
  }
  return {best, asked};
}

}  // namespace limn::test
