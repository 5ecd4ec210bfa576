#pragma once
/// From which valence on a vertex can be analysed.

#include "limn/mesh/split/split.h"
#include "limn/scheme/check.h"

namespace limn {

/// The least valence of an interior vertex that frequency blocks and limit stencils know: 2 of
/// quads, whose star has four vertices then; else 3, as of faces (dual splits). Rules are checked
/// from kSmallestValence on when they are read; below, when they are needed.
[[nodiscard]] inline int least_valence(const Split& split) {
  return split.lattice == Lattice::quad && !split.births.corners ? 2 : kSmallestValence;
}

}  // namespace limn
