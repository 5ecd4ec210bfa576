#include "limn/certify/lattice/contraction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/regular/smoothness/rounding.h"

namespace limn::certify {
namespace {

constexpr std::size_t kLongestWord = 400;
constexpr std::size_t kMostShortWords = 5000;  // whose norms bound how errors grow

/// A matrix and a bound of the ∞-norm of its error.
struct Rounded {
  Eigen::MatrixXd matrix;
  double error = 0;
};

double norm(const Eigen::MatrixXd& a) {
  return a.rows() == 0 || a.cols() == 0 ? 0 : a.cwiseAbs().rowwise().sum().maxCoeff();
}

double norm(const Rounded& a) { return regular::inflated(norm(a.matrix) + a.error); }

Rounded rounded(const RationalRows& rows, std::size_t columns, const Rational& factor) {
  Rounded result;
  result.matrix.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < result.matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < result.matrix.cols(); ++j)
      result.matrix(i, j) =
          to_double(factor * rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  result.error = regular::inflated(norm(result.matrix) * std::numeric_limits<double>::epsilon());
  return result;
}

Rounded product(const Rounded& a, const Rounded& b) {
  Rounded result;
  result.matrix.noalias() = a.matrix * b.matrix;
  const double of_a = norm(a.matrix);
  const double of_b = norm(b.matrix);
  result.error = regular::inflated(a.error * (of_b + b.error) + of_a * b.error +
                                   regular::rounding_error(a.matrix.cols()) * of_a * of_b);
  return result;
}

class Tree {
 public:
  Tree(const CellMatrices& cells, double leaf_norm, int most_products, const Stop& stop)
      : scale_(cells.scale), leaf_norm_(leaf_norm), most_products_(most_products), stop_(stop) {
    const Rational s(cells.scale);
    const std::size_t size = cells.sizes.size();
    for (std::size_t d = 0; d < cells.residual.size(); ++d) {
      steps_.push_back(rounded(cells.residual[d], size, s));
      gradients_.push_back(rounded(cells.gradient[d], size, s));
      values_.push_back(rounded({cells.value[d]}, size, 1));
    }
    root_ = {
        Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size)),
        0};
    bound_norms();
  }

  Result<Contraction> grow() {
    const Sums sums = below(root_, 0);
    if (!fault_.empty()) return Error{fault_};
    // what comes after a leaf is at most so much of the leaf's largest residual
    std::array<double, 3> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = regular::inflated(sums.norm[i] / (1 - leaf_norm_));
    const auto whole = [&](std::size_t i) {
      std::vector<double> row(static_cast<std::size_t>(root_.matrix.cols()));
      for (std::size_t j = 0; j < row.size(); ++j) {
        const auto at = static_cast<Eigen::Index>(j);
        row[j] = regular::inflated(sums.change[i](at) + all[i] * sums.leaf(at));
      }
      return row;
    };
    found_.leaf_norm = leaf_norm_;
    found_.gradient = {whole(0), whole(1)};
    found_.value = whole(2);
    return found_;
  }

 private:
  /// Column by column: the greatest sums of changes down the paths from a word on, of the gradient
  /// along both directions and of the value; and the greatest entries of the leaves' products.
  struct Sums {
    std::array<Eigen::RowVectorXd, 3> change;
    Eigen::RowVectorXd leaf;
    std::array<double, 3> norm{};  // of the changes, likewise
  };

  [[nodiscard]] Sums nothing() const {
    const Eigen::RowVectorXd zero = Eigen::RowVectorXd::Zero(root_.matrix.cols());
    return {{zero, zero, zero}, zero, {}};
  }

  /// Bounds of the norms of all products of so many steps: of few steps by looking at all of them,
  /// of more by those.
  void bound_norms() {
    norms_ = {1};
    std::vector<Rounded> words{root_};
    while (words.size() * steps_.size() <= kMostShortWords) {
      std::vector<Rounded> longer;
      double largest = 0;
      for (const Rounded& word : words)
        for (const Rounded& step : steps_) {
          longer.push_back(product(step, word));
          largest = std::max(largest, norm(longer.back()));
        }
      norms_.push_back(largest);
      words = std::move(longer);
    }
    const std::size_t known = norms_.size();
    while (norms_.size() <= kLongestWord) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < known; ++k)
        least = std::min(least, regular::inflated(norms_[k] * norms_[norms_.size() - k]));
      norms_.push_back(least);
    }
  }

  /// One more step after a word; `faults_` are the errors that each step of the word made anew,
  /// which later steps carry on. Precondition: the word is that of the path.
  Rounded next_word(const Rounded& step, const Rounded& word) {
    Rounded next;
    next.matrix.noalias() = step.matrix * word.matrix;
    const double of_word = norm(word);
    faults_.push_back(
        regular::inflated(step.error * of_word + regular::rounding_error(step.matrix.cols()) *
                                                     norm(step.matrix) * of_word));
    for (std::size_t i = 0; i < faults_.size(); ++i)
      next.error += faults_[i] * norms_[faults_.size() - 1 - i];
    next.error = regular::inflated(next.error);
    return next;
  }

  Sums below(const Rounded& word, std::size_t length) {
    Sums here = nothing();
    Sums further = nothing();
    for (std::size_t d = 0; d < steps_.size() && fault_.empty(); ++d) {
      const auto change = changes(word, d, length);
      for (std::size_t i = 0; i < change.size(); ++i) {
        here.change[i] = here.change[i].cwiseMax(change[i]);
        here.norm[i] = std::max(here.norm[i], change[i].sum());
      }
      const Rounded next = next_word(steps_[d], word);
      count(length + 1);
      if (!fault_.empty()) break;
      Sums after = nothing();
      if (norm(next) <= leaf_norm_)
        after.leaf = next.matrix.cwiseAbs().colwise().maxCoeff().array() + next.error;
      else
        after = below(next, length + 1);
      faults_.pop_back();
      for (std::size_t i = 0; i < change.size(); ++i) {
        further.change[i] = further.change[i].cwiseMax(after.change[i]);
        further.norm[i] = std::max(further.norm[i], after.norm[i]);
      }
      further.leaf = further.leaf.cwiseMax(after.leaf);
    }
    for (std::size_t i = 0; i < here.change.size(); ++i) {
      further.change[i] = (further.change[i] + here.change[i]) * (1 + 1e-14);
      further.norm[i] = regular::inflated(further.norm[i] + here.norm[i]);
    }
    return further;
  }

  /// Of the gradient along both directions and of the value, by one more step.
  [[nodiscard]] std::array<Eigen::RowVectorXd, 3> changes(const Rounded& word, std::size_t digit,
                                                          std::size_t length) const {
    const Rounded gradient = product(gradients_[digit], word);
    const Rounded value = product(values_[digit], word);
    const auto size = [](const Rounded& a, Eigen::Index row) {
      return Eigen::RowVectorXd(a.matrix.row(row).cwiseAbs().array() + a.error);
    };
    const Eigen::RowVectorXd first = size(gradient, 0);
    const Eigen::RowVectorXd second = size(gradient, 1);
    // the word holds s^length; a part's points are at most 1 from its origin
    const double back = std::pow(scale_, -static_cast<double>(length)) * (1 + 1e-12);
    return {first, second, (size(value, 0) + (first + second) / scale_) * back};
  }

  void count(std::size_t length) {
    found_.longest = std::max(found_.longest, static_cast<int>(length));
    if (++found_.products > most_products_ || length > kLongestWord)
      fault_ = "products of the cell matrices did not contract within the bound on their number";
    if (stop_ && stop_()) fault_ = "the time ended while products of cell matrices were bounded";
  }

  int scale_;
  double leaf_norm_;
  int most_products_;
  const Stop& stop_;
  std::vector<Rounded> steps_, gradients_, values_;
  Rounded root_;
  std::vector<double> norms_;   // by the number of steps
  std::vector<double> faults_;  // of the path's steps
  Contraction found_;
  std::string fault_;
};

}  // namespace

Result<Contraction> enclose_contraction(const CellMatrices& cells, double leaf_norm,
                                        int most_products, const Stop& stop) {
  return Tree(cells, leaf_norm, most_products, stop).grow();
}

}  // namespace limn::certify
