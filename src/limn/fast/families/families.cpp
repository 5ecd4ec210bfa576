#include "limn/fast/families/families.h"

#include "limn/fast/families/dual_family.h"
#include "limn/fast/families/grid_family.h"

namespace limn::fast {
namespace {

bool is_dual(const Split& split) { return split.lattice == Lattice::quad && split.births.corners; }

}  // namespace

bool has_family(const Split& split) { return is_dual(split) || grid_cycle(split).has_value(); }

std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control, int levels) {
  if (is_dual(*scheme.split)) return make_dual_family(scheme, control, levels);
  return make_grid_family(scheme, *grid_cycle(*scheme.split), control, levels);
}

}  // namespace limn::fast
