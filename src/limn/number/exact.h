#pragma once
/// The exact numbers that a weight expression can denote: cyclotomic numbers, square roots
/// over them, and rational multiples of π (which only cos and sin can consume).
///
/// A square root that is not rational is an indeterminate t with t² = its radicand. Two such
/// indeterminates are never related to one another, so `==` never calls different numbers equal,
/// but may miss an equality between unlike roots, as between sqrt(2)*sqrt(3) and sqrt(6).

#include <memory>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/cyclotomic.h"

namespace limn::number {

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
  /// Nearest double up to a few units in the last place of `magnitude`.
  [[nodiscard]] double approx() const;
  /// The sum of the moduli of the terms.
  [[nodiscard]] double magnitude() const;

  /// These fail, with the reason in the message, where the answer is no exact number of this kind,
  /// and where it would be so large (in digits, in the order of its field, in square roots) that
  /// one operation took more than about a second. The operators below have no such bound.
  [[nodiscard]] static Result<Exact> add(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> subtract(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> multiply(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> divide(const Exact& a, const Exact& b);
  [[nodiscard]] static Result<Exact> cos(const Exact& angle);
  [[nodiscard]] static Result<Exact> sin(const Exact& angle);
  [[nodiscard]] static Result<Exact> sqrt(const Exact& square);

  Exact& operator+=(const Exact& b);
  Exact& operator-=(const Exact& b);
  friend Exact operator+(Exact a, const Exact& b) { return a += b; }
  friend Exact operator-(Exact a, const Exact& b) { return a -= b; }
  /// Precondition: where one holds π, the other is rational.
  friend Exact operator*(const Exact& a, const Exact& b);
  friend bool operator==(const Exact& a, const Exact& b) { return (a - b).is_zero(); }

 private:
  using Root = std::shared_ptr<const Exact>;  // the indeterminate sqrt(*root)
  struct Term {
    std::vector<Root> roots;  // distinct
    Cyclotomic coefficient;   // not zero
  };
  void add(Term term);
  static Exact product(const Term& a, const Term& b);
  [[nodiscard]] Result<Exact> inverse() const;

  /// How large a number is, roots within roots included: what the cost of arithmetic grows with.
  struct Size {
    double terms = 0;
    double order = 1;   // least common multiple of the fields' orders
    double bits = 1;    // of the longest numerator or denominator
    double depth = 0;   // of square roots within square roots
    bool huge = false;  // beyond what a double can hold
  };
  [[nodiscard]] Size size() const;
  static Status charge(const Size& a, const Size& b, double operations);
  static Result<Exact> bounded(Exact value);

  std::vector<Term> terms_;  // with distinct sets of roots
  Rational pi_ = 0;          // the multiple of π that is added
};

/// While it lives, the checked operations on this thread may cost at most `work` in all
/// (multiplications of short rationals, roughly); then they fail. So a file that we did not
/// write cannot keep us busy for long. Budgets nest: the work counts in each.
class ExactBudget {
 public:
  explicit ExactBudget(double work);
  ExactBudget(const ExactBudget&) = delete;
  ExactBudget& operator=(const ExactBudget&) = delete;
  ~ExactBudget();

 private:
  double outer_;  // what was left before
  double given_;
};

}  // namespace limn::number
