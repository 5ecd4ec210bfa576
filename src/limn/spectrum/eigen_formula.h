#pragma once
/// Eigenvalues at extraordinary vertices as closed formulas in the valence n, the frequency omega
/// and the scheme's parameters [BGSK §3-4].
///
/// The star is refined once with all weights as names (sector_pattern.h); evaluated as formulas
/// they make the block of a frequency, entry by entry, whose characteristic polynomial is factored
/// over the rationals with n, the parameters and one cosine for each angle as independent
/// indeterminates.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/closed_root.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// An eigenvalue. The text is an expression as scheme files write them, in n, the frequency and
/// the parameters.
struct EigenFormula {
  /// The least number of rings that are invariant by themselves and have it. At single frequencies
  /// (the butterfly's omega = 3 at n = 6) phases may cancel, so that fewer do.
  int ring = 0;
  ClosedRoot root;  ///< the eigenvalue and its multiplicity in the block
  /// The same with the scheme's lets as names, where that is shorter: "5/8 - n*beta".
  std::optional<ClosedRoot> by_lets;
};

/// What has no closed form: the roots of a polynomial of degree 3 or more.
struct EigenEquation {
  int ring = 0;           ///< as in EigenFormula
  int degree = 0;         ///< in the unknown, at least 3
  ClosedRoot polynomial;  ///< in the unknown (EigenFormulas::unknown), equal to 0
};

/// The eigenvalues of one frequency, or of all from one on.
struct FrequencyFormulas {
  int frequency = 0;       ///< omega ≥ 0
  bool and_above = false;  ///< for every omega from `frequency` to n/2
  /// Ring after ring, largest modulus first where the parameters have their present values (and
  /// n is about 7): for others the order may be another.
  std::vector<EigenFormula> eigenvalues;
  std::vector<EigenEquation> left;  ///< eigenvalues without a closed form
};

/// Valences first … last; without last: every n from first on.
struct ValenceSpan {
  int first = 0;            ///< at least 3
  std::optional<int> last;  ///< included
};

/// One set of formulas, and the valences that it holds at.
struct ValenceFormulas {
  std::vector<ValenceSpan> valences;  ///< ascending, apart
  int rings = 0;                      ///< of the star whose matrix this is
  /// omega = 0, 1, …; frequencies beyond n/2 at a valence are not meant.
  std::vector<FrequencyFormulas> frequencies;
};

/// A parameter that depends on n has one value at the centre, and another one in the regular rules
/// round it, where it goes by the name `name`.
struct RegularName {
  std::string name;       ///< in the formulas
  std::string parameter;  ///< of the scheme
  int n = 0;              ///< the regular valence that it is meant at
};

/// What `eigen_formulas` finds.
struct EigenFormulas {
  std::vector<ValenceFormulas> valences;   ///< one entry for each set of formulas
  std::vector<RegularName> regular_names;  ///< that occur in the formulas
  std::string frequency =
      "omega";                     ///< its name in the formulas; another if the scheme has this one
  std::string unknown = "lambda";  ///< the same for the unknown of equations
};

/// Guards of rules are looked at up to this valence; what holds there is taken to hold beyond.
inline constexpr int kLargestGuardedValence = 100;

/// For every n that the scheme has rules for: one set of formulas for each set of rule cases that
/// applies at the centre of more than two valences, and one each for the valences that are left.
/// Parameters stay names, but for those in `evaluated`, whose values are put in; guards see their
/// present values. rings 0: as many as control the limit surface, whatever the parameters are.
///
/// Fails where limn was built without FLINT, where the rings are not invariant for every value of
/// the parameters, and where a weight has no such formula (n % 2) or no closed sum over k.
/// Cost: tens of milliseconds for most schemes, hundreds where edge rules hold parameters.
[[nodiscard]] Result<EigenFormulas> eigen_formulas(const Scheme& scheme,
                                                   const std::set<std::string>& evaluated = {},
                                                   int rings = 0);

}  // namespace limn
