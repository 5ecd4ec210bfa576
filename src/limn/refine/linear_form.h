#pragma once
/// Linear forms in the control vertices: the value type whose refinement is a subdivision matrix.

#include <algorithm>
#include <utility>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::refine {

/// Σ coefficient · (value at vertex), terms sorted by vertex.
template <class Number>
struct LinearForm {
  std::vector<std::pair<Index, Number>> terms;

  /// The value at one vertex.
  static LinearForm unit(Index vertex) { return {{{vertex, Number(1)}}}; }

  [[nodiscard]] Number coefficient(Index vertex) const {
    const auto found = std::lower_bound(terms.begin(), terms.end(), vertex,
                                        [](const auto& term, Index v) { return term.first < v; });
    return found != terms.end() && found->first == vertex ? found->second : Number(0);
  }
};

/// Cost O(terms of both).
template <class Number>
void add_scaled(LinearForm<Number>& sum, const Number& weight, const LinearForm<Number>& form) {
  std::vector<std::pair<Index, Number>> merged;
  merged.reserve(sum.terms.size() + form.terms.size());
  auto left = sum.terms.begin();
  for (const auto& [vertex, value] : form.terms) {
    for (; left != sum.terms.end() && left->first < vertex; ++left)
      merged.push_back(std::move(*left));
    if (left != sum.terms.end() && left->first == vertex)
      merged.emplace_back(vertex, Number(left++->second + weight * value));
    else
      merged.emplace_back(vertex, weight * value);
  }
  merged.insert(merged.end(), std::make_move_iterator(left),
                std::make_move_iterator(sum.terms.end()));
  sum.terms = std::move(merged);
}

/// The unit forms of `count` vertices: the identity.
template <class Number>
[[nodiscard]] std::vector<LinearForm<Number>> unit_forms(Index count) {
  std::vector<LinearForm<Number>> forms;
  forms.reserve(static_cast<std::size_t>(count));
  for (Index v = 0; v < count; ++v) forms.push_back(LinearForm<Number>::unit(v));
  return forms;
}

}  // namespace limn::refine
