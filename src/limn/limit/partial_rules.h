#pragma once
/// The rules of meshes cut out of others. Private to limits.

#include <optional>

#include "limn/refine/rule_tables.h"

namespace limn::limit {

/// The rules of a mesh that was cut out of another: one that is missing makes a value unknown (not
/// a number), as whether anything depends on it is not known beforehand. At the rim of the cut
/// nothing does.
class PartialRules {
 public:
  /// `scheme` must outlive them.
  PartialRules(const Scheme& scheme, refine::Boundary boundary);
  PartialRules(const PartialRules&) = delete;
  PartialRules& operator=(const PartialRules&) = delete;

  [[nodiscard]] refine::RuleTables<double>& tables() { return tables_; }
  [[nodiscard]] bool complete() const { return !missing_; }
  /// What is missing: the first, one of the interior before one of the boundary. Precondition: not
  /// complete.
  [[nodiscard]] const Error& missing() const { return *missing_; }
  /// At a vertex whose limit depends on what is missing.
  [[nodiscard]] Error error_at(Index vertex) const;

 private:
  Result<refine::Row<double>> row(const Scheme& scheme, RuleKind kind, int n,
                                  std::optional<int> quads);

  std::optional<Error> missing_;  // the first, one of the interior before one of the boundary
  bool missing_inside_ = false;
  refine::RuleTables<double> tables_;
};

}  // namespace limn::limit
