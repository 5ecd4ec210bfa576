#pragma once
/// Why a vertex of a limit surface has no curvature.

#include <string_view>

namespace limn {

/// Why a vertex has no curvature.
enum class NoCurvature : char {
  none,         ///< it has one
  boundary,     ///< it lies on the boundary
  no_limit,     ///< it has no limit point, or no faces
  no_normal,    ///< its tangents vanish or are parallel, or there is no tangent pair
  unbounded,    ///< by the eigenvalues of the vertex: it grows towards it, or may
  regular,      ///< the scheme's regular surface has unbounded curvature everywhere
  direction,    ///< bounded, with another value from each side: second derivatives jump there
  not_regular,  ///< its neighbourhood never becomes regular (dual splits, beside the boundary)
  unknown,      ///< what it would follow from cannot be had
  too_large,    ///< not a number in double precision
};
/// In words, as a clause that a warning ends with.
[[nodiscard]] std::string_view to_string(NoCurvature reason);

}  // namespace limn
