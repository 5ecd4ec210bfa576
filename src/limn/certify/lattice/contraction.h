#pragma once
/// How far the limit surface on a cell can be from what its control values say: bounds that hold
/// for every control net, from products of the cell's matrices.
///
/// Words d1 d2 … of digits form a tree. Its leaves are words whose product X = s^l residual[dl] …
/// residual[d1] has ‖X‖∞ ≤ q < 1; that the tree is finite proves that gradients converge, so
/// that the scheme is C1 on the lattice, given sum rules of order 2 (CellMatrices has checked
/// these). With h the change of the gradient along one edge of the tree, its sum down a path and
/// 1/(1 - q) for what comes after a leaf bound the whole way to the limit.

#include <array>

#include "limn/base/budget.h"
#include "limn/certify/lattice/cell_matrices.h"

namespace limn::certify {

/// Leaves' products have norms of at most this.
inline constexpr double kContracted = 0.25;

struct Contraction {
  double leaf_norm = 0;  ///< q
  int products = 0;      ///< in the tree, leaves included
  int longest = 0;       ///< word, in refinements
  /// |∂f/∂s_i - g_i| ≤ Σ_j gradient[i][j] |r_j/size_j| on the cell; rounded up.
  std::array<std::vector<double>, 2> gradient;
  /// |f - (c(0) + y · g)| ≤ Σ_j value[j] |r_j/size_j|, y from the cell's origin; rounded up.
  std::vector<double> value;
};

/// With leaves of norms ≤ leaf_norm, in (0, 1): the smaller, the larger the tree and the better the
/// bounds. Fails where the tree would have more than `most_products` products or words of more than
/// 400 digits, and where `stop` asks for an end. In double precision with errors bounded. Cost:
/// products × points³.
[[nodiscard]] Result<Contraction> enclose_contraction(const CellMatrices& cells, double leaf_norm,
                                                      int most_products, const Stop& stop = {});

}  // namespace limn::certify
