#pragma once
/// The family (family.h) of splits whose new vertices are born from corners (Doo–Sabin; any
/// polygons): quads on kites. Numbers and faces: kites.h; at level 0 those of the control mesh.
/// After the first step all is regular but for the centres, of control faces and of interior
/// control vertices, that have not four sides.
///
/// No step is plain where the rule sees its own face alone: the first one is made by rows for each
/// number of corners. A rule that looks beyond its face leaves the first steps to the plain engine,
/// until centres are far enough apart. The mesh recedes from its boundary, near which points have
/// tables of their own (rim_tables.h).
///
/// An interior vertex of valence 2 gives no face, which leaves vertices of valence 3. Then the
/// first step is plain; its mesh, with the plain engine's numbers at level 1, takes the control
/// mesh's part in kites.h, whose level 1 is level 2.

#include "limn/fast/families/family.h"
#include "limn/fast/layout/lattice_step.h"

namespace limn::fast {

/// Precondition: cycle.offset. `control` must outlive the family, as the scheme; where there are no
/// tables (stencil_tables.h) or no inner edges, all steps are left to the plain engine. Cost: the
/// tables, some 0.1 ms for each number of sides that a face or vertex has.
[[nodiscard]] std::unique_ptr<Family> make_kite_family(const Scheme& scheme, const GridCycle& cycle,
                                                       const Mesh& control, int levels);

}  // namespace limn::fast
