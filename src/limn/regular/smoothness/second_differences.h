#pragma once
/// Whether curvature is bounded on the regular lattice, that is, whether second differences over h²
/// of the refined data stay bounded: what bounded curvature at an extraordinary vertex presupposes,
/// since the surface round the vertex is regular.
///
/// With ρ the joint spectral radius of the transition operators on differences (regularity.h) that
/// is so where ρ < 1/|det M|: the Hölder exponent is above 2. Where ρ is greater, and the shifts of
/// φ are stable, it is not so: the exponent is below 2; nor where shifts are stable and the sum
/// rules are of order 2 or less [Jia1998]. At the exponent 2 itself rounded brackets cannot tell.
/// There an exact norm ≤ 1 of some steps of the normalised scheme of second differences proves
/// boundedness (quadratic splines), and a Jordan block at the critical eigenvalue of a product of
/// the operators proves, for stable shifts, that second differences grow like a power of the level
/// (the butterfly, the four-point scheme). Where shifts are dependent, differences of the data may
/// tell nothing; of a box spline (box_spline.h) it is known from its directions (midedge).

#include "limn/scheme/mask.h"
#include "limn/scheme/regular_part.h"

namespace limn {

/// Of a mask: found once in a process and then remembered (a few hundred masks; from several
/// threads at once). The search stops as soon as it is decided, and gives up, undecided, where a
/// wide mask would take long. Cost: at most a few tenths of a second; the reason says what was
/// proved.
[[nodiscard]] RegularPart find_regular_part(const Mask& mask);

/// Of a scheme at its present parameters; undecided, with the reason, where it has no regular mask.
/// Where meshes have both kinds of faces it is what holds on either lattice; of the seams between
/// them nothing is said.
[[nodiscard]] RegularPart find_regular_part(const Scheme& scheme);

}  // namespace limn
