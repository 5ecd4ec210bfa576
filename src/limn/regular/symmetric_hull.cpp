#include "limn/regular/symmetric_hull.h"

#include <cmath>

#include "limn/regular/rounding.h"

namespace limn {
namespace {

constexpr double kIndependent = 1e-6;
constexpr double kOptimal = 1e-11;  // of the greatest |y·v| beyond 1
constexpr int kRefactor = 40;       // updates of the inverse before it is made anew

double sign(double x) { return x < 0 ? -1 : 1; }

}  // namespace

SymmetricHull::SymmetricHull(Eigen::Index dimension)
    : dimension_(dimension), points_(dimension, 64), directions_(dimension, 0) {}

bool SymmetricHull::leaves_span(const Eigen::VectorXd& v) const {
  Eigen::VectorXd rest = v - directions_ * (directions_.transpose() * v);
  rest -= directions_ * (directions_.transpose() * rest);
  return rest.norm() > kIndependent * v.norm();
}

void SymmetricHull::add(const Eigen::VectorXd& v) {
  if (count_ == points_.cols()) points_.conservativeResize(Eigen::NoChange, 2 * count_);
  points_.col(count_) = v;
  if (!spans() && leaves_span(v)) {
    Eigen::VectorXd rest = v - directions_ * (directions_.transpose() * v);
    rest -= directions_ * (directions_.transpose() * rest);
    directions_.conservativeResize(Eigen::NoChange, directions_.cols() + 1);
    directions_.rightCols(1) = rest.normalized();
    basis_.push_back(count_);
    first_basis_ = basis_;
  }
  ++count_;
}

void SymmetricHull::factorise() {
  Eigen::MatrixXd matrix(dimension_, dimension_);
  for (Eigen::Index i = 0; i < dimension_; ++i)
    matrix.col(i) = points_.col(basis_[static_cast<std::size_t>(i)]);
  inverse_ = matrix.inverse();
}

SymmetricHull::Combination SymmetricHull::least_combination(const Eigen::VectorXd& u,
                                                            double enough, double too_much) {
  const auto most_steps = static_cast<int>(20 * dimension_ + 200);
  factorise();
  Eigen::VectorXd c = inverse_ * u;
  Combination found;
  for (int step = 1;; ++step) {
    found.norm = c.lpNorm<1>();
    if (found.norm <= enough || step == most_steps) break;
    const Eigen::VectorXd y = inverse_.transpose() * c.unaryExpr(&sign);
    const Eigen::RowVectorXd heights = y.transpose() * points();
    Eigen::Index entering = 0;
    const double highest = heights.cwiseAbs().maxCoeff(&entering);
    if (found.norm > too_much * highest) {
      found.outside = true;
      break;
    }
    if (highest <= 1 + kOptimal) break;
    const Eigen::VectorXd way = inverse_ * points_.col(entering) * sign(heights(entering));
    Eigen::Index leaving = -1;
    double length = std::numeric_limits<double>::infinity();
    double pivot = 0;
    for (Eigen::Index i = 0; i < dimension_; ++i) {
      const double towards = way(i) * sign(c(i));
      if (towards < 1e-10) continue;
      const double ratio = std::abs(c(i)) / towards;
      if (ratio < length || (ratio == length && towards > pivot)) {
        length = ratio;
        leaving = i;
        pivot = towards;
      }
    }
    if (leaving < 0) break;
    basis_[static_cast<std::size_t>(leaving)] = entering;
    if (step % kRefactor == 0) {
      factorise();
    } else {
      const Eigen::VectorXd column = inverse_ * points_.col(entering);
      const Eigen::RowVectorXd row = inverse_.row(leaving) / column(leaving);
      inverse_ -= column * row;
      inverse_.row(leaving) = row;
    }
    c = inverse_ * u;
  }
  found.points = basis_;
  found.coefficients = c;
  return found;
}

Eigen::VectorXd SymmetricHull::axis_norms() const {
  Eigen::MatrixXd matrix(dimension_, dimension_);
  for (Eigen::Index i = 0; i < dimension_; ++i)
    matrix.col(i) = points_.col(first_basis_[static_cast<std::size_t>(i)]);
  const Eigen::MatrixXd inverse = matrix.inverse();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(dimension_, dimension_);
  // e_i = matrix · inverse · e_i + rest_i
  const Eigen::MatrixXd rest =
      (identity - matrix * inverse).cwiseAbs() +
      rounding_error(dimension_ + 2) * (identity + matrix.cwiseAbs() * inverse.cwiseAbs());
  const Eigen::VectorXd sums = inverse.cwiseAbs().colwise().sum();
  const double left = inflated(rest.colwise().sum().maxCoeff());
  if (!(left < 0.5))
    return Eigen::VectorXd::Constant(dimension_, std::numeric_limits<double>::infinity());
  const double greatest = inflated(sums.maxCoeff() / (1 - left));
  const Eigen::VectorXd norms = sums + greatest * rest.colwise().sum().transpose();
  return norms.unaryExpr(&inflated);
}

Eigen::VectorXd SymmetricHull::residual_bound(const Eigen::VectorXd& u,
                                              const Eigen::VectorXd& slack,
                                              const Combination& combination) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(dimension_);
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(dimension_);
  for (Eigen::Index i = 0; i < dimension_; ++i) {
    const auto point = points_.col(combination.points[static_cast<std::size_t>(i)]);
    sum += combination.coefficients(i) * point;
    sizes += std::abs(combination.coefficients(i)) * point.cwiseAbs();
  }
  const Eigen::VectorXd bound =
      (u - sum).cwiseAbs() + rounding_error(dimension_ + 2) * (u.cwiseAbs() + sizes) + slack;
  return bound.unaryExpr(&inflated);
}

}  // namespace limn
