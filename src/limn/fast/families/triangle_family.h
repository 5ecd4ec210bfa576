#pragma once
/// The family (family.h) of the split triangle-dyadic: at each level the triangles of control faces
/// cut into grids (triangle_layout.h).

#include "limn/fast/families/family.h"

namespace limn::fast {

/// `control` has triangles only; it must outlive the family. Cost: the tables, some 0.1 ms for each
/// valence in the mesh.
[[nodiscard]] std::unique_ptr<Family> make_triangle_family(const Scheme& scheme,
                                                           const Mesh& control, int levels);

}  // namespace limn::fast
