#include "limn/fast/layout/dual_walk.h"

#include <numeric>

namespace limn::fast {
namespace {

/// The first half-edges of the fine mesh are still those of the control mesh: they run from corner
/// to corner of the faces' shrunk images. From there each patch is walked.
class PatchWalk {
 public:
  PatchWalk(const DualLayout& layout, const Mesh& fine, std::vector<Index>& order)
      : corners_(layout.corners()), layout_(layout), fine_(fine), order_(order) {}

  void run(Index h) {
    Index side = h;  // leaves (0, y) towards (-1, y)
    set(h, 0, 0, fine_.origin(side));
    if (corners_.has_x_arm(h)) walk_row(h, side, 0);
    if (!corners_.has_y_arm(h)) return;
    for (Index y = 1; y < layout_.n(); ++y) {
      side = across(side);
      set(h, 0, y, fine_.origin(side));
      if (corners_.is_whole(h)) walk_row(h, side, y);
    }
  }

 private:
  void walk_row(Index h, Index side, Index y) {
    side = fine_.prev(side);  // comes to (x, y) from (x, y-1)
    for (Index x = 1; x < layout_.n(); ++x) {
      side = across(side);
      set(h, x, y, fine_.target(side));
    }
  }

  void set(Index h, Index x, Index y, Index v) {
    order_[static_cast<std::size_t>(layout_.point(h, x, y))] = v;
  }

  /// Over the quad beyond a side, to the side opposite.
  [[nodiscard]] Index across(Index side) const { return fine_.next(fine_.next(fine_.twin(side))); }

  const DualCorners& corners_;
  const DualLayout& layout_;
  const Mesh& fine_;
  std::vector<Index>& order_;
};

}  // namespace

std::vector<Index> dual_order(const DualLayout& layout, const Mesh& fine) {
  std::vector<Index> order(static_cast<std::size_t>(layout.vertex_count()));
  for (Index h = 0; h < layout.corners().control().halfedge_count(); ++h)
    PatchWalk(layout, fine, order).run(h);
  // isolated vertices are the last of both
  std::iota(order.begin() + layout.isolated_begin(), order.end(), layout.isolated_begin());
  return order;
}

}  // namespace limn::fast
