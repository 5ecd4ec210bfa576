#include "limn/number/closed_roots.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/core.h>

#include "limn/number/polynomial_factors.h"
#include "limn/number/polynomial_text.h"

namespace limn::number {
namespace {

constexpr Notation kNotations[] = {Notation::text, Notation::latex};

std::string& of(ClosedRoot& root, Notation notation) {
  return notation == Notation::text ? root.text : root.latex;
}

/// a/b, factored.
Result<PolynomialFactors> quotient(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero()) return PolynomialFactors{0, {}};
  Result<PolynomialFactors> above = factor(a);
  if (!above) return above;
  const Result<PolynomialFactors> below = factor(b);
  if (!below) return below.error();
  above->content /= below->content;
  for (const auto& [base, exponent] : below->factors) {
    const auto same = std::find_if(above->factors.begin(), above->factors.end(),
                                   [&base = base](const auto& one) { return one.first == base; });
    if (same == above->factors.end()) {
      above->factors.emplace_back(base, -exponent);
      continue;
    }
    same->second -= exponent;
    if (same->second == 0) above->factors.erase(same);
  }
  return above;
}

/// a λ + b = 0
Result<ClosedRoot> linear_root(const Polynomial& a, const Polynomial& b) {
  const Result<PolynomialFactors> value = quotient(-b, a);
  if (!value) return value.error();
  ClosedRoot root;
  // a product of cosines may be shorter as a sum of them
  for (const Notation notation : kNotations) of(root, notation) = product_text(*value, notation);
  if (!a.is_rational()) return root;
  const Polynomial sum = with_multiple_angles(-b) * Polynomial(Rational(1 / a.rational()));
  ClosedRoot other;
  for (const Notation notation : kNotations)
    of(other, notation) = sum_text(sum, notation, TermOrder::rising);
  constexpr std::size_t kWorth = 5;  // a sum of cosines reads better than their powers
  return other.text.size() < root.text.size() + kWorth ? other : root;
}

/// (centre ± outside·√inside) / below
struct Surd {
  Polynomial centre, outside, below;
  PolynomialFactors inside;
};

/// The largest square that divides the product goes outside.
void take_squares_out(Surd& surd) {
  Integer above = numerator(surd.inside.content);
  Rational root = 1;
  for (int p = 2; p < 1000 && p * p <= abs(above); ++p)
    while (above % (p * p) == 0) {
      above /= p * p;
      root *= p;
    }
  surd.inside.content = above;
  surd.outside = root;
  std::vector<std::pair<Polynomial, int>> odd;
  for (const auto& [base, exponent] : surd.inside.factors) {
    surd.outside = surd.outside * power(base, exponent / 2);
    if (exponent % 2 != 0) odd.emplace_back(base, 1);
  }
  surd.inside.factors = std::move(odd);
}

/// Divides centre, outside and below by what they have in common but for rationals.
Status cancel(Surd& surd) {
  Result<Coprime> common = without_common_divisor(surd.outside, surd.below);
  if (common) common = without_common_divisor(common->divisor, surd.centre);
  if (!common) return common.error();
  const Polynomial divisor = common->divisor;
  for (Polynomial* part : {&surd.centre, &surd.outside, &surd.below}) {
    const Result<Coprime> divided = without_common_divisor(*part, divisor);
    if (!divided) return divided.error();
    *part = divided->a * Polynomial(Rational(1 / divided->b.rational()));
  }
  return Done{};
}

/// Makes the three primitive together, over a denominator that is written without a minus.
void scale(Surd& surd) {
  const Rational parts[] = {abs(content(surd.below)), abs(content(surd.outside)),
                            surd.centre.is_zero() ? Rational(0) : abs(content(surd.centre))};
  Integer numerators = 0;
  Integer denominators = 1;
  for (const Rational& part : parts) {
    numerators = gcd(numerators, numerator(part));
    denominators = lcm(denominators, denominator(part));
  }
  const Rational factor = Rational(denominators, numerators) *
                          (sum_text(surd.below, Notation::text).starts_with("-") ? -1 : 1);
  surd.below *= factor;
  surd.centre *= factor;
  surd.outside *= abs(factor);
  if (sum_text(surd.outside, Notation::text).starts_with("-")) surd.outside *= Rational(-1);
}

std::string surd_text(const Surd& surd, int sign, Notation notation) {
  const bool latex = notation == Notation::latex;
  std::string radicand = product_text(surd.inside, notation);
  std::string root = latex ? "\\sqrt{" + radicand + "}" : "sqrt(" + radicand + ")";
  if (!(surd.outside == Polynomial(1))) {
    const std::string outside = sum_text(surd.outside, notation);
    const bool sum = surd.outside.terms().size() > 1;
    root = (sum ? "(" + outside + ")" : outside) + (latex ? " " : "*") + root;
  }
  std::string above = sign < 0 ? "-" + root : root;
  const bool two = !surd.centre.is_zero();
  if (two) above = sum_text(surd.centre, notation) + (sign < 0 ? " - " : " + ") + root;
  if (surd.below == Polynomial(1)) return above;
  const std::string below = sum_text(surd.below, notation);
  if (latex) return fmt::format("\\frac{{{}}}{{{}}}", above, below);
  const bool one_word = below.find_first_of("*/ ") == std::string::npos;
  return (two ? "(" + above + ")" : above) + "/" + (one_word ? below : "(" + below + ")");
}

/// a λ² + b λ + c = 0
Result<std::vector<ClosedRoot>> quadratic_roots(const Polynomial& a, const Polynomial& b,
                                                const Polynomial& c) {
  const Polynomial discriminant = b * b - Polynomial(4) * a * c;
  Result<PolynomialFactors> inside = factor(discriminant);
  if (!inside) return inside.error();
  Surd surd{-b, 1, Polynomial(2) * a, std::move(*inside)};
  take_squares_out(surd);
  if (Status status = cancel(surd); !status) return status.error();
  scale(surd);
  surd.centre = with_best_angles(surd.centre);
  surd.outside = with_best_angles(surd.outside);
  surd.below = with_best_angles(surd.below);
  std::vector<ClosedRoot> roots(2);
  for (const Notation notation : kNotations) {
    of(roots[0], notation) = surd_text(surd, 1, notation);
    of(roots[1], notation) = surd_text(surd, -1, notation);
  }
  return roots;
}

std::string polynomial_in(const std::map<int, Polynomial>& powers, const Indeterminate& unknown,
                          Notation notation) {
  std::string text;
  for (auto power = powers.rbegin(); power != powers.rend(); ++power) {
    Polynomial coefficient = with_best_angles(power->second);
    const Monomial raised = power->first == 0 ? Monomial() : Monomial{{unknown, power->first}};
    bool negative = sum_text(coefficient, notation).starts_with("-");
    if (negative) coefficient *= Rational(-1);
    std::string part;
    if (coefficient.terms().size() == 1) {
      part = sum_text(coefficient * Polynomial(raised, 1), notation);
    } else {
      part = sum_text(coefficient, notation);
      if (!raised.empty())
        part = "(" + part + ")" + (notation == Notation::text ? "*" : " ") +
               sum_text(Polynomial(raised, 1), notation);
      else if (negative && !text.empty())
        part = "(" + part + ")";
    }
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    text += part;
  }
  return text;
}

}  // namespace

Result<ClosedRoots> closed_roots(const Polynomial& a, const Indeterminate& unknown) {
  const Result<PolynomialFactors> product = factor(a);
  if (!product) return product.error();
  ClosedRoots result;
  for (const auto& [base, multiplicity] : product->factors) {
    std::map<int, Polynomial> powers = base.powers_of(unknown);
    const int degree = powers.rbegin()->first;
    if (degree == 0) continue;
    if (degree == 1) {
      Result<ClosedRoot> root = linear_root(powers[1], powers[0]);
      if (!root) return root.error();
      root->multiplicity = multiplicity;
      result.roots.push_back(std::move(*root));
      continue;
    }
    const Polynomial doubled = with_double_angles(base);
    powers = doubled.powers_of(unknown);
    if (sum_text(powers.rbegin()->second, Notation::text).starts_with("-"))
      powers = (-doubled).powers_of(unknown);
    if (degree == 2) {
      Result<std::vector<ClosedRoot>> roots = quadratic_roots(powers[2], powers[1], powers[0]);
      if (!roots) return roots.error();
      for (ClosedRoot& root : *roots) {
        root.multiplicity = multiplicity;
        result.roots.push_back(std::move(root));
      }
      continue;
    }
    ClosedRoots::Left left{degree, {}};
    left.polynomial.multiplicity = multiplicity;
    for (const Notation notation : kNotations)
      of(left.polynomial, notation) = polynomial_in(powers, unknown, notation);
    result.left.push_back(std::move(left));
  }
  return result;
}

}  // namespace limn::number
