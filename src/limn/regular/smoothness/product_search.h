#pragma once
/// Products of matrices with large spectral radius, by trial.

#include <Eigen/Core>
#include <vector>

#include "limn/base/budget.h"

namespace limn::regular {

struct Product {
  std::vector<int> factors;  ///< first factor first; no power of a shorter product
  double growth = 0;         ///< spectral radius, by the root of the length; approximate
  /// All products of that length and growth, as far as double precision tells, one for each class
  /// under rotation; the first is `factors`.
  std::vector<std::vector<int>> equals;
  std::vector<Eigen::VectorXd> leading;  ///< a leading eigenvector, or its real and imaginary part
};

/// The best of all products of up to so many factors, the shortest of equals; where `stop` asks for
/// an end, of those looked at, among them a matrix at least. Cost: (number of matrices)^length
/// eigenvalue problems over the length.
[[nodiscard]] Product approx_best_product(const std::vector<Eigen::MatrixXd>& matrices, int length,
                                          const Stop& stop = {});

}  // namespace limn::regular
