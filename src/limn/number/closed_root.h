#pragma once
/// A number that is known as a formula.

#include <string>

namespace limn {

/// A root of a polynomial (or, where that has no closed form, the polynomial itself) as a formula,
/// and how often it counts.
struct ClosedRoot {
  std::string text;      ///< an expression as scheme files write them (scheme/expression.h)
  std::string latex;     ///< the same in LaTeX's mathematics mode, without dollar signs
  int multiplicity = 1;  ///< of the root, or of the factor that the polynomial is
};

}  // namespace limn
