#pragma once
/// The patches of a step, several at once (lanes.h).

#include <memory>

#include "limn/fast/kernel/patch_program.h"

namespace limn::fast {

/// Patches of a plan, and the number that each of their runs begins with, patch by patch (kNone:
/// the run is not to be made).
struct PatchRange {
  Index first = 0, last = 0;  ///< patches first … last - 1
  const Index* runs = nullptr;
};

/// The patches of a plan, its stencils made ready, so that any of them can be made anywhere. Plan
/// and program must outlive it.
template <class Real>
class PatchStep {
 public:
  PatchStep(const PatchPlan& plan, const PatchProgram& program);
  PatchStep(PatchStep&&) noexcept;
  ~PatchStep();
  /// Makes the patches' runs; arrays as for make_patches.
  void make(const PatchRange& range, const Real* in, Real* out) const;
  /// Of a limit plan.
  void make_limit(const PatchRange& range, const Real* in, Real* positions, Real* normals) const;

 private:
  struct Stencils;
  const PatchPlan* plan_;
  const PatchProgram* program_;
  std::unique_ptr<Stencils> stencils_;
};

/// Makes the runs of all patches, in parallel. `in` has the old points, three numbers each, and one
/// number of padding, `out` room for the new points; they do not overlap. Each value is summed by
/// one thread in a fixed order. For float and double.
template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out);

/// Of a limit plan (step_plan.h): the patches' limit positions, and unit normals.
template <class Real>
void make_limit_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in,
                        Real* positions, Real* normals);

extern template class PatchStep<float>;
extern template class PatchStep<double>;
extern template void make_patches<float>(const PatchPlan&, const PatchProgram&, const float*,
                                         float*);
extern template void make_patches<double>(const PatchPlan&, const PatchProgram&, const double*,
                                          double*);
extern template void make_limit_patches<float>(const PatchPlan&, const PatchProgram&, const float*,
                                               float*, float*);
extern template void make_limit_patches<double>(const PatchPlan&, const PatchProgram&,
                                                const double*, double*, double*);

}  // namespace limn::fast
