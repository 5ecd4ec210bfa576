#pragma once
/// How large a mesh can be: its parts are counted in an `Index`, its lengths are squared.

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// The most vertices, faces and corners: an `Index` also holds one more than there are, which is
/// where an array of offsets ends.
inline constexpr std::size_t kMostElements = std::numeric_limits<Index>::max() - 1;

/// Why a mesh with so many of each cannot be held; nothing where it can.
[[nodiscard]] inline std::optional<Error> too_many(std::size_t vertices, std::size_t faces,
                                                   std::size_t corners) {
  const char* what = vertices > kMostElements  ? "vertices"
                     : faces > kMostElements   ? "faces"
                     : corners > kMostElements ? "corners"
                                               : nullptr;
  if (what == nullptr) return std::nullopt;
  return Error{std::string("2^31 - 1 ") + what + " or more", "cut the mesh into parts"};
}

/// Whether sums and differences of coordinates can be represented: whether all are below 1e307 in
/// size. Coordinates that are not finite do not count. Cost O(V).
[[nodiscard]] Status check_differences(const std::vector<Point3>& positions);

/// Whether squares of lengths, as areas, and their inverses can be represented: whether the
/// largest coordinate lies between 1e-150 and 1e150, or all are 0. Coordinates that are not finite
/// do not count. Cost O(V).
[[nodiscard]] Status check_squares(const std::vector<Point3>& positions);

}  // namespace limn::mesh
