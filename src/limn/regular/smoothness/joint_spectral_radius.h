#pragma once
/// The joint spectral radius ρ of rational matrices: the growth of the largest of all products of n
/// of them, lim max ‖A_{i1} … A_{in}‖^{1/n} [Jungers2009]. Common invariant subspaces are split off
/// first; then ρ lies between the spectral radius of a product (proved by an exact determinant) and
/// a norm, that of a polytope (proved in doubles rounded outwards).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/time_budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn {

struct JointSpectralRadiusOptions {
  int budget = 7000;        ///< vertices of one polytope
  double tolerance = 3e-3;  ///< upper/lower - 1 below which little more is sought
  /// Called with what is done next, if given.
  std::function<void(const std::string&)> progress = {};
  /// If given, nothing is asked but whether ρ is below this: `upper` is brought below it or left
  /// coarse, and left coarse at once where `lower` comes near it.
  std::optional<double> target = {};
  /// Asks for the end of the search: what was reached is given, all of it proved.
  Stop stop = {};
};

struct JointSpectralRadius {
  struct Block {
    int size = 0;
    double lower = 0;  ///< of the block's own ρ; rounded, not proved, but in the block that leads
    double upper = 0;  ///< proved: of the block's ρ, or of that of all where this is smaller
    int vertices = 0;  ///< of the largest polytope made; 0 where size is 1
    bool irreducible = false;
  };
  double lower = 0;
  double upper = 0;
  /// The matrices of the product with the greatest spectral radius found, first factor first;
  /// ρ ≥ |an eigenvalue of it|^(1/length). Empty where ρ = 0.
  std::vector<int> product;
  std::optional<Rational> eigenvalue;  ///< of the product, where it is rational
  bool exact = false;  ///< ρ is |eigenvalue|^(1/length), or 0: all blocks of size 1
  std::vector<Block> blocks;
  bool time_ended = false;  ///< `stop` asked for an end: more time would narrow the bracket
};

/// Precondition: at least one matrix, all square and of one size ≥ 1. Deterministic.
[[nodiscard]] JointSpectralRadius enclose_joint_spectral_radius(
    const std::vector<RationalMatrix>& matrices, const JointSpectralRadiusOptions& options = {});

}  // namespace limn
