#pragma once
/// Parallel projection of space onto a page. A point as *seen* has the viewer's coordinates: to the
/// right, up, and towards the eye.

#include <array>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/canvas/space_vector.h"
#include "limn/figure/canvas/ticks.h"

namespace limn::figure {

/// Surfaces are lit from the left above the viewer; in the viewer's coordinates, of length 1.
inline constexpr SpaceVector kLightFrom = {-0.45, 0.62, 0.643};

class ParallelView {
 public:
  /// Where the viewer stands, in degrees: the azimuth about the z axis, from x towards y; the
  /// elevation over the xy plane, in [−90, 90]. One that is not finite counts as 0.
  ParallelView(double azimuth, double elevation);

  /// Of a point or of a direction; a rotation.
  [[nodiscard]] SpaceVector seen(const SpaceVector& at) const {
    return {dot(at, right_), dot(at, up_), dot(at, near_)};
  }

 private:
  SpaceVector right_, up_, near_;
};

/// A rectangle of the viewer's plane; both sides have a length.
struct ViewFrame {
  Range x, y;
  [[nodiscard]] double aspect() const { return (y.high - y.low) / (x.high - x.low); }
};

/// The least one of all finite points, widened where it has no size or nearly none.
[[nodiscard]] ViewFrame frame_of(const std::vector<SpaceVector>& seen);

/// From the viewer's plane to the page: the frame as large as it fits, in the middle of the box.
class FramePlacement {
 public:
  /// Precondition: the box has an area.
  FramePlacement(const ViewFrame& frame, const Box& box);

  /// Where a seen point is drawn.
  [[nodiscard]] PagePoint page(const SpaceVector& seen) const {
    return {box_.x + scale_ * (seen[0] - frame_.x.low),
            box_.bottom() - scale_ * (seen[1] - frame_.y.low)};
  }
  /// Right and up of what is drawn there.
  [[nodiscard]] std::array<double, 2> seen(const PagePoint& page) const {
    return {frame_.x.low + (page[0] - box_.x) / scale_,
            frame_.y.low + (box_.bottom() - page[1]) / scale_};
  }
  /// Points of the page a unit of space.
  [[nodiscard]] double scale() const { return scale_; }
  /// The frame on the page.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  ViewFrame frame_;
  double scale_;
  Box box_;
};

}  // namespace limn::figure
