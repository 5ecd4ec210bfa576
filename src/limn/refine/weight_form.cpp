#include "limn/refine/weight_form.h"

#include <algorithm>
#include <iterator>

namespace limn::refine {

WeightForm operator+(WeightForm a, const WeightForm& b) {
  for (const auto& [names, coefficient] : b.terms_) a.terms_[names] += coefficient;
  return a;
}

WeightForm operator*(const WeightForm& a, const WeightForm& b) {
  WeightForm result;
  for (const auto& [left, x] : a.terms_)
    for (const auto& [right, y] : b.terms_) {
      WeightForm::Names names;
      std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(names));
      result.terms_[names] += x * y;
    }
  return result;
}

}  // namespace limn::refine
