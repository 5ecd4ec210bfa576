#pragma once
/// The regular mask by brute force: exact linear forms refined once on a torus.

#include "limn/scheme/mask.h"

namespace limn::test {

/// Coefficients by twice the offset, as in Mask, of a dyadic scheme; the same around every
/// vertex, or else an error. The mask has to fit into 7 × 7 control edges.
[[nodiscard]] Result<Mask> refined_mask(const Scheme& scheme);

}  // namespace limn::test
