#pragma once
/// Stam and Loop's step on any mesh, typed a second time on lists of faces: nothing of scheme/ or
/// refine/ is used, and of the mesh only which vertices, edges and faces it has.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::test {

/// Faces are cut linearly, triangles into triangles and others into quads, and then every inner
/// vertex of n edges and q quads becomes (itself + half its neighbours + a quarter of the corners
/// opposite in its quads) / (1 + n/2 + q/4) [StamLoop2003]; at the boundary (1, 2, 1)/4. Values at
/// old vertices, then edges, then faces of 4 and more corners. `own` 1: vertices of triangles
/// alone, or of quads alone, become what Loop's, or Catmull and Clark's, weights [Loop1987;
/// Stam2001] make of them; between 0 and 1 a blend.
[[nodiscard]] std::vector<double> quad_triangle_reference_step(const Mesh& mesh,
                                                               const std::vector<double>& old,
                                                               double own = 0);

}  // namespace limn::test
