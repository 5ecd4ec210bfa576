#include "limn/refine/fast/families.h"

#include "limn/refine/fast/dual_family.h"
#include "limn/refine/fast/quad_family.h"
#include "limn/refine/fast/sqrt3_family.h"
#include "limn/refine/fast/triangle_family.h"

namespace limn::fast {
namespace {

using Maker = std::unique_ptr<Family> (*)(const Scheme& scheme, const Mesh& control, int levels);

/// By what a split does, not by its name.
Maker maker(const Split& split) {
  const bool old_and_edges = split.births.vertices && split.births.edges && !split.births.corners;
  if (split.lattice == Lattice::quad && split.births.corners) return make_dual_family;
  if (split.lattice == Lattice::triangle && split.trisects_boundary && split.dilation.growth() == 3)
    return make_sqrt3_family;
  if (!old_and_edges || split.dilation.growth() != 4) return nullptr;
  if (split.lattice == Lattice::triangle && !split.births.faces) return make_triangle_family;
  if (split.lattice == Lattice::quad && split.births.faces) return make_quad_family;
  return nullptr;
}

}  // namespace

bool has_family(const Split& split) { return maker(split) != nullptr; }

std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control, int levels) {
  return maker(*scheme.split)(scheme, control, levels);
}

}  // namespace limn::fast
