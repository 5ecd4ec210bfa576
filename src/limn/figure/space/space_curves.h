#pragma once
/// Curves in the viewer's coordinates: joined from pieces, cut where a surface hides them, and put
/// on the page.

#include <vector>

#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/chart/level_sets.h"
#include "limn/figure/space/visibility.h"

namespace limn::figure {

using SpaceCurve = std::vector<SpaceVector>;

/// A piece of a curve. Ends of the same name are the same point.
struct SpaceSegment {
  long long from = 0, to = 0;
  SpaceVector a = {}, b = {};
};

/// The segments as curves, each as long as can be: a curve ends where other than two segments meet.
/// A closed one repeats its first point. The order and direction of the segments do not matter,
/// apart from those of the result. O(n log n).
[[nodiscard]] std::vector<SpaceCurve> joined(const std::vector<SpaceSegment>& segments);

/// Parts of curves, on the page.
struct DrawnCurves {
  std::vector<Polyline> visible, hidden;
};

/// Cuts the curves where surfaces begin to hide them, to 1/100 of a point; `tolerance` as in
/// `RayCaster::hides`. Parts that are too short to see are joined to what is round them, those of
/// no length left out, and points are left out where the line stays within 1/50 of a point. Cost: a
/// few rays each point of the page.
[[nodiscard]] DrawnCurves drawn_curves(const std::vector<SpaceCurve>& curves, const RayCaster& rays,
                                       const FramePlacement& place,
                                       double tolerance = RayCaster::kOnSurface);

/// The polyline without points that are nearer than `tolerance` to it. The ends stay.
[[nodiscard]] Polyline simplified(const Polyline& line, double tolerance);

}  // namespace limn::figure
