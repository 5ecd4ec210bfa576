#pragma once
/// Polynomials in weights that are still names: the number type with which a star is refined once,
/// for all valences. A name is an index into a list that its user keeps.

#include <map>
#include <vector>

#include "limn/number/arithmetic.h"

namespace limn::refine {

/// Σ coefficient · product of named weights. Of most stencils the degree is 0 or 1.
class WeightForm {
 public:
  using Names = std::vector<int>;  ///< sorted; a name may come more than once

  WeightForm() = default;
  WeightForm(double constant) {
    if (constant != 0) terms_[{}] = constant;
  }
  [[nodiscard]] static WeightForm name(int index) {
    WeightForm form;
    form.terms_[{index}] = 1;
    return form;
  }

  [[nodiscard]] const std::map<Names, double>& terms() const { return terms_; }

  friend WeightForm operator+(WeightForm a, const WeightForm& b);
  friend WeightForm operator*(const WeightForm& a, const WeightForm& b);

 private:
  std::map<Names, double> terms_;
};

}  // namespace limn::refine

namespace limn::number {

/// What refinement of values needs of a number; no expression is evaluated in weight forms.
template <>
struct Arithmetic<refine::WeightForm> {
  static refine::WeightForm from(const Rational& q) { return {to_double(q)}; }
};

}  // namespace limn::number
