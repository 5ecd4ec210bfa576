#pragma once
/// The family (family.h) of split quad-dual (Doo–Sabin; any polygons). Vertices are born from
/// corners, so after the first step all is regular but for a centre in each control face and
/// interior control vertex that has not four sides. Numbers and faces: dual_layout.h; at level 0
/// those of the control mesh.
///
/// No step is plain where the rule sees its own face alone: the first one is made by rows for each
/// number of corners, and at the boundary, from which the mesh recedes, nothing is special. A rule
/// that looks beyond its face leaves the first steps to the plain engine, until centres are far
/// enough apart, and has stencils of its own along the boundary (dual_rims.h).
///
/// An interior vertex of valence 2 gives no face, which leaves vertices of valence 3. Then the
/// first step is plain; its mesh, with the plain engine's numbers at level 1, takes the control
/// mesh's part in dual_layout.h, whose level 1 is level 2.
///
/// The limit is planned at every level where the rule sees its own face alone (dual_limit.h), but
/// at level 0 not where such vertices are; else on closed meshes whose patches are large enough
/// (dual_wide_limit.h).

#include "limn/refine/fast/family.h"

namespace limn::fast {

/// Precondition: scheme.split->births.corners. `control` must outlive the family; where there are
/// no tables (dual_tables.h) or no inner edges, all steps are left to the plain engine. Cost: the
/// tables, some 0.1 ms for each number of sides that a face or vertex has.
[[nodiscard]] std::unique_ptr<Family> make_dual_family(const Scheme& scheme, const Mesh& control,
                                                       int levels);

}  // namespace limn::fast
