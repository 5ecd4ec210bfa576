#pragma once
/// How smooth a scheme is on the regular lattice, with proof.
///
/// The refined data S^n f have differences of order k whose growth is the joint spectral radius ρ of
/// finitely many matrices: the transition operators, one for each digit, on the smallest space of
/// sequences that holds the differences of order k of the unit impulse and that they map to
/// itself (transition_operators.h). With k the order of the sum rules, the limit functions have
/// the Hölder exponent -log ρ / log √|det M| at least, and exactly that where the shifts of φ are
/// stable [DynLevin2002; Jia1999; Han2003]. Hölder exponents are Zygmund's: α = r + s, 0 < s ≤ 1,
/// says that the derivatives of order r have differences, of the second order where s = 1, that
/// shrink like |h|^{s'} for every s' < s.
///
/// ρ lies between the spectral radius of one product and a norm (joint_spectral_radius.h), after
/// common invariant subspaces have been split off exactly. All that is called proved rests on exact
/// rationals or on doubles rounded outwards.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/truth.h"
#include "limn/regular/polynomial_orders.h"

namespace limn {

struct RegularityOptions {
  /// Work for each irreducible block, in vertices of the polytope whose norm bounds it. The
  /// bracket reached is given where that does not suffice for `tolerance`.
  int budget = 2000;
  /// Width of the Hölder bracket below which no more is sought.
  double tolerance = 1e-3;
  /// How many steps of the difference schemes are tried for a norm below 1.
  int most_steps = 5;
};

/// One irreducible block of the transition operators.
struct RegularityBlock {
  int size = 0;
  double lower = 0;  ///< of the joint spectral radius
  double upper = 0;
  int vertices = 0;  ///< of the polytope that proves `upper`; 0: the block is of size 1, or bounded
                     ///< by a norm of matrices
};

struct HolderBracket {
  double lower = 0;             ///< proved for every limit function
  std::optional<double> upper;  ///< nothing where stability is not proved
  double joint_spectral_radius_lower = 0;
  double joint_spectral_radius_upper = 0;
  /// The digits of the product whose spectral radius, by the root of its length, is the lower bound
  /// of the joint spectral radius; empty where that is 0.
  std::vector<LatticeVector> product;
  /// An eigenvalue of that product where it is rational, so that the upper end is exact.
  std::optional<Rational> eigenvalue;
  std::vector<RegularityBlock> blocks;  ///< in the order of the split
  std::string lower_reason, upper_reason;
};

/// Whether all limit functions are r times continuously differentiable.
struct Smoothness {
  Truth verdict = Truth::undecided;
  /// ‖(S_r)^power‖∞ ≤ norm < 1 for the r times divided difference scheme S_r, rounded up; 0: no
  /// such power was found among the steps tried (the proof, if there is one, is then the bracket).
  int power = 0;
  double norm = 0;
  std::string reason;
};

struct Regularity {
  PolynomialOrders orders;
  HolderBracket holder;
  std::array<Smoothness, 3> smoothness;  ///< C0, C1, C2
  /// Whether the shifts of φ are stable: yes where proved, else undecided.
  Truth stable = Truth::undecided;
  std::string stability_reason;
};

/// Brackets the regularity of a mask. Deterministic. Cost: seconds at the default options for masks
/// up to radius 3. Fails where the cosets of the mask do not sum to 1, and where the matrices would
/// have more than 400 rows.
[[nodiscard]] Result<Regularity> enclose_regularity(const Mask& mask,
                                                    const RegularityOptions& options = {});

}  // namespace limn
