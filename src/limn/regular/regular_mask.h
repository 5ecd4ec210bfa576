#pragma once
/// The regular mask of any scheme, read off its rules: linear forms are refined on a torus.

#include "limn/scheme/mask.h"

namespace limn {

/// The scheme's mask on the regular lattice, exactly. Weights at regular valence must come out
/// rational. Fails, with the reason, otherwise, and where a rule is missing.
/// Cost: one step on a torus of 16 × 16 vertices, in exact numbers; milliseconds.
[[nodiscard]] Result<Mask> regular_mask(const Scheme& scheme);

/// The mask as people print it: rows from the top, a hexagon on triangles, integers over a
/// common denominator. E.g. "1/16 ×" and the rows.
[[nodiscard]] std::string to_string(const Mask& mask);

}  // namespace limn
