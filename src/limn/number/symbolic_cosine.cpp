#include "limn/number/polynomial_text.h"
#include "limn/number/symbolic.h"

namespace limn::number {
namespace {

constexpr int kMostTurns = 64;  // of an angle's multiple that is resolved

struct CosineAndSine {
  Symbolic cosine;
  Result<Symbolic> sine;
};

Result<Symbolic> complement(const Symbolic& cosine) {
  const Result<Symbolic> square = Symbolic::multiply(cosine, cosine);
  if (!square) return square.error();
  const Result<Symbolic> rest = Symbolic::add(1, square->negated());
  if (!rest) return rest.error();
  return Symbolic::sqrt(*rest);
}

/// Whether π q m lies in [0, π]: m is 1/n, or k/n with 0 ≤ k ≤ n, and q ≤ 1.
bool in_upper_half(const Rational& q, const Monomial& monomial) {
  if (q > 1) return false;
  int above = 0;
  int below = 0;
  for (const auto& [indeterminate, exponent] : monomial) {
    if (indeterminate->kind != IndeterminateKind::whole) return false;
    if (exponent == -1 && indeterminate->name == "n")
      ++below;
    else if (exponent == 1 && indeterminate->name != "n")
      ++above;
    else
      return false;
  }
  return above <= 1 && (below == 1 || monomial.empty());
}

/// cos(π/d), where it has a plain form.
Result<Symbolic> cosine_of_fraction(const Integer& d) {
  if (d == 1) return Symbolic(-1);
  if (d == 2) return Symbolic(0);
  if (d == 3) return Symbolic(Polynomial(Rational(1, 2)));
  if (d == 4) return Symbolic::sqrt(Polynomial(Rational(1, 2)));
  if (d == 5) {
    const Result<Symbolic> root = Symbolic::sqrt(Polynomial(Rational(5, 16)));
    return root ? Symbolic::add(*root, Polynomial(Rational(1, 4))) : root;
  }
  if (d == 6) return Symbolic::sqrt(Polynomial(Rational(3, 4)));
  return Symbolic(Polynomial(cosine_indeterminate(Rational(Integer(1), d), {})));
}

Result<CosineAndSine> of_one_angle(const Rational& q, const Monomial& monomial) {
  const Integer d = denominator(q);
  Integer turns = numerator(q);
  int cosine_sign = 1;
  int sine_sign = 1;
  if (monomial.empty()) {  // to the first quadrant, so that equal cosines are written alike
    turns = ((turns % (2 * d)) + 2 * d) % (2 * d);
    if (turns > d) {
      turns = 2 * d - turns;
      sine_sign = -1;
    }
    if (2 * turns > d) {
      turns = d - turns;
      cosine_sign = -1;
    }
  }
  if (abs(turns) > kMostTurns) return Error{"the multiple of the angle is too high"};
  const Rational unit(Integer(1), d);
  Result<Symbolic> base = monomial.empty()
                              ? cosine_of_fraction(d)
                              : Result<Symbolic>(Polynomial(cosine_indeterminate(unit, monomial)));
  if (!base) return base.error();
  const int j = turns.convert_to<int>();
  // a product has the radicands in place of the squares of roots
  const Result<Symbolic> cosine = Symbolic::multiply(chebyshev(j, base->numerator()), cosine_sign);
  if (!cosine) return cosine.error();
  CosineAndSine result{*cosine, Error{"the sine of such an angle may have either sign"}};
  if (!in_upper_half(unit, monomial)) return result;
  result.sine = complement(*base);
  if (!result.sine) return result;
  const Result<Symbolic> factor =
      Symbolic::multiply(chebyshev_of_sine(j, base->numerator()), sine_sign);
  if (!factor) return factor.error();
  result.sine = Symbolic::multiply(*factor, *result.sine);
  return result;
}

/// a·b ± c·d
Result<Symbolic> two_products(const Symbolic& a, const Symbolic& b, const Symbolic& c,
                              const Symbolic& d, int sign) {
  const Result<Symbolic> left = Symbolic::multiply(a, b);
  if (!left) return left.error();
  const Result<Symbolic> right = Symbolic::multiply(c, d);
  if (!right) return right.error();
  return Symbolic::add(*left, sign < 0 ? right->negated() : *right);
}

Result<CosineAndSine> cosine_and_sine(const Symbolic& angle) {
  CosineAndSine sum{1, Symbolic(0)};
  if (angle.is_zero()) return sum;
  const Indeterminate pi = pi_indeterminate();
  if (!(angle.denominator() == Polynomial(1)))
    return Error{"cos and sin take sums of multiples of pi, of pi/n and the like"};
  const std::map<int, Polynomial> powers = angle.numerator().powers_of(pi);
  if (powers.size() != 1 || powers.begin()->first != 1)
    return Error{"cos and sin take multiples of pi in exact arithmetic"};
  bool first = true;
  for (const auto& [monomial, q] : powers.begin()->second.terms()) {
    const Result<CosineAndSine> part = of_one_angle(q, monomial);
    if (!part) return part.error();
    if (first) {
      sum = *part;
      first = false;
      continue;
    }
    if (!sum.sine) return sum.sine.error();
    if (!part->sine) return part->sine.error();
    const Result<Symbolic> cosine =
        two_products(sum.cosine, part->cosine, *sum.sine, *part->sine, -1);
    if (!cosine) return cosine.error();
    sum.sine = two_products(*sum.sine, part->cosine, sum.cosine, *part->sine, 1);
    sum.cosine = *cosine;
  }
  return sum;
}

}  // namespace

Result<Symbolic> symbolic_cos(const Symbolic& angle) {
  Result<CosineAndSine> both = cosine_and_sine(angle);
  if (!both) return both.error();
  return std::move(both->cosine);
}

Result<Symbolic> symbolic_sin(const Symbolic& angle) {
  Result<CosineAndSine> both = cosine_and_sine(angle);
  if (!both) return both.error();
  return std::move(both->sine);
}

}  // namespace limn::number
