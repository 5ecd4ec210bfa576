#include "limn/regular/smoothness/joint_spectral_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <Eigen/Dense>

#include "limn/regular/algebra/approx_matrix.h"
#include "limn/regular/algebra/determinant.h"
#include "limn/regular/smoothness/exact_radius.h"
#include "limn/regular/smoothness/polytope_bound.h"
#include "limn/regular/smoothness/product_search.h"
#include "limn/regular/smoothness/rounding.h"
#include "limn/regular/smoothness/spectral_radius.h"

namespace limn::regular {
namespace {

constexpr double kMostProducts = 4e6;  // times size³: what the search for products may cost
constexpr int kLongestProduct = 8;
// how far above the lower bound polytopes are tried
constexpr double kLevels[] = {3, 0.5, 0.1, 0.03, 0.007};
constexpr double kRoot = 4e-15;  // what a root in double precision is off by, and more
constexpr double kFine = 0.1;
constexpr double kAtProduct = 1e-8;
constexpr double kBelowTarget[] = {3e-2, 1e-3, 1e-5};  // how far below a target polytopes are tried
constexpr double kNearTarget = 1e-6;
constexpr double kFarBelow =
    0.999;  // growth over that of the leading product: such a block is lower
constexpr int kFewVertices = 1000;   // to prove that
constexpr double kExactWork = 5000;  // vertices times rows of an exact polytope
constexpr int kJump = 12;  // the finest level takes so many times the vertices of kFine, or fewer

/// A diagonal block of more than one row.
struct Work {
  std::vector<Eigen::MatrixXd> matrices;
  Product best;
};

int product_length(std::size_t matrices, std::size_t size) {
  const double cost = std::pow(static_cast<double>(size), 3);
  int length = 1;
  while (length < kLongestProduct &&
         std::pow(matrices, length + 1) / (length + 1) * cost < kMostProducts)
    ++length;
  return length;
}

RationalMatrix product_along(const std::vector<RationalMatrix>& matrices,
                             const std::vector<int>& factors) {
  std::vector<const RationalMatrix*> list;
  list.reserve(factors.size());
  for (const int factor : factors) list.push_back(&matrices[static_cast<std::size_t>(factor)]);
  return product_of(list);
}

/// ρ ≤ the greatest norm of one matrix: the largest sum of a row.
double norm_bound(const std::vector<Eigen::MatrixXd>& matrices) {
  double greatest = 0;
  for (const Eigen::MatrixXd& matrix : matrices)
    greatest = std::max(greatest, matrix.cwiseAbs().rowwise().sum().maxCoeff());
  return inflated(greatest);
}

class Enclosure {
 public:
  Enclosure(const std::vector<RationalMatrix>& matrices, const JointSpectralRadiusOptions& options)
      : options_(options), blocks_(diagonal_blocks(matrices, options.stop)) {}

  JointSpectralRadius run() {
    for (const DiagonalBlock& block : blocks_) look_at(block);
    tell("joint spectral radius: a lower bound");
    for (std::size_t b = 0; b < blocks_.size(); ++b) raise_lower(b);
    if (result_.eigenvalue)
      level_ = rational_root(abs(*result_.eigenvalue), static_cast<int>(result_.product.size()));
    result_.upper = result_.lower;
    result_.exact = true;
    std::vector<std::size_t> small_first(blocks_.size());  // the time may end
    std::iota(small_first.begin(), small_first.end(), std::size_t{0});
    std::stable_sort(small_first.begin(), small_first.end(), [&](std::size_t a, std::size_t b) {
      return blocks_[a].size() < blocks_[b].size();
    });
    for (const std::size_t b : small_first) bound(b);
    if (result_.exact) result_.upper = result_.lower * (1 + kRoot);
    if (result_.lower == 0 && result_.exact) result_.upper = 0;
    result_.time_ended = !result_.exact && asked(options_.stop);
    return std::move(result_);
  }

 private:
  void tell(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }

  /// The best product of the block, approximately.
  void look_at(const DiagonalBlock& block) {
    tell(fmt::format("joint spectral radius: products of {} rows", block.size()));
    Work& work = work_.emplace_back();
    for (const RationalMatrix& matrix : block.matrices)
      work.matrices.push_back(approx_matrix(matrix));
    work.best = approx_best_product(
        work.matrices, block.size() == 1 ? 1 : product_length(block.matrices.size(), block.size()),
        options_.stop);
    result_.blocks.push_back({static_cast<int>(block.size()), work.best.growth,
                              std::numeric_limits<double>::infinity(), 0, block.irreducible});
  }

  /// Proves the block's lower bound where it would be the greatest yet.
  void raise_lower(std::size_t b) {
    const Product& best = work_[b].best;
    if (!(best.growth > result_.lower * (1 + 1e-12)) || best.factors.empty()) return;
    const SpectralRadiusBound proved =
        lower_spectral_radius(product_along(blocks_[b].matrices, best.factors), options_.stop);
    double root = proved.lower;
    if (best.factors.size() > 1)  // a root is off by a unit in the last place or two
      root = std::pow(root, 1.0 / static_cast<double>(best.factors.size())) * (1 - kRoot);
    if (root <= result_.lower) return;
    result_.lower = root;
    result_.product = best.factors;
    result_.eigenvalue = proved.eigenvalue;
  }

  void bound(std::size_t b) {
    JointSpectralRadius::Block& block = result_.blocks[b];
    block.upper = norm_bound(work_[b].matrices);
    if (block.size == 1) {
      // blocks of one row are compared with the leading eigenvalue exactly
      compare_with_leading(blocks_[b].matrices, block);
    } else if (options_.target) {
      bring_below_target(work_[b], block);
    } else {
      refine_upper(b, block);
    }
    block.below = block.below || block.upper < result_.lower;
    if (!block.bounded && !block.below) raise_upper(block.upper);
  }

  /// Whether a polytope bounds the block's ρ by the level, or nearly.
  bool polytope_reaches(const Work& work, JointSpectralRadius::Block& block, double level, int most,
                        int& made) const {
    const PolytopeLimits limits{most, options_.stop, [&](int vertices) {
                                  tell(
                                      fmt::format("joint spectral radius of {} rows: is it below "
                                                  "{:.6f}? {} vertices",
                                                  block.size, level, vertices));
                                }};
    const PolytopeBound found = polytope_bound(work.matrices, level, work.best.leading, limits);
    made = found.vertices;
    block.vertices = std::max(block.vertices, found.vertices);
    block.upper = std::min(block.upper, found.upper);
    return std::isfinite(found.upper);
  }

  void bring_below_target(const Work& work, JointSpectralRadius::Block& block) const {
    if (result_.lower >= *options_.target * (1 - kNearTarget)) return;
    int made = 0;
    for (const double less : kBelowTarget) {
      const double level = *options_.target * (1 - less);
      if (block.upper < *options_.target * (1 - kNearTarget)) return;
      if (level <= result_.lower) continue;
      if (polytope_reaches(work, block, level, options_.budget, made)) return;
    }
  }

  /// Whether a polytope says that a block whose products grow much less has a lower ρ.
  bool is_far_below(const Work& work, JointSpectralRadius::Block& block) const {
    if (work.best.growth > kFarBelow * result_.lower) return false;
    const double between = std::max(std::sqrt(work.best.growth * result_.lower),
                                    kFarBelow * kFarBelow * result_.lower);
    int made = 0;
    return polytope_reaches(work, block, between, std::min(kFewVertices, options_.budget), made) &&
           block.upper < result_.lower;
  }

  /// Whether a polytope in exact numbers bounds the block's products by the leading one's growth.
  bool is_bounded_exactly(std::size_t b, JointSpectralRadius::Block& block) const {
    if (!level_) return false;
    const int most = std::min(options_.budget, static_cast<int>(kExactWork / block.size));
    const ExactPolytopeLimits limits{most, options_.stop, [&](int vertices) {
                                       tell(fmt::format(
                                           "joint spectral radius of {} rows: is it {} exactly? "
                                           "{} vertices",
                                           block.size, to_string(*level_), vertices));
                                     }};
    const std::optional<int> vertices =
        bound_exactly(blocks_[b].matrices, *level_, work_[b].best, limits);
    if (!vertices) return false;
    block.bounded = true;
    block.vertices = *vertices;
    block.upper = std::min(block.upper, result_.lower * (1 + kRoot));
    return true;
  }

  /// From coarse levels to fine ones, as long as the vertices that the next will need are likely to
  /// be within the budget.
  void refine_upper(std::size_t b, JointSpectralRadius::Block& block) const {
    const Work& work = work_[b];
    int last = 0;  // vertices at the level before
    const auto reaches = [&](double more, int most) {
      const double level = result_.lower * (1 + more);
      if (level == 0 || level >= block.upper) return level > 0;
      return polytope_reaches(work, block, level, most, last);
    };
    if (is_far_below(work, block)) return;
    bool tried = false;
    for (const double more : kLevels) {
      if (more <= options_.tolerance) break;
      // where the level before was easy, the next coarse one would teach little
      if (more > kFine && last > 0 && kJump * last <= options_.budget) continue;
      if (!reaches(more, options_.budget) && more <= kFine) return;
      if (more <= kFine && !std::exchange(tried, true) && is_bounded_exactly(b, block)) return;
      if (more <= kFine && kJump * last <= options_.budget) break;
      if (2 * last > options_.budget) return;
    }
    if (!reaches(0.9 * options_.tolerance, options_.budget)) return;
    // at the product itself a few more vertices do, or very many
    if (last * block.size <= options_.budget) reaches(kAtProduct, options_.budget / 4);
  }

  void raise_upper(double upper) {
    result_.upper = std::max(result_.upper, upper);
    result_.exact = false;
  }

  void compare_with_leading(const std::vector<RationalMatrix>& entries,
                            JointSpectralRadius::Block& block) const {
    Rational greatest = 0;
    for (const RationalMatrix& entry : entries)
      greatest = std::max(greatest, Rational(abs(entry[0][0])));
    const bool vanishes = greatest == 0;
    if (!result_.eigenvalue) {
      block.bounded = vanishes;
      block.below = vanishes && result_.lower > 0;
      return;
    }
    Rational power = 1;
    for (std::size_t i = 0; i < result_.product.size(); ++i) power *= greatest;
    block.bounded = power <= abs(*result_.eigenvalue);
    block.below = power < abs(*result_.eigenvalue);
  }

  JointSpectralRadiusOptions options_;
  std::vector<DiagonalBlock> blocks_;
  std::vector<Work> work_;
  JointSpectralRadius result_;
  std::optional<Rational> level_;  // the leading product's growth, where it is rational
};

}  // namespace

JointSpectralRadius enclose_joint_spectral_radius(const std::vector<RationalMatrix>& matrices,
                                                  const JointSpectralRadiusOptions& options) {
  return Enclosure(matrices, options).run();
}

}  // namespace limn::regular
