#include "limn/fast/families/kite_family.h"

#include <cassert>

#include "limn/base/parallel.h"
#include "limn/fast/layout/kite_patches.h"
#include "limn/fast/limit/limit_tables.h"
#include "limn/fast/limit/one_ring.h"
#include "limn/fast/plain/plain_order.h"
#include "limn/fast/sites/kite_rows.h"

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
    if (!read_tables(scheme)) return;
    plain_ = first_;
    if (own_face()) return;
    const Index smallest = tables_->reach.smallest_side;
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
    if (level == first_) return plan_first();
    const KiteLayout coarse = layout(level), fine = layout(level + 1);
    std::vector<FinePoint> points;
    for (Index y = 1; y < step_.edge * coarse.n(); y += step_.new_edge)
      for (Index x = 1; x < step_.edge * coarse.n(); x += step_.new_edge)
        points.push_back({step_.class_of(x, y), step_.to_local(step_.anchor_of(x, y))});
    std::optional<StepPlan> made =
        plan(*tables_, rims_, {coarse, step_.edge}, {fine, step_.new_edge}, std::move(points));
    assert(made);
    return *std::move(made);
  }

  /// Of a rule that looks beyond its face no limit points are known at the boundary.
  [[nodiscard]] Result<std::optional<StepPlan>> limit_plan(int level,
                                                           LimitReader& reader) const override {
    using Found = std::optional<StepPlan>;
    if (!tables_ || (level == first_ && !own_face())) return Found();
    if (level <= first_ + 1 && own_face()) return plan_one_rings(level, reader);
    const LimitControl control{split_, cycle_, kinds(), false, false};
    const auto tables = read_limit_tables(control, level - first_ - 1, level, reader);
    if (!tables) return tables.error();
    if (!*tables) return Found();
    RimTables rims;
    if (kites_.has_rims()) {
      if (!own_face()) return Found();
      auto read = read_limit_rims(split_, cycle_, patterns(), level, reader);
      if (!read) return read.error();
      if (!*read) return Found();
      rims = **std::move(read);
    }
    const KiteLayout at = layout(level);
    std::vector<FinePoint> points;
    for (Index y = 0; y < at.n(); ++y)
      for (Index x = 0; x < at.n(); ++x) points.push_back({0, {x, y}});
    return plan(**tables, rims, {at, step_.edge}, {at, step_.edge}, std::move(points));
  }

  [[nodiscard]] std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const override {
    if (plain_ <= first_) return {};
    return kite_order(layout(plain_), steps.back().mesh);
  }

  void write_faces(int level, std::span<Index> corners) const override {
    if (level > first_) return layout(level).write_faces(corners.data());
    base::parallel_for_each(control_.halfedge_count(), [&](Index h) {
      corners[static_cast<std::size_t>(h)] = control_.origin(h);
    });
  }

  [[nodiscard]] Index corners_per_face() const override { return kites_.is_regular() ? 4 : 0; }

  void write_face_begin(int level, std::span<Index> begin) const override {
    if (level > first_) return layout(level).write_face_begin(begin.data());
    base::parallel_for_each(control_.face_count() + 1, [&](Index f) {
      begin[static_cast<std::size_t>(f)] = control_.face_begin(f);
    });
  }

 private:
  [[nodiscard]] KiteLayout layout(int level) const {
    assert(level > first_);
    return {kites_, kites_.inner_edges().empty() ? 1 : power(cycle_.cut, level - first_ - 1)};
  }
  /// Whether the rule sees its own face alone. Then it may stand in the first step, too.
  [[nodiscard]] bool own_face() const { return tables_->reach.rim == 1; }
  [[nodiscard]] std::vector<StarShape> kinds() const {
    std::vector<StarShape> kinds{{Lattice::quad, 0}};
    for (const Index sides : groups_.sides) kinds.push_back({Lattice::quad, sides});
    return kinds;
  }
  [[nodiscard]] std::set<RimPattern> patterns() const {
    std::set<RimPattern> patterns;
    for (const auto& [pattern, faces] : groups_.rims) patterns.insert(pattern);
    return patterns;
  }

  bool read_tables(const Scheme& scheme) {
    auto interior = read_stencils(scheme, cycle_, kinds(), {true, kites_.has_rims()});
    if (!interior) return false;
    if (kites_.has_rims()) {
      Result<RimTables> rims = read_rims(scheme, cycle_, patterns(), interior->front().reach);
      if (!rims) return false;
      rims_ = std::move(*rims);
    }
    tables_ = std::move(interior->front());
    return true;
  }

  /// Nothing where stencils look past the next patch.
  [[nodiscard]] std::optional<StepPlan> plan(const StencilTables& tables, const RimTables& rims,
                                             const KiteLevel& old, const KiteLevel& made,
                                             std::vector<FinePoint> points) const {
    StepPlan plan;
    auto patches = plan_kite_patches(old.layout, made.layout, std::move(points), tables.interior);
    if (!patches) return std::nullopt;
    plan.patches = *std::move(patches);
    if (kites_.has_rims()) add_rim_rows(rims, groups_, old, made, plan.rows);
    const bool overlap = tables.reach.zones_meet(old.edge * old.layout.n());
    for (const KiteCentres& centres : groups_.centres)
      for (const ZoneTable& table : tables.stars.at(centres.sides).tables)
        plan.rows.push_back(centre_rows(table, centres, old, made, overlap));
    add_isolated(tables, old.layout.isolated(), made.layout.isolated(), plan);
    return plan;
  }

  static void add_isolated(const StencilTables& tables, const std::vector<Index>& from,
                           const std::vector<Index>& to, StepPlan& plan) {
    if (!from.empty())
      plan.rows.push_back({tables.stars.at(0).tables.front().rows, base::HugeArray<Index>(from),
                           base::HugeArray<Index>(to), false});
  }

  [[nodiscard]] StepPlan plan_first() const {
    const KiteLayout fine = layout(first_ + 1);
    StepPlan plan;
    for (const Index sides : groups_.sides) {
      const ZoneTable& table = tables_->stars.at(sides).tables.front();
      std::vector<Index> sources, targets;
      for (Index f = 0; f < control_.face_count(); ++f) {
        if (control_.degree(f) != sides) continue;
        const Index h = control_.face_begin(f);
        for (const SectorPoint& p : table.sources) sources.push_back(control_.origin(h + p.sector));
        for (const SectorPoint& p : table.targets)
          targets.push_back(fine.point(h + p.sector, 0, 0));
      }
      if (!sources.empty())
        plan.rows.push_back(
            {table.rows, base::HugeArray<Index>(sources), base::HugeArray<Index>(targets), false});
    }
    add_isolated(*tables_, kites_.isolated(), fine.isolated(), plan);
    return plan;
  }

  /// At the first two levels.
  [[nodiscard]] Result<std::optional<StepPlan>> plan_one_rings(int level,
                                                               LimitReader& reader) const {
    if (level == first_) return fast::plan_one_rings(control_, {}, level, reader);
    const KiteLayout at = layout(level);
    std::vector<Index> numbers;
    numbers.reserve(static_cast<std::size_t>(control_.halfedge_count()));
    for (Index h = 0; h < control_.halfedge_count(); ++h) numbers.push_back(at.point(h, 0, 0));
    for (const Index v : at.isolated()) numbers.push_back(v);
    return fast::plan_one_rings(split_.apply(control_, 0).mesh, numbers, level, reader);
  }

  int first_;  // the level of control_
  GridCycle cycle_;
  LatticeStep step_{cycle_, 0};
  const Split& split_;
  Mesh owned_;  // where it is not the control mesh itself
  const Mesh& control_;
  Kites kites_;
  KiteGroups groups_;
  int plain_;
  std::optional<StencilTables> tables_;
  RimTables rims_;
};

}  // namespace

std::unique_ptr<Family> make_kite_family(const Scheme& scheme, const GridCycle& cycle,
                                         const Mesh& control, int levels) {
  return std::make_unique<KiteFamily>(scheme, cycle, control, levels);
}

}  // namespace limn::fast
