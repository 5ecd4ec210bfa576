#pragma once
/// The family (family.h) of splits whose levels are grids on the faces of a mesh (grid_layout.h):
/// of dyadic splits, √3 and the like. All that a split has of its own is a row of data, its cycle
/// (lattice_step.h).
///
/// The mesh is the control mesh where all its faces have as many sides as the cells of the lattice.
/// Otherwise it is the one that the split makes of it, and the family's own: the steps of the first
/// cycle are left to the plain engine, and levels are numbered from there on. After the split of
/// other polygons than quads by quad-dyadic, control edge e has vertex V + e, control face f has
/// vertex V + E + f, and control half-edge h is the patch number h.

#include "limn/fast/families/family.h"
#include "limn/fast/layout/lattice_step.h"

namespace limn::fast {

/// The cycle of a split, if its levels are such grids.
[[nodiscard]] std::optional<GridCycle> grid_cycle(const Split& split);

/// `control` is what the split takes; it must outlive the family, as the scheme. What is sharp
/// fades uniformly, and only a cycle of one step takes it. Cost: the tables, some 0.1 ms for each
/// valence in the mesh and each kind of sharp place, and for other faces than quads one split of
/// the mesh.
[[nodiscard]] std::unique_ptr<Family> make_grid_family(const Scheme& scheme, const GridCycle& cycle,
                                                       const Mesh& control, int levels,
                                                       Sharpness sharpness);

}  // namespace limn::fast
