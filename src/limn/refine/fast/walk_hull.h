#pragma once
/// The vertices of all faces that a rule's walks visit.

#include <set>

#include "limn/scheme/scheme.h"

namespace limn::fast {

/// The rule (or rules, an edge's ends having their own) by which the vertex is born that belongs to
/// old vertex origin(h), or to old edge edge(h): every case of it, whatever its guard.
[[nodiscard]] std::set<Index> vertex_hull(const Scheme& scheme, const Mesh& mesh, Index h);
[[nodiscard]] std::set<Index> edge_hull(const Scheme& scheme, const Mesh& mesh, Index h);
/// The same of the vertex that is born from corner h (dual splits).
[[nodiscard]] std::set<Index> corner_hull(const Scheme& scheme, const Mesh& mesh, Index h);

}  // namespace limn::fast
