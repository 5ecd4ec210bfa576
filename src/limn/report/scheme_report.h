#pragma once
/// A scheme, described: what `limn show` and `limn schemes` print.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn {

/// Everything in the scheme file, with the regular mask, for people.
[[nodiscard]] std::string describe(const Scheme& scheme);

/// The same for programs: {"name", "title", "split", "source", "notes", "file", "parameters":
/// [{"name", "value", "range", "meaning"}], "lets": {name: expression}, "rules": {rule:
/// [{"when", "weights": [{"role", "walk", "positions", "weight"}]}]}, "mask": {"denominator"…} or
/// null}. Weights and mask coefficients are strings, exact.
[[nodiscard]] nlohmann::ordered_json describe_json(const Scheme& scheme);

/// Name, title, split and parameters only.
[[nodiscard]] nlohmann::ordered_json summary_json(const Scheme& scheme);

}  // namespace limn
