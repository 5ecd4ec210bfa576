#pragma once
/// The family (family.h) of the split quad-dyadic: at each level the quads of a mesh cut into grids
/// (quad_layout.h). The mesh is the control mesh where that has quads only. Otherwise it is the one
/// that the split makes of it, a quad for each corner, and the family's own: the first step is left
/// to the plain engine, and levels are numbered from there on.
///
/// Numbers: see quad_layout.h, of the mesh that is cut into grids. The control vertices keep
/// theirs. After the split of other polygons than quads, control edge e has vertex V + e, control
/// face f has vertex V + E + f, and control half-edge h is the patch number h.

#include "limn/fast/families/family.h"

namespace limn::fast {

/// `control` has any polygons; it must outlive the family. Cost: the tables, some 0.1 ms for each
/// valence in the mesh, and for other faces than quads one split of the mesh.
[[nodiscard]] std::unique_ptr<Family> make_quad_family(const Scheme& scheme, const Mesh& control,
                                                       int levels);

}  // namespace limn::fast
