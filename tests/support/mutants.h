#pragma once
/// Changed schemes: what a typing error, or a wrong rule whose weights still sum to 1, would make
/// of a scheme file.

#include <string>
#include <vector>

#include "limn/scheme/scheme.h"

namespace limn::test {

/// A scheme file with one change in it.
struct TextMutant {
  std::string change;  ///< "line 12: 3 → 4 in …"
  std::string text;
};

/// Changes in the values of rules, lets, parameter defaults, factors and facts (titles, notes,
/// sources, ranges, valences and splits are left alone): every integer one larger and one
/// smaller (in stated masks, the first of each row); every operator of + - * / ^ == != exchanged
/// with its opposite; cos and sin; and every value as a whole larger by 1/64.
[[nodiscard]] std::vector<TextMutant> text_mutants(const std::string& text);

struct RuleMutant {
  std::string change;
  Scheme scheme;
};

/// Changes that keep every sum of weights: for every weight of every rule, 1/64 more of it and as
/// much less of another weight of its case, at all valences and at a single one; a weight that
/// goes round (depending on k) shifted towards k = 0; 1/64 taken from it for a role that the case
/// does not have yet.
[[nodiscard]] std::vector<RuleMutant> rule_mutants(const Scheme& scheme);

}  // namespace limn::test
