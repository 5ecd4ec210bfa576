#include "limn/number/cyclotomic.h"

#include <cassert>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

namespace limn::number {
namespace {

using Coefficients = std::vector<Rational>;  // lowest degree first, no zero at the end

void trim(Coefficients& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

std::vector<Integer> divide_exactly(std::vector<Integer> a, const std::vector<Integer>& monic) {
  std::vector<Integer> quotient(a.size() - monic.size() + 1);
  for (std::size_t i = quotient.size(); i-- > 0;) {
    const Integer q = a[i + monic.size() - 1];
    quotient[i] = q;
    for (std::size_t j = 0; j < monic.size(); ++j) a[i + j] -= q * monic[j];
  }
  return quotient;
}

struct Division {
  Coefficients quotient, remainder;
};

Division divide(Coefficients a, const Coefficients& b) {
  Coefficients quotient(a.size() >= b.size() ? a.size() - b.size() + 1 : 0);
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const Rational q = a.back() / b.back();
    quotient[shift] = q;
    for (std::size_t j = 0; j < b.size(); ++j) a[shift + j] -= q * b[j];
    trim(a);
  }
  return {std::move(quotient), std::move(a)};
}

Coefficients subtract_product(Coefficients a, const Coefficients& b, const Coefficients& c) {
  if (!b.empty() && !c.empty()) a.resize(std::max(a.size(), b.size() + c.size() - 1));
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j) a[i + j] -= b[i] * c[j];
  trim(a);
  return a;
}

/// Rationals as integers over one denominator: sums of products of these need no gcd.
struct Fractions {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

Fractions over_common_denominator(const Coefficients& p) {
  Fractions result;
  for (const Rational& q : p) result.denominator = lcm(result.denominator, denominator(q));
  result.numerators.reserve(p.size());
  for (const Rational& q : p)
    result.numerators.push_back(numerator(q) * (result.denominator / denominator(q)));
  return result;
}

}  // namespace

const std::vector<Integer>& cyclotomic_polynomial(int n) {
  static std::mutex mutex;
  static std::map<int, std::vector<Integer>> known;
  {
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(n); found != known.end()) return found->second;
  }
  // x^n - 1 is the product of Φ_d over the divisors d of n
  std::vector<Integer> p(static_cast<std::size_t>(n) + 1);
  p.front() = -1;
  p.back() = 1;
  for (int d = 1; d < n; ++d)
    if (n % d == 0) p = divide_exactly(std::move(p), cyclotomic_polynomial(d));
  const std::lock_guard lock(mutex);
  return known.try_emplace(n, std::move(p)).first->second;
}

Cyclotomic Cyclotomic::cos_turn(long long p, long long q) {
  assert(q >= 1);
  const long long common = std::gcd(p, q);
  q /= common;
  p = ((p / common) % q + q) % q;
  Cyclotomic c;
  c.order_ = static_cast<int>(q);
  c.coefficients_.assign(static_cast<std::size_t>(q), 0);
  c.coefficients_[static_cast<std::size_t>(p)] += Rational(1, 2);
  c.coefficients_[static_cast<std::size_t>((q - p) % q)] += Rational(1, 2);
  c.reduce();
  return c;
}

void Cyclotomic::reduce() {
  const Fractions fractions = over_common_denominator(coefficients_);
  assign(fractions.numerators, fractions.denominator);
}

void Cyclotomic::assign(std::vector<Integer> numerators, const Integer& denominator) {
  const std::vector<Integer>& phi = cyclotomic_polynomial(order_);
  const std::size_t degree = phi.size() - 1;
  for (std::size_t i = numerators.size(); i-- > degree;) {
    const Integer q = numerators[i];
    if (q == 0) continue;
    for (std::size_t j = 0; j <= degree; ++j)
      if (phi[j] != 0) numerators[i - degree + j] -= q * phi[j];
  }
  numerators.resize(degree);
  coefficients_.assign(degree, 0);
  for (std::size_t i = 0; i < degree; ++i)
    if (numerators[i] != 0) coefficients_[i] = Rational(numerators[i], denominator);
  bool rational = true;
  for (std::size_t i = 1; i < degree; ++i) rational = rational && coefficients_[i] == 0;
  if (rational) {
    order_ = 1;
    coefficients_.resize(1);
  }
}

Cyclotomic Cyclotomic::lifted(int order) const {
  if (order == order_) return *this;
  Cyclotomic result;
  result.order_ = order;
  const std::size_t stride = static_cast<std::size_t>(order / order_);
  result.coefficients_.assign(static_cast<std::size_t>(order), 0);
  for (std::size_t i = 0; i < coefficients_.size(); ++i)
    result.coefficients_[i * stride] = coefficients_[i];
  const int kept = result.order_;
  result.reduce();
  if (result.order_ != kept) {  // a rational number: write it in the field asked for
    result.order_ = kept;
    result.coefficients_.resize(cyclotomic_polynomial(kept).size() - 1);
  }
  return result;
}

double Cyclotomic::approx() const {
  double sum = 0;
  for (std::size_t j = 0; j < coefficients_.size(); ++j)
    if (coefficients_[j] != 0)
      sum += to_double(coefficients_[j]) * std::cos(2 * M_PI * static_cast<double>(j) / order_);
  return sum;
}

Cyclotomic& Cyclotomic::operator+=(const Cyclotomic& b) {
  if (b.is_rational()) {
    coefficients_[0] += b.coefficients_[0];
    return *this;
  }
  const int order = std::lcm(order_, b.order_);
  *this = lifted(order);
  const Cyclotomic other = b.lifted(order);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i] += other.coefficients_[i];
  reduce();
  return *this;
}

Cyclotomic& Cyclotomic::operator-=(const Cyclotomic& b) {
  return *this += b * Cyclotomic(Rational(-1));
}

Cyclotomic& Cyclotomic::operator*=(const Cyclotomic& b) {
  if (b.is_rational()) {
    for (Rational& c : coefficients_) c *= b.coefficients_[0];
    if (b.coefficients_[0] == 0) reduce();
    return *this;
  }
  const int order = std::lcm(order_, b.order_);
  const Cyclotomic left = lifted(order);
  const Cyclotomic right = b.lifted(order);
  const Fractions x = over_common_denominator(left.coefficients_);
  const Fractions y = over_common_denominator(right.coefficients_);
  std::vector<Integer> product(x.numerators.size() + y.numerators.size() - 1);
  for (std::size_t i = 0; i < x.numerators.size(); ++i) {
    if (x.numerators[i] == 0) continue;
    for (std::size_t j = 0; j < y.numerators.size(); ++j)
      if (y.numerators[j] != 0) product[i + j] += x.numerators[i] * y.numerators[j];
  }
  order_ = order;
  assign(std::move(product), x.denominator * y.denominator);
  return *this;
}

Cyclotomic Cyclotomic::inverse() const {
  assert(!is_zero());
  if (is_rational()) return {Rational(1) / rational()};
  // extended Euclid on (Φ_N, a): s·a ≡ gcd, a constant, because Φ_N is irreducible
  Coefficients r0;
  for (const Integer& c : cyclotomic_polynomial(order_)) r0.emplace_back(c);
  Coefficients r1 = coefficients_;
  trim(r1);
  Coefficients s0;
  Coefficients s1{Rational(1)};
  while (r1.size() > 1) {
    Division step = divide(r0, r1);
    Coefficients s2 = subtract_product(s0, step.quotient, s1);
    r0 = std::move(r1);
    r1 = std::move(step.remainder);
    s0 = std::move(s1);
    s1 = std::move(s2);
  }
  Cyclotomic result;
  result.order_ = order_;
  const Rational scale = Rational(1) / r1[0];
  for (Rational& c : s1) c *= scale;
  result.coefficients_ = std::move(s1);
  result.coefficients_.resize(
      std::max(result.coefficients_.size(), cyclotomic_polynomial(order_).size() - 1));
  result.reduce();
  return result;
}

}  // namespace limn::number
