#pragma once
/// The subdivision matrix round one extraordinary vertex (or face, for dual splits): refinement
/// of linear forms on a star, read off at the same star in the refined mesh.

#include "limn/number/exact.h"
#include "limn/refine/linear_form.h"
#include "limn/scheme/scheme.h"

namespace limn::refine {

/// Row i holds the weights of the i-th vertex of the refined star over the vertices of the old one,
/// both numbered as in star_step.h.
template <class Number>
struct SubdivisionMatrix {
  int size = 0;
  int center = 0;  ///< 1 where vertex 0 is the centre; 0 for dual splits, which have none
  std::vector<Number> entries;  ///< row by row

  [[nodiscard]] const Number& operator()(int row, int column) const {
    return entries[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                   static_cast<std::size_t>(column)];
  }
};

/// The matrix at valence n ≥ 3 on `rings` ≥ 1 rings. Fails where the neighbourhood is not invariant
/// (a row weighs a vertex beyond it: the message says to take more rings), and as
/// RuleTables::prepare does. Cost about O(n · (rings + margin)²) rule evaluations and size²
/// memory.
template <class Number>
[[nodiscard]] Result<SubdivisionMatrix<Number>> subdivision_matrix(const Scheme& scheme, int n,
                                                                   int rings);

/// The smallest number of rings, at most `largest`, whose neighbourhood is invariant at valence n.
[[nodiscard]] Result<int> invariant_rings(const Scheme& scheme, int n, int largest = 6);

extern template Result<SubdivisionMatrix<double>> subdivision_matrix<double>(const Scheme&, int,
                                                                             int);
extern template Result<SubdivisionMatrix<number::Exact>> subdivision_matrix<number::Exact>(
    const Scheme&, int, int);

}  // namespace limn::refine
