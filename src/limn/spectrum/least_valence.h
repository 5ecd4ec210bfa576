#pragma once
/// From which valence on a vertex can be analysed.

#include "limn/mesh/split/split.h"
#include "limn/scheme/check.h"

namespace limn::spectrum {

/// The least valence of an interior vertex that frequency blocks and limit stencils know, if the
/// scheme's rules are defined there: 2, two faces that share both edges at the vertex; under dual
/// splits n is the number of a face's corners, of which it has at least 3. Rules are checked from
/// kSmallestValence on when they are read; below, when they are needed.
[[nodiscard]] inline int least_valence(const Split& split) {
  return split.is_dual() ? scheme::kSmallestValence : 2;
}

}  // namespace limn::spectrum
