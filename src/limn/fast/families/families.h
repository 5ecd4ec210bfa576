#pragma once
/// The families of all splits.

#include "limn/fast/families/family.h"

namespace limn::fast {

/// Whether there is a family for schemes of this split.
[[nodiscard]] bool has_family(const Split& split);

/// Precondition: has_family(*scheme.split), and `control` is what the split takes. Both must
/// outlive the family.
[[nodiscard]] std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control,
                                                  int levels);

}  // namespace limn::fast
