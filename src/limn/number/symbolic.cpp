#include "limn/number/symbolic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "limn/number/polynomial_factors.h"
#include "limn/number/polynomial_text.h"

namespace limn::number {
namespace {

constexpr std::size_t kMostFormulaTerms = 2000;
constexpr int kLargestDegree = 1000;
constexpr unsigned kMostFormulaBits = 20000;  // of a numerator or a denominator
constexpr double kDecided = 1e-9;

Status bounded(const Polynomial& a) {
  const auto bits = [](const Integer& of) { return of == 0 ? 0 : msb(abs(of)); };
  if (a.terms().size() > kMostFormulaTerms) return Error{"a formula has too many terms"};
  for (const auto& [monomial, value] : a.terms()) {
    if (bits(numerator(value)) > kMostFormulaBits || bits(denominator(value)) > kMostFormulaBits)
      return Error{"the number is too large"};
    for (const auto& [indeterminate, exponent] : monomial)
      if (std::abs(exponent) > kLargestDegree) return Error{"a formula's degree is too high"};
  }
  return Done{};
}

Result<Polynomial> bounded_product(const Polynomial& a, const Polynomial& b) {
  if (a.terms().size() * b.terms().size() > kMostFormulaTerms * 10)
    return Error{"a formula has too many terms"};
  Polynomial result = a * b;
  if (Status status = bounded(result); !status) return status.error();
  return result;
}

int nesting(const IndeterminateData& indeterminate) {
  int deepest = 0;
  if (indeterminate.argument)
    for (const Indeterminate& inner : indeterminate.argument->indeterminates())
      deepest = std::max(deepest, nesting(*inner));
  return deepest + 1;
}

/// The square root that holds the most others within it.
std::optional<Indeterminate> outer_root(const Polynomial& a, int least_exponent) {
  std::optional<Indeterminate> found;
  for (const Indeterminate& indeterminate : a.indeterminates()) {
    if (indeterminate->kind != IndeterminateKind::root ||
        a.powers_of(indeterminate).rbegin()->first < least_exponent)
      continue;
    if (!found || nesting(*indeterminate) > nesting(**found)) found = indeterminate;
  }
  return found;
}

/// With the radicand in place of every square of a root.
Result<Polynomial> without_squares(Polynomial a) {
  for (std::optional<Indeterminate> root = outer_root(a, 2); root; root = outer_root(a, 2)) {
    Polynomial result;
    for (const auto& [exponent, coefficient] : a.powers_of(*root)) {
      Polynomial term = coefficient;
      for (int e = 1; e < exponent; e += 2) {
        Result<Polynomial> product = bounded_product(term, *(*root)->argument);
        if (!product) return product;
        term = std::move(*product);
      }
      result += exponent % 2 == 0 ? term : term * Polynomial(*root);
    }
    a = std::move(result);
  }
  if (Status status = bounded(a); !status) return status.error();
  return a;
}

Result<Polynomial> product_without_squares(const Polynomial& a, const Polynomial& b) {
  Result<Polynomial> product = bounded_product(a, b);
  if (!product) return product;
  return without_squares(std::move(*product));
}

/// Of q ≥ 0 the largest s with s² dividing it, as far as small primes show.
Rational square_part(const Rational& q) {
  const auto part = [](Integer left) {
    Integer root = 1;
    if (Integer whole = sqrt(left); whole * whole == left) return whole;
    for (int p = 2; p < 1000 && p * p <= left; ++p)
      while (left % (p * p) == 0) {
        left /= p * p;
        root *= p;
      }
    return root;
  };
  const Integer below = denominator(q);
  // a/b = ab/b²
  return Rational(part(numerator(q) * below), below);
}

/// The sum of the moduli of the terms.
double magnitude(const Polynomial& a) {
  double sum = 0;
  for (const auto& [monomial, coefficient] : a.terms())
    sum += std::abs(approx(Symbolic(Polynomial(monomial, coefficient))));
  return sum;
}

/// Whether it holds but numbers, cosines and roots of such, and π.
bool is_constant(const Polynomial& a) {
  const std::vector<Indeterminate> indeterminates = a.indeterminates();
  return std::all_of(indeterminates.begin(), indeterminates.end(),
                     [](const Indeterminate& indeterminate) {
                       return indeterminate->argument ? is_constant(*indeterminate->argument)
                                                      : indeterminate->name == "pi";
                     });
}

Result<int> constant_sign(const Polynomial& a) {
  if (a.is_rational()) return a.rational() < 0 ? -1 : a.is_zero() ? 0 : 1;
  const double value = approx(Symbolic(a));
  if (!(std::abs(value) > kDecided * magnitude(a)))
    return Error{"cannot decide the sign of a number this close to 0"};
  return value < 0 ? -1 : 1;
}

/// Of a polynomial in one whole number alone: that beyond its roots.
Result<int> eventual_sign(const Polynomial& a, const Indeterminate& indeterminate) {
  const std::map<int, Polynomial> powers = a.powers_of(indeterminate);
  const auto& [degree, leading] = *powers.rbegin();
  const Rational lead = leading.rational();
  const bool linear = degree == 1 && powers.begin()->first == 0;
  Rational bound = 0;  // the root itself, or Cauchy's
  for (const auto& [exponent, coefficient] : powers) {
    const Rational ratio = coefficient.rational() / lead;
    if (exponent != degree)
      bound = linear ? Rational(-ratio) : std::max(bound, Rational(abs(ratio) + 1));
  }
  if (indeterminate->suppose) indeterminate->suppose(Polynomial(indeterminate) - Polynomial(bound));
  return lead < 0 ? -1 : 1;
}

/// Of a·k + b·n + c amid k = 0 … n-1, for large n.
Result<int> sign_amid(const Polynomial& a, const Indeterminate& inner, const Indeterminate& outer) {
  std::map<int, Polynomial> powers = a.powers_of(inner);
  std::map<int, Polynomial> rest = powers[0].powers_of(outer);
  const bool linear = powers.rbegin()->first == 1 && powers.begin()->first == 0 &&
                      powers[1].is_rational() && rest[1].is_rational() && rest[0].is_rational() &&
                      rest.begin()->first >= 0 && rest.rbegin()->first <= 1;
  if (!linear || !(rest[1] == -powers[1]))
    return Error{"cannot decide this comparison for every n and k"};
  const Rational size = abs(powers[1].rational());
  const int sign = powers[1].rational() < 0 ? 1 : -1;  // of n - k
  Polynomial supposed = a;
  supposed *= sign / size;
  if (inner->suppose) inner->suppose(supposed);
  return sign;
}

}  // namespace

Symbolic Symbolic::negated() const {
  Symbolic result = *this;
  result.numerator_ *= Rational(-1);
  return result;
}

Result<Symbolic> Symbolic::reduced(Polynomial numerator, Polynomial denominator) {
  // (p + q t)(p - q t) = p² - q² t²
  for (std::optional<Indeterminate> root = outer_root(denominator, 1); root;
       root = outer_root(denominator, 1)) {
    const std::map<int, Polynomial> powers = denominator.powers_of(*root);
    const Polynomial q = powers.at(1) * Polynomial(*root);
    const Polynomial conjugate = denominator - q - q;
    const Result<Polynomial> above = product_without_squares(numerator, conjugate);
    if (!above) return above.error();
    const Result<Polynomial> below = product_without_squares(denominator, conjugate);
    if (!below) return below.error();
    numerator = *above;
    denominator = *below;
  }
  if (denominator.is_zero()) return Error{"division by zero"};
  Symbolic result;
  if (denominator.terms().size() > 1) {
    const Monomial lowest = numerator.is_zero() ? Monomial() : numerator.common_monomial();
    const Monomial low = denominator.common_monomial();
    const Result<Coprime> coprime = without_common_divisor(
        numerator * Polynomial(power(lowest, -1), 1), denominator * Polynomial(power(low, -1), 1));
    if (coprime) {  // else it stays as it is: not the shortest quotient, but the same number
      numerator = coprime->a * Polynomial(product(lowest, power(low, -1)), 1);
      denominator = coprime->b;
    }
  }
  if (denominator.terms().size() == 1) {
    const auto& [monomial, value] = *denominator.terms().begin();
    numerator = numerator * Polynomial(power(monomial, -1), 1 / value);
    denominator = 1;
  } else {
    const Rational scale = content(denominator);
    numerator *= 1 / scale;
    denominator *= 1 / scale;
  }
  if (Status status = bounded(numerator); !status) return status.error();
  if (Status status = bounded(denominator); !status) return status.error();
  result.numerator_ = std::move(numerator);
  result.denominator_ = std::move(denominator);
  return result;
}

Result<Symbolic> Symbolic::add(const Symbolic& a, const Symbolic& b) {
  if (a.denominator_ == b.denominator_) {
    Polynomial sum = a.numerator_ + b.numerator_;
    if (a.denominator_ == Polynomial(1)) {
      if (Status status = bounded(sum); !status) return status.error();
      return Symbolic(std::move(sum));
    }
    return reduced(std::move(sum), a.denominator_);
  }
  const Result<Polynomial> left = product_without_squares(a.numerator_, b.denominator_);
  if (!left) return left.error();
  const Result<Polynomial> right = product_without_squares(b.numerator_, a.denominator_);
  if (!right) return right.error();
  const Result<Polynomial> below = bounded_product(a.denominator_, b.denominator_);
  if (!below) return below.error();
  return reduced(*left + *right, *below);
}

Result<Symbolic> Symbolic::multiply(const Symbolic& a, const Symbolic& b) {
  const Result<Polynomial> above = product_without_squares(a.numerator_, b.numerator_);
  if (!above) return above.error();
  const Result<Polynomial> below = bounded_product(a.denominator_, b.denominator_);
  if (!below) return below.error();
  if (*below == Polynomial(1)) return Symbolic(*above);
  return reduced(*above, *below);
}

Result<Symbolic> Symbolic::divide(const Symbolic& a, const Symbolic& b) {
  if (b.is_zero()) return Error{"division by zero"};
  if (is_constant(b.numerator_))
    if (const Result<int> sign = constant_sign(b.numerator_); !sign) return sign.error();
  const Result<Polynomial> above = product_without_squares(a.numerator_, b.denominator_);
  if (!above) return above.error();
  const Result<Polynomial> below = product_without_squares(a.denominator_, b.numerator_);
  if (!below) return below.error();
  return reduced(*above, *below);
}

Result<Symbolic> Symbolic::sqrt(const Symbolic& square) {
  if (square.is_zero()) return square;
  if (is_constant(square.numerator_) && is_constant(square.denominator_)) {
    const Result<int> sign = Arithmetic<Symbolic>::sign(square);
    if (!sign) return sign.error();
    if (*sign < 0) return Error{"square root of a negative number"};
  }
  const Result<int> below = Arithmetic<Symbolic>::sign(square.denominator_);
  if (!below) return below.error();
  Result<Polynomial> radicand = product_without_squares(square.numerator_, square.denominator_);
  if (!radicand) return radicand.error();
  const Rational outside = square_part(abs(content(*radicand)));
  *radicand *= 1 / (outside * outside);
  if (*radicand == Polynomial(1)) return divide(Symbolic(outside * *below), square.denominator_);
  IndeterminateData data;
  data.kind = IndeterminateKind::root;
  data.name = "sqrt(" + sum_text(*radicand, Notation::text) + ")";
  data.latex = "\\sqrt{" + sum_text(*radicand, Notation::latex) + "}";
  data.argument = std::make_shared<const Polynomial>(std::move(*radicand));
  const Indeterminate indeterminate = std::make_shared<const IndeterminateData>(std::move(data));
  return divide(Polynomial({{indeterminate, 1}}, outside * *below), square.denominator_);
}

Indeterminate variable(const std::string& name) {
  IndeterminateData data;
  data.name = name;
  data.latex = latex_name(name);
  return std::make_shared<const IndeterminateData>(std::move(data));
}

Indeterminate whole_number(const std::string& name,
                           std::function<void(const Polynomial&)> suppose) {
  IndeterminateData data;
  data.kind = IndeterminateKind::whole;
  data.name = name;
  data.latex = latex_name(name);
  data.suppose = std::move(suppose);
  return std::make_shared<const IndeterminateData>(std::move(data));
}

Indeterminate pi_indeterminate() { return variable("pi"); }

double approx(const Symbolic& a) {
  return approx(a, [](const std::string&) { return std::numeric_limits<double>::quiet_NaN(); });
}

double approx(const Symbolic& a, const std::function<double(const std::string&)>& lookup) {
  const auto with_pi = [&](const std::string& name) {
    return name == "pi" ? std::numbers::pi : lookup(name);
  };
  return approx(a.numerator(), with_pi) / approx(a.denominator(), with_pi);
}

Result<int> Arithmetic<Symbolic>::sign(const Symbolic& a) {
  if (a.is_zero()) return 0;
  if (!(a.denominator() == Polynomial(1))) {
    const Result<Symbolic> product =
        Symbolic::multiply(Symbolic(a.numerator()), Symbolic(a.denominator()));
    if (!product) return product.error();
    return sign(*product);
  }
  const Polynomial& value = a.numerator();
  if (is_constant(value)) return constant_sign(value);
  std::vector<Indeterminate> indeterminates = value.indeterminates();
  if (!std::all_of(indeterminates.begin(), indeterminates.end(),
                   [](const Indeterminate& indeterminate) {
                     return indeterminate->kind == IndeterminateKind::whole;
                   }))
    return Error{"cannot decide the sign of a formula"};
  if (indeterminates.size() == 1) return eventual_sign(value, indeterminates.front());
  // k stands before n
  if (indeterminates.size() == 2 && indeterminates[1]->name == "n")
    return sign_amid(value, indeterminates[0], indeterminates[1]);
  return Error{"cannot decide the sign of a formula"};
}

Result<long long> Arithmetic<Symbolic>::integer(const Symbolic& a) {
  if (!a.is_rational() || !limn::is_integer(a.numerator().rational()) ||
      abs(a.numerator().rational()) > Rational(1'000'000'000'000'000LL))
    return Error{"an integer is needed here"};
  return numerator(a.numerator().rational()).convert_to<long long>();
}

}  // namespace limn::number
