#include "limn/fast/kernel/patch_program.h"

#include <algorithm>

namespace limn::fast {
namespace {

constexpr Index kBlockPoints = 256;  // so that a line stays in the nearest cache

class ProgramMaker {
 public:
  ProgramMaker(const PatchShape& shape, const std::vector<Stencil>& stencils, std::size_t each)
      : shape_(shape), stencils_(stencils), each_(each) {}

  PatchProgram make() {
    find_box();
    for (const Offset place : shape_.frame) program_.frame.push_back(slot(place));
    for (const Offset place : shape_.inner) program_.inner.push_back(slot(place));
    for (std::size_t run = 0; run < shape_.runs.size(); ++run) add_run(run);
    return std::move(program_);
  }

 private:
  void enclose(Offset place) {
    low_ = {std::min(low_.a, place.a), std::min(low_.b, place.b)};
    high_ = {std::max(high_.a, place.a), std::max(high_.b, place.b)};
  }

  void find_box() {
    for (const Offset place : shape_.frame) enclose(place);
    for (const Offset place : shape_.inner) enclose(place);
    for (const std::vector<FinePoint>& run : shape_.runs)
      for (const FinePoint& point : run)
        for (std::size_t s = point.stencil; s < point.stencil + each_; ++s)
          for (const Tap& tap : stencils_[s])
            enclose({point.anchor.a + tap.place.a, point.anchor.b + tap.place.b});
    program_.pitch = high_.a - low_.a + 1;
    program_.slots = program_.pitch * (high_.b - low_.b + 1);
  }

  [[nodiscard]] Index slot(Offset place) const {
    return program_.slot_step({place.a - low_.a, place.b - low_.b});
  }

  void add_run(std::size_t run) {
    const std::vector<FinePoint>& points = shape_.runs[run];
    const auto count = static_cast<Index>(points.size());
    for (Index first = 0; first < count;) {
      if (program_.blocks.empty() || used_ >= kBlockPoints) {
        program_.blocks.emplace_back();
        used_ = 0;
      }
      PatchBlock& block = program_.blocks.back();
      const Index part = std::min(count - first, kBlockPoints - used_);
      block.parts.push_back({run, first, part});
      for (Index i = first; i < first + part; ++i) add(block, points[static_cast<std::size_t>(i)]);
      first += part;
    }
  }

  void add(PatchBlock& block, const FinePoint& point) {
    auto same = std::find_if(block.points.begin(), block.points.end(),
                             [&](const auto& known) { return known.stencil == point.stencil; });
    if (same == block.points.end()) {
      same = block.points.emplace(same);
      same->stencil = point.stencil;
    }
    same->anchors.push_back(slot(point.anchor));
    same->places.push_back(used_++);
    program_.line = std::max(program_.line, used_);
  }

  const PatchShape& shape_;
  const std::vector<Stencil>& stencils_;
  std::size_t each_;
  PatchProgram program_;
  Offset low_, high_;
  Index used_ = 0;  // of the line
};

}  // namespace

PatchProgram make_patch_program(const PatchShape& shape, const std::vector<Stencil>& stencils,
                                std::size_t each) {
  return ProgramMaker(shape, stencils, each).make();
}

}  // namespace limn::fast
