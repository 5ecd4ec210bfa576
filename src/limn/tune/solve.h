#pragma once
/// All real values of a freed parameter or let at which an equation in the eigencomponents holds.
///
/// A label such as "cup" changes from one eigenvalue to another as x moves. So every real
/// eigenvalue of the sought label's block (sought_component) is tried in the label's place, and for
/// each root found it is said whether the label holds there: at valence 3 of √3 an eigenvalue of
/// the centre equals tangent² at alpha = 5/9, but one of an outer ring leads there and is the cup.
///
/// The search samples the range evenly and follows the eigenvalues of each ring in the order of
/// their size: changes of sign are bisected, least distances from 0 are minimised, so that double
/// roots are found. Two roots of one eigenvalue nearer than a sample's width, without a visible
/// least distance between them, may be missed: absence is found, not proved.

#include <optional>
#include <string>
#include <vector>

#include "limn/base/budget.h"
#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/base/truth.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/tune/freed_scheme.h"

namespace limn {

/// A value of the freed name that solves the equation.
struct Solution {
  double value = 0;     ///< x
  double residual = 0;  ///< |left - right| at `value` for the eigenvalue tried
  /// near_rational that solves as well as `value` does; recognised, not proved.
  std::optional<Rational> rational;
  bool is_double = false;          ///< the two sides touch and do not cross
  Eigenvalue eigenvalue;           ///< that solves; frequency 0 and value 1 where none is sought
  Truth holds = Truth::undecided;  ///< with the labels as they are at `value`
  std::string reason;              ///< why not
  Eigencomponents found;           ///< at `value`
};

/// What `solve_at` finds at one valence.
struct ValenceSolutions {
  int valence = 0;    ///< n
  Interval searched;  ///< where was looked
  int samples = 0;    ///< even ones, before those that were added
  /// Whether the equation has a value anywhere there: at valence 3 none with a saddle has.
  bool has_value = true;
  std::vector<Solution> solutions;  ///< ascending
  /// Where it holds throughout: at two samples in a row or more, to kEqualBelow.
  std::vector<Interval> throughout;
  /// Why there is no solution: nothing where there is one.
  std::string reason;
  bool time_ended = false;  ///< the search was stopped: nothing above is complete
};

/// A residual up to this is a solution.
inline constexpr double kSolved = 1e-12;
/// A residual from kSolved up to this may be a solution that rounding hides: it is given,
/// undecided.
inline constexpr double kUndecidedResidual = 1e-8;

/// At valence n. Residuals of simple roots reach 1e-14 and less, in double. Cost: 1025 samples (257
/// where no quick reading of the blocks exists), each at most three small eigenvalue problems.
/// Fails where the range is empty and where the scheme has no blocks at any sample.
[[nodiscard]] Result<ValenceSolutions> solve_at(FreedScheme& scheme, const Requirement& requirement,
                                                int n, const SearchRange* range = nullptr,
                                                const Stop& stop = {});

// The values of a freed parameter or let at which an inequality or a verdict holds.

/// One end of a part: a value, and what stops the requirement there.
struct RangeEnd {
  double value = 0;                  ///< x
  std::optional<Rational> rational;  ///< that `value` stands for; recognised, not proved
  bool of_search = false;  ///< the searched range ends here, the requirement may hold beyond
  std::string reason;      ///< what fails just beyond; empty where `of_search`
};

/// An interval on which the requirement holds.
struct RangePart {
  RangeEnd low;   ///< lower end
  RangeEnd high;  ///< upper end, low.value ≤ high.value
};

/// What `range_at` finds at one valence.
struct ValenceRange {
  int valence = 0;               ///< n
  Interval searched;             ///< where was looked
  int samples = 0;               ///< even ones; 0: the regular lattice decides for every x
  bool closed = false;           ///< ends belong to it; those of the search always do
  std::vector<RangePart> parts;  ///< ascending, apart
  /// Whether some of it is undecided: what the regular lattice allows is not known at two samples
  /// in a row where the eigenvalues would do. Such x are in no part.
  bool undecided = false;
  std::string reason;       ///< why there is no part; nothing where there is one
  bool time_ended = false;  ///< the search was stopped: nothing above is complete
  long long solved = 0;     ///< eigenvalue problems that it took
};

/// At valence n: the range is sampled evenly, least failures are looked at closely, and ends are
/// bisected, to rounding; but where a requirement that allows equality (is_closed) holds with
/// equality all along, its end is where it fails by kEqualBelow. Parts narrower than a sample's
/// width may be missed where no sample comes near them; the same goes for gaps. Cost: 257 samples,
/// each with the eigenvalues of the blocks that x changes and that may lead (an upper bound of
/// their moduli tells). Fails as solve_at does.
[[nodiscard]] Result<ValenceRange> range_at(FreedScheme& scheme, const Requirement& requirement,
                                            int n, const SearchRange* range = nullptr,
                                            const Stop& stop = {});

/// Where it holds at every one of these valences at the same time: intervals, ascending and apart;
/// none where there is no such x, or `ranges` is empty.
[[nodiscard]] std::vector<Interval> common_range(const std::vector<ValenceRange>& ranges);

}  // namespace limn
