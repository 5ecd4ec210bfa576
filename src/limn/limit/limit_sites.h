#pragma once
/// Which vertices of a mesh have a neighbourhood of standard form, and refinement of the others'
/// surroundings until they have. Private to limit_points.

#include "limn/limit/limit_points.h"
#include "limn/mesh/pattern.h"
#include "limn/refine/rule_tables.h"

namespace limn::limit {

/// A vertex whose limit is sought, or (dual splits) a face, named by a half-edge.
struct LimitSite {
  Index result;            ///< where the limit goes
  Index at;                ///< vertex, or half-edge of the face
  bool has_limit = false;  ///< found already: only a curvature is still sought
};

/// Faces round some sites, refined once, and where the sites are there. Values are points or linear
/// forms.
template <class Value>
struct LimitPatch {
  Mesh mesh;
  std::vector<Value> values;
  std::vector<LimitSite> sites;
};

/// The sites of these vertices, isolated ones left out, in the mesh itself; not for dual splits.
[[nodiscard]] std::vector<LimitSite> limit_sites(const Mesh& mesh,
                                                 const std::vector<Index>& vertices);

/// Whether one of a vertex's triangles has an edge on the boundary: where such edges are cut in
/// three, the triangle's centroid is left out, and even an inner vertex gets other neighbours.
[[nodiscard]] bool beside_boundary_edge(const Mesh& mesh, Index vertex);

/// The whole mesh of a dual split after one step, its number `step`, and the vertices' sites there.
template <class Value>
[[nodiscard]] Result<LimitPatch<Value>> dual_patch(const Scheme& scheme, const Mesh& mesh,
                                                   const std::vector<Value>& values,
                                                   const std::vector<Index>& vertices, int step,
                                                   refine::RuleTables<double>& tables);

/// The faces within `rings` rings of the sites after one step, its number `step`.
template <class Value>
[[nodiscard]] Result<LimitPatch<Value>> refined_patch(const Scheme& scheme, const Mesh& mesh,
                                                      const std::vector<Value>& values,
                                                      const std::vector<LimitSite>& sites,
                                                      int rings, int step,
                                                      refine::RuleTables<double>& tables);

}  // namespace limn::limit
