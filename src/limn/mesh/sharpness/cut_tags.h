#pragma once
/// What a mesh that repair has cut holds sharp.

#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/tags.h"

namespace limn {

/// Repaired::sharp_vertices as corners and sharp_edges as creases, infinitely sharp, by numbers of
/// the repaired mesh: with them it is refined to the positions that OpenSubdiv gives the mesh as it
/// was.
[[nodiscard]] SharpnessTags cut_tags(const Repaired& repaired);

}  // namespace limn
