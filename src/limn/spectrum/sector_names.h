#pragma once
/// Names for the weights of a star: what it is refined with once for all valences. Private to
/// sector_pattern.

#include <algorithm>
#include <memory>
#include <vector>

#include "limn/refine/rule_tables.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn::spectrum {

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

  refine::Row<refine::WeightForm> row(const RuleCase* rule_case, RuleKind kind, Lattice lattice) {
    refine::Row<refine::WeightForm> row;
    if (rule_case == nullptr) return row;
    const auto program =
        std::make_shared<refine::Program>(refine::compile(*rule_case, kind, lattice));
    for (const refine::Step& step : *program) {
      const bool repeated = step.walk.repeated;
      const int name = static_cast<int>(names.size());
      names.push_back({kind, step.weight, step.share, repeated, step.per_sector});
      for (int k = 0; k < (repeated ? kSectors : 1); ++k) {
        row.weights.push_back(refine::WeightForm::name(static_cast<int>(positions.size())));
        positions.push_back({name, repeated ? k : -1});
      }
    }
    row.program = program;
    return row;
  }

  /// A row of a scheme of stages: `pair` is the case of its pairs of averagings at the centre.
  refine::Row<refine::WeightForm> stage_row(const Stages& stages, const RuleCase& pair,
                                            RuleKind kind) {
    if (sectors_name_ < 0) {
      static const Weight sectors{"sectors", {}, {Expression::parse("n").value(), {}}};
      sectors_name_ = add(RuleKind::vertex, sectors, false);
    }
    refine::Row<refine::WeightForm> row;
    if (kind == RuleKind::face) row.weights.push_back(stage_form(kind, stages.corner, true));
    if (kind != RuleKind::vertex) return row;
    row.weights.resize(kPairRoles.size());
    for (const Weight& weight : pair.weights) {
      const PairRole role = pair_role(weight);
      row.weights[static_cast<std::size_t>(role)] =
          stage_form(kind, weight, role != PairRole::self);
    }
    return row;
  }
  /// The name of the number of sectors, where rows are those of stages; else -1.
  [[nodiscard]] int sectors_name() const { return sectors_name_; }

  /// A row of a regular rule.
  Result<refine::Row<refine::WeightForm>> regular_row(const Scheme& scheme, RuleKind kind, int n,
                                                      const RegularNames& named) {
    const Result<const RuleCase*> rule_case = scheme::applicable_case(scheme, kind, n);
    if (!rule_case) return rule_case.error();
    refine::Row<refine::WeightForm> row;
    if (*rule_case == nullptr) {
      if (stands_in_for(kind, *scheme.split)) return row;
      return scheme::missing_rule(scheme, kind, n);
    }
    const auto program = std::make_shared<refine::Program>(
        refine::compile(**rule_case, kind, scheme.split->lattice));
    for (const refine::Step& step : *program)
      for (int k = 0; k < (step.walk.repeated ? n : 1); ++k) {
        NamedWeight name{kind, step.weight, step.share, false, false, n, std::nullopt};
        if (step.walk.repeated) name.k = k;
        row.weights.push_back(named(name) ? form_of(name) : refine::WeightForm());
      }
    row.program = program;
    return row;
  }

 private:
  int add(RuleKind kind, const Weight& weight, bool per_sector) {
    names.push_back({kind, &weight, 1, false, per_sector});
    return static_cast<int>(names.size()) - 1;
  }
  refine::WeightForm stage_form(RuleKind kind, const Weight& weight, bool per_sector) {
    positions.push_back({add(kind, weight, per_sector), -1});
    return refine::WeightForm::name(static_cast<int>(positions.size()) - 1);
  }

  refine::WeightForm form_of(const NamedWeight& name) {
    const auto same = std::find_if(names.begin(), names.end(), [&](const NamedWeight& other) {
      return other.weight == name.weight && other.share == name.share &&
             other.regular == name.regular && other.k == name.k;
    });
    if (same == names.end()) {
      names.push_back(name);
      positions.push_back({static_cast<int>(names.size()) - 1, -1});
      return refine::WeightForm::name(static_cast<int>(positions.size()) - 1);
    }
    const int number = static_cast<int>(same - names.begin());
    const auto position = std::find_if(positions.begin(), positions.end(),
                                       [&](const Position& p) { return p.name == number; });
    return refine::WeightForm::name(static_cast<int>(position - positions.begin()));
  }

  int sectors_name_ = -1;
};

}  // namespace limn::spectrum
