#include "limn/refine/fast/patch_step.h"

#include <algorithm>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/refine/fast/lanes.h"

namespace limn::fast {
namespace {

constexpr Index kChunkPoints = 16384;  // fine points that one call of a parallel loop makes
constexpr int kUnrolled = 16;          // stencils of up to so many taps are unrolled

/// A stencil with its weights in every lane.
template <class Real>
struct LaneStencil {
  std::vector<Index> slots;
  std::vector<Vector<Real>> weights;
};

/// Sums of `taps` terms at count anchors, `step` apart, into every second element of `to`.
/// `unrolled` > 0: taps is known beforehand.
template <class Real, int unrolled>
void apply_stencil(const LanePoint<Real>* anchor, std::ptrdiff_t step, Index count,
                   const LaneStencil<Real>& stencil, LanePoint<Real>* to) {
  const int taps = unrolled > 0 ? unrolled : static_cast<int>(stencil.slots.size());
  const Index* slots = stencil.slots.data();
  const Vector<Real>* weights = stencil.weights.data();
  for (Index i = 0; i < count; ++i, anchor += step, to += 2) {
    const LanePoint<Real>& first = anchor[slots[0]];
    LanePoint<Real> sum{weights[0] * first.x, weights[0] * first.y, weights[0] * first.z};
    for (int t = 1; t < taps; ++t) {
      const LanePoint<Real>& point = anchor[slots[t]];
      sum.x += weights[t] * point.x;
      sum.y += weights[t] * point.y;
      sum.z += weights[t] * point.z;
    }
    *to = sum;
  }
}

template <class Real>
using Applier = void (*)(const LanePoint<Real>*, std::ptrdiff_t, Index, const LaneStencil<Real>&,
                         LanePoint<Real>*);
template <class Real, std::size_t... taps>
constexpr std::array<Applier<Real>, sizeof...(taps)> make_appliers(std::index_sequence<taps...>) {
  return {apply_stencil<Real, static_cast<int>(taps)>...};
}

/// One level's step; all that does not depend on the patch.
template <class Real>
struct LevelStep {
  LevelStep(const TriangleLayout& coarse_, const TriangleLayout& fine_, const StencilTables& tables,
            const Real* in_, Real* out_)
      : coarse(coarse_),
        fine(fine_),
        program(make_patch_program(coarse.n(), tables.halo)),
        in(in_),
        out(out_) {
    static constexpr auto kAppliers =
        make_appliers<Real>(std::make_index_sequence<kUnrolled + 1>());
    for (std::size_t c = 0; c < kClasses; ++c) {
      for (const Tap& tap : tables.interior[c]) {
        stencils[c].slots.push_back(program.slot_step(tap.place));
        stencils[c].weights.push_back(Vector<Real>{} + static_cast<Real>(tap.weight));
      }
      const std::size_t taps = stencils[c].slots.size();
      appliers[c] = kAppliers[taps <= kUnrolled ? taps : 0];
    }
  }

  const TriangleLayout& coarse;
  const TriangleLayout& fine;
  PatchProgram program;
  std::array<LaneStencil<Real>, kClasses> stencils;
  std::array<Applier<Real>, kClasses> appliers{};
  const Real* in;
  Real* out;
};

/// Takes a few patches at a time through the step.
template <class Real>
class PatchWorker {
 public:
  explicit PatchWorker(const LevelStep<Real>& step)
      : step_(step),
        program_(step.program),
        control_(step.coarse.control()),
        grid_(static_cast<std::size_t>(program_.slots)),
        line_(2 * static_cast<std::size_t>(program_.n) + 1),
        numbers_(static_cast<std::size_t>(program_.n + 1) * kLaneCount) {}

  /// Faces first … first + lanes - 1; those past the last face are the last one again.
  void run(Index first) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      faces_[lane] = std::min(first + static_cast<Index>(lane), control_.face_count() - 1);
    load_corners();
    for (Index side = 0; side < 3; ++side) {
      load_side(side);
      for (Index r = 1; r <= program_.halo; ++r) load_halo(side, r);
    }
    load_inside();
    for (Index side = 0; side < 3; ++side) make_side(side);
    make_inside();
  }

 private:
  static constexpr auto kLaneCount = static_cast<std::size_t>(kLanes<Real>);
  using Sources = PerLane<Real, const Real*>;
  using Targets = PerLane<Real, Real*>;
  using Strides = PerLane<Real, std::ptrdiff_t>;

  [[nodiscard]] Index halfedge(std::size_t lane, Index side) const {
    return 3 * faces_[lane] + side;
  }
  [[nodiscard]] const Real* old_point(Index v) const {
    return step_.in + 3 * static_cast<std::ptrdiff_t>(v);
  }

  /// Where point (a, b) of the frame of a side lies in the patch.
  [[nodiscard]] Offset in_patch(Index side, Offset p) const {
    for (; side > 0; --side) p = {program_.n - p.a - p.b, p.a};
    return p;
  }
  /// The local slot of a point of a side's frame, and the step to the next along the side.
  [[nodiscard]] std::pair<Index, Index> slots_along(Index side, Offset first) const {
    const Offset from = in_patch(side, first), to = in_patch(side, {first.a + 1, first.b});
    const Index slot = program_.slot(from.a, from.b);
    return {slot, program_.slot(to.a, to.b) - slot};
  }

  void load_corners() {
    for (Index side = 0; side < 3; ++side) {
      Sources from;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane)
        from[lane] = old_point(control_.origin(halfedge(lane, side)));
      gather(from, grid_[static_cast<std::size_t>(slots_along(side, {0, 0}).first)]);
    }
  }

  void load_side(Index side) {
    if (program_.n < 2) return;
    Sources from;
    Strides stride;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index h = halfedge(lane, side);
      from[lane] = old_point(step_.coarse.edge_point(h, 1));
      stride[lane] = control_.halfedge_of_edge(control_.edge(h)) == h ? 3 : -3;
    }
    auto [slot, slot_step] = slots_along(side, {1, 0});
    for (Index t = 1; t < program_.n; ++t, slot += slot_step) {
      gather(from, grid_[static_cast<std::size_t>(slot)]);
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) from[lane] += stride[lane];
    }
  }

  void load_inside() {
    Sources from;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      from[lane] = old_point(step_.coarse.face_begin(faces_[lane]));
    for (Index y = 1; y + 1 < program_.n; ++y) {
      LanePoint<Real>* to = &grid_[static_cast<std::size_t>(program_.slot(1, y))];
      for (Index x = 1; x + y < program_.n; ++x, ++to) {
        gather(from, *to);
        for (std::size_t lane = 0; lane < kLaneCount; ++lane) from[lane] += 3;
      }
    }
  }

  /// Row r of the neighbours across a side; where there is none, anything.
  void load_halo(Index side, Index r) {
    const Index count = program_.n - r + 1;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index h = halfedge(lane, side);
      const Index across = control_.twin(h);
      if (across != kNone) {
        step_.coarse.column(control_.next(across), r, &numbers_[lane], kLaneCount);
      } else {
        for (Index i = 0; i < count; ++i)
          numbers_[static_cast<std::size_t>(i) * kLaneCount + lane] = control_.origin(h);
      }
    }
    auto [slot, slot_step] = slots_along(side, {r, -r});
    const Index* number = numbers_.data();
    for (Index i = 0; i < count; ++i, slot += slot_step, number += kLaneCount) {
      Sources from;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) from[lane] = old_point(number[lane]);
      gather(from, grid_[static_cast<std::size_t>(slot)]);
    }
  }

  /// The run's points into the line.
  void evaluate(const PatchRun& run) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t c = run.classes[i];
      step_.appliers[c](&grid_[static_cast<std::size_t>(run.anchors[i])], run.anchor_step,
                        (run.count + 1 - static_cast<Index>(i)) / 2, step_.stencils[c], &line_[i]);
    }
  }

  /// The line's first points to consecutive places; of the very last one nothing spills over.
  void put(Index count, Targets& to, const Strides& stride, bool spill_last) {
    const auto advance = [&] {
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) to[lane] += stride[lane];
    };
    const Index spilling = spill_last ? count : count - 1;
    for (Index i = 0; i < spilling; ++i, advance())
      scatter<true>(line_[static_cast<std::size_t>(i)], to);
    for (Index i = spilling; i < count; ++i, advance())
      scatter<false>(line_[static_cast<std::size_t>(i)], to);
  }

  /// A side's points are written by the patch whose half-edge stands for the edge.
  void make_side(Index side) {
    Targets to;
    Strides stride;
    bool any = false;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index h = halfedge(lane, side), e = control_.edge(h);
      const bool own = control_.halfedge_of_edge(e) == h;
      any = any || own;
      to[lane] = own ? step_.out + 3 * static_cast<std::ptrdiff_t>(step_.fine.edge_begin(e))
                     : unwanted_[lane].data();
      stride[lane] = own ? 3 : 0;
    }
    if (!any) return;
    const PatchRun& run = program_.sides[static_cast<std::size_t>(side)];
    evaluate(run);
    put(run.count, to, stride, false);
  }

  void make_inside() {
    Targets to;
    Strides stride;
    stride.fill(3);
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      to[lane] = step_.out + 3 * static_cast<std::ptrdiff_t>(step_.fine.face_begin(faces_[lane]));
    for (const PatchRun& run : program_.rows) {
      evaluate(run);
      put(run.count, to, stride, &run != &program_.rows.back());
    }
  }

  const LevelStep<Real>& step_;
  const PatchProgram& program_;
  const Mesh& control_;
  std::vector<LanePoint<Real>> grid_;  // coarse points of the patch and its halo
  std::vector<LanePoint<Real>> line_;  // fine points of a run
  std::vector<Index> numbers_;         // vertices of a halo row, lane by lane
  PerLane<Real, Index> faces_{};
  PerLane<Real, std::array<Real, 4>> unwanted_{};
};

}  // namespace

template <class Real>
void refine_patches(const TriangleLayout& coarse, const TriangleLayout& fine,
                    const StencilTables& tables, const Real* in, Real* out) {
  const LevelStep<Real> step(coarse, fine, tables, in, out);
  const Index faces = coarse.control().face_count();
  const Index batches = (faces + kLanes<Real> - 1) / kLanes<Real>;
  const Index grain = std::max(1, kChunkPoints / (kLanes<Real> * (fine.face_size() + 1)));
  parallel_for(
      Index{0}, batches,
      [&](Index first, Index last) {
        PatchWorker<Real> worker(step);
        for (Index b = first; b < last; ++b) worker.run(b * kLanes<Real>);
      },
      grain);
}

template void refine_patches<float>(const TriangleLayout&, const TriangleLayout&,
                                    const StencilTables&, const float*, float*);
template void refine_patches<double>(const TriangleLayout&, const TriangleLayout&,
                                     const StencilTables&, const double*, double*);

}  // namespace limn::fast
