#pragma once
/// An upper bound of a joint spectral radius by a polytope that the matrices map into a multiple
/// of itself [GuglielmiProtasov2013].

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "limn/base/budget.h"

namespace limn::regular {

struct PolytopeBound {
  double upper = 0;  ///< of the joint spectral radius, proved; infinite where it was not reached
  int vertices = 0;  ///< that were made
};

struct PolytopeLimits {
  int most_vertices = 7000;
  Stop stop;
  std::function<void(int vertices)> progress;  ///< called now and then, if given
};

/// Grows the hull of `start`, its negatives and their images under matrices/level until images
/// add nothing. It ends for every level above the joint spectral radius ρ, and often at ρ itself
/// if `start` is the leading eigenvector of a product that has it; then upper is level times
/// 1 + 10⁻⁹ or less. Gives up at the limits. Each entry of the matrices may be off by one
/// rounding. Cost: vertices times the number of matrices linear programs.
[[nodiscard]] PolytopeBound polytope_bound(const std::vector<Eigen::MatrixXd>& matrices,
                                           double level, const std::vector<Eigen::VectorXd>& start,
                                           const PolytopeLimits& limits = {});

}  // namespace limn::regular
