#include "limn/fairness/trend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::fairness {

Trend trend_of(const std::vector<double>& values, double negligible) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  constexpr double kRelative = 1e-9;
  Trend trend{Truth::undecided, kUnknown, kUnknown};
  const std::size_t n = values.size();
  if (n < 4) return trend;
  for (const double value : values)
    if (!std::isfinite(value)) return trend;
  const auto change = [&](std::size_t back) { return values[n - 1 - back] - values[n - 2 - back]; };
  const double last = values[n - 1];
  const double least = std::max(kRelative * std::abs(last), negligible);
  double late = std::abs(change(0));
  double early = std::abs(change(2));
  if (n > 4) {
    late = std::max(late, std::abs(change(1)));
    early = std::max(early, std::abs(change(3)));
  }
  if (std::max(late, std::abs(change(1))) <= least) return {Truth::yes, kUnknown, last};
  if (early == 0) return trend;
  trend.ratio = std::sqrt(late / early);
  const bool rising = change(0) > 0 && change(1) > 0 && change(2) > 0;
  // what has just begun to grow does not converge, however large the first changes were
  const bool growing = change(0) * change(1) > 0 && change(0) / change(1) >= kDivergent;
  if (trend.ratio <= kConvergent && !growing) {
    trend.converges = Truth::yes;
    const double signed_ratio = change(0) * change(1) < 0 ? -trend.ratio : trend.ratio;
    trend.limit = last + change(0) * signed_ratio / (1 - signed_ratio);
  } else if (trend.ratio >= kDivergent && rising) {
    trend.converges = Truth::no;
  }
  return trend;
}

}  // namespace limn::fairness
