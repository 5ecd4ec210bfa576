#include "limn/number/polynomial.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace limn::number {

bool IndeterminateLess::operator()(const Indeterminate& a, const Indeterminate& b) const {
  if (a == b) return false;
  if (a->kind != b->kind) return a->kind < b->kind;
  return a->name < b->name;
}

bool MonomialLess::operator()(const Monomial& a, const Monomial& b) const {
  constexpr IndeterminateLess kLess;
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (kLess(a[i].first, b[i].first)) return true;
    if (kLess(b[i].first, a[i].first)) return false;
    if (a[i].second != b[i].second) return a[i].second < b[i].second;
  }
  return a.size() < b.size();
}

Monomial product(const Monomial& a, const Monomial& b) {
  constexpr IndeterminateLess kLess;
  Monomial result;
  result.reserve(a.size() + b.size());
  auto left = a.begin();
  auto right = b.begin();
  while (left != a.end() || right != b.end()) {
    if (right == b.end() || (left != a.end() && kLess(left->first, right->first))) {
      result.push_back(*left++);
    } else if (left == a.end() || kLess(right->first, left->first)) {
      result.push_back(*right++);
    } else {
      if (left->second + right->second != 0)
        result.emplace_back(left->first, left->second + right->second);
      ++left;
      ++right;
    }
  }
  return result;
}

Monomial power(Monomial a, int exponent) {
  if (exponent == 0) return {};
  for (auto& [indeterminate, count] : a) count *= exponent;
  return a;
}

void Polynomial::add(const Monomial& monomial, const Rational& coefficient) {
  if (coefficient == 0) return;
  const auto [at, fresh] = terms_.try_emplace(monomial, coefficient);
  if (fresh) return;
  at->second += coefficient;
  if (at->second == 0) terms_.erase(at);
}

bool Polynomial::is_rational() const {
  return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first.empty());
}

Rational Polynomial::rational() const {
  return terms_.empty() ? Rational(0) : terms_.begin()->second;
}

std::vector<Indeterminate> Polynomial::indeterminates() const {
  std::set<Indeterminate, IndeterminateLess> found;
  for (const auto& [monomial, coefficient] : terms_)
    for (const auto& [indeterminate, exponent] : monomial) found.insert(indeterminate);
  return {found.begin(), found.end()};
}

bool Polynomial::depends_on(const std::string& name) const {
  const std::vector<Indeterminate> all = indeterminates();
  return std::any_of(all.begin(), all.end(), [&](const Indeterminate& indeterminate) {
    return indeterminate->name == name ||
           (indeterminate->argument && indeterminate->argument->depends_on(name));
  });
}

std::map<int, Polynomial> Polynomial::powers_of(const Indeterminate& indeterminate) const {
  constexpr IndeterminateLess kLess;
  std::map<int, Polynomial> powers;
  for (const auto& [monomial, coefficient] : terms_) {
    int exponent = 0;
    Monomial rest;
    for (const auto& factor : monomial)
      if (!kLess(factor.first, indeterminate) && !kLess(indeterminate, factor.first))
        exponent = factor.second;
      else
        rest.push_back(factor);
    powers[exponent].add(rest, coefficient);
  }
  return powers;
}

Monomial Polynomial::common_monomial() const {
  std::map<Indeterminate, int, IndeterminateLess> least;
  for (const Indeterminate& indeterminate : indeterminates())
    least.emplace(indeterminate, powers_of(indeterminate).begin()->first);
  Monomial result;
  for (const auto& [indeterminate, exponent] : least)
    if (exponent != 0) result.emplace_back(indeterminate, exponent);
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& b) {
  if (this == &b) return *this *= Rational(2);
  for (const auto& [monomial, coefficient] : b.terms_) add(monomial, coefficient);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& b) {
  if (this == &b) return *this = Polynomial();
  for (const auto& [monomial, coefficient] : b.terms_) add(monomial, -coefficient);
  return *this;
}

Polynomial& Polynomial::operator*=(const Rational& factor) {
  if (factor == 0) terms_.clear();
  for (auto& [monomial, coefficient] : terms_) coefficient *= factor;
  return *this;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [left, x] : a.terms_)
    for (const auto& [right, y] : b.terms_) result.add(product(left, right), x * y);
  return result;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  constexpr MonomialLess kLess;
  return a.terms_.size() == b.terms_.size() &&
         std::equal(
             a.terms_.begin(), a.terms_.end(), b.terms_.begin(), [&](const auto& x, const auto& y) {
               return x.second == y.second && !kLess(x.first, y.first) && !kLess(y.first, x.first);
             });
}

Polynomial power(const Polynomial& a, int exponent) {
  Polynomial result(1);
  for (int i = 0; i < exponent; ++i) result = result * a;
  return result;
}

Polynomial chebyshev(int j, const Polynomial& x) {
  Polynomial before = x;  // T_{-1}
  Polynomial here(1);
  for (int i = 0; i < std::abs(j); ++i) {
    Polynomial next = Polynomial(2) * x * here - before;
    before = std::move(here);
    here = std::move(next);
  }
  return here;
}

Polynomial chebyshev_of_sine(int j, const Polynomial& x) {
  Polynomial before(-1);
  Polynomial here;  // of j = 0
  for (int i = 0; i < std::abs(j); ++i) {
    Polynomial next = Polynomial(2) * x * here - before;
    before = std::move(here);
    here = std::move(next);
  }
  return j < 0 ? -here : here;
}

std::map<int, Polynomial> chebyshev_coefficients(const Polynomial& a, const Indeterminate& x) {
  std::map<int, Polynomial> result;
  Polynomial left = a;
  while (!left.is_zero()) {
    const std::map<int, Polynomial> powers = left.powers_of(x);
    const auto& [degree, leading] = *powers.rbegin();
    Polynomial part = leading;
    for (int i = 1; i < degree; ++i) part *= Rational(1, 2);  // T_j(x) = 2^{j-1} xʲ + …
    left -= part * chebyshev(degree, Polynomial(x));
    result.emplace(degree, std::move(part));
  }
  return result;
}

Polynomial substituted(const Polynomial& a, const Indeterminate& indeterminate,
                       const Polynomial& value) {
  Polynomial result;
  Polynomial raised(1);
  int exponent = 0;
  for (const auto& [next, coefficient] : a.powers_of(indeterminate)) {
    for (; exponent < next; ++exponent) raised = raised * value;
    result += coefficient * raised;
  }
  return result;
}

double approx(const Polynomial& a, const std::function<double(const std::string&)>& lookup) {
  const auto value_of = [&](const IndeterminateData& indeterminate) {
    switch (indeterminate.kind) {
      case IndeterminateKind::cosine:
        return std::cos(std::numbers::pi * approx(*indeterminate.argument, lookup));
      case IndeterminateKind::root: return std::sqrt(approx(*indeterminate.argument, lookup));
      default: return lookup(indeterminate.name);
    }
  };
  double sum = 0;
  for (const auto& [monomial, coefficient] : a.terms()) {
    double product = to_double(coefficient);
    for (const auto& [indeterminate, exponent] : monomial)
      product *= std::pow(value_of(*indeterminate), exponent);
    sum += product;
  }
  return sum;
}

}  // namespace limn::number
