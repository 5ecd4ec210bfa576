#pragma once
/// What a FastRefiner holds, for the sources of this folder.

#include <memory>
#include <optional>
#include <vector>

#include "limn/fast/families/family.h"
#include "limn/fast/fast_refiner.h"
#include "limn/fast/kernel/patch_program.h"
#include "limn/fast/plain/plain_steps.h"

namespace limn {

namespace fast {

/// A step, made ready.
struct ReadyStep {
  StepPlan plan;
  PatchProgram program;
};

}  // namespace fast

struct FastRefiner::State {
  Mesh control;
  int levels = 0;
  Sharpness sharpness;
  std::unique_ptr<fast::Family> family;
  std::optional<fast::PlainSteps> plain;
  fast::Family::Size size;
  std::vector<fast::ReadyStep> steps;
  std::vector<Index> vertices;  ///< before each step, and after the last

  State(Mesh mesh, int steps_wanted, Sharpness sharp = {})
      : control(std::move(mesh)), levels(steps_wanted), sharpness(std::move(sharp)) {}

  /// Finds the family, and the size of the result; fails where that is beyond an index.
  [[nodiscard]] Status choose(const Scheme& scheme);
  /// Whether the plain engine makes all steps.
  [[nodiscard]] bool is_plain() const { return family->plain_steps() == levels; }
  /// Works out the steps, once there is memory for what they make.
  [[nodiscard]] Status work_out(const Scheme& scheme);

  /// The points after the first `count` of `steps`; `out` has room for one number more.
  template <class Real>
  void evaluate(const Real* control_points, std::size_t count, Real* out,
                Scratch<Real>& scratch) const;
};

struct FastRefiner::Limit::Plan {
  fast::ReadyStep step;
};

}  // namespace limn
