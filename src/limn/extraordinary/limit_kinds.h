#pragma once
/// From the vertices of a mesh to where their limit stencils apply: what limit points and limit
/// forms share. Private to them.

#include <array>
#include <map>
#include <numeric>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/extraordinary/limit_curvature.h"
#include "limn/extraordinary/limit_sites.h"

namespace limn {

/// What is measured at vertices of one kind: their stencils, and where these apply.
struct LimitKind {
  LimitStencil limit;
  std::optional<CurvatureStencil> curvature;
  int shape = 0;  ///< rings that must be regular but for the vertex
  Pattern pattern;
};

/// The kinds of a scheme, found when they are met.
class LimitKinds {
 public:
  LimitKinds(const Scheme& scheme, bool curvatures)
      : scheme_(scheme), curvatures_(curvatures), analysis_(scheme) {}

  /// Finds those of the sites. Fails as the limit stencils do.
  Status prepare(const Mesh& mesh, const std::vector<LimitSite>& sites);
  /// At the boundary or not; of so many faces (dual splits: a face of so many corners).
  Result<const LimitKind*> find(bool boundary, int size);
  /// Of a site that is prepared for.
  [[nodiscard]] const LimitKind& at(const Mesh& mesh, Index at) const {
    return kinds_[at_boundary(mesh, at) ? 1 : 0].at(size_of(mesh, at));
  }
  [[nodiscard]] bool at_boundary(const Mesh& mesh, Index at) const;
  [[nodiscard]] int rings() const { return rings_; }  ///< of the widest of them

 private:
  [[nodiscard]] int size_of(const Mesh& mesh, Index at) const;
  [[nodiscard]] Result<LimitKind> make(bool boundary, int size);

  const Scheme& scheme_;
  bool curvatures_;
  FrequencyAnalysis analysis_;
  std::array<std::map<int, LimitKind>, 2> kinds_;  // interior, boundary; by size
  int rings_ = 1;
};

/// Calls apply(kind, mesh, values, start, neighbourhood, vertex) once for each vertex that is not
/// isolated, on several threads: on the mesh after as many steps as it takes until the vertex's
/// neighbourhood is of its kind; `start` is the half-edge from which the neighbourhood is numbered.
/// Fails as LimitKinds::prepare and `refine`, and where no few steps make it regular.
template <class Value, class Apply>
[[nodiscard]] Status for_each_limit(const Scheme& scheme, LimitKinds& kinds, const Mesh& control,
                                    const std::vector<Value>& control_values,
                                    const std::vector<Index>& vertices, const LimitOptions& options,
                                    Apply apply) {
  constexpr int kMostSteps = 12;  // until a neighbourhood is regular; each halves its faces
  constexpr int kMargin = 3;      // rings round a neighbourhood, so that a cut does not reach it
  const bool dual = scheme.split->births_corners;
  RuleTables<double> tables(scheme, options.boundary ? Boundary::refined : Boundary::left_out);
  int step = options.steps_made;
  LimitPatch<Value> patch;
  if (dual) {
    Result<LimitPatch<Value>> first =
        dual_patch(scheme, control, control_values, vertices, step++, tables);
    if (!first) return first.error();
    patch = std::move(*first);
  } else {
    patch.sites = limit_sites(control, vertices);
  }
  bool in_patch = dual;
  for (int round = 0; round < kMostSteps; ++round) {
    const Mesh& mesh = in_patch ? patch.mesh : control;
    const std::vector<Value>& values = in_patch ? patch.values : control_values;
    if (Status status = kinds.prepare(mesh, patch.sites); !status) return status;
    std::vector<char> done(patch.sites.size(), 0);
    const bool boundary_rests = scheme.split->trisects_boundary && step % 2 != 0;
    parallel_for(std::size_t{0}, patch.sites.size(), [&](std::size_t first, std::size_t last) {
      std::vector<Index> neighbourhood;
      for (std::size_t i = first; i < last; ++i) {
        const Index at = patch.sites[i].at;
        if (boundary_rests && beside_boundary_edge(mesh, at)) continue;
        const LimitKind& kind = kinds.at(mesh, at);
        const Index start = dual ? at : mesh.halfedge_of_vertex(at);
        if (!kind.pattern.match(mesh, start, neighbourhood)) continue;
        apply(kind, mesh, values, start, neighbourhood, patch.sites[i].result);
        done[i] = 1;
      }
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < patch.sites.size(); ++i)
      if (done[i] == 0) patch.sites[kept++] = patch.sites[i];
    patch.sites.resize(kept);
    if (patch.sites.empty()) return Done{};
    if (options.progress) options.progress(static_cast<int>(patch.sites.size()));
    Result<LimitPatch<Value>> next =
        refined_patch(scheme, mesh, values, patch.sites, kinds.rings() + kMargin, step++, tables);
    if (!next) return next.error();
    patch = std::move(*next);
    in_patch = true;
  }
  return Error{fmt::format("no limit points at vertex {}: after {} steps its surroundings are "
                           "still not regular",
                           patch.sites.front().result, kMostSteps),
               {},
               {},
               0,
               0};
}

}  // namespace limn
