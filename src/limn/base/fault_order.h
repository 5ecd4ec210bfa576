#pragma once
/// The order in which faults of one file are told.

#include <vector>

#include "limn/base/error.h"

namespace limn::base {

/// By line and column; those of one place as they were found.
[[nodiscard]] std::vector<Error> by_place(std::vector<Error> faults);

}  // namespace limn::base
