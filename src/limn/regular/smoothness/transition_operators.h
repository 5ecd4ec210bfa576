#pragma once
/// The transition operators of a mask: for each digit ε, a member of each class of Z² modulo M Z²,
/// (T_ε v)(i) = Σ_l a(ε + M i - l) v(l) on finite sequences. A difference v of the unit impulse
/// refined n times is (v * Sⁿδ)(ε_1 + M ε_2 + … + Mⁿ i) = (T_{ε_n} … T_{ε_1} v)(i), so that
/// products of the operators tell how fast differences shrink [CDM; Jungers2009 §5].

#include <limits>
#include <vector>

#include "limn/regular/algebra/invariant_subspaces.h"
#include "limn/scheme/mask.h"

namespace limn::regular {

/// The mask by whole offsets: those of dual masks are moved by half a refined edge along both
/// axes, which moves φ and changes nothing else.
[[nodiscard]] Laurent integer_offsets(const Mask& mask);

struct TransitionOperators {
  std::vector<LatticeVector> digits;   ///< cosets(M)
  std::vector<LatticeVector> support;  ///< Ω: sequences on it are mapped to such by each T_ε
  std::vector<RationalMatrix> on_differences;  ///< T_ε on D, in some basis of it, digit by digit
};

/// D: the sequences on Ω that are orthogonal to all polynomials of degree < order, which are the
/// combinations, within Ω, of differences of that order. Ω is a set that every difference of that
/// order of the unit impulse is carried into; so the joint spectral radius on D is the growth of
/// the differences of S^n f. Fails where the order is greater than that of the sum rules (D is not
/// invariant then), and where Ω has more than 400 points.
[[nodiscard]] Result<TransitionOperators> transition_operators(const Mask& mask, int order);

/// The differences of an order along e1 and e2 of the unit impulse, or along other directions:
/// Π (1 - z^d) for each choice, with repetition, of `order` of the directions d, none of them more
/// than `most_alike` times.
[[nodiscard]] std::vector<Laurent> unit_differences(
    const std::vector<LatticeVector>& directions, int order,
    int most_alike = std::numeric_limits<int>::max());

/// T_digit v for a finite sequence; `a` as from integer_offsets.
[[nodiscard]] Laurent transition(const Laurent& a, const LatticeMatrix& dilation,
                                 LatticeVector digit, const Laurent& v);

}  // namespace limn::regular
