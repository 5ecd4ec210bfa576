#include "limn/fast/families/family.h"

#include "limn/fast/families/grid_family.h"
#include "limn/fast/families/kite_family.h"

namespace limn::fast {

bool has_family(const Split& split) { return grid_cycle(split).has_value(); }

std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control, int levels) {
  const GridCycle cycle = *grid_cycle(*scheme.split);
  if (cycle.offset) return make_kite_family(scheme, cycle, control, levels);
  return make_grid_family(scheme, cycle, control, levels);
}

}  // namespace limn::fast
