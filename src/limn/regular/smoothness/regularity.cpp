#include "limn/regular/smoothness/regularity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/core.h>

#include "limn/base/outward.h"
#include "limn/number/rational_power.h"
#include "limn/regular/smoothness/attainment.h"
#include "limn/regular/smoothness/box_spline.h"
#include "limn/regular/smoothness/difference_norm.h"
#include "limn/regular/smoothness/joint_spectral_radius.h"
#include "limn/regular/smoothness/stability.h"
#include "limn/regular/smoothness/transition_operators.h"

namespace limn {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
constexpr double kLogarithms =
    4e-15;  // what quotients of logarithms are off by, relatively, and more

constexpr int kAlways = 2;                // C1 and C2 are always asked for
constexpr double kShareOfBracket = 0.75;  // of the time; the rest is for the difference schemes

using number::power;

/// Whether the proved lower bound of the joint spectral radius is at least |det M|^{-r/2}; exactly,
/// where it comes from a rational eigenvalue.
bool radius_reaches(const JointSpectralRadius& radius, int growth, int r) {
  if (!radius.eigenvalue) return radius.lower >= std::pow(growth, -r / 2.0) * (1 + kLogarithms);
  const int length = static_cast<int>(radius.product.size());
  return power(*radius.eigenvalue, 2) * power(Rational(growth), r * length) >= 1;
}

/// -log ρ / log √|det M|, moved down or up by what rounding may have done.
double exponent(double radius, int growth, double direction) {
  if (radius == 0) return kNoBound;
  const double value = -2 * std::log(radius) / std::log(growth);
  const double off = kLogarithms * (1 + std::abs(value));
  return value + direction * off;
}

/// The exponent as a whole number, where the radius is such a power of √|det M| exactly.
std::optional<double> whole_exponent(const JointSpectralRadius& radius, int growth) {
  if (!radius.eigenvalue) return std::nullopt;
  const double value = std::nearbyint(exponent(radius.lower, growth, 0));
  const int length = static_cast<int>(radius.product.size());
  if (value < 0 || value > 100) return std::nullopt;
  const int r = static_cast<int>(value);
  if (power(*radius.eigenvalue, 2) * power(Rational(growth), r * length) != 1) return std::nullopt;
  return value;
}

Status check_cosets(const Mask& mask) {
  std::vector<Rational> sums(cosets(mask.dilation).size(), Rational(0));
  for (const auto& [k, value] : regular::integer_offsets(mask))
    sums[static_cast<std::size_t>(coset_of(mask.dilation, k))] += value;
  for (const Rational& sum : sums)
    if (sum != 1)
      return Error{"the weights of a new point do not sum to 1: no regularity can be told"};
  return Done{};
}

class Analysis {
 public:
  Analysis(const Mask& mask, const RegularityOptions& options)
      : mask_(mask),
        options_(options),
        time_(options.seconds, options.clock),
        growth_(mask.dilation.growth()) {}

  Result<Regularity> run() {
    if (Status status = check_cosets(mask_); !status) return status.error();
    result_.orders = polynomial_orders(mask_);
    const Result<regular::TransitionOperators> operators =
        regular::transition_operators(mask_, result_.orders.sum_rules);
    if (!operators) return operators.error();
    bracket(*operators);
    if (result_.holder.radius.time_ended) raise_by_norms();
    decide_convergence(result_.smoothness.emplace_back());
    find_power(0);
    if (result_.smoothness.front().verdict == Truth::yes) {
      tell("stability of the shifts");
      const regular::Stability stability = regular::prove_stability(mask_);
      result_.stable = stability.verdict;
      result_.stability_reason = stability.reason;
    } else {
      result_.stability_reason = "asked only of schemes that converge";
    }
    bound_above();
    state_closed_form();
    for (int r = 1; r <= kAlways || result_.smoothness.back().verdict == Truth::yes; ++r) decide(r);
    for (int r = 1; r < static_cast<int>(result_.smoothness.size()); ++r) find_power(r);
    decide_attained();
    result_.time_ended = result_.holder.radius.time_ended || time_.ended();
    return std::move(result_);
  }

 private:
  void tell(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }

  void bracket(const regular::TransitionOperators& operators) {
    HolderBracket& holder = result_.holder;
    const regular::JointSpectralRadiusOptions options{
        .budget = options_.budget,
        .tolerance = std::pow(growth_, options_.tolerance / 2) - 1,
        .progress = options_.progress,
        .stop = time_.stop(kShareOfBracket)};
    if (operators.on_differences.front().empty())
      holder.radius.exact = true;
    else
      holder.radius = regular::enclose_joint_spectral_radius(operators.on_differences, options);
    for (const int factor : holder.radius.product)
      holder.digits.push_back(operators.digits[static_cast<std::size_t>(factor)]);
    const std::optional<double> whole = whole_exponent(holder.radius, growth_);
    holder.lower =
        holder.radius.exact && whole ? *whole : exponent(holder.radius.upper, growth_, -1);
    holder.lower = std::min<double>(holder.lower, result_.orders.sum_rules);
  }

  void bound_above() {
    HolderBracket& holder = result_.holder;
    if (result_.stable != Truth::yes) return;
    const std::optional<double> whole = whole_exponent(holder.radius, growth_);
    holder.upper = std::min<double>(whole ? *whole : exponent(holder.radius.lower, growth_, 1),
                                    result_.orders.sum_rules);
  }

  /// Names the exponent where it is known exactly, and decides whether it is attained.
  void decide_attained() {
    HolderBracket& holder = result_.holder;
    const JointSpectralRadius& radius = holder.radius;
    if (!radius.exact || !radius.eigenvalue || !holder.upper || !(radius.upper < 1)) {
      holder.attained.reason = result_.stable == Truth::yes || !radius.exact
                                   ? "the exponent is not known exactly"
                                   : "the exponent is known to be at least so much, not exactly: "
                                     "stability is not proved";
      return;
    }
    const std::optional<double> whole = whole_exponent(radius, growth_);
    const double value = whole.value_or(exponent(radius.lower, growth_, 0));
    if (value > result_.orders.sum_rules) {
      holder.attained.reason = "the sum rules do not reach the exponent of the differences";
      return;
    }
    tell("whether the exponent is attained");
    holder.exact = regular::exponent_text(*radius.eigenvalue,
                                          static_cast<int>(radius.product.size()), growth_);
    holder.attained = regular::decide_attainment(mask_, radius, result_.orders.sum_rules, value,
                                                 whole.has_value(), time_.stop());
  }

  /// Where differences prove less.
  void state_closed_form() {
    HolderBracket& holder = result_.holder;
    const std::optional<regular::BoxSpline> spline = regular::find_box_spline(mask_);
    if (!spline || result_.smoothness.front().verdict != Truth::yes) return;
    if (holder.upper == holder.lower) return;
    holder.lower = spline->exponent();
    holder.exact = fmt::format("{:.17g}", holder.lower);
    holder.exact_reason = spline->text();
  }

  [[nodiscard]] std::string product_text() const {
    std::string text;
    for (const LatticeVector digit : result_.holder.digits)
      text += fmt::format("{}({}, {})", text.empty() ? "" : " ", digit[0], digit[1]);
    return text;
  }

  void decide_convergence(Smoothness& smoothness) const {
    if (result_.holder.lower > 0)
      smoothness = {Truth::yes, 0, 0,
                    "Hölder exponent ≥ " + base::rounded_down(result_.holder.lower)};
    else if (radius_reaches(result_.holder.radius, growth_, 0))
      smoothness = {
          Truth::no, 0, 0,
          fmt::format("differences do not shrink in the steps with digits {}", product_text())};
    else
      smoothness.reason = fmt::format("the joint spectral radius is known to [{}, {}] only{}",
                                      base::rounded_down(result_.holder.radius.lower),
                                      base::rounded_up(result_.holder.radius.upper), why_no_more());
  }

  [[nodiscard]] std::string why_no_more() const {
    return result_.holder.radius.time_ended ? ": the time ended" : "";
  }

  void decide(int r) {
    Smoothness& smoothness = result_.smoothness.emplace_back();
    const HolderBracket& holder = result_.holder;
    if (!holder.exact_reason.empty()) {  // a box spline: `lower` is its exponent
      smoothness = {holder.lower > r ? Truth::yes : Truth::no, 0, 0,
                    fmt::format("Hölder exponent {}: {}", holder.exact, holder.exact_reason)};
    } else if (holder.lower > r) {
      smoothness = {Truth::yes, 0, 0, "Hölder exponent ≥ " + base::rounded_down(holder.lower)};
    } else if (result_.smoothness.front().verdict == Truth::no) {
      smoothness = {Truth::no, 0, 0, "the scheme does not converge"};
    } else if (result_.stable != Truth::yes) {
      smoothness.reason =
          fmt::format("Hölder exponent ≥ {}, and more is not excluded: stability is not proved{}",
                      base::rounded_down(holder.lower), why_no_more());
    } else if (result_.orders.sum_rules <= r) {
      smoothness = {
          Truth::no, 0, 0,
          fmt::format("stable shifts and C{} need sum rules of order {}, the mask's are of "
                      "order {}",
                      r, r + 1, result_.orders.sum_rules)};
    } else if (radius_reaches(holder.radius, growth_, r)) {
      smoothness = {Truth::no, 0, 0,
                    fmt::format("divided differences of order {} do not vanish in the steps with "
                                "digits {}",
                                r + 1, product_text())};
    } else {
      smoothness.reason = fmt::format("the Hölder exponent is known to [{}, {}] only{}",
                                      base::rounded_down(holder.lower),
                                      base::rounded_up(*holder.upper), why_no_more());
    }
  }

  /// Norms of the differences of order r + 1, power after power; found once.
  const std::vector<double>& norms(int r) {
    const auto [at, fresh] = norms_.try_emplace(r);
    if (!fresh) return at->second;
    tell(fmt::format("steps that shrink for C{}", r));
    const double step = std::pow(growth_, r / 2.0) * (1 + kLogarithms);
    at->second = regular::difference_norms(mask_, r + 1, options_.most_steps,
                                           1 / (step * (1 + kLogarithms)), time_.stop());
    return at->second;
  }

  /// The classical proof beside the bracket's.
  void find_power(int r) {
    Smoothness& smoothness = result_.smoothness[static_cast<std::size_t>(r)];
    if (smoothness.verdict == Truth::no || result_.orders.sum_rules <= r) return;
    if (norms(r).empty()) return;
    const double step = std::pow(growth_, r / 2.0) * (1 + kLogarithms);
    const int power = static_cast<int>(norms(r).size());
    const double norm = norms(r).back() * std::pow(step, power) * (1 + kLogarithms);
    if (!(norm < 1)) return;
    smoothness.power = power;
    smoothness.norm = norm;
    if (smoothness.verdict == Truth::yes) return;
    smoothness.verdict = Truth::yes;
    smoothness.reason = "the divided differences shrink";
  }

  /// Where the time ended before there was a bracket worth the name: norms bound the joint spectral
  /// radius on differences of each order, and with it the exponent, up to that order.
  void raise_by_norms() {
    for (int r = 0; r < result_.orders.sum_rules; ++r) {
      double best = -kNoBound;
      for (std::size_t k = 0; k < norms(r).size(); ++k)
        best = std::max(best, exponent(norms(r)[k], growth_, -1) / static_cast<double>(k + 1));
      result_.holder.lower = std::max(result_.holder.lower, std::min<double>(best, r + 1));
      if (!(best > r)) return;
    }
  }

  const Mask& mask_;
  const RegularityOptions& options_;
  TimeBudget time_;
  int growth_;
  Regularity result_;
  std::map<int, std::vector<double>> norms_;  // by r
};

}  // namespace

Result<Regularity> enclose_regularity(const Mask& mask, const RegularityOptions& options) {
  return Analysis(mask, options).run();
}

}  // namespace limn
