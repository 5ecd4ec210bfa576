#pragma once
/// The least eigenvalues of a large sparse matrix, by Spectra; for spectrum.cpp.

#include <vector>

#include <Eigen/SparseCore>

#include "limn/base/error.h"

namespace limn::fairness {

struct LeastEigenpairs {
  std::vector<double> values;  ///< rising
  Eigen::MatrixXd vectors;     ///< orthonormal columns
};

[[nodiscard]] bool lanczos_available();

/// The `count` least eigenvalues, multiple ones as often as they are, of a symmetric matrix without
/// negative eigenvalues; 1 ≤ count ≤ rows/8, and rows of some hundreds at least. To about 1e-10.
/// Fails without Spectra, and where the method does not converge.
[[nodiscard]] Result<LeastEigenpairs> approx_least_eigenpairs(
    const Eigen::SparseMatrix<double>& matrix, int count);

}  // namespace limn::fairness
