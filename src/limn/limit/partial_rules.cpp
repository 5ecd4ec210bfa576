#include "limn/limit/partial_rules.h"

#include <limits>
#include <memory>

#include <fmt/core.h>

namespace limn::limit {

PartialRules::PartialRules(const Scheme& scheme, refine::Boundary boundary)
    : tables_(scheme, boundary, [this, &scheme](RuleKind kind, int n, std::optional<int> quads) {
        return row(scheme, kind, n, quads);
      }) {}

Result<refine::Row<double>> PartialRules::row(const Scheme& scheme, RuleKind kind, int n,
                                              std::optional<int> quads) {
  Result<refine::Row<double>> row = refine::tabulate_row<double>(scheme, kind, n, quads);
  if (row) return row;
  const bool inside = kind < RuleKind::boundary_vertex;
  if (!missing_ || (inside && !missing_inside_)) {
    missing_ = row.error();
    missing_inside_ = inside;
  }
  refine::Row<double> unknown;
  unknown.program = std::make_shared<refine::Program>(1);  // a value of the anchor's own
  unknown.weights.assign(scheme.stages ? kPairRoles.size() : 1,
                         std::numeric_limits<double>::quiet_NaN());
  return unknown;
}

Error PartialRules::error_at(Index vertex) const {
  Error error = *missing_;
  error.message = fmt::format("vertex {}: its limit depends on {}, where {}", vertex,
                              missing_inside_ ? "a place" : "the boundary", error.message);
  return error;
}

}  // namespace limn::limit
