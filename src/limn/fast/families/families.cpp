#include "limn/fast/families/families.h"

#include "limn/fast/families/dual_family.h"
#include "limn/fast/families/quad_family.h"
#include "limn/fast/families/sqrt3_family.h"
#include "limn/fast/families/triangle_family.h"

namespace limn::fast {
namespace {

using Maker = std::unique_ptr<Family> (*)(const Scheme& scheme, const Mesh& control, int levels);

/// By what a split does, not by its name.
Maker maker(const Split& split) {
  const bool old_and_edges = split.births_vertices && split.births_edges && !split.births_corners;
  if (split.lattice == Lattice::quad && split.births_corners) return make_dual_family;
  if (split.lattice == Lattice::triangle && split.trisects_boundary && split.dilation.growth() == 3)
    return make_sqrt3_family;
  if (!old_and_edges || split.dilation.growth() != 4) return nullptr;
  if (split.lattice == Lattice::triangle && !split.births_faces) return make_triangle_family;
  if (split.lattice == Lattice::quad && split.births_faces) return make_quad_family;
  return nullptr;
}

}  // namespace

bool has_family(const Split& split) { return maker(split) != nullptr; }

std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control, int levels) {
  return maker(*scheme.split)(scheme, control, levels);
}

}  // namespace limn::fast
