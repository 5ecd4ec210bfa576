#pragma once
/// Reflection lines: what a mirror shows of parallel light lines that are infinitely far away.
/// A surface that joins with C¹ only shows kinks in them, one that joins with C² does not.
///
/// Seen along v, the mirror with the normal n shows the direction r = 2 (n·v) n − v. Half-planes
/// that end in the line through the eye along L hold the directions of one light line each; which
/// of them r meets is its angle about L. The sign of n does not matter.

#include <optional>

#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/canvas/space_vector.h"

namespace limn::figure {

struct LightLines {
  /// L, in space; any length but 0. Without it along the horizon, from the left to the right.
  std::optional<SpaceVector> direction = {};
  int count = 48;  ///< of lines all round L, evenly, in [1, 10000]
};

/// Light lines about an axis in the viewer's coordinates, in which v is (0, 0, 1).
class MirroredLights {
 public:
  /// A count out of range is clamped; a direction of no length is as none. The half-plane of the
  /// eye (or, where L passes through the eye, the one upwards) is in the middle between two light
  /// lines.
  MirroredLights(const LightLines& lights, const ParallelView& view);

  [[nodiscard]] int count() const { return count_; }

  /// r for a seen normal; of length |normal|².
  [[nodiscard]] static SpaceVector mirrored(const SpaceVector& normal) {
    const double twice = 2 * normal[2];
    return {twice * normal[0], twice * normal[1], twice * normal[2] - dot(normal, normal)};
  }

  /// How many light lines r is beyond the first one: whole on a light line. Any value where r is
  /// parallel to L.
  [[nodiscard]] double turn(const SpaceVector& r) const;

  /// The half-plane of a light line: r is on it where dot(r, across) = 0 and dot(r, along) > 0.
  struct HalfPlane {
    SpaceVector along, across;
  };
  [[nodiscard]] HalfPlane half_plane(int line) const;

 private:
  int count_;
  SpaceVector first_, second_;  // at angles 0 and 90° about L
};

}  // namespace limn::figure
