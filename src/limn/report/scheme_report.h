#pragma once
/// A scheme, described: what `limn show` and `limn schemes` print.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn::report {

/// Everything in the scheme file, with the regular mask, for people. Of the lets of a scheme that
/// it extends those that something uses.
[[nodiscard]] std::string describe(const Scheme& scheme);

/// The same for programs: {"name", "title", "split", "source", "notes", "file", "parameters":
/// [{"name", "value", "range", "meaning"}], "lets": {name: expression}, "same_as": [{"scheme",
/// "with": {parameter: expression}, "source"}], "rules": {rule:
/// [{"when", "weights": [{"role", "walk", "positions", "weight"}]}]}, and what
/// lattice_json says; "mask" is null where there is none}. Where the scheme has two lattices
/// (lattice_schemes.h) that is in "lattices": [{"lattice": "triangle" or "quad", "mask", …}].
/// Weights and coefficients are strings, exact.
[[nodiscard]] nlohmann::ordered_json describe_json(const Scheme& scheme);

/// LaTeX for a paper: mask, factors, limit stencil and artifact formulas (needs amsmath). Fails
/// where regular_mask does.
[[nodiscard]] Result<std::string> describe_latex(const Scheme& scheme);

/// Name, title, split and parameters only.
[[nodiscard]] nlohmann::ordered_json summary_json(const Scheme& scheme);

}  // namespace limn::report
