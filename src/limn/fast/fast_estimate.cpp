#include "limn/fast/fast_estimate.h"

namespace limn::fast {

double needed_bytes(double vertices, double faces, double corners) {
  constexpr double kPoint = 3 * sizeof(double);
  // the level before, and the plans' numbers (measured: 1 to 9 bytes; 18 where √3 ends early)
  constexpr double kWork = kPoint / 3 + 9;
  return vertices * (kPoint + kWork) + (faces + corners) * sizeof(Index);
}

refine::RefineEstimate estimate_fast(const Split& split, const Mesh& control, int levels) {
  refine::RefineEstimate estimate =
      refine::estimate_refinement(split, control, levels, sizeof(Point3));
  const double corners = (split.lattice == Lattice::triangle ? 3 : 4) * estimate.faces;
  estimate.peak_bytes = needed_bytes(estimate.vertices, estimate.faces, corners);
  return estimate;
}

}  // namespace limn::fast
