#pragma once
/// --valence, as several commands take it.

#include <string>

#include "limn/base/error.h"
#include "limn/scheme/check.h"

namespace limn::app {

struct Valences {
  int first = 0, last = 0;
};

/// "7" or "3..12": `least` … kLargestValence, not empty.
[[nodiscard]] Result<Valences> read_valences(const std::string& text,
                                             int least = scheme::kSmallestValence);

}  // namespace limn::app
