#pragma once
/// One step of a star, sector by sector, with the weights of its centre as names: what the
/// frequency blocks of every valence are made of. Private to frequency_blocks and eigen_formula.

#include <functional>
#include <optional>
#include <vector>

#include "limn/refine/weight_form.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn::spectrum {

/// The cases of the rules at the star's centre that apply at one valence; nullptr: none does.
using CenterCases = std::vector<const RuleCase*>;

/// The rules of a star's centre, or that are seen from it: vertex, edge-end and face-end; or
/// corner. Not of a scheme of stages: of that it is the case of its pairs of averagings alone.
[[nodiscard]] std::vector<RuleKind> center_rules(const Split& split);
[[nodiscard]] Result<CenterCases> center_cases(const Scheme& scheme, int n);

/// A weight of the rules at the centre: of a position, times `share`; of all n positions of a
/// repeated role. Or one weight of a regular rule.
struct NamedWeight {
  RuleKind kind;
  const Weight* weight;
  Rational share;
  bool repeated;
  bool per_sector;  ///< weighs a position in each sector, so that it comes n times
  /// Of a regular rule its n (0 where it has none) and, of a repeated role, its k.
  std::optional<int> regular = std::nullopt;
  std::optional<int> k = std::nullopt;
};

/// Which weights of the regular rules are names too; the others are 0. Nothing: none is a name, all
/// are numbers.
using RegularNames = std::function<bool(const NamedWeight&)>;

inline constexpr int kCenter = -1;  ///< in place of an orbit's number

/// coefficient · product of named weights · X_column, in the row of an orbit; the column's point
/// lies `angle` sectors on from the row's.
struct SectorTerm {
  int row, column;
  double angle;
  double coefficient;
  std::vector<int> names;  ///< that are not repeated
  /// A repeated name, or -1: the term is then a sum over its positions k, each `slope`·k sectors
  /// on.
  int repeated = -1;
  int slope = 0;
  bool every_sector = false;  ///< the same for the column's points in all n sectors (then slope 0)
};

struct SectorPattern {
  int rings = 0;
  std::vector<Orbit> orbits;
  bool has_center = false;
  std::vector<NamedWeight> names;
  std::vector<SectorTerm> terms;
};

/// How many rings control the limit surface on the faces round the centre.
[[nodiscard]] Result<int> control_rings(const Scheme& scheme, const CenterCases& cases,
                                        const RegularNames& named = {});

/// Fails where the rings are not invariant.
[[nodiscard]] Result<SectorPattern> sector_pattern(const Scheme& scheme, const CenterCases& cases,
                                                   int rings, const RegularNames& named = {});

}  // namespace limn::spectrum
