#pragma once
/// Closed formulas of eigenvalues as text, LaTeX and JSON: `limn eigen --formulas`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/number/notation.h"
#include "limn/spectrum/eigen_formula.h"

namespace limn::report {

/// "n = 5, n ≥ 7", or the same as LaTeX.
[[nodiscard]] std::string valences_text(const ValenceFormulas& formulas, number::Notation notation);

/// Text: a paragraph for each set of valences, a line for each eigenvalue. LaTeX: a line of text
/// and an align* (amsmath) for each set of valences. A cosine that a formula holds more than once
/// is called c.
[[nodiscard]] std::string eigen_formulas_text(const std::string& scheme,
                                              const EigenFormulas& formulas,
                                              number::Notation notation);

/// {"scheme", "formulas": [{"valences": "n ≥ 5", "spans": [[5, null]], "rings", "frequency": 0 or
/// "omega ≥ 1", "eigenvalues": [{"ring", "text", "latex", "multiplicity", "by_lets": {"text",
/// "latex"} or null}], "left": [{"ring", "degree", "text", "latex", "multiplicity"}]}], "names":
/// [{"name", "parameter", "n"}]}. Texts are expressions as scheme files write them; those in "left"
/// are polynomials in "unknown", whose roots are the eigenvalues that have no closed form.
[[nodiscard]] nlohmann::ordered_json eigen_formulas_json(const std::string& scheme,
                                                         const EigenFormulas& formulas);

}  // namespace limn::report
