#pragma once
/// Rational matrices in double precision.

#include <Eigen/Core>

#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

/// Each entry is off by a unit in the last place at most.
[[nodiscard]] inline Eigen::MatrixXd approx_matrix(const RationalMatrix& a) {
  const auto size = static_cast<Eigen::Index>(a.size());
  Eigen::MatrixXd result(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      result(i, j) = to_double(a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  return result;
}

}  // namespace limn::regular
