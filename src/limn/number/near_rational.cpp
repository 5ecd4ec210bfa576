#include "limn/number/near_rational.h"

#include <cmath>
#include <utility>

namespace limn::number {

std::optional<Rational> near_rational(double x, double tolerance, long long largest) {
  constexpr double kLargestNumber = 1e6;
  if (!(std::abs(x) < kLargestNumber)) return std::nullopt;
  // the convergents p/q of its continued fraction
  long long p = 1, q = 0, last_p = 0, last_q = 1;
  for (double rest = x;;) {
    const double whole = std::floor(rest);
    const auto term = static_cast<long long>(whole);
    last_p = std::exchange(p, term * p + last_p);
    last_q = std::exchange(q, term * q + last_q);
    if (q > largest) return std::nullopt;
    const double error = x - static_cast<double>(p) / static_cast<double>(q);
    if (std::abs(error) <= tolerance * (1 + std::abs(x))) return Rational(p, q);
    if (!(rest - whole > 1e-12)) return std::nullopt;
    rest = 1 / (rest - whole);
    if (!(rest < kLargestNumber)) return std::nullopt;
  }
}

}  // namespace limn::number
