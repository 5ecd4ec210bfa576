#pragma once
/// The laws every rule must keep, decided in exact arithmetic: at each valence some case of the
/// rule applies, every parameter lies in its range, the weights sum to exactly 1, and weights
/// that depend on k are the same in both directions (w_k = w_{n-k}).

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "limn/base/faults.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// The name of the number of quads at a vertex, in the formulas of stages that begin linearly.
inline constexpr std::string_view kQuads = "q";

inline constexpr int kSmallestValence = 3;
inline constexpr int kLargestCheckedValence = 24;  // of every rule, when a file is read

/// The budget (number/exact.h) of checking a scheme, seconds at most: many times what the shipped
/// ones need, so that only a hostile file meets it.
inline constexpr double kExactWork = 2e6;

/// All rules of the scheme at valences kSmallestValence … kLargestCheckedValence: each place at
/// which something is wrong is a fault, at the first valence where it is. What uses a name in
/// `valueless`, and rules for which `is_left_out(kind)`, are passed over.
void check_rules(const Scheme& scheme, const std::set<std::string>& valueless,
                 const std::function<bool(RuleKind)>& is_left_out, base::Faults& faults);

/// That each parameter lies in its range, where check_rules looks at it: the first that does not.
[[nodiscard]] Status check_ranges(const Scheme& scheme);

/// One rule at one valence (ignored for rules without n). Here and below `quads` is the number of
/// quads at the vertex, where meshes have both kinds of faces (Split::mixed); else nothing.
[[nodiscard]] Status check_rule(const Scheme& scheme, RuleKind kind, int n,
                                std::optional<int> quads = {});

/// The case of `rule` that applies at valence n: nullptr where none does. Guards are decided in
/// exact arithmetic, so every number type takes the same case. In a scheme of stages the vertex
/// rule is what two averagings make of a vertex, and there are no others.
[[nodiscard]] Result<const RuleCase*> applicable_case(const Scheme& scheme, RuleKind kind, int n,
                                                      std::optional<int> quads = {});

/// Whether the formula names one of these.
[[nodiscard]] bool uses_any(const Formula& formula, const std::set<std::string>& names);

/// The error that names a missing rule or case; `what` as "the vertex rule at valence 5".
[[nodiscard]] Error missing_rule(const Scheme& scheme, RuleKind kind, int n,
                                 std::optional<int> quads = {});

}  // namespace limn::scheme
