#include "limn/refine/fast/patch_step.h"

#include <algorithm>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/refine/fast/lane_stencil.h"

namespace limn::fast {
namespace {

constexpr Index kChunkPoints = 65536;  // fine points that one call of a parallel loop makes

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
    for (std::size_t c = 0; c < kClasses; ++c)
      stencils[c] = LaneStencil<Real>(tables.interior[c], program);
  }

  const TriangleLayout& coarse;
  const TriangleLayout& fine;
  PatchProgram program;
  std::array<LaneStencil<Real>, kClasses> stencils;
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
        line_(static_cast<std::size_t>(program_.line)),
        numbers_(static_cast<std::size_t>(3 * program_.halo * (program_.n + 1)) * kLaneCount) {}

  /// Faces first … first + lanes - 1; those past the last face are the last one again.
  void run(Index first) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      faces_[lane] = std::min(first + static_cast<Index>(lane), control_.face_count() - 1);
    // the neighbours' points lie anywhere: they are called for before all others are read
    each_halo_row([&](Index side, Index r, Index* numbers) { number_halo(side, r, numbers); });
    load_corners();
    for (Index side = 0; side < 3; ++side) load_side(side);
    load_inside();
    each_halo_row([&](Index side, Index r, Index* numbers) { load_halo(side, r, numbers); });
    make();
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
      stride[lane] = step_.coarse.leads(h) ? 3 : -3;
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
    for (const Index slot : program_.inner_slots) {
      gather(from, grid_[static_cast<std::size_t>(slot)]);
      for (const Real*& next : from) next += 3;
    }
  }

  /// visit(side, r, the row's part of numbers_) for every row of the halo.
  template <class Visit>
  void each_halo_row(Visit visit) {
    Index* numbers = numbers_.data();
    for (Index side = 0; side < 3; ++side)
      for (Index r = 1; r <= program_.halo; ++r, numbers += (program_.n + 1) * kLanes<Real>)
        visit(side, r, numbers);
  }

  /// The vertices of row r of the neighbours across a side, lane by lane; where there is none,
  /// anything.
  void number_halo(Index side, Index r, Index* numbers) {
    const Index count = program_.n - r + 1;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index h = halfedge(lane, side);
      const Index across = control_.twin(h);
      if (across != kNone) {
        step_.coarse.column(control_.next(across), r, numbers + lane, kLanes<Real>);
      } else {
        for (Index i = 0; i < count; ++i) numbers[i * kLanes<Real> + lane] = control_.origin(h);
      }
    }
    for (Index i = 0; i < count * kLanes<Real>; ++i) __builtin_prefetch(old_point(numbers[i]));
  }

  void load_halo(Index side, Index r, const Index* numbers) {
    const Index count = program_.n - r + 1;
    auto [slot, slot_step] = slots_along(side, {r, -r});
    for (Index i = 0; i < count; ++i, slot += slot_step, numbers += kLanes<Real>) {
      Sources from;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) from[lane] = old_point(numbers[lane]);
      gather(from, grid_[static_cast<std::size_t>(slot)]);
    }
  }

  /// A block's points into the line.
  void evaluate(const PatchBlock& block) {
    for (std::size_t c = 0; c < kClasses; ++c)
      step_.stencils[c].apply(grid_.data(), block.classes[c], line_.data());
  }

  void make() {
    Targets to;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      to[lane] = step_.out + 3 * static_cast<std::ptrdiff_t>(step_.fine.face_begin(faces_[lane]));
    for (const PatchBlock& block : program_.blocks) {
      evaluate(block);
      const LanePoint<Real>* line = line_.data();
      for (Index side = 0; block.side > 0 && side < 3; ++side, line += block.side)
        put_side(side, line, block.side);
      put(
          line, block.inner, to, [](std::size_t) { return 3; }, &block != &program_.blocks.back());
      for (Real*& next : to) next += 3 * static_cast<std::ptrdiff_t>(block.inner);
    }
  }

  /// Points to consecutive places, or of lanes with `stride` 0 all to one; of the very last point
  /// nothing spills over where `spill_last` is false.
  template <class Stride>
  static void put(const LanePoint<Real>* line, Index count, const Targets& to, Stride stride,
                  bool spill_last) {
    const std::ptrdiff_t spilling = spill_last ? count : count - 1;
    const auto place = [&](std::ptrdiff_t i) {
      Targets places;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane)
        places[lane] = to[lane] + i * stride(lane);
      return places;
    };
    for (std::ptrdiff_t i = 0; i < spilling; ++i) scatter<true>(line[i], place(i));
    if (spilling >= 0 && spilling < count) scatter<false>(line[spilling], place(spilling));
  }

  /// A side's points are written by the patch whose half-edge stands for the edge.
  void put_side(Index side, const LanePoint<Real>* line, Index count) {
    Targets to;
    Strides stride;
    bool any = false;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index h = halfedge(lane, side), e = control_.edge(h);
      const bool own = step_.fine.leads(h);
      any = any || own;
      to[lane] = own ? step_.out + 3 * static_cast<std::ptrdiff_t>(step_.fine.edge_begin(e))
                     : unwanted_[lane].data();
      stride[lane] = own ? 3 : 0;
    }
    if (any)
      put(
          line, count, to, [&](std::size_t lane) { return stride[lane]; }, false);
  }

  const LevelStep<Real>& step_;
  const PatchProgram& program_;
  const Mesh& control_;
  std::vector<LanePoint<Real>> grid_;  // coarse points of the patch and its halo
  std::vector<LanePoint<Real>> line_;  // fine points of a block
  std::vector<Index> numbers_;         // vertices of the halo's rows
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
