#pragma once
/// What a random mesh has that some schemes have no rules for.

#include "limn/mesh/mesh.h"

namespace limn::test {

/// Amid the surface, with two edges: the modified butterfly's weights are those of valence 3 and
/// more, and dual splits squeeze the face that such a vertex would give.
inline bool has_inner_vertex_of_valence_two(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v) && mesh.valence(v) < 3) return true;
  return false;
}

}  // namespace limn::test
