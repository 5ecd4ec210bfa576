#include "limn/certify/blocks/spectral_bound.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace limn::certify {
namespace {

constexpr int kInflations = 12;
constexpr int kRefinements = 4;
constexpr double kGrown = 1e40;  // no later square of such a matrix has a norm below 1 in practice

/// The eigenproblem as F(z) = 0, z the vector with the eigenvalue in the pivot's place.
class EigenEquation {
 public:
  EigenEquation(const number::BallMatrix& a, std::size_t pivot) : a_(a), pivot_(pivot) {}

  [[nodiscard]] std::vector<number::Ball> value(const std::vector<number::Ball>& z) const {
    std::vector<number::Ball> result(z.size());
    for (std::size_t i = 0; i < z.size(); ++i) {
      for (std::size_t j = 0; j < z.size(); ++j)
        if (!a_(i, j).is_exactly_zero()) result[i].add_product(a_(i, j), entry(z, j));
      result[i] -= z[pivot_] * entry(z, i);
    }
    return result;
  }

  [[nodiscard]] number::BallMatrix jacobian(const std::vector<number::Ball>& z) const {
    number::BallMatrix result(z.size(), z.size());
    for (std::size_t i = 0; i < z.size(); ++i)
      for (std::size_t j = 0; j < z.size(); ++j) {
        if (j == pivot_) {
          result(i, j) = -entry(z, i);
          continue;
        }
        result(i, j) = a_(i, j);
        if (i == j) result(i, j) -= z[pivot_];
      }
    return result;
  }

 private:
  [[nodiscard]] number::Ball entry(const std::vector<number::Ball>& z, std::size_t i) const {
    return i == pivot_ ? number::Ball(1) : z[i];
  }

  const number::BallMatrix& a_;
  std::size_t pivot_;
};

std::vector<number::Ball> times(const number::BallMatrix& a, const std::vector<number::Ball>& x) {
  std::vector<number::Ball> result(a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) result[i].add_product(a(i, j), x[j]);
  return result;
}

Eigen::MatrixXd middle(const number::BallMatrix& a) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(a.rows()), static_cast<Eigen::Index>(a.rows()));
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.rows(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = a(i, j).approx();
  return result;
}

ApproxPair pair_of(const Eigen::EigenSolver<Eigen::MatrixXd>& solver, Eigen::Index number) {
  ApproxPair pair{solver.eigenvalues()(number).real(), {}};
  const Eigen::VectorXd vector = solver.eigenvectors().col(number).real();
  Eigen::Index largest = 0;
  vector.cwiseAbs().maxCoeff(&largest);
  pair.vector.reserve(static_cast<std::size_t>(vector.size()));
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    pair.vector.push_back(i == largest ? 1 : vector(i) / vector(largest));
  return pair;
}

/// An approximate inverse of the midpoints.
std::optional<number::BallMatrix> approx_inverse(const number::BallMatrix& a) {
  const Eigen::MatrixXd inverse = middle(a).partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  number::BallMatrix result(a.rows(), a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.rows(); ++j)
      result(i, j) =
          number::Ball(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return result;
}

std::vector<number::Ball> middles(const std::vector<number::Ball>& z) {
  std::vector<number::Ball> result;
  result.reserve(z.size());
  for (const number::Ball& one : z) result.push_back(one.middle());
  return result;
}

/// Krawczyk's operator on the box z.
std::optional<std::vector<number::Ball>> krawczyk(const EigenEquation& equation,
                                                  const std::vector<number::Ball>& z) {
  const std::vector<number::Ball> middle = middles(z);
  const std::optional<number::BallMatrix> inverse = approx_inverse(equation.jacobian(middle));
  if (!inverse) return std::nullopt;
  number::BallMatrix rest = number::product(*inverse, equation.jacobian(z));
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < z.size(); ++j)
      rest(i, j) = (i == j ? number::Ball(1) : number::Ball(0)) - rest(i, j);
  std::vector<number::Ball> spread;
  for (std::size_t i = 0; i < z.size(); ++i) spread.push_back(z[i] - middle[i]);
  const std::vector<number::Ball> step = times(*inverse, equation.value(middle));
  const std::vector<number::Ball> wide = times(rest, spread);
  std::vector<number::Ball> result;
  for (std::size_t i = 0; i < z.size(); ++i) result.push_back(middle[i] - step[i] + wide[i]);
  return result;
}

bool strictly_inside(const std::vector<number::Ball>& inner,
                     const std::vector<number::Ball>& outer) {
  for (std::size_t i = 0; i < inner.size(); ++i)
    if (!inner[i].is_finite() || !inner[i].is_strictly_inside(outer[i])) return false;
  return true;
}

std::size_t largest_entry(const std::vector<double>& vector) {
  return static_cast<std::size_t>(
      std::max_element(vector.begin(), vector.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      vector.begin());
}

}  // namespace

std::optional<ApproxPair> approx_leader(const number::BallMatrix& a, double most_imaginary) {
  const Eigen::MatrixXd matrix = middle(a);
  if (matrix.size() == 0 || !matrix.allFinite()) return std::nullopt;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  Eigen::Index leader = 0;
  solver.eigenvalues().cwiseAbs().maxCoeff(&leader);
  if (std::abs(solver.eigenvalues()(leader).imag()) > most_imaginary) return std::nullopt;
  return pair_of(solver, leader);
}

ApproxPair approx_nearest(const number::BallMatrix& a, double value) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(middle(a));
  Eigen::Index nearest = 0;
  (solver.eigenvalues().array() - value).abs().minCoeff(&nearest);
  return pair_of(solver, nearest);
}

std::vector<std::complex<double>> approx_eigenvalues(const number::BallMatrix& a) {
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(middle(a)).eigenvalues();
  return {values.begin(), values.end()};
}

Result<EnclosedPair> enclose_eigenpair(const number::BallMatrix& a, double value,
                                       const std::vector<double>& vector) {
  EnclosedPair pair;
  pair.pivot = largest_entry(vector);
  const EigenEquation equation(a, pair.pivot);
  std::vector<number::Ball> z;
  for (std::size_t i = 0; i < vector.size(); ++i)
    z.emplace_back(i == pair.pivot ? value : vector[i] / vector[pair.pivot]);
  bool proved = false;
  for (int round = 0; round < kInflations && !proved; ++round) {
    // a little wider than the operator's last result, so that the next may lie inside
    for (number::Ball& one : z)
      one = one.widened(0.1 * one.radius() + 1e-30 + 1e-25 * std::abs(one.approx()));
    const auto next = krawczyk(equation, z);
    if (!next) break;
    proved = strictly_inside(*next, z);
    z = *next;
  }
  if (!proved) return Error{"the eigenvalue and its eigenvector could not be enclosed"};
  for (int round = 0; round < kRefinements; ++round)
    if (const auto next = krawczyk(equation, z); next && strictly_inside(*next, z)) z = *next;
  pair.value = z[pair.pivot];
  pair.vector = std::move(z);
  pair.vector[pair.pivot] = number::Ball(1);
  return pair;
}

number::BallMatrix deflated(const number::BallMatrix& a, const EnclosedPair& pair) {
  number::BallMatrix result(a.rows() - 1, a.rows() - 1);
  for (std::size_t i = 0, row = 0; i < a.rows(); ++i) {
    if (i == pair.pivot) continue;
    for (std::size_t j = 0, column = 0; j < a.rows(); ++j) {
      if (j == pair.pivot) continue;
      result(row, column++) = a(i, j) - pair.vector[i] * a(pair.pivot, j);
    }
    ++row;
  }
  return result;
}

std::optional<int> squarings_below(const number::BallMatrix& a, const number::Ball& bound,
                                   int most_squarings) {
  number::BallMatrix power = a;
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.rows(); ++j) power(i, j) /= bound;
  for (int k = 0; k <= most_squarings; ++k) {
    const double norm = number::row_norm(power);
    if (norm < 1) return k;
    if (!(norm < kGrown) || k == most_squarings) break;
    power = number::product(power, power);
  }
  return std::nullopt;
}

}  // namespace limn::certify
