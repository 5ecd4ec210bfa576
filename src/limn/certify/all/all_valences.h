#pragma once
/// That a scheme is C1 at extraordinary vertices of every valence n ≥ N: with t = 1/n everything
/// is a function of t alone, and a finite cover of 0 … 1/N decides [PetersReif2008, ch. 5].
///
/// On an interval of t: the leading eigenvalue μ1 of frequency 1 and its eigenvector in the
/// coordinates (Re, Im/θ), θ = 2πt, are enclosed, and the other eigenvalues of frequency 1 and
/// those of frequency 0 are smaller; the Jacobian of the characteristic map has one sign on half a
/// sector of a ring of cells, and the map of it lies in a half-plane, so that the ring winds once
/// round 0. On an interval of the turn θ' = 2πω/n, 2 ≤ ω ≤ n/2: either all eigenvalues are
/// smaller than every μ1; or all but one are, and that one falls as θ' grows, so that of all
/// frequencies the first leads.

#include <string>
#include <vector>

#include "limn/base/budget.h"
#include "limn/base/rational.h"
#include "limn/base/truth.h"
#include "limn/certify/lattice/contraction.h"
#include "limn/scheme/scheme.h"

namespace limn::certify {

/// What is shown for all t = 1/n in begin … end. Numbers are rounded: the check encloses what is
/// near them.
struct ValenceInterval {
  Rational begin, end;
  double eigenvalue = 0;
  std::vector<double> eigenvector;  ///< real basis, imaginary parts over θ
  int squarings = 0;                ///< of the other eigenvalues of frequency 1
  std::vector<int> special;         ///< of frequencies 2, 3, … whose weights are others
  /// Of frequency 0 without 1; -1: its next eigenvalue, below, tends to μ1 as n → ∞.
  int constant_squarings = 0;
  double cup = 0;
  std::vector<double> cup_vector;  ///< left, of the orbits' real parts
  int cup_squarings = 0;           ///< of the others
  int odd_squarings = 0;           ///< of those on imaginary parts
  /// Of each cell of the ring (ring_cells.h) the parts it was cut into: words of digits, "" the
  /// whole cell.
  std::vector<std::vector<std::string>> parts;
};

/// What is shown for all θ'² in π²begin … π²end.
struct TurnInterval {
  Rational begin, end;
  int squarings = 0;  ///< of all eigenvalues, or of all but the one that falls
  double eigenvalue = 0;
  std::vector<double> right, left;  ///< its eigenvectors; empty: none is apart
};

/// Valences for which it is not shown, and why.
struct UncoveredValences {
  long long first = 0;
  long long last = 0;  ///< 0: all from `first` on
  std::string reason;
};

struct AllValences {
  int from = 0;  ///< N
  Truth c1 = Truth::undecided;
  std::string reason;                        ///< where it is not yes
  std::vector<ValenceInterval> intervals;    ///< t ascending; every valence but those uncovered
  std::vector<TurnInterval> turns;           ///< from 0 to 1
  std::vector<UncoveredValences> uncovered;  ///< descending
};

/// The least N, 7 … 60, from which on the centre's rules are one formula in n that a proof can use:
/// where guards no longer change. Fails where there is none, with the reason at 60.
[[nodiscard]] Result<int> first_of_all_valences(const Scheme& scheme);

/// Searches for a proof for all valences n ≥ `from` > 6. The scheme's regular part is taken as
/// proved: `bounds` are those of `cells`. Cost: seconds.
[[nodiscard]] AllValences certify_all_valences(const Scheme& scheme, const CellMatrices& cells,
                                               const Contraction& bounds, int from,
                                               const Stop& stop = {});

/// Whether `claim` proves what it says, c1 = yes, without a search; the error is the first fault.
[[nodiscard]] Status check_all_valences(const Scheme& scheme, const CellMatrices& cells,
                                        const Contraction& bounds, const AllValences& claim);

}  // namespace limn::certify
