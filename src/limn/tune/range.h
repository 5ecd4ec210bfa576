#pragma once
/// The values of a freed parameter or let at which an inequality or a verdict holds.

#include <optional>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/base/time_budget.h"
#include "limn/tune/freed_scheme.h"
#include "limn/tune/requirement.h"

namespace limn {

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
