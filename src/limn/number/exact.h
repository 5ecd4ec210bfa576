#pragma once
/// The exact numbers that a weight expression can denote: cyclotomic numbers, square roots
/// over them, and rational multiples of π (which only cos and sin can consume).
///
/// A square root that is not rational is a symbol t with t² = its radicand. Two such symbols
/// are never related to one another, so `==` never calls different numbers equal, but may miss an
/// equality between unlike roots, as between sqrt(2)*sqrt(3) and sqrt(6).

#include <memory>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/cyclotomic.h"

namespace limn {

class Exact {
 public:
  Exact() = default;
  Exact(int value) : Exact(Rational(value)) {}
  Exact(Rational value) : Exact(Cyclotomic(std::move(value))) {}
  Exact(Cyclotomic value);

  static Exact pi();

  [[nodiscard]] bool is_zero() const { return terms_.empty() && pi_ == 0; }
  [[nodiscard]] bool is_rational() const;
  /// Precondition: is_rational().
  [[nodiscard]] Rational rational() const;
  /// Nearest double up to a few units in the last place of the largest term.
  [[nodiscard]] double approx() const;

  /// These fail, with the reason in the message, where the answer is no exact number of this kind.
  [[nodiscard]] static Result<Exact> multiply(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> divide(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> cos(const Exact& angle);
  [[nodiscard]] static Result<Exact> sin(const Exact& angle);
  [[nodiscard]] static Result<Exact> sqrt(const Exact& square);

  Exact& operator+=(const Exact& b);
  Exact& operator-=(const Exact& b);
  friend Exact operator+(Exact a, const Exact& b) { return a += b; }
  friend Exact operator-(Exact a, const Exact& b) { return a -= b; }
  /// Precondition: not both hold π.
  friend Exact operator*(const Exact& a, const Exact& b) { return multiply(a, b).value(); }
  friend bool operator==(const Exact& a, const Exact& b) { return (a - b).is_zero(); }

 private:
  using Root = std::shared_ptr<const Exact>;  // the symbol sqrt(*root)
  struct Term {
    std::vector<Root> roots;  // distinct
    Cyclotomic coefficient;   // not zero
  };
  void add(Term term);
  static Exact product(const Term& a, const Term& b);
  [[nodiscard]] Result<Exact> inverse() const;

  std::vector<Term> terms_;  // with distinct sets of roots
  Rational pi_ = 0;          // the multiple of π that is added
};

}  // namespace limn
