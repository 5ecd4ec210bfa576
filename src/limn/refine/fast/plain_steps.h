#pragma once
/// The first steps, by the plain engine, with vertices renumbered as the quick engine has them.

#include "limn/refine/fast/triangle_layout.h"
#include "limn/refine/rule_tables.h"

namespace limn::fast {

class PlainSteps {
 public:
  /// `count` ≥ 0 steps from the control mesh; scheme and mesh must outlive them. Fails as refine
  /// (refine/refine.h) does.
  [[nodiscard]] static Result<PlainSteps> make(const Scheme& scheme, const Mesh& control,
                                               int count);

  [[nodiscard]] int count() const { return static_cast<int>(splits_.size()); }

  /// x, y, z of the control vertices → those of TriangleLayout(control, 2^count). Sums in double.
  template <class Real>
  void evaluate(const Real* control, Real* fine) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  PlainSteps(const Scheme& scheme, const Mesh& control)
      : scheme_(&scheme), control_(&control), tables_(scheme) {}
  [[nodiscard]] const Mesh& mesh(std::size_t step) const {
    return step == 0 ? *control_ : splits_[step - 1].mesh;
  }
  void number_vertices();

  const Scheme* scheme_;
  const Mesh* control_;
  RuleTables<double> tables_;
  std::vector<SplitResult> splits_;
  /// The plain engine's vertex at each place of the layout; empty where it has the same numbers.
  std::vector<Index> order_;
};

extern template void PlainSteps::evaluate<float>(const float*, float*) const;
extern template void PlainSteps::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
