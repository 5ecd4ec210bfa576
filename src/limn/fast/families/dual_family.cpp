#include "limn/fast/families/dual_family.h"

#include <cassert>
#include <numeric>

#include "limn/base/parallel.h"
#include "limn/fast/families/dual_steps.h"
#include "limn/fast/layout/dual_walk.h"
#include "limn/fast/limit/dual_limit.h"
#include "limn/fast/limit/dual_wide_limit.h"

namespace limn::fast {
namespace {

/// Whether there is a vertex that gives no face although it is off the boundary.
bool loses_faces(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v) && mesh.valence(v) == 2) return true;
  return false;
}

class DualFamily final : public Family {
 public:
  DualFamily(const Scheme& scheme, const Mesh& control, int levels)
      : first_(levels > 0 && loses_faces(control) ? 1 : 0),
        owned_(first_ > 0 ? scheme.split->apply(control, 0).mesh : Mesh()),
        control_(first_ > 0 ? owned_ : control),
        corners_(control_),
        plain_(levels) {
    // without inner edges nothing grows, whatever the level
    if (corners_.inner_edges().empty()) return;
    Result<DualTables> read = read_dual_tables(scheme, control_);
    if (!read) return;
    tables_ = std::move(*read);
    has_tables_ = true;
    int plain = first_;
    if (!tables_.own_face)
      while (plain < levels && (plain == first_ || layout(plain).n() < tables_.smallest_grid))
        ++plain;
    plain_ = plain;
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    if (level == first_)
      return {control_.vertex_count(), control_.face_count(), control_.halfedge_count()};
    const DualLayout at = layout(level);
    return {at.vertex_count(), at.face_count(), at.corner_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    if (level == first_) return plan_first_dual_step(corners_, tables_);
    return plan_dual_step(corners_, tables_, layout(level).n());
  }

  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    if (!has_tables_) return std::optional<StepPlan>();
    if (!tables_.own_face) {
      if (level == first_ || control_.has_boundary()) return std::optional<StepPlan>();
      return plan_wide_dual_limit(layout(level), level, reader);
    }
    if (level == first_) return plan_control_dual_limit(control_, level, reader);
    return plan_dual_limit(layout(level), level, reader);
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (plain_ <= first_) return {};
    const DualLayout at = layout(plain_);
    if (at.n() > 1) return dual_order(at, steps.back().mesh);
    std::vector<Index> order(static_cast<std::size_t>(at.vertex_count()));
    for (Index h = 0; h < control_.halfedge_count(); ++h)
      order[static_cast<std::size_t>(at.point(h, 0, 0))] = h;
    std::iota(order.begin() + at.isolated_begin(), order.end(), at.isolated_begin());
    return order;
  }

  void write_faces(int level, std::span<Index> corners) const override {
    if (level > first_) return layout(level).write_faces(corners.data());
    parallel_for_each(control_.halfedge_count(),
                      [&](Index h) { corners[static_cast<std::size_t>(h)] = control_.origin(h); });
  }

  [[nodiscard]] Index corners_per_face() const override { return corners_.is_regular() ? 4 : 0; }

  void write_face_begin(int level, std::span<Index> begin) const override {
    if (level > first_) return layout(level).write_face_begin(begin.data());
    parallel_for_each(control_.face_count() + 1, [&](Index f) {
      begin[static_cast<std::size_t>(f)] = control_.face_begin(f);
    });
  }

 private:
  [[nodiscard]] DualLayout layout(int level) const {
    assert(level > first_);
    return {corners_, corners_.inner_edges().empty() ? 1 : Index{1} << (level - first_ - 1)};
  }

  int first_;   // the level of control_
  Mesh owned_;  // where it is not the control mesh itself
  const Mesh& control_;
  DualCorners corners_;
  int plain_;
  DualTables tables_;
  bool has_tables_ = false;
};

}  // namespace

std::unique_ptr<Family> make_dual_family(const Scheme& scheme, const Mesh& control, int levels) {
  return std::make_unique<DualFamily>(scheme, control, levels);
}

}  // namespace limn::fast
