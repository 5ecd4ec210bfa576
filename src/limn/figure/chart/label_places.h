#pragma once
/// Places for labels beside points, where they hide no lines.

#include <array>
#include <vector>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

/// A label of this size that belongs to a point.
struct LabelWish {
  PagePoint anchor;
  double width = 0, height = 0;
};

/// What labels keep off.
struct LabelSurroundings {
  struct Dot {
    PagePoint at;
    double radius = 0;
  };
  std::vector<std::array<PagePoint, 2>> lines = {};
  std::vector<Dot> dots = {};
  Box within = {};  ///< labels stay inside
};

/// The middle of each label, in their order: of a ring of places round the anchor the nearest that
/// touches no line, no dot and no label before it, and lies inside the box; where there is none,
/// the one that touches least. Cost O(labels · (lines + dots + labels)).
[[nodiscard]] std::vector<PagePoint> label_places(const std::vector<LabelWish>& labels,
                                                  const LabelSurroundings& around);

/// Whether the segment has a point inside the box.
[[nodiscard]] bool crosses(const std::array<PagePoint, 2>& segment, const Box& box);

}  // namespace limn::figure
