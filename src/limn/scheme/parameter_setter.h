#pragma once
/// Parameters of one scheme that are set again and again, as a slider does.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "limn/base/rational.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// Sets parameters as `set_parameters` does, with the same answers, but proves nothing twice: where
/// all weights are polynomials of degree d in a parameter, the sum of a rule's weights is one, too,
/// and so are differences of weights. What was found to be 1 (or 0) at d + 1 values of the
/// parameter is so at each of its values. Then the ranges alone are checked.
class ParameterSetter {
 public:
  /// Precondition: the scheme was checked, as by read_scheme.
  explicit ParameterSetter(Scheme scheme);

  /// What was given, whose parameters have their defaults.
  [[nodiscard]] const Scheme& scheme() const { return scheme_; }

  /// The scheme with these parameters, and defaults for the others. Fails as set_parameters. Cost
  /// as that, or, of a parameter that is polynomial, at the third value or so that of a copy.
  [[nodiscard]] Result<Scheme> with(const std::vector<std::string>& assignments);

 private:
  /// Of one parameter, all others being the same.
  struct Line {
    std::optional<int> degree;   ///< nothing: weights are no polynomials in it
    std::set<Rational> checked;  ///< values at which all rules were found right
    [[nodiscard]] bool is_proved() const {
      return degree && checked.size() > static_cast<std::size_t>(*degree);
    }
  };
  /// The parameter's number, and the texts of the others' values.
  using Key = std::pair<std::size_t, std::vector<std::string>>;

  Line& line(const Scheme& scheme, std::size_t parameter);
  void note(const Scheme& scheme);

  Scheme scheme_;
  std::map<Key, Line> lines_;
};

namespace detail {

/// Puts the expressions in place; nothing is checked but that there are such parameters.
[[nodiscard]] Status assign_parameters(Scheme& scheme, const std::vector<std::string>& assignments);
/// A fault of the scheme that these assignments have made.
[[nodiscard]] Error in_assignments(const std::vector<std::string>& assignments, Error fault);
/// The degree of the weights in that parameter, the most of all rules; nothing where they, or their
/// guards, are no polynomials in it, or rules are made of a mask.
[[nodiscard]] std::optional<int> degree_of_weights(const Scheme& scheme,
                                                   const std::string& parameter);

}  // namespace detail
}  // namespace limn::scheme
