#include "limn/fast/families/kite_family.h"

#include <cassert>

#include "limn/base/parallel.h"
#include "limn/fast/families/kite_steps.h"
#include "limn/fast/limit/kite_limit.h"
#include "limn/fast/plain/plain_order.h"

namespace limn::fast {
namespace {

/// Whether there is a vertex that gives no face although it is off the boundary.
bool loses_faces(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v) && mesh.valence(v) == 2) return true;
  return false;
}

class KiteFamily final : public Family {
 public:
  KiteFamily(const Scheme& scheme, const GridCycle& cycle, const Mesh& control, int levels)
      : first_(levels > 0 && loses_faces(control) ? 1 : 0),
        cycle_(cycle),
        split_(*scheme.split),
        owned_(first_ > 0 ? split_.apply(control, 0).mesh : Mesh()),
        control_(first_ > 0 ? owned_ : control),
        kites_(control_),
        plain_(levels) {
    // without inner edges nothing grows, whatever the level
    if (kites_.inner_edges().empty()) return;
    groups_ = group_kites(kites_);
    Result<KiteTables> read = read_kite_tables(scheme, cycle, kites_, groups_);
    if (!read) return;
    tables_ = std::move(*read);
    plain_ = first_;
    if (tables_->own_face()) return;
    const Index smallest = tables_->interior.reach.smallest_side;
    while (plain_ < levels && (plain_ == first_ || layout(plain_).n() * cycle.edge() < smallest))
      ++plain_;
  }

  [[nodiscard]] int plain_steps() const override { return plain_; }

  [[nodiscard]] Size size(int level) const override {
    if (level == first_)
      return {control_.vertex_count(), control_.face_count(), control_.halfedge_count()};
    const KiteLayout at = layout(level);
    return {at.vertex_count(), at.face_count(), at.corner_count()};
  }

  [[nodiscard]] StepPlan plan(int level) const override {
    if (level == first_) return plan_first_kite_step(kites_, *tables_);
    return plan_kite_step(kites_, groups_, cycle_, *tables_, layout(level).n());
  }

  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    if (!tables_) return std::optional<StepPlan>();
    if (level > first_ + 1 || !tables_->own_face()) {
      if (level == first_) return std::optional<StepPlan>();
      return plan_kite_limit({split_, cycle_, groups_, tables_->own_face()}, layout(level), level,
                             reader);
    }
    if (level == first_) return plan_one_rings(control_, {}, level, reader);
    std::vector<Index> numbers;
    const KiteLayout at = layout(level);
    for (Index h = 0; h < control_.halfedge_count(); ++h) numbers.push_back(at.point(h, 0, 0));
    for (const Index v : at.isolated()) numbers.push_back(v);
    return plan_one_rings(split_.apply(control_, 0).mesh, numbers, level, reader);
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (plain_ <= first_) return {};
    return kite_order(layout(plain_), steps.back().mesh);
  }

  void write_faces(int level, std::span<Index> corners) const override {
    if (level > first_) return layout(level).write_faces(corners.data());
    parallel_for_each(control_.halfedge_count(),
                      [&](Index h) { corners[static_cast<std::size_t>(h)] = control_.origin(h); });
  }

  [[nodiscard]] Index corners_per_face() const override { return kites_.is_regular() ? 4 : 0; }

  void write_face_begin(int level, std::span<Index> begin) const override {
    if (level > first_) return layout(level).write_face_begin(begin.data());
    parallel_for_each(control_.face_count() + 1, [&](Index f) {
      begin[static_cast<std::size_t>(f)] = control_.face_begin(f);
    });
  }

 private:
  [[nodiscard]] KiteLayout layout(int level) const {
    assert(level > first_);
    return {kites_, kites_.inner_edges().empty() ? 1 : power(cycle_.cut, level - first_ - 1)};
  }

  int first_;  // the level of control_
  GridCycle cycle_;
  const Split& split_;
  Mesh owned_;  // where it is not the control mesh itself
  const Mesh& control_;
  Kites kites_;
  KiteGroups groups_;
  int plain_;
  std::optional<KiteTables> tables_;
};

}  // namespace

std::unique_ptr<Family> make_kite_family(const Scheme& scheme, const GridCycle& cycle,
                                         const Mesh& control, int levels) {
  return std::make_unique<KiteFamily>(scheme, cycle, control, levels);
}

}  // namespace limn::fast
