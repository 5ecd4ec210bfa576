#pragma once
/// Common invariant subspaces of rational matrices, split off exactly: a small MeatAxe [Parker1984;
/// HoltRees1994]. In a basis along a chain of invariant subspaces the matrices are block
/// triangular, and their joint spectral radius is the greatest of those of the diagonal blocks.

#include "limn/base/budget.h"
#include "limn/base/rational.h"
#include "limn/regular/algebra/echelon.h"

namespace limn::regular {

using RationalMatrix = FieldMatrix<Rational>;

/// The diagonal blocks, along one chain: each a list of square matrices, one for each given.
struct DiagonalBlock {
  std::vector<RationalMatrix> matrices;
  /// Vectors of the whole space, a row each, that span the block modulo those of the blocks before
  /// it: the columns of `matrices` tell, modulo those, what the matrices given make of them.
  RationalMatrix basis;
  bool irreducible = false;  ///< over the rationals, proved; else merely nothing was found to split

  [[nodiscard]] std::size_t size() const { return matrices.front().size(); }
};

/// Precondition: at least one matrix, all square and of one size ≥ 1. Subspaces are sought
/// modulo a prime and verified over the rationals; those whose basis needs integers above 2³⁰, or
/// irrational numbers, are not found. Deterministic. Cost: about size³ operations for each try.
/// Where `stop` asks for an end no further block is split.
[[nodiscard]] std::vector<DiagonalBlock> diagonal_blocks(std::vector<RationalMatrix> matrices,
                                                         const Stop& stop = {});

}  // namespace limn::regular
