#include "limn/certify/all/turn_range.h"

namespace limn::certify {
namespace {

// With cos √u = Σ (-u)^k/(2k)! and sinc = ∫ cos(s√u) ds over 0 … 1, whose derivatives by u are
// integrals of s², s⁴, … times those of the cosine, which are largest at u = 0.
constexpr double kCosineCurvature = 1.0 / 12;
constexpr double kSincCurvature = 1.0 / 60;
constexpr double kCosineThird = 1.0 / 120;
constexpr double kSincThird = 1.0 / 840;
constexpr double kRoundedUp = 1 + 1e-6;  // for what a ball has below 0 by rounding

/// A function by its value and slope at the middle and a bound of its second derivative.
number::Ball by_slope(const number::Ball& u, const number::Ball& value, const number::Ball& slope,
                      double curvature) {
  const double radius = u.radius();
  return (value + slope * (u - u.middle())).widened(curvature / 2 * radius * radius * kRoundedUp);
}

struct AtPoint {
  number::Ball cosine, sinc, cosine_slope, sinc_slope, cosine_curvature, sinc_curvature;
};

/// u is one number. From Taylor's series near 0, where quotients lose digits.
AtPoint at_point(const number::Ball& u) {
  if (u.magnitude().upper() < 1e-3) {
    // Σ (-u)^k/(2k)! and Σ (-u)^k/(2k+1)! and derivatives; what is left out is below the next term
    constexpr int kTerms = 14;
    AtPoint at;
    number::Ball factorial(1);  // (2k)!
    std::vector<number::Ball> cosine, sinc;
    for (int k = 0; k < kTerms; ++k) {
      if (k > 0) factorial *= number::Ball(2 * k) * number::Ball(2 * k - 1);
      const number::Ball sign(k % 2 == 0 ? 1 : -1);
      cosine.push_back(sign / factorial);
      sinc.push_back(sign / (factorial * number::Ball(2 * k + 1)));
    }
    const auto sum = [&](const std::vector<number::Ball>& series, int derivative) {
      number::Ball total;
      for (int k = kTerms - 1; k >= derivative; --k) {
        number::Ball coefficient = series[static_cast<std::size_t>(k)];
        for (int i = 0; i < derivative; ++i) coefficient *= number::Ball(k - i);
        total = total * u + coefficient;
      }
      return total.widened(1e-50);
    };
    return {sum(cosine, 0), sum(sinc, 0),   sum(cosine, 1),
            sum(sinc, 1),   sum(cosine, 2), sum(sinc, 2)};
  }
  const number::Ball y = number::sqrt(u);
  AtPoint at;
  at.cosine = number::cos(y);
  at.sinc = number::sin(y) / y;
  at.cosine_slope = -at.sinc / number::Ball(2);
  at.sinc_slope = (at.cosine - at.sinc) / (number::Ball(2) * u);
  at.cosine_curvature = -at.sinc_slope / number::Ball(2);
  at.sinc_curvature = (at.cosine_slope - number::Ball(3) * at.sinc_slope) / (number::Ball(2) * u);
  return at;
}

/// x, of so many sectors.
number::Ball sectors(int numerator, int denominator) {
  return number::Ball(Rational(Integer(numerator), Integer(denominator)));
}

}  // namespace

number::Ball enclose_cosine(const number::Ball& u) {
  const AtPoint at = at_point(u.middle());
  return by_slope(u, at.cosine, at.cosine_slope, kCosineCurvature);
}

number::Ball enclose_sinc(const number::Ball& u) {
  const AtPoint at = at_point(u.middle());
  return by_slope(u, at.sinc, at.sinc_slope, kSincCurvature);
}

number::Ball enclose_cosine_slope(const number::Ball& u) {
  const AtPoint at = at_point(u.middle());
  return by_slope(u, at.cosine_slope, at.cosine_curvature, kCosineThird);
}

number::Ball enclose_sinc_slope(const number::Ball& u) {
  const AtPoint at = at_point(u.middle());
  return by_slope(u, at.sinc_slope, at.sinc_curvature, kSincThird);
}

Phase<number::Ball> turns_of(const number::Ball& w) {
  return [w](int numerator, int denominator) {
    const number::Ball x = sectors(numerator, denominator);
    const number::Ball u = x * x * w;
    const number::Ball slope = x * enclose_sinc(u);
    return Turn<number::Ball>(enclose_cosine(u), slope, slope * w);
  };
}

Phase<number::Ball> turn_slopes_of(const number::Ball& w) {
  return [w](int numerator, int denominator) {
    const number::Ball x = sectors(numerator, denominator);
    const number::Ball u = x * x * w;
    const number::Ball change = x * x * x * enclose_sinc_slope(u);
    return Turn<number::Ball>(x * x * enclose_cosine_slope(u), change,
                              x * enclose_sinc(u) + w * change);
  };
}

Phase<number::Ball> turn_losses_of(const number::Ball& w) {
  return [w](int numerator, int denominator) {
    const number::Ball x = sectors(numerator, denominator);
    const number::Ball u = x * x * w;
    // 1 - cos y = 2 sin²(y/2)
    const number::Ball half = enclose_sinc(u / number::Ball(4));
    return Turn<number::Ball>(x * x * half * half / number::Ball(2), number::Ball(0),
                              -x * enclose_sinc(u));
  };
}

}  // namespace limn::certify
