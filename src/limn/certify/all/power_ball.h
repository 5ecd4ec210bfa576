#pragma once
/// Quantities that depend on the valence n, enclosed for all n in a range at once, n → ∞ included.
///
/// With t = 1/n a quantity is t^power · F(t), and a ball holds F(t) for every t of the range. So n
/// is t^-1 · 1, and 1/n² times n is t · 1: what tends to 0 or ∞ keeps its exact power of t, and
/// quotients that have a limit are enclosed where a ball of n, or of t, would say nothing. Where
/// F(0) is known to be a rational, F = F(0) + t^step · R with a ball for R, so that differences
/// that tend to 0, as 1/4 - cos(3π/n)/4, get their power of t too.

#include <optional>

#include "limn/number/ball.h"

namespace limn::certify {

/// While it lives, t = 1/n on this thread is any number of the ball given, which holds no negative
/// number but by rounding. Without one t is anywhere in 0 … 1.
class ValenceRange {
 public:
  explicit ValenceRange(number::Ball t);
  ValenceRange(const ValenceRange&) = delete;
  ValenceRange& operator=(const ValenceRange&) = delete;
  ~ValenceRange();
  [[nodiscard]] static const number::Ball& t();

 private:
  number::Ball outer_;
};

class PowerBall {
 public:
  PowerBall() : PowerBall(Rational(0)) {}
  PowerBall(int value) : PowerBall(Rational(value)) {}
  explicit PowerBall(const Rational& value);
  explicit PowerBall(number::Ball value) : factor_(std::move(value)) {}

  [[nodiscard]] static PowerBall valence();  ///< n

  [[nodiscard]] int power() const { return power_; }
  [[nodiscard]] const number::Ball& factor() const { return factor_; }  ///< F
  [[nodiscard]] bool is_zero() const { return factor_.is_exactly_zero(); }
  /// Whether it was made without n.
  [[nodiscard]] bool is_constant() const { return constant_; }
  /// All its values; the whole line where it may tend to ∞.
  [[nodiscard]] number::Ball ball() const { return over(0); }
  /// The same of it over t^power.
  [[nodiscard]] number::Ball over(int power) const;

  friend PowerBall operator+(const PowerBall& a, const PowerBall& b);
  friend PowerBall operator-(const PowerBall& a, const PowerBall& b);
  friend PowerBall operator*(const PowerBall& a, const PowerBall& b);
  friend PowerBall operator/(const PowerBall& a, const PowerBall& b);

 private:
  friend struct number::Arithmetic<PowerBall>;
  /// F = value + t^step · rest.
  struct Head {
    Rational value;
    int step;
    number::Ball rest;
    /// `rest` where F is written with another step, not above this one.
    [[nodiscard]] number::Ball with_step(int other) const;
  };
  PowerBall(int power, number::Ball factor, std::optional<Head> head, bool constant);
  /// Of the quantity over t^power, power ≤ power_.
  [[nodiscard]] std::optional<Head> head_over(int power) const;

  int power_ = 0;
  number::Ball factor_;
  std::optional<Head> head_;
  bool constant_ = true;
};

PowerBall operator+(const PowerBall& a, const PowerBall& b);
PowerBall operator-(const PowerBall& a, const PowerBall& b);
PowerBall operator*(const PowerBall& a, const PowerBall& b);
PowerBall operator/(const PowerBall& a, const PowerBall& b);

}  // namespace limn::certify

namespace limn::number {

/// Weight expressions for a range of valences: guards such as n == 3 are decided for all of them,
/// or not at all.
template <>
struct Arithmetic<certify::PowerBall> {
  using Number = certify::PowerBall;
  static Number from(const Rational& q) { return Number(q); }
  static Number pi() { return Number(Ball::pi()); }
  static Result<Number> add(const Number& a, const Number& b) { return finite(a + b); }
  static Result<Number> subtract(const Number& a, const Number& b) { return finite(a - b); }
  static Result<Number> multiply(const Number& a, const Number& b) { return finite(a * b); }
  static Result<Number> divide(const Number& a, const Number& b);
  static Result<Number> cos(const Number& a);
  static Result<Number> sin(const Number& a);
  static Result<Number> sqrt(const Number& a);
  static Result<int> sign(const Number& a) { return Arithmetic<Ball>::sign(a.factor_); }
  static Result<long long> integer(const Number& a);
  static double approx(const Number& a) { return a.ball().approx(); }

 private:
  static Result<Number> finite(Number a);
};

}  // namespace limn::number
