#include "limn/regular/smoothness/attainment.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/number/rational_power.h"
#include "limn/regular/algebra/determinant.h"
#include "limn/regular/algebra/jordan.h"
#include "limn/regular/smoothness/difference_norm.h"
#include "limn/regular/smoothness/exact_radius.h"
#include "limn/regular/smoothness/growth_power.h"
#include "limn/regular/smoothness/transition_operators.h"

namespace limn::regular {
namespace {

constexpr int kMostNormSteps = 3;  // of the difference scheme, whose norms are tried
constexpr std::size_t kMostPowerRows =
    60;  // of the operators: powers of rational matrices are dear

using number::power;

class AttainmentDecision {
 public:
  AttainmentDecision(const Mask& mask, const JointSpectralRadius& radius, int order,
                     const Stop& stop)
      : mask_(mask), radius_(radius), stop_(stop) {
    found_.order = order;
  }

  /// By the blocks of the differences that `radius` is of.
  void try_one_block() {
    const auto leading =
        std::count_if(radius_.blocks.begin(), radius_.blocks.end(),
                      [](const JointSpectralRadius::Block& block) { return !block.below; });
    if (leading != 1) return;
    found_.verdict = Truth::yes;
    found_.reason =
        "one block of the differences has that joint spectral radius, and its products are bounded "
        "by an invariant norm";
  }

  /// By the operators on the differences of the order in question.
  Attainment run() {
    if (found_.verdict != Truth::undecided) return found_;
    const Result<TransitionOperators> operators = transition_operators(mask_, found_.order);
    if (!operators) return undecided(operators.error().message);
    const std::size_t rows = operators->on_differences.front().size();
    const bool small = rows <= kMostPowerRows;
    if (small && grows(*operators)) {
      found_.sharp = power_bound(operators->on_differences) == found_.logarithm;
      return found_;
    }
    if (by_norm()) return found_;
    if (small && power_bound(operators->on_differences) == 0) {
      found_.verdict = Truth::yes;
      found_.reason =
          "the blocks of the differences that have that joint spectral radius do not "
          "act on each other";
      return found_;
    }
    if (asked(stop_)) return undecided("the time ended");
    if (!small)
      return undecided(fmt::format("{} differences would have to be followed, too many", rows));
    return undecided("neither a bound of the differences nor a Jordan block was found");
  }

 private:
  Attainment undecided(const std::string& reason) {
    found_.reason = reason;
    return found_;
  }

  /// Whether powers of some product grow, the product at hand and each operator being tried.
  bool grows(const TransitionOperators& operators) {
    const int length = static_cast<int>(radius_.product.size());
    const Rational leading = abs(*radius_.eigenvalue);
    try_product(operators, radius_.product, leading);
    if (const std::optional<Rational> level = rational_root(leading, length))
      for (std::size_t i = 0; i < operators.digits.size() && !asked(stop_); ++i)
        try_product(operators, {static_cast<int>(i)}, *level);
    return found_.logarithm > 0;
  }

  /// Looks for a larger Jordan block at ±eigenvalue.
  void try_product(const TransitionOperators& operators, const std::vector<int>& factors,
                   const Rational& eigenvalue) {
    std::vector<const RationalMatrix*> list;
    std::string digits;
    for (const int factor : factors) {
      const auto i = static_cast<std::size_t>(factor);
      list.push_back(&operators.on_differences[i]);
      digits += fmt::format(" ({}, {})", operators.digits[i][0], operators.digits[i][1]);
    }
    const RationalMatrix product = product_of(list);
    int most = 0;
    for (const Rational& value : {eigenvalue, -eigenvalue})
      most = std::max(most, largest_jordan_block(product, value));
    if (most - 1 > found_.logarithm) {
      found_.verdict = Truth::no;
      found_.logarithm = most - 1;
      found_.reason = fmt::format(
          "the steps with digits{}, repeated, have a Jordan block of {} rows at the "
          "eigenvalue {}",
          digits, most, to_string(eigenvalue));
    }
  }

  /// Norms of fewer and fewer kinds of differences, each bounding all that they span; one step of
  /// each is tried first.
  bool by_norm() {
    for (const int most_steps : {1, kMostNormSteps})
      for (int most_alike = found_.order; most_alike >= 1 && !asked(stop_); --most_alike)
        if (const std::optional<int> steps =
                steps_that_bound_differences(mask_, found_.order, most_alike, most_steps, stop_)) {
          found_.verdict = Truth::yes;
          found_.reason = norm_text(*steps);
          return true;
        }
    return false;
  }

  [[nodiscard]] std::string norm_text(int steps) const {
    const Rational squared = 1 / power(Rational(mask_.dilation.growth()), found_.order * steps);
    return fmt::format("{} multipl{} a norm of the differences of order {} by {} at most, exactly",
                       steps == 1 ? "a step" : fmt::format("{} steps", steps),
                       steps == 1 ? "ies" : "y", found_.order,
                       to_string(*rational_root(squared, 2)));
  }

  [[nodiscard]] std::optional<int> power_bound(const std::vector<RationalMatrix>& matrices) const {
    const int length = static_cast<int>(radius_.product.size());
    const std::optional<Rational> level = rational_root(abs(*radius_.eigenvalue), length);
    if (!level) return std::nullopt;
    return bound_growth_power(matrices, *level, length, stop_);
  }

  const Mask& mask_;
  const JointSpectralRadius& radius_;
  const Stop& stop_;
  Attainment found_;
};

/// log_s(q) where growth = s², or 2 log_growth(q).
std::string logarithm_text(const Rational& q, int growth) {
  const std::optional<Rational> base = rational_root(Rational(growth), 2);
  return base ? fmt::format("log{}({})", to_string(*base), to_string(q))
              : fmt::format("2*log{}({})", growth, to_string(q));
}

}  // namespace

std::string exponent_text(const Rational& eigenvalue, int length, int growth) {
  const Rational shrinks = 1 / abs(eigenvalue);
  // shrinks² = growthᵏ: the exponent is k/length
  Rational reached = 1;
  for (int k = 0; reached <= shrinks * shrinks; ++k, reached *= growth)
    if (reached == shrinks * shrinks) return to_string(Rational(k, length));
  if (const std::optional<Rational> root = rational_root(shrinks, length))
    return logarithm_text(*root, growth);
  return fmt::format("{}/{}", logarithm_text(shrinks, growth), length);
}

Attainment decide_attainment(const Mask& mask, const JointSpectralRadius& radius, int sum_rules,
                             double value, bool whole, const Stop& stop) {
  const int order = static_cast<int>(whole ? std::nearbyint(value) : std::ceil(value));
  AttainmentDecision decision(mask, radius, order, stop);
  if (!whole || order == sum_rules) decision.try_one_block();
  return decision.run();
}

}  // namespace limn::regular
