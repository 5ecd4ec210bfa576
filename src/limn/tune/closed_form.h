#pragma once
/// Closed forms behind numbers that belong to valences: recognised, not proved.

#include <optional>
#include <string>
#include <vector>

namespace limn::tune {

/// A formula in n, as scheme files write it, that has these values at these valences, to 1e-12:
/// p(cos(2*pi/n)) or p(cos(2*pi/n))/n, p a polynomial of degree 2 at most whose coefficients are
/// fractions. At least five different valences are needed: three that say p, two that confirm it.
[[nodiscard]] std::optional<std::string> closed_form(const std::vector<int>& valences,
                                                     const std::vector<double>& values);

/// The same of one value, with p of degree 1 and of small coefficients: of so few that one is met
/// by chance once in a million times.
[[nodiscard]] std::optional<std::string> closed_form_at(int valence, double value);

}  // namespace limn::tune
