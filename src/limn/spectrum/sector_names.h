#pragma once
/// Names for the weights of a star: what it is refined with once for all valences. Private to
/// sector_pattern.

#include <algorithm>
#include <memory>
#include <vector>

#include "limn/refine/rule_tables.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn {

/// Sectors of the star that is refined: no regular valence, and wide enough that stencils at the
/// centre's neighbours do not meet round it.
inline constexpr int kSectors = 13;

/// Names given to the weights at the centre, and which of them a repeated role's positions are.
class Namer {
 public:
  std::vector<NamedWeight> names;
  struct Position {
    int name;
    int k;  // -1: not of a repeated role
  };
  std::vector<Position> positions;  // by WeightForm's index

  Row<WeightForm> row(const RuleCase* rule_case, RuleKind kind, Lattice lattice) {
    Row<WeightForm> row;
    if (rule_case == nullptr) return row;
    const auto program = std::make_shared<Program>(compile(*rule_case, kind, lattice));
    for (const Step& step : *program) {
      const bool repeated = step.walk.repeated;
      const int name = static_cast<int>(names.size());
      names.push_back({kind, step.weight, step.share, repeated, step.per_sector});
      for (int k = 0; k < (repeated ? kSectors : 1); ++k) {
        row.weights.push_back(WeightForm::name(static_cast<int>(positions.size())));
        positions.push_back({name, repeated ? k : -1});
      }
    }
    row.program = program;
    return row;
  }

  /// The mean over the sectors, in a scheme of stages.
  Row<WeightForm> mean_row(const Stages& stages) {
    Row<WeightForm> row;
    row.weights.push_back(WeightForm::name(static_cast<int>(positions.size())));
    positions.push_back({static_cast<int>(names.size()), -1});
    names.push_back({.kind = RuleKind::face,
                     .weight = &stages.mean,
                     .share = 1,
                     .repeated = false,
                     .per_sector = true,
                     .mean = true});
    return row;
  }

  /// A row of a regular rule.
  Result<Row<WeightForm>> regular_row(const Scheme& scheme, RuleKind kind, int n,
                                      const RegularNames& named) {
    const Result<const RuleCase*> rule_case = applicable_case(scheme, kind, n);
    if (!rule_case) return rule_case.error();
    Row<WeightForm> row;
    if (*rule_case == nullptr) {
      if (stands_in_for(kind, *scheme.split)) return row;
      return missing_rule(scheme, kind, n);
    }
    const auto program =
        std::make_shared<Program>(compile(**rule_case, kind, scheme.split->lattice));
    for (const Step& step : *program)
      for (int k = 0; k < (step.walk.repeated ? n : 1); ++k) {
        NamedWeight name{kind, step.weight, step.share, false, false, n, std::nullopt};
        if (step.walk.repeated) name.k = k;
        row.weights.push_back(named(name) ? form_of(name) : WeightForm());
      }
    row.program = program;
    return row;
  }

 private:
  WeightForm form_of(const NamedWeight& name) {
    const auto same = std::find_if(names.begin(), names.end(), [&](const NamedWeight& other) {
      return other.weight == name.weight && other.share == name.share &&
             other.regular == name.regular && other.k == name.k;
    });
    if (same == names.end()) {
      names.push_back(name);
      positions.push_back({static_cast<int>(names.size()) - 1, -1});
      return WeightForm::name(static_cast<int>(positions.size()) - 1);
    }
    const int number = static_cast<int>(same - names.begin());
    const auto position = std::find_if(positions.begin(), positions.end(),
                                       [&](const Position& p) { return p.name == number; });
    return WeightForm::name(static_cast<int>(position - positions.begin()));
  }
};

}  // namespace limn
