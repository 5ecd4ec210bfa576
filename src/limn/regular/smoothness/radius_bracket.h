#pragma once
/// What is known of the joint spectral radius ρ of finitely many matrices: the growth of the
/// largest of all products of n of them, lim max ‖A_{i1} … A_{in}‖^{1/n} [Jungers2009]. It is found
/// by joint_spectral_radius.h.

#include <optional>
#include <vector>

#include "limn/base/rational.h"

namespace limn {

/// A bracket of ρ, and what it rests on.
struct JointSpectralRadius {
  /// One diagonal block along a chain of common invariant subspaces.
  struct Block {
    int size = 0;      ///< rows of its matrices
    double lower = 0;  ///< of the block's own ρ; rounded, not proved, but in the block that leads
    double upper = 0;  ///< proved: of the block's ρ, or of that of all where this is smaller
    int vertices = 0;  ///< of the largest polytope made; 0 where size is 1
    bool irreducible = false;  ///< proved; else merely nothing was found to split
    /// Proved: products of n of the block's matrices are bounded by a constant times gⁿ, where g is
    /// the growth of `product`, exactly (exact_polytope.h).
    bool bounded = false;
    bool below = false;  ///< proved: the block's ρ is less than that growth
  };
  double lower = 0;  ///< proved: ρ ≥ lower
  double upper = 0;  ///< proved: ρ ≤ upper
  /// The matrices of the product with the greatest spectral radius found, first factor first;
  /// ρ ≥ |an eigenvalue of it|^(1/length). Empty where ρ = 0.
  std::vector<int> product;
  std::optional<Rational> eigenvalue;  ///< of the product, where it is rational
  /// Proved: ρ is |eigenvalue|^(1/length), or 0 where there is no product. Every block is bounded
  /// by it or below it.
  bool exact = false;
  std::vector<Block> blocks;  ///< along one chain; ρ is the greatest of theirs
  bool time_ended = false;    ///< `stop` asked for an end: more time would narrow the bracket
};

}  // namespace limn
