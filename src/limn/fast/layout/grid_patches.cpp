#include "limn/fast/layout/grid_patches.h"

#include <algorithm>

#include "limn/base/parallel.h"
#include "limn/fast/layout/star_places.h"

namespace limn::fast {
namespace {

constexpr Index kPatchGrain = 2048;

/// The runs of a patch: points on a side, inside of the grid, or its centres.
struct Run {
  GridLayout::Spot::On on;
  Index side = 0;
};

class Patches {
 public:
  Patches(const GridStep& step, std::vector<Stencil> stencils, const PatchTopology& faces,
          Made made)
      : step_(step.step),
        old_(step.old_points),
        made_(made == Made::same_level ? step.old_points : step.new_points),
        in_place_(made == Made::same_level),
        stencils_(std::move(stencils)),
        faces_(faces) {}

  PatchPlan plan() {
    make_runs();
    const PatchFrame frame(old_, halo_);
    PatchPlan plan;
    for (const Offset p : frame.places()) shape_.frame.push_back(step_.to_local(p));
    const Index unit = old_.unit();
    if (old_.has_centres()) {
      for (const Offset p : centre_places(old_.lattice(), old_.n(), unit))
        shape_.inner.push_back(step_.to_local(p));
      plan.inner_begin = old_.centre_begin(0);
    } else {
      shape_.inner = inner_places(old_.lattice(), old_.n());
      plan.inner_begin = old_.face_begin(0);
    }
    plan.patches = old_.control().face_count();
    const std::size_t each = shape_.frame.size(), runs = shape_.runs.size();
    plan.frame = base::HugeArray<Index>(static_cast<std::size_t>(plan.patches) * each);
    plan.runs = base::HugeArray<Index>(static_cast<std::size_t>(plan.patches) * runs);
    base::parallel_for(
        Index{0}, plan.patches,
        [&](Index first, Index last) {
          for (Index f = first; f < last; ++f) {
            const PatchTopology::Face face = faces_.face(f);
            frame.number(f, face, plan.frame.data() + static_cast<std::size_t>(f) * each);
            number_runs(f, face, plan.runs.data() + static_cast<std::size_t>(f) * runs);
          }
        },
        kPatchGrain);
    plan.shape = std::move(shape_);
    plan.stencils = std::move(stencils_);
    return plan;
  }

 private:
  void make_runs() {
    const Lattice lattice = made_.lattice();
    const Index side = made_.side(), unit = made_.unit();
    std::vector<Offset> points;
    for (Index k = 0; k < made_.sides(); ++k) {
      points.clear();
      for (Index t = unit; t < side; t += unit)
        points.push_back(in_patch(lattice, side, k, {t, 0}));
      add_run({GridLayout::Spot::edge, k}, points);
    }
    points = inner_places(lattice, made_.n());
    for (Offset& p : points) p = {unit * p.a, unit * p.b};
    add_run({GridLayout::Spot::inner}, points);
    if (made_.has_centres())
      add_run({GridLayout::Spot::centre}, centre_places(lattice, made_.n(), unit));
  }

  void add_run(Run run, const std::vector<Offset>& points) {
    if (points.empty()) return;
    runs_.push_back(run);
    std::vector<FinePoint>& to = shape_.runs.emplace_back();
    to.reserve(points.size());
    for (const Offset p : points) {
      const Offset anchor = in_place_ ? p : step_.anchor_of(p.a, p.b);
      const std::size_t stencil = in_place_ ? 0 : step_.class_of(p.a, p.b);
      to.push_back({stencil, step_.to_local(anchor)});
      if (in_place_)
        for (const Stencil& all : stencils_) see(anchor, all);
      else
        see(anchor, stencils_[stencil]);
    }
  }

  /// Rows beyond the sides that a new point takes from, as far as the neighbours go: what looks
  /// farther is in a zone.
  void see(Offset anchor, const Stencil& stencil) {
    const Index side = old_.side();
    for (const Tap& tap : stencil) {
      const Offset step = step_.from_local(tap.place);
      const Offset place{anchor.a + step.a, anchor.b + step.b};
      if (patch_sees(old_.lattice(), side, place))
        halo_ = std::max(halo_, rows_beyond(old_.lattice(), side, place));
    }
  }

  void number_runs(Index f, const PatchTopology::Face& face, Index* out) const {
    for (const Run& run : runs_) {
      if (run.on == GridLayout::Spot::inner) {
        *out++ = made_.face_begin(f);
      } else if (run.on == GridLayout::Spot::centre) {
        *out++ = made_.centre_begin(f);
      } else {
        const EdgeCode side = face.codes()[run.side];
        *out++ = (side & 1) != 0 ? made_.edge_begin(side >> 1) : kNone;
      }
    }
  }

  LatticeStep step_;
  GridLayout old_, made_;
  bool in_place_;
  std::vector<Stencil> stencils_;
  const PatchTopology& faces_;
  PatchShape shape_;
  std::vector<Run> runs_;
  Index halo_ = 0;
};

}  // namespace

PatchPlan plan_patches(const GridStep& step, std::vector<Stencil> stencils,
                       const PatchTopology& faces, Made made) {
  return Patches(step, std::move(stencils), faces, made).plan();
}

}  // namespace limn::fast
