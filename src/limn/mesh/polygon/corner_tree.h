#pragma once
/// Corners of a polygon in a tree of boxes, from which they are taken one by one: is one of them in
/// a triangle?

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "limn/mesh/polygon/orientation.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

class CornerTree {
 public:
  /// `points` must outlive the tree. Cost O(m log m) for m `members`.
  void build(std::span<const Point2> points, std::vector<Index> members) {
    points_ = points;
    members_ = std::move(members);
    std::size_t leaves = 1;
    while (leaves * kLeaf < members_.size()) leaves *= 2;
    nodes_.assign(2 * leaves, Node{});
    place_.assign(points.size(), kNone);
    build(1, 0, members_.size());
    for (std::size_t k = 0; k < members_.size(); ++k) place_[members_[k]] = static_cast<Index>(k);
  }

  /// Takes a member out; nothing happens to what is no member. Cost O(log m).
  void take(Index member) {
    if (place_[member] == kNone) return;
    const auto place = static_cast<std::size_t>(place_[member]);
    place_[member] = kNone;
    std::size_t node = 1, first = 0, last = members_.size();
    for (;;) {
      --nodes_[node].count;
      if (2 * node >= nodes_.size()) return;
      const std::size_t middle = (first + last) / 2;
      node = 2 * node + (place < middle ? 0 : 1);
      (place < middle ? last : first) = middle;
    }
  }

  /// The first member found that may lie within `slack` of the triangle and for which `stops`
  /// holds; else kNone.
  template <class Stops>
  [[nodiscard]] Index find(const std::array<Point2, 3>& triangle, double slack,
                           const Stops& stops) const {
    const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const Box around{left - slack, right + slack, low - slack, high + slack};
    return find(1, 0, members_.size(), triangle, around, stops);
  }

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Box {
    double left = HUGE_VAL, right = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
  };
  struct Node {
    Box box;
    std::size_t count = 0;  // of the members that are not taken
  };

  void build(std::size_t node, std::size_t first, std::size_t last) {
    Box& box = nodes_[node].box;
    for (std::size_t k = first; k < last; ++k) {
      const Point2 p = points_[members_[k]];
      box = {std::min(box.left, p.x), std::max(box.right, p.x), std::min(box.low, p.y),
             std::max(box.high, p.y)};
    }
    nodes_[node].count = last - first;
    if (2 * node >= nodes_.size()) return;
    const std::size_t middle = (first + last) / 2;
    const bool wide = box.right - box.left > box.high - box.low;
    const auto at = [&](std::size_t k) {
      return members_.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::nth_element(at(first), at(middle), at(last), [&](Index i, Index k) {
      return wide ? points_[i].x < points_[k].x : points_[i].y < points_[k].y;
    });
    build(2 * node, first, middle);
    build(2 * node + 1, middle, last);
  }

  /// Certainly on the right of the line from a to b.
  static bool misses(const Box& box, Point2 a, Point2 b, double slack) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    // the corner of the box that is most to the left of the line
    const double left = dx * ((dx > 0 ? box.high : box.low) - a.y);
    const double right = dy * ((dy > 0 ? box.left : box.right) - a.x);
    constexpr double rounding = 1e-15;
    return left - right <
           -rounding * (std::abs(left) + std::abs(right)) - slack * (std::abs(dx) + std::abs(dy));
  }

  template <class Stops>
  Index find(std::size_t node, std::size_t first, std::size_t last,
             const std::array<Point2, 3>& triangle, const Box& around, const Stops& stops) const {
    const Node& here = nodes_[node];
    if (here.count == 0 || here.box.left > around.right || here.box.right < around.left ||
        here.box.low > around.high || here.box.high < around.low)
      return kNone;
    if (2 * node >= nodes_.size()) {
      for (std::size_t k = first; k < last; ++k)
        if (place_[members_[k]] != kNone && stops(members_[k])) return members_[k];
      return kNone;
    }
    const double slack = std::max(around.right - around.left, around.high - around.low) * 1e-8;
    for (std::size_t k = 0; k < 3; ++k)
      if (misses(here.box, triangle[k], triangle[(k + 1) % 3], slack)) return kNone;
    const std::size_t middle = (first + last) / 2;
    const Index found = find(2 * node, first, middle, triangle, around, stops);
    return found != kNone ? found : find(2 * node + 1, middle, last, triangle, around, stops);
  }

  std::span<const Point2> points_;
  std::vector<Index> members_;
  std::vector<Index> place_;  // of each point among the members; kNone: no member, or taken
  std::vector<Node> nodes_;
};

}  // namespace limn::mesh
