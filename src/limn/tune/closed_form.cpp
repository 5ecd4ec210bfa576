#include "limn/tune/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include <fmt/core.h>

#include "limn/number/near_rational.h"

namespace limn::tune {
namespace {

constexpr std::size_t kLeastValences = 5;
constexpr double kMatches = 1e-12;
constexpr double kFitted = 1e-10;  // of coefficients, which are worse known than the values
constexpr const char* kCosine = "cos(2*pi/n)";

using Coefficients = std::array<Rational, 3>;  // of 1, cos, cos²

double cosine(int n) { return std::cos(2 * std::numbers::pi / n); }

double value_at(const Coefficients& p, int n) {
  const double c = cosine(n);
  return to_double(p[0]) + c * (to_double(p[1]) + c * to_double(p[2]));
}

/// " - 3/4*cos(2*pi/n)"
void append(std::string& text, const Rational& coefficient, const std::string& of) {
  if (coefficient == 0) return;
  const bool negative = coefficient < 0;
  const Rational size = negative ? -coefficient : coefficient;
  text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
  if (of.empty())
    text += to_string(size);
  else if (size == 1)
    text += of;
  else
    text += to_string(size) + "*" + of;
}

std::string text_of(const Coefficients& p, bool over_n) {
  std::string text;
  append(text, p[0], "");
  append(text, p[1], kCosine);
  append(text, p[2], std::string(kCosine) + "^2");
  if (text.empty()) text = "0";
  return over_n ? fmt::format("({})/n", text) : text;
}

/// The polynomial through three places (Newton's divided differences), in fractions.
std::optional<Coefficients> fitted(const std::array<int, 3>& n, const std::array<double, 3>& t) {
  const std::array<double, 3> c{cosine(n[0]), cosine(n[1]), cosine(n[2])};
  const double first = (t[1] - t[0]) / (c[1] - c[0]);
  const double second = ((t[2] - t[1]) / (c[2] - c[1]) - first) / (c[2] - c[0]);
  const std::array<double, 3> p{t[0] - c[0] * first + c[0] * c[1] * second,
                                first - (c[0] + c[1]) * second, second};
  Coefficients result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Rational> rational = number::near_rational(p[i], kFitted);
    if (!rational) return std::nullopt;
    result[i] = *rational;
  }
  return result;
}

}  // namespace

std::optional<std::string> closed_form(const std::vector<int>& valences,
                                       const std::vector<double>& values) {
  const std::size_t count = valences.size();
  if (std::set<int>(valences.begin(), valences.end()).size() < kLeastValences) return std::nullopt;
  const std::array<std::size_t, 3> at{0, count / 2, count - 1};
  for (const bool over_n : {false, true}) {
    std::array<int, 3> n{};
    std::array<double, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) {
      n[i] = valences[at[i]];
      t[i] = values[at[i]] * (over_n ? n[i] : 1);
    }
    const std::optional<Coefficients> p = fitted(n, t);
    if (!p) continue;
    bool all = true;
    for (std::size_t i = 0; i < count; ++i)
      all = all && std::abs(value_at(*p, valences[i]) / (over_n ? valences[i] : 1) - values[i]) <=
                       kMatches * (1 + std::abs(values[i]));
    if (all) return text_of(*p, over_n);
  }
  return std::nullopt;
}

std::optional<std::string> closed_form_at(int valence, double value) {
  constexpr int kSmallest = 64;  // denominators of the cosine's coefficient: powers of 2 up to it
  constexpr int kMost = 2 * kSmallest;
  constexpr long long kLargest = 128;  // of the other coefficient's denominator
  for (const bool over_n : {false, true})
    for (int p = 1; p <= kMost; ++p)
      for (const int sign : {1, -1}) {
        const Rational b(Integer(sign * p), Integer(kSmallest));
        const double rest = value * (over_n ? valence : 1) - to_double(b) * cosine(valence);
        if (const auto a = number::near_rational(rest, 1e-13, kLargest))
          return text_of({*a, b, Rational(0)}, over_n);
      }
  return std::nullopt;
}

}  // namespace limn::tune
