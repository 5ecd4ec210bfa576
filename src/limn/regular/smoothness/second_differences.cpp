#include "limn/regular/smoothness/regularity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "limn/base/outward.h"
#include "limn/number/rational_power.h"
#include "limn/regular/algebra/jordan.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/box_spline.h"
#include "limn/regular/smoothness/difference_norm.h"
#include "limn/regular/smoothness/joint_spectral_radius.h"
#include "limn/regular/smoothness/stability.h"
#include "limn/regular/smoothness/transition_operators.h"
#include "limn/scheme/lattice_schemes.h"

namespace limn {
namespace {

constexpr int kOrder = 2;
constexpr int kMostSteps = 4;             // whose norms are tried
constexpr std::size_t kMostRows = 72;     // of the transition operators
constexpr std::size_t kRemembered = 512;  // masks
// vertices of a polytope: what fits a few tenths of a second falls with the cube of the rows
constexpr double kMostDecisionWork = 1.5e7;
constexpr int kFewDecisionVertices = 60;
constexpr int kManyVertices = 2000;
constexpr double kRounding = 1e-12;  // what a comparison in double precision leaves open

/// ρ against 1/|det M|.
enum class Side { below, equal, above, unknown };

using number::power;

Side side_of(const JointSpectralRadius& radius, int growth) {
  const double target = 1.0 / growth;
  if (radius.upper < target * (1 - kRounding)) return Side::below;
  if (radius.eigenvalue) {
    const Rational normalised =
        abs(*radius.eigenvalue) * power(Rational(growth), radius.product.size());
    if (normalised == 1) return Side::equal;
    if (normalised > 1) return Side::above;
  }
  return radius.lower > target * (1 + kRounding) ? Side::above : Side::unknown;
}

regular::RationalMatrix product_of(const std::vector<regular::RationalMatrix>& matrices,
                                   const std::vector<int>& factors) {
  regular::RationalMatrix result = matrices[static_cast<std::size_t>(factors.front())];
  for (std::size_t i = 1; i < factors.size(); ++i)
    result = regular::product(result, matrices[static_cast<std::size_t>(factors[i])]);
  return result;
}

/// Decides it for one mask.
class Decision {
 public:
  explicit Decision(const Mask& mask)
      : mask_(mask), growth_(mask.dilation.growth()), orders_(polynomial_orders(mask)) {}

  RegularPart run() {
    if (orders_.sum_rules < 1 || total(mask_.coefficients) != growth_)
      return {Truth::undecided, "the weights of a new point do not sum to 1 there"};
    const Result<regular::TransitionOperators> operators =
        regular::transition_operators(mask_, orders_.sum_rules);
    if (!operators) return {Truth::undecided, operators.error().message};
    const std::size_t rows = operators->on_differences.front().size();
    if (rows > kMostRows)
      return {
          Truth::undecided,
          fmt::format("its mask is wide ({} differences to follow), so nothing was tried", rows)};
    if (rows > 0) {
      radius_ = regular::enclose_joint_spectral_radius(operators->on_differences, options(rows));
    }
    if (!(radius_.lower < 1 - kRounding)) {
      if (side_at_one() == Side::unknown)
        return {Truth::undecided, "whether the scheme converges there is not decided"};
      return {Truth::no, "the scheme does not converge there"};
    }
    return orders_.sum_rules < kOrder ? of_low_order() : by_radius();
  }

 private:
  [[nodiscard]] regular::JointSpectralRadiusOptions options(std::size_t rows) const {
    regular::JointSpectralRadiusOptions options;
    options.budget = static_cast<int>(
        std::clamp<double>(kMostDecisionWork / std::pow(static_cast<double>(rows), 3),
                           kFewDecisionVertices, kManyVertices));
    options.target = 1.0 / growth_;
    return options;
  }

  [[nodiscard]] Side side_at_one() const {
    if (radius_.eigenvalue) return abs(*radius_.eigenvalue) >= 1 ? Side::above : Side::unknown;
    return radius_.lower >= 1 ? Side::above : Side::unknown;
  }

  /// An upper end of the Hölder exponent of stable shifts.
  [[nodiscard]] std::string exponent_text() const {
    const double exponent =
        -2 * std::log(radius_.lower) / std::log(growth_) * (1 + kRounding) + kRounding;
    return base::rounded_up(std::min<double>(exponent, orders_.sum_rules));
  }

  /// What holds if shifts are stable: `words` says so then.
  RegularPart unbounded_if_stable(const std::string& words) {
    if (!converges())
      return {Truth::undecided, "whether the scheme converges there is not decided"};
    const regular::Stability stability = regular::prove_stability(mask_);
    if (stability.verdict == Truth::yes) return {Truth::no, words};
    return {Truth::undecided, fmt::format("{} if shifts are stable, which is not proved", words)};
  }

  bool converges() {
    if (radius_.upper < 1) return true;
    const std::vector<double> norms = regular::difference_norms(mask_, 1, kMostSteps, 1);
    return !norms.empty() && norms.back() < 1;
  }

  RegularPart of_low_order() {
    return unbounded_if_stable(
        fmt::format("its mask has sum rules of order {}, where bounded curvature needs order 3",
                    orders_.sum_rules));
  }

  RegularPart by_radius() {
    switch (side_of(radius_, growth_)) {
      case Side::below: return {Truth::yes, "its Hölder exponent is above 2"};
      case Side::above:
        return unbounded_if_stable(
            fmt::format("its Hölder exponent is at most {}", exponent_text()));
      case Side::equal:
        if (grows_at_critical_value())
          return unbounded_if_stable(
              "second differences over h² grow with the level: its Hölder exponent is at most 2, "
              "and the critical eigenvalue has a Jordan block");
        break;
      case Side::unknown: break;
    }
    if (const auto steps = regular::steps_that_bound_differences(mask_, kOrder, kOrder, kMostSteps))
      return {
          Truth::yes,
          fmt::format("second differences over h² stay bounded: {} multipl{} them by 1 at most, "
                      "exactly",
                      *steps == 1 ? "a step" : fmt::format("{} steps", *steps),
                      *steps == 1 ? "ies" : "y")};
    const std::optional<regular::BoxSpline> spline = regular::find_box_spline(mask_);
    if (spline && spline->exponent() >= kOrder)
      return {Truth::yes, spline->text() + ", whose second derivatives are bounded"};
    if (orders_.sum_rules <= kOrder) return of_low_order();
    if (side_of(radius_, growth_) == Side::equal)
      return {
          Truth::undecided,
          "its Hölder exponent is at most 2 if shifts are stable, and neither a bound of second "
          "differences over h² nor a Jordan block was found"};
    return {Truth::undecided,
            fmt::format("whether its Hölder exponent is above 2 is not decided: the joint spectral "
                        "radius is known to [{}, {}] only",
                        base::rounded_down(radius_.lower), base::rounded_up(radius_.upper))};
  }

  /// Whether powers of some product grow on the second differences, the product at hand and each
  /// operator being tried.
  [[nodiscard]] bool grows_at_critical_value() const {
    const Result<regular::TransitionOperators> operators =
        regular::transition_operators(mask_, kOrder);
    if (!operators) return false;
    std::vector<std::vector<int>> products{radius_.product};
    for (std::size_t i = 0; i < operators->digits.size(); ++i)
      products.push_back({static_cast<int>(i)});
    return std::any_of(products.begin(), products.end(), [&](const std::vector<int>& factors) {
      const regular::RationalMatrix a = product_of(operators->on_differences, factors);
      const Rational critical = 1 / power(Rational(growth_), factors.size());
      return regular::largest_jordan_block(a, critical) > 1 ||
             regular::largest_jordan_block(a, -critical) > 1;
    });
  }

  const Mask& mask_;
  int growth_;
  PolynomialOrders orders_;
  JointSpectralRadius radius_;
};

using Key = std::tuple<Lattice, std::array<std::array<int, 2>, 2>, Laurent>;

Key key_of(const Mask& mask) { return {mask.lattice, mask.dilation.rows, mask.coefficients}; }

}  // namespace

RegularPart find_regular_part(const Mask& mask) {
  static std::mutex mutex;
  static std::map<Key, RegularPart> known;
  const Key key = key_of(mask);
  {
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  RegularPart part = Decision(mask).run();
  part.stable = regular::prove_stability(mask).verdict == Truth::yes;
  const std::lock_guard lock(mutex);
  if (known.size() >= kRemembered) known.clear();
  return known.emplace(key, std::move(part)).first->second;
}

RegularPart find_regular_part(const Scheme& scheme) {
  RegularPart all{Truth::yes, {}};
  const std::vector<Scheme> lattices = scheme::lattice_schemes(scheme);
  for (const Scheme& one : lattices) {
    const Result<Mask> mask = regular_mask(one);
    RegularPart part =
        mask ? find_regular_part(*mask) : RegularPart{Truth::undecided, mask.error().message};
    if (lattices.size() == 1) return part;
    all.bounded = all.bounded && part.bounded;
    all.stable = all.stable && part.stable;
    all.reason += fmt::format("{}on {}s: {}", all.reason.empty() ? "" : "; ",
                              scheme::lattice_name(one.split->lattice), part.reason);
  }
  return all;
}

}  // namespace limn
