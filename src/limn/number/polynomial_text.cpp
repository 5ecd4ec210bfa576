#include "limn/number/polynomial_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

namespace limn::number {
namespace {

std::string with_exponent(const std::string& base, int exponent, Notation notation) {
  if (exponent == 1) return base;
  if (notation == Notation::text) return fmt::format("{}^{}", base, exponent);
  constexpr std::string_view kCosine = "\\cos";
  if (base.starts_with(kCosine))
    return fmt::format("\\cos^{{{}}}{}", exponent, base.substr(kCosine.size()));
  return fmt::format("{}^{{{}}}", base, exponent);
}

/// Factors side by side, with their signs of multiplication; empty of none.
std::string joined(const std::vector<std::string>& factors, Notation notation) {
  std::string text;
  for (const std::string& factor : factors) {
    if (!text.empty()) text += notation == Notation::text ? "*" : " ";
    text += factor;
  }
  return text;
}

std::string fraction(const std::string& numerator, const std::vector<std::string>& denominator,
                     Notation notation) {
  if (denominator.empty()) return numerator;
  const std::string below = joined(denominator, notation);
  if (notation == Notation::latex) return fmt::format("\\frac{{{}}}{{{}}}", numerator, below);
  return numerator + (denominator.size() > 1 ? "/(" + below + ")" : "/" + below);
}

/// The parts of a product: what stands above the fraction bar and what below.
struct Parts {
  std::vector<std::string> above, below;
};

/// coefficient > 0 times what the parts hold; a lone coefficient where they hold nothing.
std::string with_coefficient(const Rational& coefficient, Parts parts, Notation notation) {
  const std::string above = numerator(coefficient).str();
  const std::string below = denominator(coefficient).str();
  const bool apart = parts.below.empty() && !parts.above.empty() && below != "1";
  if (apart && (above != "1" || notation == Notation::latex))  // 2/3*x
    return joined({fraction(above, {below}, notation), joined(parts.above, notation)}, notation);
  if (below != "1") parts.below.insert(parts.below.begin(), below);
  if (above != "1" || parts.above.empty()) parts.above.insert(parts.above.begin(), above);
  return fraction(joined(parts.above, notation), parts.below, notation);
}

void append(Parts& parts, const Indeterminate& indeterminate, int exponent, Notation notation) {
  const std::string& name = notation == Notation::text ? indeterminate->name : indeterminate->latex;
  (exponent > 0 ? parts.above : parts.below)
      .push_back(with_exponent(name, std::abs(exponent), notation));
}

std::string term_text(const Rational& size, const Monomial& monomial, Notation notation) {
  Parts parts;
  for (const auto& [indeterminate, exponent] : monomial)
    append(parts, indeterminate, exponent, notation);
  return with_coefficient(size, std::move(parts), notation);
}

int total_degree(const Monomial& monomial) {
  int sum = 0;
  for (const auto& [indeterminate, exponent] : monomial) sum += exponent;
  return sum;
}

std::vector<std::pair<Monomial, Rational>> ordered(const Polynomial& a, TermOrder order) {
  std::vector<std::pair<Monomial, Rational>> terms(a.terms().begin(), a.terms().end());
  std::sort(terms.begin(), terms.end(), [&](const auto& x, const auto& y) {
    const int left = total_degree(x.first);
    const int right = total_degree(y.first);
    if (left != right) return order == TermOrder::rising ? left < right : left > right;
    // of one degree: in the order of the indeterminates, whole numbers first
    constexpr IndeterminateLess kLess;
    for (std::size_t i = 0; i < x.first.size() && i < y.first.size(); ++i) {
      const auto& [a_indeterminate, a_exponent] = x.first[i];
      const auto& [b_indeterminate, b_exponent] = y.first[i];
      if (kLess(a_indeterminate, b_indeterminate) || kLess(b_indeterminate, a_indeterminate))
        return kLess(a_indeterminate, b_indeterminate);
      if (a_exponent != b_exponent) return a_exponent > b_exponent;
    }
    return x.first.size() < y.first.size();
  });
  return terms;
}

std::string in_parentheses(const std::string& text, Notation notation) {
  return notation == Notation::text ? "(" + text + ")" : "\\left(" + text + "\\right)";
}

/// a as a sum of cosines of multiples of this indeterminate's angle.
Polynomial with_multiple_angles(const Polynomial& a, const Indeterminate& cosine) {
  if (a.is_zero() || a.powers_of(cosine).begin()->first < 0) return a;
  const auto [q, monomial] = angle_of(cosine);
  Polynomial result;
  for (const auto& [j, coefficient] : chebyshev_coefficients(a, cosine))
    result +=
        j == 0 ? coefficient : coefficient * Polynomial(cosine_indeterminate(q * j, monomial));
  return result;
}

/// The e-th root of q, where it is rational.
std::optional<Rational> rational_root(const Rational& q, int e) {
  if (q < 0 && e % 2 == 0) return std::nullopt;
  const auto root = [&](const Integer& of) -> std::optional<Integer> {
    const Integer near(std::llround(std::pow(of.convert_to<double>(), 1.0 / e)));
    Integer power = 1;
    for (int i = 0; i < e; ++i) power *= near;
    if (power != of) return std::nullopt;
    return near;
  };
  if (abs(q) > Rational(1'000'000'000'000LL) || denominator(q) > 1'000'000'000'000LL)
    return std::nullopt;
  const std::optional<Integer> above = root(abs(numerator(q)));
  const std::optional<Integer> below = root(denominator(q));
  if (!above || !below) return std::nullopt;
  return Rational(q < 0 ? Integer(-*above) : *above, *below);
}

constexpr std::size_t kFewTerms = 2;  // each of which then has a fraction of its own

/// q·f, a fraction before each term: "3/8 + cos(2*pi/n)/4".
std::string distributed(const Rational& q, const Polynomial& f, Notation notation) {
  return sum_text(f * Polynomial(q), notation, TermOrder::rising);
}

/// q·f^e for a sum f, over one denominator.
std::string over_one_denominator(const Rational& q, const Polynomial& f, int e, Notation notation) {
  const bool turned = q < 0 && e % 2 == 1;
  const std::string sum = sum_text(turned ? -f : f, notation, TermOrder::falling);
  const Rational size = abs(q);
  const bool bare =
      e == 1 && (size == 1 || (notation == Notation::latex && size < 1 && numerator(size) == 1));
  const std::string base = bare ? sum : with_exponent(in_parentheses(sum, notation), e, notation);
  const std::string sign = q < 0 && !turned ? "-" : "";
  if (bare && size != 1) return sign + fraction(base, {denominator(size).str()}, notation);
  return sign + with_coefficient(size, {{base}, {}}, notation);
}

/// q·f^e for a sum f. Both notations are written alike.
std::string power_text(const Rational& q, const Polynomial& f, int e, Notation notation) {
  const std::optional<Rational> root = rational_root(q, e);
  if (!root || denominator(q) == 1) return over_one_denominator(q, f, e, notation);
  const auto apart = [&](Notation in) {
    const std::string sum = distributed(*root, f, in);
    return e == 1 ? sum : with_exponent(in_parentheses(sum, in), e, in);
  };
  const bool shorter =
      f.terms().size() <= kFewTerms ||
      apart(Notation::text).size() < over_one_denominator(q, f, e, Notation::text).size();
  return shorter ? apart(notation) : over_one_denominator(q, f, e, notation);
}

}  // namespace

std::string latex_name(const std::string& name) {
  static constexpr std::array kGreek{
      "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu",
      "nu",    "xi",   "pi",    "rho",   "sigma",   "tau",  "phi", "chi",   "psi",   "omega"};
  if (name.size() == 1) return name;
  if (std::find(kGreek.begin(), kGreek.end(), name) != kGreek.end()) return "\\" + name;
  std::string text;
  for (const char c : name) text += c == '_' ? std::string("\\_") : std::string(1, c);
  return "\\mathit{" + text + "}";
}

Indeterminate cosine_indeterminate(const Rational& q, const Monomial& monomial) {
  const auto angle = [&](Notation notation) {
    Parts parts;
    if (numerator(q) != 1) parts.above.push_back(numerator(q).str());
    parts.above.emplace_back(notation == Notation::text ? "pi" : "\\pi");
    if (denominator(q) != 1) parts.below.push_back(denominator(q).str());
    for (const auto& [indeterminate, exponent] : monomial)
      append(parts, indeterminate, exponent, notation);
    return fraction(joined(parts.above, notation), parts.below, notation);
  };
  IndeterminateData data;
  data.kind = IndeterminateKind::cosine;
  data.name = "cos(" + angle(Notation::text) + ")";
  data.latex = "\\cos" + angle(Notation::latex);
  data.argument = std::make_shared<const Polynomial>(monomial, q);
  return std::make_shared<const IndeterminateData>(std::move(data));
}

CosineAngle angle_of(const Indeterminate& cosine) {
  const auto& [monomial, q] = *cosine->argument->terms().begin();
  return {q, monomial};
}

std::string sum_text(const Polynomial& a, Notation notation, TermOrder order) {
  const bool rising = order == TermOrder::rising;
  const TermOrder other = rising ? TermOrder::falling : TermOrder::rising;
  if (!a.is_zero() && ordered(a, order).front().second < 0 && ordered(a, other).front().second > 0)
    order = other;
  std::string text;
  for (const auto& [monomial, coefficient] : ordered(a, order)) {
    const bool negative = coefficient < 0;
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    text += term_text(abs(coefficient), monomial, notation);
  }
  return text.empty() ? "0" : text;
}

Polynomial with_double_angles(const Polynomial& a) {
  Polynomial result = a;
  std::vector<Indeterminate> open = result.indeterminates();
  while (!open.empty()) {
    const Indeterminate indeterminate = open.back();
    open.pop_back();
    if (indeterminate->kind != IndeterminateKind::cosine) continue;
    const std::map<int, Polynomial> powers = result.powers_of(indeterminate);
    const bool even = std::all_of(powers.begin(), powers.end(), [](const auto& power) {
      return power.first >= 0 && power.first % 2 == 0;
    });
    if (!even || powers.size() < 2) continue;
    const auto [q, monomial] = angle_of(indeterminate);
    const Indeterminate twice = cosine_indeterminate(2 * q, monomial);
    const Polynomial square = (Polynomial(1) + Polynomial(twice)) * Polynomial(Rational(1, 2));
    result = Polynomial();
    for (const auto& [exponent, coefficient] : powers)
      result += coefficient * power(square, exponent / 2);
    open.push_back(twice);
  }
  return result;
}

Polynomial with_multiple_angles(const Polynomial& a) {
  Polynomial summed = a;
  for (const Indeterminate& indeterminate : a.indeterminates())
    if (indeterminate->kind == IndeterminateKind::cosine)
      summed = with_multiple_angles(summed, indeterminate);
  return summed;
}

Polynomial with_best_angles(const Polynomial& a) {
  const Polynomial doubled = with_double_angles(a);
  const Polynomial summed = with_multiple_angles(a);
  const auto length = [](const Polynomial& of) { return sum_text(of, Notation::text).size(); };
  const Polynomial& shorter = length(doubled) <= length(a) ? doubled : a;
  return length(summed) < length(shorter) ? summed : shorter;
}

std::string product_text(const PolynomialFactors& product, Notation notation) {
  Rational q = product.content;
  if (q == 0) return "0";
  std::vector<std::pair<Polynomial, int>> sums;
  Parts parts;
  for (const auto& [base, exponent] : product.factors) {
    if (base.terms().size() == 1) {
      append(parts, base.terms().begin()->first.front().first, exponent, notation);
      continue;
    }
    Polynomial best = with_best_angles(base);
    Rational scale = content(best);
    if (ordered(best, TermOrder::falling).front().second / scale < 0) scale = -scale;
    best *= 1 / scale;
    for (int e = 0; e < std::abs(exponent); ++e) q *= exponent > 0 ? scale : Rational(1 / scale);
    if (best.terms().size() == 1)  // cos(pi/n)^2 may have become a sum and turned back
      append(parts, best.terms().begin()->first.front().first, exponent, notation);
    else
      sums.emplace_back(std::move(best), exponent);
  }
  if (sums.size() == 1 && sums.front().second > 0 && parts.above.empty() && parts.below.empty())
    return power_text(q, sums.front().first, sums.front().second, notation);
  std::sort(sums.begin(), sums.end(), [&](const auto& a, const auto& b) {
    const std::string left = sum_text(a.first, Notation::text);
    const std::string right = sum_text(b.first, Notation::text);
    return left.size() != right.size() ? left.size() < right.size() : left > right;
  });
  for (auto& [base, exponent] : sums) {
    TermOrder order = TermOrder::falling;
    if (q < 0 && exponent % 2 != 0) {  // (1 - 4*w) rather than -(4*w - 1)
      base *= Rational(-1);
      q = -q;
      order = TermOrder::rising;
    }
    const std::string sum = in_parentheses(sum_text(base, notation, order), notation);
    (exponent > 0 ? parts.above : parts.below)
        .push_back(with_exponent(sum, std::abs(exponent), notation));
  }
  return (q < 0 ? "-" : "") + with_coefficient(abs(q), std::move(parts), notation);
}

}  // namespace limn::number
