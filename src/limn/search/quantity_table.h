#pragma once
/// What the table of quantities and its reader share; private to search/.

#include "limn/search/quantity.h"

namespace limn::search {

/// The limit surface that a scheme makes of a control mesh, after so many steps.
[[nodiscard]] Result<Polygons> limit_surface(const Scheme& scheme, const Polygons& control,
                                             int levels);

}  // namespace limn::search
