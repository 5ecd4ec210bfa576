#include "limn/refine/fast/patch_step.h"

#include <algorithm>

#include "limn/base/parallel.h"
#include "limn/refine/fast/lane_stencil.h"

namespace limn::fast {
namespace {

constexpr std::size_t kChunkPoints = 65536;  // new points that one call of a parallel loop makes

/// Takes a few patches at a time through the step.
template <class Real>
class PatchWorker {
 public:
  PatchWorker(const PatchPlan& plan, const PatchProgram& program,
              const std::vector<LaneStencil<Real>>& stencils, const Real* in, Real* out)
      : plan_(plan),
        program_(program),
        stencils_(stencils),
        in_(in),
        out_(out),
        grid_(static_cast<std::size_t>(program.slots)),
        line_(static_cast<std::size_t>(program.line)) {}

  /// Patches first … first + lanes - 1; those past the last are the last one again.
  void run(Index first) {
    choose(first + kLanes<Real>);
    for (const Index* numbers : frames_)  // they lie anywhere
      for (std::size_t i = 0; i < program_.frame.size(); ++i) __builtin_prefetch(old(numbers[i]));
    choose(first);
    load_frame();
    load_inner();
    for (const PatchBlock& block : program_.blocks) make(block);
  }

 private:
  static constexpr auto kLaneCount = static_cast<std::size_t>(kLanes<Real>);
  using Sources = PerLane<Real, const Real*>;
  using Targets = PerLane<Real, Real*>;
  using Strides = PerLane<Real, std::ptrdiff_t>;

  [[nodiscard]] const Real* old(Index number) const {
    return in_ + 3 * static_cast<std::ptrdiff_t>(number);
  }

  void choose(Index first) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      patches_[lane] = std::min(first + static_cast<Index>(lane), plan_.patches - 1);
      frames_[lane] =
          plan_.frame.data() + static_cast<std::size_t>(patches_[lane]) * program_.frame.size();
    }
  }

  void load_frame() {
    for (std::size_t i = 0; i < program_.frame.size(); ++i) {
      Sources from;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) from[lane] = old(frames_[lane][i]);
      gather(from, grid_[static_cast<std::size_t>(program_.frame[i])]);
    }
  }

  void load_inner() {
    Sources from;
    const auto each = static_cast<Index>(program_.inner.size());
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      from[lane] = old(plan_.inner_begin + patches_[lane] * each);
    for (const Index slot : program_.inner) {
      gather(from, grid_[static_cast<std::size_t>(slot)]);
      for (const Real*& next : from) next += 3;
    }
  }

  void make(const PatchBlock& block) {
    for (const StencilPoints& points : block.points)
      stencils_[points.stencil].apply(grid_.data(), points, line_.data());
    const LanePoint<Real>* line = line_.data();
    for (const RunPart& part : block.parts) {
      put(part, line);
      line += part.count;
    }
  }

  /// Where the patch in a lane is not to make the run, its points go nowhere, one over the other.
  void put(const RunPart& part, const LanePoint<Real>* line) {
    const std::vector<FinePoint>& run = plan_.shape.runs[part.run];
    Targets to;
    Strides stride;
    std::size_t made = 0;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const Index begin =
          plan_.runs[static_cast<std::size_t>(patches_[lane]) * plan_.shape.runs.size() + part.run];
      made += begin != kNone ? 1U : 0U;
      to[lane] = begin != kNone ? out_ + 3 * static_cast<std::ptrdiff_t>(begin + part.first)
                                : unwanted_[lane].data();
      stride[lane] = begin != kNone ? 3 : 0;
    }
    if (made == 0) return;
    const bool ends = part.first + part.count == static_cast<Index>(run.size());
    if (made == kLaneCount) {
      put(
          line, part.count, to, [](std::size_t) { return 3; }, ends);
    } else {
      put(
          line, part.count, to, [&](std::size_t lane) { return stride[lane]; }, ends);
    }
  }

  /// A point may be written with a number after it, which the next one overwrites; not the last.
  template <class Stride>
  static void put(const LanePoint<Real>* line, Index count, const Targets& to, Stride stride,
                  bool ends) {
    const auto place = [&](std::ptrdiff_t i) {
      Targets places;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane)
        places[lane] = to[lane] + i * stride(lane);
      return places;
    };
    const std::ptrdiff_t spilling = ends ? count - 1 : count;
    for (std::ptrdiff_t i = 0; i < spilling; ++i) scatter<true>(line[i], place(i));
    if (ends) scatter<false>(line[spilling], place(spilling));
  }

  const PatchPlan& plan_;
  const PatchProgram& program_;
  const std::vector<LaneStencil<Real>>& stencils_;
  const Real* in_;
  Real* out_;
  std::vector<LanePoint<Real>> grid_;  // old points of the patch and round it
  std::vector<LanePoint<Real>> line_;  // new points of a block
  PerLane<Real, Index> patches_{};
  PerLane<Real, const Index*> frames_{};
  PerLane<Real, std::array<Real, 4>> unwanted_{};
};

}  // namespace

template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out) {
  if (program.blocks.empty() || plan.patches == 0) return;
  std::vector<LaneStencil<Real>> stencils;
  for (const Stencil& stencil : plan.stencils) stencils.emplace_back(stencil, program);
  std::size_t points = 1;
  for (const std::vector<FinePoint>& run : plan.shape.runs) points += run.size();
  const Index batches = (plan.patches + kLanes<Real> - 1) / kLanes<Real>;
  const std::size_t grain = std::max<std::size_t>(1, kChunkPoints / (kLanes<Real> * points));
  parallel_for(
      Index{0}, batches,
      [&](Index first, Index last) {
        PatchWorker<Real> worker(plan, program, stencils, in, out);
        for (Index b = first; b < last; ++b) worker.run(b * kLanes<Real>);
      },
      static_cast<std::ptrdiff_t>(grain));
}

template void make_patches<float>(const PatchPlan&, const PatchProgram&, const float*, float*);
template void make_patches<double>(const PatchPlan&, const PatchProgram&, const double*, double*);

}  // namespace limn::fast
