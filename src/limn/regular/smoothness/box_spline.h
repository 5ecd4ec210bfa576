#pragma once
/// Masks whose limit function is a box spline, which is known in closed form: how smooth it is
/// follows from its directions alone [deBoorHolligRiemenschneider1993 §I].

#include <optional>
#include <string>

#include "limn/scheme/mask.h"

namespace limn::regular {

/// A box spline in the plane.
struct BoxSpline {
  int directions = 0;  ///< with their counts
  int parallel = 0;    ///< the most of them that are parallel
  /// φ is a piecewise polynomial. Directions - parallel is the least number of directions without
  /// which the others do not span the plane; φ has two continuous derivatives less than that, and
  /// those of one order more are bounded and jump: its Hölder exponent is that number less 1.
  [[nodiscard]] int exponent() const { return directions - parallel - 1; }
  /// "φ is the box spline of 8 directions, of which 2 are parallel"
  [[nodiscard]] std::string text() const;
};

/// Nothing where the mask is no product of directions (regular_mask.h), or of directions that
/// powers of M do not carry to one another. Where p steps are a dilation by an integer q, times an
/// isometry that exchanges the mask's directions up to sign, each direction d comes p times in φ:
/// as d, Md, … M^{p-1} d, all but for a factor. So the mask (1, 2, 1)² / 8 of quad-sqrt2 makes the
/// box spline of four directions, each twice.
[[nodiscard]] std::optional<BoxSpline> find_box_spline(const Mask& mask);

}  // namespace limn::regular
