#pragma once
/// All that limn says of one scheme, for a page that shows it: `limn report`.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn::report {

/// What is looked for, and how long.
struct PageRecordOptions {
  int first_valence = 3, last_valence = 12;  ///< 3 ≤ first
  double seconds = 60;               ///< for each of regularity and proofs; infinite: without end
  std::set<std::string> given = {};  ///< parameters that keep their values in closed formulas
  std::function<void(const std::string& what)> progress = {};  ///< called before each part
};

/// {"scheme": {"name", "label", "texts": [{"name", "text"}], "parameters": {name: expression}},
/// "show": describe_json, "record": record_json (report/compare/record_json.h), "formulas":
/// {"eigen": eigen_formulas_json or null, "reason", "lattice_latex": describe_latex or null},
/// "certificate": certify::answers_json or null, "certificate_reason", "facts": [{"valences":
/// [first, last], "source", "values": {key: expression}}]}. "reason" says why something is null,
/// and is empty where nothing is. Of a scheme with two lattices (lattice_schemes.h) "lattices":
/// [{"lattice": "triangle" or "quad", "record", …, "facts"}] stands for what follows "show".
/// `label`: what reports call it. Cost: mostly that of regularity and proofs.
[[nodiscard]] nlohmann::ordered_json page_record_json(const std::string& label,
                                                      const Scheme& scheme,
                                                      const PageRecordOptions& options = {});

}  // namespace limn::report
