#pragma once
/// What a new vertex is born from, and what its rule looks at.

#include <set>

#include "limn/scheme/scheme.h"

namespace limn::fast {

/// What a new vertex is born from, as a half-edge: one out of the old vertex, of the edge, of the
/// face, the corner, or the one of a boundary edge near one of whose ends it lies.
struct Birth {
  enum Kind { vertex, edge, face, edge_end, corner } kind = vertex;
  Index halfedge = kNone;
  bool at_target = false;
};
/// Of the new vertex number `made`.
[[nodiscard]] Birth birth_of(const Mesh& mesh, const Births& births, Index made);

/// What a first step bears, found without its mesh.
[[nodiscard]] Births first_births(const Split& split, const Mesh& mesh);

/// The vertices of all faces that the walks of the rule visit (or rules, an edge's ends having
/// their own) by which a vertex is born: of every case, whatever its guard. Where it weighs a
/// face's new vertex, what that one's rule visits belongs to it.
[[nodiscard]] std::set<Index> dependence(const Scheme& scheme, const Mesh& mesh,
                                         const Births& births, const Birth& birth);

}  // namespace limn::fast
