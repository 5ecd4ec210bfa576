#pragma once
/// Patches, several at once (lanes.h): reading their old points, writing their new ones.

#include <algorithm>

#include "limn/base/parallel.h"
#include "limn/fast/kernel/lanes.h"
#include "limn/fast/kernel/patch_step.h"

namespace limn::fast {

/// Reads a few patches at a time, and writes what was made of them.
template <class Real>
class PatchWorker {
 public:
  PatchWorker(const PatchPlan& plan, const PatchProgram& program, const PatchRange& range,
              const Real* in)
      : plan_(plan),
        program_(program),
        range_(range),
        in_(in),
        grid_(static_cast<std::size_t>(program.slots)) {}

  /// Reads patches first … first + lanes - 1; those past the range's last are the last one again.
  void load(Index first) {
    choose(first + kLanes<Real>);
    for (const Index* numbers : frames_)  // they lie anywhere
      for (std::size_t i = 0; i < program_.frame.size(); ++i) __builtin_prefetch(old(numbers[i]));
    choose(first);
    load_frame();
    load_inner();
  }

  /// The old points, by slots.
  [[nodiscard]] const LanePoint<Real>* grid() const { return grid_.data(); }

  /// Writes a block's line.
  void put(const PatchBlock& block, const LanePoint<Real>* line, Real* out) {
    for (const RunPart& part : block.parts) {
      put(part, line, out);
      line += part.count;
    }
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
      patches_[lane] = std::min(first + static_cast<Index>(lane), range_.last - 1);
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

  /// Where the patch in a lane is not to make the run, its points go nowhere, one over the other.
  void put(const RunPart& part, const LanePoint<Real>* line, Real* out) {
    const std::vector<FinePoint>& run = plan_.shape.runs[part.run];
    Targets to;
    Strides stride;
    std::size_t made = 0;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const auto patch = static_cast<std::size_t>(patches_[lane] - range_.first);
      const Index begin = range_.runs[patch * plan_.shape.runs.size() + part.run];
      made += begin != kNone ? 1U : 0U;
      to[lane] = begin != kNone ? out + 3 * static_cast<std::ptrdiff_t>(begin + part.first)
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
  const PatchRange range_;
  const Real* in_;
  std::vector<LanePoint<Real>> grid_;  // old points of the patch and round it
  PerLane<Real, Index> patches_{};
  PerLane<Real, const Index*> frames_{};
  PerLane<Real, std::array<Real, 4>> unwanted_{};
};

/// Patches that one call of a parallel loop takes: whole batches.
template <class Real>
[[nodiscard]] std::ptrdiff_t patch_grain(const PatchPlan& plan) {
  constexpr std::size_t kChunkPoints = 65536;
  std::size_t points = 1;
  for (const std::vector<FinePoint>& run : plan.shape.runs) points += run.size();
  return kLanes<Real> * static_cast<std::ptrdiff_t>(
                            std::max<std::size_t>(1, kChunkPoints / (kLanes<Real> * points)));
}

/// work(worker) after each batch of the range has been read.
template <class Real, class Work>
void for_batches(const PatchPlan& plan, const PatchProgram& program, const PatchRange& range,
                 const Real* in, Work work) {
  PatchWorker<Real> worker(plan, program, range, in);
  for (Index first = range.first; first < range.last; first += kLanes<Real>) {
    worker.load(first);
    work(worker);
  }
}

}  // namespace limn::fast
