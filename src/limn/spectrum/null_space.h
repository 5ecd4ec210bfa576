#pragma once
/// Null vectors of small matrices. Private to eigenvectors and sector_matrix.

#include <Eigen/Dense>
#include <algorithm>

namespace limn::spectrum {

/// An orthonormal basis, as columns, of the vectors x with matrix·x = 0, where entries are of order
/// 1 and exact to about 1e-13; of at least so many columns.
template <class Matrix>
[[nodiscard]] Matrix null_space(const Matrix& matrix, Eigen::Index least = 0) {
  constexpr double kVanishes = 1e-9;
  // not BDCSVD: of some blocks of 16 rows and more it gives vectors that are none of theirs
  const Eigen::JacobiSVD<Matrix> svd(matrix, Eigen::ComputeFullV);
  const Eigen::Index nullity = (svd.singularValues().array() < kVanishes).count();
  return svd.matrixV().rightCols(std::max(nullity, least));
}

}  // namespace limn::spectrum
