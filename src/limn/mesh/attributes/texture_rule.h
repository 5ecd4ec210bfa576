#pragma once
/// How texture coordinates are refined where the texture ends.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace limn {

/// What stays in place where the texture ends, at seams and boundaries. The names are USD's.
enum class TextureRule : std::uint8_t {
  none,           ///< nothing: seams and boundaries are curves
  corners_only,   ///< points that one face has
  corners_plus1,  ///< and points of vertices where three charts or more meet, or where a sharp edge
                  ///< ends at a seam or the same point is on both sides
  corners_plus2,  ///< and the ends of seams, and both points where one of two is a corner
  boundaries,     ///< all of seams and boundaries: they stay straight
  all             ///< everything: texture coordinates are linear on each face
};
/// Their names: "none", "cornersOnly", "cornersPlus1", "cornersPlus2", "boundaries", "all".
[[nodiscard]] const std::vector<std::pair<std::string, TextureRule>>& texture_rules();

}  // namespace limn
