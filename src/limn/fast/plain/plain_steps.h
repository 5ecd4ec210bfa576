#pragma once
/// The first steps, by the plain engine, with vertices renumbered as the fast engine has them.
/// What it sums is written down once, as rows.

#include <memory>
#include <vector>

#include "limn/fast/plain/plain_rows.h"

namespace limn::fast {

class PlainSteps {
 public:
  /// `count` ≥ 0 steps from the control mesh, of this sharpness (holes are not looked at); scheme
  /// and mesh must outlive them. Fails as refine (refine/refine.h) does.
  [[nodiscard]] static Result<PlainSteps> make(const Scheme& scheme, const Mesh& control, int count,
                                               Sharpness sharpness = {});

  [[nodiscard]] int count() const { return count_; }

  /// What each step made; of a single step, the births alone. Empty once sums are written down.
  [[nodiscard]] const std::vector<SplitResult>& splits() const { return splits_; }

  /// From now on, vertices are put out in this order (the plain engine's own, if it is empty), and
  /// the steps' sums are those written down here; but where that would take far more memory than
  /// the points (edges that weigh all that is round vertices of many hundred faces), the plain
  /// engine makes the steps anew in each evaluation.
  void write_down(std::vector<Index> order);

  /// x, y, z of the control vertices → those of the vertices after `count` steps. Sums are made in
  /// `Real` where they are written down, else in double.
  template <class Real>
  void evaluate(const Real* control, Real* fine) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  PlainSteps(const Scheme& scheme, const Mesh& control)
      : scheme_(&scheme), control_(&control), tables_(scheme) {}
  [[nodiscard]] const Mesh& mesh(std::size_t step) const {
    return step == 0 ? *control_ : splits_[step - 1].mesh;
  }

  /// Finds what one more step makes; `sharpness` is then what is left of it.
  Status add_step(bool alone, Sharpness& sharpness);
  [[nodiscard]] std::optional<PlainRows> rows_of(std::size_t step, std::vector<Index> places) const;
  template <class Real>
  void evaluate_rows(const Real* control, Real* fine) const;
  template <class Real>
  void evaluate_anew(const Real* control, Real* fine) const;

  const Scheme* scheme_;
  const Mesh* control_;
  refine::RuleTables<double> tables_;
  int count_ = 0;
  std::vector<SplitResult> splits_;                           ///< unless there are rows
  std::vector<std::unique_ptr<refine::CreaseStep>> creases_;  ///< likewise; null: nothing is sharp
  std::vector<Index> order_;                                  ///< likewise
  std::vector<PlainRows> rows_;                               ///< of each step, or empty
};

extern template void PlainSteps::evaluate<float>(const float*, float*) const;
extern template void PlainSteps::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
