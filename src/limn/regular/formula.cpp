#include "limn/regular/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include <fmt/core.h>

#include "limn/regular/limit_values.h"
#include "limn/regular/regular_mask.h"
#include "limn/scheme/mask_rules.h"

namespace limn::regular {
namespace {

/// a^power, a by twice the offset.
struct Power {
  Laurent base;
  int exponent;
};

/// Angles as multiples of π: numerator/denominator, 0 ≤ numerator < 2 denominator.
struct Shift {
  int numerator;
  int denominator;
};

bool is_odd(const Laurent& a) {
  return a.begin()->first[0] % 2 != 0 || a.begin()->first[1] % 2 != 0;
}

/// a(z1, z2) as b(z1)·c(z2), where it is such a product.
std::optional<std::array<Laurent, 2>> tensor_factors(const Laurent& a) {
  const auto [corner, scale] = *a.begin();
  std::array<Laurent, 2> parts;
  for (const auto& [k, value] : a) {
    if (k[1] == corner[1]) parts[0][{k[0], 0}] = value / scale;
    if (k[0] == corner[0]) parts[1][{0, k[1]}] = value;
  }
  if (product(parts[0], parts[1]) != a || !(reflected(parts[0]) == parts[0])) return std::nullopt;
  return parts;
}

/// Half angles come in pairs where they can: (cos(t/2))² is (1 + cos t)/2.
void append(std::vector<Power>& powers, const Laurent& base, int exponent) {
  if (exponent == 0) return;
  if (!is_odd(base)) {
    powers.push_back({base, exponent});
    return;
  }
  if (exponent >= 2) powers.push_back({product(base, base), exponent / 2});
  if (exponent % 2 == 1) powers.push_back({base, 1});
}

void append_whole(std::vector<Power>& powers, Lattice lattice, const Laurent& base) {
  const auto parts =
      lattice == Lattice::quad && base.size() > 1 ? tensor_factors(base) : std::nullopt;
  if (!parts) {
    powers.push_back({base, 1});
    return;
  }
  for (const Laurent& part : *parts) powers.push_back({part, 1});
}

/// The symbol, factored: what is not smoothing first.
std::vector<Power> symbol_powers(const Mask& mask, const Factorization& factors) {
  std::vector<Power> powers;
  append_whole(powers, mask.lattice, factors.kernel);
  const Laurent stage = smoothing_stage(mask.lattice, mask.dilation);
  if (is_odd(stage)) {
    for (const LatticeVector step : edge_directions(mask.lattice))
      append(powers, scheme::smoothing_direction(step, mask.dilation), factors.stages);
  } else {
    append(powers, stage, factors.stages);
  }
  for (const auto& [step, count] : factors.directions)
    append(powers, scheme::smoothing_direction(step, mask.dilation), count);
  return powers;
}

std::string combination(int a, int b, int c) {
  std::string text;
  const auto add = [&](int factor, const char* name) {
    if (factor == 0) return;
    if (!text.empty()) text += factor < 0 ? " - " : " + ";
    if (text.empty() && factor < 0) text += "-";
    text += (std::abs(factor) == 1 ? "" : fmt::format("{}*", std::abs(factor))) + name;
  };
  add(a, "t1");
  add(b, "t2");
  add(c, "t3");
  return text;
}

std::string latex_angle(std::string text) {
  for (const auto& [from, to] : {std::pair{"t1", "\\theta_1"},
                                 {"t2", "\\theta_2"},
                                 {"t3", "\\theta_3"},
                                 {"pi", "\\pi"},
                                 {"*", " "}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;) {
      text.replace(at, std::string(from).size(), to);
      at += std::string(to).size();
    }
  return text;
}

struct Writer {
  Lattice lattice;
  number::Notation notation;

  /// "c1", "c12", … of twice an offset; empty where the cosine has no short name.
  [[nodiscard]] std::string short_name(LatticeVector k) const {
    struct Named {
      LatticeVector k;
      const char* name;
    };
    static constexpr Named kTriangle[] = {{{2, 0}, "1"},   {{0, 2}, "2"},  {{2, 2}, "3"},
                                          {{2, -2}, "12"}, {{4, 2}, "13"}, {{2, 4}, "23"}};
    for (const Named& named : kTriangle) {
      if (lattice == Lattice::quad && named.name[0] == '3') break;
      if (named.k != k && named.k != LatticeVector{-k[0], -k[1]}) continue;
      return notation == number::Notation::text ? fmt::format("c{}", named.name)
                                                : fmt::format("c_{{{}}}", named.name);
    }
    return {};
  }

  /// cos(k·θ/2 + π shift), k twice an offset, with the sign that stands before it.
  [[nodiscard]] std::pair<int, std::string> cosine(LatticeVector k, Shift shift) const {
    const auto [numerator, denominator] = shift;
    const bool quarter = 2 * numerator % denominator == 0;
    const int quarters = quarter ? 2 * numerator / denominator : 0;
    const int sign = quarters == 1 || quarters == 2 ? -1 : 1;
    const bool sine = quarters % 2 == 1;
    if (const std::string name = short_name(k); !name.empty() && quarter && !sine)
      return {sign, name};
    std::string angle = angle_text(k);
    if (!quarter)
      angle += fmt::format(" + {}pi/{}", numerator == 1 ? "" : fmt::format("{}*", numerator),
                           denominator);
    if (notation == number::Notation::text)
      return {sign, fmt::format("{}({})", sine ? "sin" : "cos", angle)};
    return {sign, fmt::format("\\{}({})", sine ? "sin" : "cos", latex_angle(angle))};
  }

  /// k·θ/2
  [[nodiscard]] std::string angle_text(LatticeVector k) const {
    const bool half = k[0] % 2 != 0 || k[1] % 2 != 0;
    const int unit = half ? 1 : 2;
    std::string angle = lattice == Lattice::triangle && k[0] == k[1]
                            ? combination(0, 0, -k[0] / unit)
                            : combination(k[0] / unit, k[1] / unit, 0);
    if (!half) return angle;
    return (angle.find(' ') != std::string::npos ? "(" + angle + ")" : angle) + "/2";
  }

  [[nodiscard]] std::string times() const { return notation == number::Notation::text ? "*" : ""; }

  /// The primitive integer polynomial of which `base` is `content` times.
  [[nodiscard]] std::string polynomial(const Laurent& base, const Rational& content,
                                       const LatticeMatrix& dilation, LatticeVector kappa) const;
};

/// kappa's phase on the term k/2, in π: k·(M⁻ᵀ κ).
Shift shift_of(LatticeVector k, const LatticeMatrix& dilation, LatticeVector kappa) {
  const LatticeVector phase = dilation.refined_phase_times_determinant(kappa);
  int denominator = dilation.determinant();
  int numerator = k[0] * phase[0] + k[1] * phase[1];
  if (denominator < 0) {
    denominator = -denominator;
    numerator = -numerator;
  }
  numerator = ((numerator % (2 * denominator)) + 2 * denominator) % (2 * denominator);
  const int common = std::gcd(numerator, denominator);
  return {numerator / common, denominator / common};
}

/// Coefficients of cosines: one of each pair ±k, with both weights, nearest to 0 first.
std::vector<std::pair<LatticeVector, Rational>> cosine_terms(Lattice lattice, const Laurent& base) {
  std::vector<std::pair<LatticeVector, Rational>> terms;
  for (const auto& [k, value] : base)
    if (k >= LatticeVector{0, 0}) {
      // t3 is -t1-t2: along it the other one of the pair reads better
      const bool third = lattice == Lattice::triangle && k[0] == k[1];
      terms.emplace_back(third ? LatticeVector{-k[0], -k[1]} : k,
                         k == LatticeVector{0, 0} ? value : 2 * value);
    }
  std::sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) {
    const auto key = [&](LatticeVector k) {
      // c1, c2, c3 and c12, c13, c23 in this order
      return std::array<int, 4>{squared_length(lattice, k), k[0] * k[1] < 0 ? -1 : k[0] * k[1],
                                -std::abs(k[0]), k[1]};
    };
    return key(a.first) < key(b.first);
  });
  return terms;
}

/// The greatest rational that divides all coefficients of cosines with integer quotients; signed
/// like the first.
Rational content(Lattice lattice, const Laurent& base) {
  Integer numerators = 0;
  Integer denominators = 1;
  const auto terms = cosine_terms(lattice, base);
  for (const auto& [k, value] : terms) {
    numerators = gcd(numerators, numerator(value));
    denominators = lcm(denominators, denominator(value));
  }
  const Rational size(abs(numerators), denominators);
  return terms.front().second < 0 ? Rational(-size) : size;
}

std::string Writer::polynomial(const Laurent& base, const Rational& content,
                               const LatticeMatrix& dilation, LatticeVector kappa) const {
  const auto terms = cosine_terms(lattice, base);
  std::string text;
  for (std::size_t i = 0, end = 0; i < terms.size(); i = end) {
    // neighbours with one coefficient share it: 2*(c1 + c2 + c3)
    std::vector<std::pair<int, std::string>> members;
    for (end = i; end < terms.size() && terms[end].second == terms[i].second; ++end) {
      const LatticeVector k = terms[end].first;
      members.push_back(k == LatticeVector{0, 0} ? std::pair{1, std::string("1")}
                                                 : cosine(k, shift_of(k, dilation, kappa)));
    }
    const int lead = members.front().first;
    const Rational factor = terms[i].second / content * lead;
    const Rational size = abs(factor);
    // 2*(c1 - c2), but - c1 + c2
    const int before = size == 1 && factor < 0 ? -lead : lead;
    std::string group;
    for (const auto& [sign, name] : members)
      group += (group.empty() ? "" : sign == before ? " + " : " - ") + name;
    if (members.size() > 1 && size != 1) group = "(" + group + ")";
    if (size != 1) group = group == "1" ? to_string(size) : to_string(size) + times() + group;
    text += text.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
    text += group;
  }
  return text;
}

std::string formula(const Mask& mask, const std::vector<Power>& powers, LatticeVector kappa,
                    number::Notation notation) {
  const Writer writer{mask.lattice, notation};
  Rational scale = 1;
  std::vector<std::string> factors;
  for (const auto& [base, exponent] : powers) {
    const Rational part = content(mask.lattice, base);
    for (int i = 0; i < exponent; ++i) scale *= part;
    std::string text = writer.polynomial(base, part, mask.dilation, kappa);
    if (text == "1") continue;
    if (const bool one_term = text.find(' ') == std::string::npos && text[0] != '-';
        !one_term || exponent > 1)
      text = "(" + text + ")";
    if (exponent > 1)
      text += notation == number::Notation::text ? fmt::format("^{}", exponent)
                                                 : fmt::format("^{{{}}}", exponent);
    factors.push_back(text);
  }
  std::string text;
  for (const std::string& factor : factors) text += (text.empty() ? "" : writer.times()) + factor;
  const Integer above = numerator(scale);
  const Integer below = denominator(scale);
  if (text.empty() || above != 1)
    text = above == -1 && !text.empty() ? "-" + text
                                        : above.str() + (text.empty() ? "" : writer.times()) + text;
  if (below == 1) return text;
  if (notation == number::Notation::latex)
    return fmt::format("\\frac{{{}}}{{{}}}", text, below.str());
  if (factors.size() == 1 && factors.front().find(' ') != std::string::npos &&
      factors.front().front() != '(')
    text = "(" + text + ")";
  return text + "/" + below.str();
}

std::vector<std::string> formulas(const Mask& mask, const std::vector<Power>& powers,
                                  number::Notation notation) {
  std::vector<std::string> result;
  for (const LatticeVector kappa : dual_cosets(mask.dilation))
    result.push_back(formula(mask, powers, kappa, notation));
  return result;
}

}  // namespace

std::vector<std::string> step_formulas(const Mask& mask, number::Notation notation) {
  return formulas(mask, symbol_powers(mask, factor(mask)), notation);
}

Result<std::vector<std::string>> limit_formulas(const Mask& mask, number::Notation notation) {
  const Result<Laurent> limit = limit_stencil(mask);
  if (!limit) return limit.error();
  std::vector<Power> powers;
  append_whole(powers, mask.lattice, *limit);
  for (Power& power : symbol_powers(mask, factor(mask))) powers.push_back(std::move(power));
  return formulas(mask, powers, notation);
}

std::vector<std::string> formula_names(const Mask& mask, number::Notation notation) {
  const bool triangles = mask.lattice == Lattice::triangle;
  if (notation == number::Notation::latex)
    return triangles ? std::vector<std::string>{"c_i = \\cos\\theta_i",
                                                "c_{ij} = \\cos(\\theta_i - \\theta_j)",
                                                "\\theta_1 + \\theta_2 + \\theta_3 = 0"}
                     : std::vector<std::string>{"c_i = \\cos\\theta_i"};
  return triangles
             ? std::vector<std::string>{"ci = cos(ti), cij = cos(ti - tj), t1 + t2 + t3 = 0",
                                        "ti: the wave's phase per refined edge ui"}
             : std::vector<std::string>{"ci = cos(ti)", "ti: the wave's phase per refined edge ui"};
}

std::string component_name(int component, number::Notation notation) {
  static constexpr const char* kNames[] = {"alpha", "beta", "gamma", "delta"};
  if (component < 4)
    return (notation == number::Notation::latex ? "\\" : "") + std::string(kNames[component]);
  return notation == number::Notation::latex ? fmt::format("\\beta_{{{}}}", component)
                                             : fmt::format("beta{}", component);
}

}  // namespace limn::regular
