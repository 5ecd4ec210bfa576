#pragma once
/// Numbers near the end of their type's range. The engine adds numbers that have one weight before
/// it weighs them, so that a sum may be infinite though the weighted mean is not.

#include <cmath>
#include <limits>
#include <span>

#include "limn/mesh/polygons.h"

namespace limn::fast {

/// A power of two that leaves room for sums of many numbers with weights of any usual size, level
/// after level.
template <class Real>
inline constexpr Real kRoom = Real(1) / (Index{1} << 30);

/// Whether numbers must be multiplied by kRoom, which changes none of their digits, before they are
/// summed. Also where some are no numbers.
template <class Real>
[[nodiscard]] bool needs_room(std::span<const Real> numbers) {
  constexpr Real kMost = kRoom<Real> * std::numeric_limits<Real>::max();
  bool fits = true;
  for (const Real number : numbers) fits &= std::abs(number) <= kMost;
  return !fits;
}

}  // namespace limn::fast
