#include "limn/limit/limit_kinds.h"

#include <algorithm>

#include "limn/mesh/lattice.h"
#include "limn/refine/star_step.h"
#include "limn/scheme/seen_from.h"

namespace limn {

SharedSites::SharedSites(const Mesh& mesh, std::vector<LimitSite>& sites) {
  std::vector<Index> result_at(static_cast<std::size_t>(mesh.face_count()), kNone);
  std::size_t kept = 0;
  for (const LimitSite& site : sites) {
    Index& result = result_at[static_cast<std::size_t>(mesh.face(site.at))];
    if (result != kNone) {
      others_[result].push_back(site.result);
      continue;
    }
    result = site.result;
    sites[kept++] = site;
  }
  sites.resize(kept);
}

bool LimitKinds::at_boundary(const Mesh& mesh, Index at) const {
  return !scheme_.split->is_dual() && mesh.is_boundary_vertex(at);
}

/// Edges at an interior vertex, corners of a face, or faces at a boundary vertex.
int LimitKinds::size_of(const Mesh& mesh, Index at) const {
  if (scheme_.split->is_dual()) return mesh.degree(mesh.face(at));
  return mesh.valence(at) - (mesh.is_boundary_vertex(at) ? 1 : 0);
}

Status LimitKinds::prepare(const Mesh& mesh, std::vector<LimitSite>& sites,
                           std::vector<LimitPoints::Refused>* refused, const SharedSites& shared) {
  std::size_t kept = 0;
  for (const LimitSite& site : sites) {
    const bool boundary = at_boundary(mesh, site.at);
    const int size = size_of(mesh, site.at);
    const Result<const LimitKind*> kind = find(boundary, size);
    if (kind) {
      sites[kept++] = site;
      continue;
    }
    Error error = kind.error();
    if (refused != nullptr && check_rules(boundary, size)) {
      refused->push_back({site.result, error.message});
      for (const Index v : shared.others(site.result)) refused->push_back({v, error.message});
      continue;
    }
    error.message = fmt::format("vertex {}: {}", site.result, error.message);
    return error;
  }
  sites.resize(kept);
  return Done{};
}

Result<const LimitKind*> LimitKinds::find(bool boundary, int size) {
  std::map<int, Result<LimitKind>>& kinds = kinds_[boundary ? 1 : 0];
  auto found = kinds.find(size);
  if (found == kinds.end()) found = kinds.emplace(size, make(boundary, size)).first;
  if (!found->second) return found->second.error();
  return &*found->second;
}

Status LimitKinds::check_rules(bool boundary, int size) const {
  const auto check = [&](RuleKind kind, int n) -> Status {
    const Result<Row<double>> row = tabulate_row<double>(scheme_, kind, n);
    if (!row) return row.error();
    return Done{};
  };
  const Split& split = *scheme_.split;
  if (split.is_dual())
    return split.births.corners ? check(RuleKind::corner, size) : check(RuleKind::edge, 0);
  if (!boundary) return check(RuleKind::vertex, size);
  if (Status status = check(RuleKind::boundary_vertex, size + 1); !status) return status;
  const bool thirds = split.births.thirds || split.odd_step_cut == 3;
  return thirds ? check(RuleKind::boundary_edge_end, size + 1) : check(RuleKind::boundary_edge, 0);
}

Pattern LimitKinds::pattern(bool boundary, int size, int shape) const {
  const Split& split = *scheme_.split;
  if (boundary) return {fan(split.lattice, size, shape), fan_size(split.lattice, size, shape - 1)};
  return {split_star(split, size, shape), split_star_size(split, size, shape - 1)};
}

Result<LimitKind> LimitKinds::make(bool boundary, int size) {
  if (Status status = check_rules(boundary, size); !status) return status.error();
  Result<LimitStencil> limit = boundary ? approx_boundary_limit_stencil(scheme_, size)
                                        : approx_limit_stencil(analysis_, size);
  if (!limit) return limit.error();
  // What is inside must be regular: rules that are seen from an end or a corner see one ring
  // farther; and of a cropped star the corners, which have rules, count to the ring beyond.
  const int corners = boundary ? 0 : least_star_rings(*scheme_.split) - 1;
  const int more = (has_rules_seen_from(scheme_) ? 1 : 0) + corners;
  const int shape = limit->rings + more;
  rings_ = std::max(rings_, limit->rings);
  LimitKind kind{std::move(*limit), shape, pattern(boundary, size, shape), {}, {}};
  if (!curvatures_) return kind;
  kind.no_curvature = NoCurvature::boundary;
  if (boundary) return kind;
  // what is not known of the curvature takes nothing from the limit
  kind.no_curvature = NoCurvature::unknown;
  Result<VertexCurvature> curvature = approx_curvature_stencil(scheme_, analysis_, size);
  if (!curvature) return kind;
  kind.no_curvature = curvature->missing;
  if (!curvature->stencil) return kind;
  const int rings = std::max(kind.limit.rings, curvature->stencil->rings);
  rings_ = std::max(rings_, rings);
  kind.curvature =
      LimitKind::Curved{*std::move(curvature->stencil), pattern(boundary, size, rings + more)};
  return kind;
}

}  // namespace limn
