#pragma once
/// The family (family.h) of the split sqrt3: at even levels the triangles of control faces cut into
/// grids of 3^k edges a side, at odd ones these with a centroid for each triangle
/// (sqrt3_layout.h).

#include "limn/fast/families/family.h"

namespace limn::fast {

/// `control` has triangles only; it must outlive the family. Cost: the tables, some ms and 0.2 ms
/// for each valence in the mesh.
[[nodiscard]] std::unique_ptr<Family> make_sqrt3_family(const Scheme& scheme, const Mesh& control,
                                                        int levels);

}  // namespace limn::fast
