#pragma once
/// What the regular surface round a vertex lets the verdicts on the vertex say. regular/ finds it
/// (regular/smoothness/second_differences.h) and spectrum/ uses it; neither includes the
/// other.

#include <string>

#include "limn/base/truth.h"

namespace limn {

struct RegularPart {
  /// Whether curvature is bounded wherever the mesh is regular: yes: second differences over h² of
  /// every control net stay bounded, the limit surfaces are C^{1,1}; no: those of φ are not. Both
  /// proved. Undecided also where nobody looked.
  Truth bounded = Truth::undecided;
  std::string reason = "the regular lattice was not looked at";
};

}  // namespace limn
