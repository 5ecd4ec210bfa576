#include "limn/certify/contraction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/regular/smoothness/rounding.h"

namespace limn::certify {
namespace {

constexpr std::size_t kLongestWord = 40;

/// A matrix and a bound of the ∞-norm of its error.
struct Rounded {
  Eigen::MatrixXd matrix;
  double error = 0;
};

double norm(const Eigen::MatrixXd& a) {
  return a.rows() == 0 || a.cols() == 0 ? 0 : a.cwiseAbs().rowwise().sum().maxCoeff();
}

double norm(const Rounded& a) { return inflated(norm(a.matrix) + a.error); }

Rounded rounded(const RationalRows& rows, std::size_t columns, const Rational& factor) {
  Rounded result;
  result.matrix.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < result.matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < result.matrix.cols(); ++j)
      result.matrix(i, j) =
          to_double(factor * rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  result.error = inflated(norm(result.matrix) * std::numeric_limits<double>::epsilon());
  return result;
}

Rounded product(const Rounded& a, const Rounded& b) {
  Rounded result;
  result.matrix.noalias() = a.matrix * b.matrix;
  const double of_a = norm(a.matrix);
  const double of_b = norm(b.matrix);
  result.error = inflated(a.error * (of_b + b.error) + of_a * b.error +
                          rounding_error(a.matrix.cols()) * of_a * of_b);
  return result;
}

class Tree {
 public:
  Tree(const CellMatrices& cells, int most_products, const Stop& stop)
      : scale_(cells.scale), most_products_(most_products), stop_(stop) {
    const Rational s(cells.scale);
    const std::size_t size = cells.sizes.size();
    for (std::size_t d = 0; d < cells.residual.size(); ++d) {
      steps_.push_back(rounded(cells.residual[d], size, s));
      gradients_.push_back(rounded(cells.gradient[d], size, s));
      values_.push_back(rounded({cells.value[d]}, size, 1));
    }
    root_ = {Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(size),
                                       static_cast<Eigen::Index>(size)),
             0};
  }

  Result<Contraction> grow() {
    const Sums sums = below(root_, 0);
    if (!fault_.empty()) return Error{fault_};
    const double all = 1 / (1 - kContracted);
    found_.gradient = {inflated(sums[0] * all), inflated(sums[1] * all)};
    found_.value = inflated(sums[2] * all);
    return found_;
  }

 private:
  using Sums = std::array<double, 3>;

  /// The greatest sums of changes down the paths from a word on.
  Sums below(const Rounded& word, std::size_t length) {
    Sums change{};
    Sums rest{};
    for (std::size_t d = 0; d < steps_.size() && fault_.empty(); ++d) {
      const Sums here = changes(word, d, length);
      for (std::size_t i = 0; i < here.size(); ++i) change[i] = std::max(change[i], here[i]);
      const Rounded next = product(steps_[d], word);
      count(length + 1);
      if (!fault_.empty() || norm(next) <= kContracted) continue;
      const Sums further = below(next, length + 1);
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = std::max(rest[i], further[i]);
    }
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = inflated(rest[i] + change[i]);
    return rest;
  }

  /// Of the gradient along both directions and of the value, by one more step.
  [[nodiscard]] Sums changes(const Rounded& word, std::size_t digit, std::size_t length) const {
    const Rounded gradient = product(gradients_[digit], word);
    const Rounded value = product(values_[digit], word);
    const double first = gradient.matrix.row(0).cwiseAbs().sum() + gradient.error;
    const double second = gradient.matrix.row(1).cwiseAbs().sum() + gradient.error;
    // the word holds s^length; a part's points are at most 1 from its origin
    const double by_value = norm(value) + (first + second) / scale_;
    return {inflated(first), inflated(second),
            inflated(by_value / std::pow(scale_, static_cast<double>(length)))};
  }

  void count(std::size_t length) {
    found_.longest = std::max(found_.longest, static_cast<int>(length));
    if (++found_.products > most_products_ || length > kLongestWord)
      fault_ = "products of the cell matrices did not contract within the bound on their number";
    if (stop_ && stop_()) fault_ = "the time ended while products of cell matrices were bounded";
  }

  int scale_;
  int most_products_;
  const Stop& stop_;
  std::vector<Rounded> steps_, gradients_, values_;
  Rounded root_;
  Contraction found_;
  std::string fault_;
};

}  // namespace

Result<Contraction> enclose_contraction(const CellMatrices& cells, int most_products,
                                        const Stop& stop) {
  return Tree(cells, most_products, stop).grow();
}

}  // namespace limn::certify
