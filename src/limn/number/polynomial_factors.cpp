#include "limn/number/polynomial_factors.h"

#if LIMN_HAS_FLINT
#include <flint/fmpq_mpoly.h>
#include <flint/fmpq_mpoly_factor.h>
#endif

#include <algorithm>
#include <set>

namespace limn::number {

Rational content(const Polynomial& a) {
  Integer numerators = 0;
  Integer denominators = 1;
  for (const auto& [monomial, value] : a.terms()) {
    numerators = gcd(numerators, numerator(value));
    denominators = lcm(denominators, denominator(value));
  }
  const Rational size(abs(numerators), denominators);
  return a.terms().rbegin()->second < 0 ? Rational(-size) : size;
}

#if LIMN_HAS_FLINT
namespace {

/// FLINT cannot be stopped, and its time grows without bound with the integers that it works on:
/// at this size it takes about a second.
Status check_size(const Polynomial& a) {
  constexpr std::size_t kMostBits = 10'000;  // of one coefficient; shipped schemes have some 20
  constexpr std::size_t kMostBitsOfAll = 4'000'000;
  if (a.is_zero()) return Done{};
  const auto bits = [](const Integer& of) { return std::size_t{msb(abs(of))} + 1; };
  const Rational scale = content(a);
  std::size_t longest = bits(denominator(scale));
  std::size_t sum = 0;
  for (auto term = a.terms().begin(); term != a.terms().end() && longest <= kMostBits; ++term) {
    const std::size_t here = bits(numerator(Rational(term->second / scale)));
    longest = std::max(longest, here);
    sum += here;
  }
  if (longest <= kMostBits && sum <= kMostBitsOfAll) return Done{};
  return Error{"a polynomial's coefficients are too long for it to be factored"};
}

/// FLINT's polynomials in some indeterminates, and the way there and back.
class Ring {
 public:
  explicit Ring(std::vector<Indeterminate> indeterminates)
      : indeterminates_(std::move(indeterminates)) {
    fmpq_mpoly_ctx_init(
        context_, static_cast<slong>(std::max<std::size_t>(indeterminates_.size(), 1)), ORD_LEX);
  }
  ~Ring() { fmpq_mpoly_ctx_clear(context_); }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  [[nodiscard]] const fmpq_mpoly_ctx_struct* context() const { return context_; }

  /// a times a monomial that leaves no negative exponents.
  void assign(fmpq_mpoly_struct* to, const Polynomial& a) const {
    std::vector<ulong> exponents(std::max<std::size_t>(indeterminates_.size(), 1));
    fmpq_t coefficient;
    fmpq_init(coefficient);
    fmpq_mpoly_zero(to, context_);
    for (const auto& [monomial, value] : a.terms()) {
      std::fill(exponents.begin(), exponents.end(), 0);
      for (const auto& [indeterminate, exponent] : monomial)
        exponents[position(indeterminate)] = static_cast<ulong>(exponent);
      fmpq_set_str(coefficient, to_string(value).c_str(), 10);
      fmpq_mpoly_set_coeff_fmpq_ui(to, coefficient, exponents.data(), context_);
    }
    fmpq_clear(coefficient);
  }

  [[nodiscard]] Polynomial read(const fmpq_mpoly_struct* from) const {
    std::vector<ulong> exponents(std::max<std::size_t>(indeterminates_.size(), 1));
    fmpq_t coefficient;
    fmpq_init(coefficient);
    Polynomial result;
    for (slong i = 0; i < fmpq_mpoly_length(from, context_); ++i) {
      fmpq_mpoly_get_term_coeff_fmpq(coefficient, from, i, context_);
      fmpq_mpoly_get_term_exp_ui(exponents.data(), from, i, context_);
      Monomial monomial;
      for (std::size_t s = 0; s < indeterminates_.size(); ++s)
        if (exponents[s] != 0)
          monomial.emplace_back(indeterminates_[s], static_cast<int>(exponents[s]));
      result += Polynomial(monomial, rational(coefficient));
    }
    fmpq_clear(coefficient);
    return result;
  }

  static Rational rational(const fmpq* value) {
    char* const text = fmpq_get_str(nullptr, 10, value);
    Rational result{std::string(text)};
    flint_free(text);
    return result;
  }

 private:
  [[nodiscard]] std::size_t position(const Indeterminate& indeterminate) const {
    return static_cast<std::size_t>(std::lower_bound(indeterminates_.begin(), indeterminates_.end(),
                                                     indeterminate, IndeterminateLess()) -
                                    indeterminates_.begin());
  }

  std::vector<Indeterminate> indeterminates_;
  fmpq_mpoly_ctx_t context_;
};

/// One of FLINT's polynomials.
struct Value {
  explicit Value(const Ring& in) : ring(in) { fmpq_mpoly_init(value, ring.context()); }
  Value(const Ring& in, const Polynomial& a) : Value(in) { ring.assign(value, a); }
  ~Value() { fmpq_mpoly_clear(value, ring.context()); }
  Value(const Value&) = delete;
  Value& operator=(const Value&) = delete;

  const Ring& ring;
  fmpq_mpoly_t value;
};

}  // namespace

Result<PolynomialFactors> factor(const Polynomial& a) {
  if (Status status = check_size(a); !status) return status.error();
  PolynomialFactors result;
  const Monomial common = a.common_monomial();
  for (const auto& [indeterminate, exponent] : common)
    result.factors.emplace_back(indeterminate, exponent);
  const Polynomial rest = a * Polynomial(power(common, -1), 1);
  const Ring ring(rest.indeterminates());
  const Value value(ring, rest);
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, ring.context());
  const bool done = fmpq_mpoly_factor(factors, value.value, ring.context()) != 0;
  if (done) {
    result.content = Ring::rational(factors->constant);
    for (slong i = 0; i < factors->num; ++i) {
      Polynomial base = ring.read(factors->poly + i);
      const auto exponent =
          static_cast<int>(fmpq_mpoly_factor_get_exp_si(factors, i, ring.context()));
      const Rational scale = content(base);
      base *= 1 / scale;
      for (int e = 0; e < exponent; ++e) result.content *= scale;
      result.factors.emplace_back(std::move(base), exponent);
    }
  }
  fmpq_mpoly_factor_clear(factors, ring.context());
  if (!done) return Error{"a polynomial could not be factored"};
  return result;
}

Result<Coprime> without_common_divisor(const Polynomial& a, const Polynomial& b) {
  for (const Polynomial* one : {&a, &b})
    if (Status status = check_size(*one); !status) return status.error();
  std::set<Indeterminate, IndeterminateLess> indeterminates;
  for (const Polynomial* one : {&a, &b})
    for (Indeterminate& indeterminate : one->indeterminates())
      indeterminates.insert(std::move(indeterminate));
  const Ring ring({indeterminates.begin(), indeterminates.end()});
  const Value left(ring, a);
  const Value right(ring, b);
  Value divisor(ring);
  Value over_left(ring);
  Value over_right(ring);
  if (fmpq_mpoly_gcd_cofactors(divisor.value, over_left.value, over_right.value, left.value,
                               right.value, ring.context()) == 0)
    return Error{"a common divisor could not be found"};
  return Coprime{ring.read(over_left.value), ring.read(over_right.value), ring.read(divisor.value)};
}

#else
namespace {

Error without_flint() {
  return {"this limn was built without FLINT, which formulas need",
          "install FLINT 2.9 or later and build limn anew"};
}

}  // namespace

Result<PolynomialFactors> factor(const Polynomial&) { return without_flint(); }
Result<Coprime> without_common_divisor(const Polynomial&, const Polynomial&) {
  return without_flint();
}
#endif

}  // namespace limn::number
