#pragma once
/// What is asked of a scheme at a vertex: an equation, an inequality or a verdict.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/expression.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// An equation, an inequality between left and right, or a verdict.
enum class Relation {
  equal,             ///< left = right
  above,             ///< left > right (or <, with the sides exchanged)
  at_least,          ///< left ≥ right (or ≤, with the sides exchanged)
  convergent,        ///< Verdict::convergent
  c1,                ///< Verdict::c1_necessary
  bounded_curvature  ///< Verdict::bounded_curvature
};

/// "cup = tangent^2", "saddle < tangent^2", "c1", … Sides are expressions (scheme/expression.h) in
/// the names of kComponents, n and the scheme's own names; where both have a name, the component
/// has it. `==` and `=` are the same.
struct Requirement {
  std::string text;                     ///< as it was given
  Relation relation = Relation::equal;  ///< what is asked
  std::optional<Expression> left;       ///< nothing for verdicts
  std::optional<Expression> right;      ///< left - right has the relation to 0
  std::vector<std::size_t> used;        ///< which of kComponents, in the order of first use

  /// Whether its truth holds on intervals rather than at single values.
  [[nodiscard]] bool has_range() const { return relation != Relation::equal; }

  /// Reads a requirement for that scheme. Fails with the fault and its column in the message:
  /// unknown names, syntax, no relation.
  [[nodiscard]] static Result<Requirement> parse(std::string_view text, const Scheme& scheme);
};

}  // namespace limn
