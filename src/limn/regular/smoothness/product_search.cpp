#include "limn/regular/smoothness/product_search.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace limn::regular {
namespace {

constexpr double kBetter = 1 + 1e-9;  // a longer product has to be better than a shorter by this
constexpr std::size_t kAskedTo = 2;   // factors up to which it is asked whether to stop

/// Whether no rotation of the word comes before it, and none but the whole one is equal.
bool stands_for_its_rotations(const std::vector<int>& word) {
  std::vector<int> turned = word;
  for (std::size_t i = 1; i < word.size(); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (turned <= word) return false;
  }
  return true;
}

double spectral_radius(const Eigen::MatrixXd& a) { return a.eigenvalues().cwiseAbs().maxCoeff(); }

/// Tries all words of exactly `length` that begin with `word`.
void search(const std::vector<Eigen::MatrixXd>& matrices, std::size_t length,
            std::vector<int>& word, const Eigen::MatrixXd& product, Product& best,
            const Stop& stop) {
  if (word.size() <= kAskedTo && !best.factors.empty() && asked(stop)) return;
  if (word.size() == length) {
    if (!stands_for_its_rotations(word)) return;
    const double growth = std::pow(spectral_radius(product), 1.0 / static_cast<double>(length));
    if (growth > best.growth * kBetter)
      best = {word, growth, {word}, {}};
    else if (best.factors.size() == length && growth * kBetter >= best.growth)
      best.equals.push_back(word);
    return;
  }
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    word.push_back(static_cast<int>(i));
    // a word that begins with more than one of its rotations would is not the first of them
    if (word.back() >= word.front())
      search(matrices, length, word, (product * matrices[i]).eval(), best, stop);
    word.pop_back();
  }
}

}  // namespace

Product approx_best_product(const std::vector<Eigen::MatrixXd>& matrices, int length,
                            const Stop& stop) {
  const Eigen::Index size = matrices.front().rows();
  Product best;
  for (int n = 1; n <= length; ++n) {
    std::vector<int> word;
    search(matrices, static_cast<std::size_t>(n), word, Eigen::MatrixXd::Identity(size, size), best,
           stop);
  }
  Eigen::MatrixXd product = Eigen::MatrixXd::Identity(size, size);
  for (const int factor : best.factors) product *= matrices[static_cast<std::size_t>(factor)];
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(product);
  Eigen::Index leading = 0;
  solver.eigenvalues().cwiseAbs().maxCoeff(&leading);
  const Eigen::VectorXcd vector = solver.eigenvectors().col(leading);
  best.leading.emplace_back(vector.real());
  if (vector.imag().norm() > 1e-9 * vector.norm()) best.leading.emplace_back(vector.imag());
  return best;
}

}  // namespace limn::regular
