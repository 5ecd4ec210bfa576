#include "support/frequency.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace limn::test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().text());
  return std::move(*result);
}

bool has_center(const Split& split) { return split.births.vertices; }

/// A step by half a sector.
bool turns(const Split& split) {
  return split.name == "sqrt3" || split.name == "quad-sqrt2" || split.name == "midedge";
}

}  // namespace

int sector_size(const Split& split, int ring) {
  if (!has_center(split)) return 2 * ring - 1;
  if (split.name == "quad-sqrt2" && ring == 1) return 1;  // the corners are in ring 2
  return split.lattice == Lattice::triangle ? ring : 2 * ring;
}

std::vector<int> rotation(const Split& split, int n, int rings) {
  std::vector<int> image;
  if (has_center(split)) image.push_back(0);
  for (int ring = 1; ring <= rings; ++ring) {
    const int begin = static_cast<int>(image.size());
    const int sector = sector_size(split, ring);
    for (int i = 0; i < n * sector; ++i) image.push_back(begin + (i + sector) % (n * sector));
  }
  return image;
}

Eigen::MatrixXd dense(const refine::SubdivisionMatrix<double>& matrix) {
  Eigen::MatrixXd result(matrix.size, matrix.size);
  for (int i = 0; i < matrix.size; ++i)
    for (int j = 0; j < matrix.size; ++j) result(i, j) = matrix(i, j);
  return result;
}

Eigen::MatrixXcd frequency_block(const Split& split,
                                 const refine::SubdivisionMatrix<double>& matrix, int n, int rings,
                                 int omega) {
  const std::vector<int> image = rotation(split, n, rings);
  std::vector<Eigen::VectorXcd> basis;
  std::vector<bool> seen(image.size(), false);
  for (std::size_t first = 0; first < image.size(); ++first) {
    if (seen[first]) continue;
    const bool alone = image[first] == static_cast<int>(first);
    if (alone && omega % n != 0) continue;
    Eigen::VectorXcd vector = Eigen::VectorXcd::Zero(matrix.size);
    int i = static_cast<int>(first);
    for (int k = 0; !seen[static_cast<std::size_t>(i)]; ++k) {
      seen[static_cast<std::size_t>(i)] = true;
      vector(i) = std::polar(1.0, kTurn * omega * k / n);
      i = image[static_cast<std::size_t>(i)];
    }
    basis.push_back(vector.normalized());
  }
  Eigen::MatrixXcd space(matrix.size, static_cast<int>(basis.size()));
  for (int i = 0; i < space.cols(); ++i) space.col(i) = basis[static_cast<std::size_t>(i)];
  Eigen::MatrixXcd block = space.adjoint() * dense(matrix).cast<std::complex<double>>() * space;
  if (turns(split)) block *= std::polar(1.0, -kTurn * omega / (2 * n));
  return block;
}

Eigen::MatrixXcd frequency_block(const Scheme& scheme, int n, int rings, int omega) {
  return frequency_block(*scheme.split, must(refine::subdivision_matrix<double>(scheme, n, rings)),
                         n, rings, omega);
}

int analysis_rings(const Scheme& scheme, int n) {
  // one ring may be invariant by itself, and two not
  int rings = std::max(2, must(refine::invariant_rings(scheme, n)));
  while (rings < 6 && !refine::subdivision_matrix<double>(scheme, n, rings)) ++rings;
  return rings;
}

std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXcd& block) {
  const Eigen::VectorXcd all =
      Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(block, false).eigenvalues();
  std::vector<std::complex<double>> sorted(all.begin(), all.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  return sorted;
}

Eigen::VectorXd singular_values(const Eigen::MatrixXcd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXcd>(matrix).singularValues();
}

double eigenvalue_defect(const Eigen::MatrixXcd& block, double lambda) {
  const Eigen::MatrixXcd shifted =
      block - lambda * Eigen::MatrixXcd::Identity(block.rows(), block.cols());
  return singular_values(shifted).minCoeff();
}

int multiplicity(const Eigen::MatrixXcd& block, double lambda) {
  int count = 0;
  for (const std::complex<double>& value : eigenvalues(block))
    count += std::abs(value - lambda) < 1e-4;
  return count;
}

}  // namespace limn::test
