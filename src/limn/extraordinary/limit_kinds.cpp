#include "limn/extraordinary/limit_kinds.h"

#include <algorithm>

#include "limn/mesh/lattice.h"
#include "limn/refine/star_step.h"

namespace limn {

bool LimitKinds::at_boundary(const Mesh& mesh, Index at) const {
  return !scheme_.split->births_corners && mesh.is_boundary_vertex(at);
}

/// Edges at an interior vertex, corners of a face, or faces at a boundary vertex.
int LimitKinds::size_of(const Mesh& mesh, Index at) const {
  if (scheme_.split->births_corners) return mesh.degree(mesh.face(at));
  return mesh.valence(at) - (mesh.is_boundary_vertex(at) ? 1 : 0);
}

Status LimitKinds::prepare(const Mesh& mesh, const std::vector<LimitSite>& sites) {
  for (const LimitSite& site : sites) {
    Result<const LimitKind*> kind = find(at_boundary(mesh, site.at), size_of(mesh, site.at));
    if (kind) continue;
    kind.error().message =
        fmt::format("vertex {}: {}", site.result, std::move(kind.error().message));
    return kind.error();
  }
  return Done{};
}

Result<const LimitKind*> LimitKinds::find(bool boundary, int size) {
  std::map<int, LimitKind>& kinds = kinds_[boundary ? 1 : 0];
  auto found = kinds.find(size);
  if (found == kinds.end()) {
    Result<LimitKind> kind = make(boundary, size);
    if (!kind) return kind.error();
    found = kinds.emplace(size, std::move(*kind)).first;
  }
  return &found->second;
}

Result<LimitKind> LimitKinds::make(bool boundary, int size) {
  Result<LimitStencil> limit = boundary ? approx_boundary_limit_stencil(scheme_, size)
                                        : approx_limit_stencil(analysis_, size);
  if (!limit) return limit.error();
  std::optional<CurvatureStencil> curvature;
  if (curvatures_ && !boundary) {
    Result<std::optional<CurvatureStencil>> found =
        approx_curvature_stencil(scheme_, analysis_, size);
    if (!found) return found.error();
    curvature = std::move(*found);
  }
  const int rings = std::max(limit->rings, curvature ? curvature->rings : 0);
  rings_ = std::max(rings_, rings);
  // What is inside must be regular: rules that look from an edge's end see one ring farther.
  const int shape = rings + (scheme_.rule(RuleKind::edge_end) ? 1 : 0);
  const Split& split = *scheme_.split;
  Pattern pattern =
      boundary ? Pattern(fan(split.lattice, size, shape), fan_size(split.lattice, size, shape - 1))
               : Pattern(split_star(split, size, shape), split_star_size(split, size, shape - 1));
  return LimitKind{std::move(*limit), std::move(curvature), shape, std::move(pattern)};
}

}  // namespace limn
