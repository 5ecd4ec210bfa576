#pragma once
/// What the regular surface round a vertex lets the verdicts on the vertex say. regular/ finds it
/// (regular/smoothness/second_differences.h) and spectrum/ uses it; neither includes the
/// other.

#include <string>

#include "limn/base/truth.h"

namespace limn {

/// What is known of curvature on the regular lattice.
struct RegularPart {
  /// Whether curvature is bounded wherever the mesh is regular: yes: second differences over h² of
  /// every control net stay bounded, the limit surfaces are C^{1,1}; no: those of φ are not. Both
  /// proved. Undecided also where nobody looked.
  Truth bounded = Truth::undecided;
  /// What the answer rests on, or why there is none; one sentence without a full stop.
  std::string reason = "the regular lattice was not looked at";
};

}  // namespace limn
