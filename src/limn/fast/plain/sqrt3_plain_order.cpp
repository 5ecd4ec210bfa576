#include "limn/fast/plain/sqrt3_plain_order.h"

#include "limn/fast/layout/sqrt3_layout.h"
#include "limn/fast/plain/plain_steps.h"
#include "limn/fast/sites/sqrt3_site.h"

namespace limn::fast {
namespace {

/// The half-edge, two levels on from an even one, that starts as h does, on the same edge.
Index first_third(const Mesh& coarse, const SplitResult& second, Index h) {
  return halfedge_between(second.mesh, coarse.origin(h), third_along(coarse, second.births, h));
}

/// The plain engine's vertices, by walking each control face of the last even level row by row.
class PlainOrder {
 public:
  PlainOrder(const Mesh& control, const std::vector<SplitResult>& steps)
      : control_(control),
        steps_(steps),
        odd_(steps.size() % 2 != 0),
        layout_(control, power_of_3(static_cast<int>(steps.size()) / 2)),
        even_(mesh(steps.size() - steps.size() % 2)) {}

  std::vector<Index> make() {
    const Index count = odd_ ? layout_.vertex_count() : layout_.grid().vertex_count();
    order_.assign(static_cast<std::size_t>(count), kNone);
    for (Index v = 0; v < control_.vertex_count(); ++v) order_[v] = v;
    for (Index f = 0; f < control_.face_count(); ++f) walk(f);
    return std::move(order_);
  }

 private:
  [[nodiscard]] const Mesh& mesh(std::size_t level) const {
    return level == 0 ? control_ : steps_[level - 1].mesh;
  }

  void walk(Index f) {
    const Index n = layout_.n();
    Index row = 3 * f;  // the half-edge from (0, y) to (1, y)
    for (std::size_t level = 0; level + 1 < steps_.size(); level += 2)
      row = first_third(mesh(level), steps_[level + 1], row);
    centroid_ = layout_.centroid_begin(f);
    for (Index y = 0; y < n; ++y) {
      Index h = row;
      for (Index x = 0; x + y < n; ++x) {
        order_[layout_.grid().point(3 * f, x, y)] = even_.origin(h);
        order_[layout_.grid().point(3 * f, x + 1, y)] = even_.target(h);
        see_triangle(h);
        if (x + y + 1 == n) break;
        // over the triangle that points down, into the next one that points up
        const Index down = even_.twin(even_.next(h));
        see_triangle(down);
        h = even_.next(even_.twin(even_.next(down)));
      }
      order_[layout_.grid().point(3 * f, 0, y + 1)] = even_.origin(even_.prev(row));
      // the triangle that points down beside (0, y) has the next row's first edge opposite
      if (y + 1 < n) row = even_.twin(even_.prev(even_.twin(even_.next(row))));
    }
  }

  void see_triangle(Index h) {
    if (odd_) order_[centroid_++] = even_.vertex_count() + even_.face(h);
  }

  const Mesh& control_;
  const std::vector<SplitResult>& steps_;
  bool odd_;
  CentroidLayout layout_;
  const Mesh& even_;
  Index centroid_ = 0;
  std::vector<Index> order_;
};

}  // namespace

std::vector<Index> sqrt3_plain_order(const Mesh& control, const std::vector<SplitResult>& steps) {
  return PlainOrder(control, steps).make();
}

}  // namespace limn::fast
