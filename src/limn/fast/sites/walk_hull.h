#pragma once
/// The vertices of all faces that a rule's walks visit.

#include <set>

#include "limn/scheme/scheme.h"

namespace limn::fast {

/// The rule (or rules, an edge's ends having their own) by which the vertex is born that belongs to
/// old vertex origin(h), to old edge edge(h), or to old face face(h): every case of it, whatever
/// its guard. Where it weighs a face's new vertex, what that one's rule visits belongs to it.
[[nodiscard]] std::set<Index> vertex_hull(const Scheme& scheme, const Mesh& mesh, Index h);
[[nodiscard]] std::set<Index> edge_hull(const Scheme& scheme, const Mesh& mesh, Index h);
[[nodiscard]] std::set<Index> face_hull(const Scheme& scheme, const Mesh& mesh, Index h);
/// The same of the vertex born near an end of h on the boundary (its target where `at_target`).
[[nodiscard]] std::set<Index> edge_end_hull(const Scheme& scheme, const Mesh& mesh, Index h,
                                            bool at_target);
/// The same of the vertex that is born from corner h (dual splits).
[[nodiscard]] std::set<Index> corner_hull(const Scheme& scheme, const Mesh& mesh, Index h);

}  // namespace limn::fast
