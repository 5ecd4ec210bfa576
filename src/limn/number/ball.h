#pragma once
/// Real numbers in ball arithmetic: a midpoint and a radius that together enclose a number [Arb].
///
/// Every operation encloses: whatever numbers the operands' balls hold, the result's ball holds the
/// operation's value. So a sign that a ball shows is proved, and a ball that holds 0 says nothing.
/// Midpoints have BallPrecision bits; radii have 30, rounded up.
///
/// Where limn is built without Arb every ball is the whole line (ball_without_arb.cpp).

#include <cstddef>
#include <optional>
#include <string>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/number/arithmetic.h"
#include "limn/number/dense_matrix.h"

namespace limn::number {

/// While it lives, operations on balls on this thread round their midpoints to so many bits.
class BallPrecision {
 public:
  /// bits: 2 … 100 000; without any BallPrecision they are 128.
  explicit BallPrecision(int bits);
  BallPrecision(const BallPrecision&) = delete;
  BallPrecision& operator=(const BallPrecision&) = delete;
  ~BallPrecision();

 private:
  int outer_;
};

class Ball {
 public:
  Ball() noexcept;                       ///< 0
  Ball(int value) noexcept;              ///< exactly that number
  explicit Ball(double value) noexcept;  ///< exactly that number; NaN: the whole line
  explicit Ball(const Rational& value);  ///< as near as the precision allows
  Ball(const Ball& other);
  Ball(Ball&& other) noexcept;
  Ball& operator=(const Ball& other);
  Ball& operator=(Ball&& other) noexcept;
  ~Ball();

  [[nodiscard]] static bool is_available();  ///< whether limn was built with Arb

  [[nodiscard]] static Ball pi();
  /// The least ball (to rounding) that holds low … high. Precondition: finite, low ≤ high.
  [[nodiscard]] static Ball between(double low, double high);
  /// The least ball (to rounding) that holds both.
  [[nodiscard]] static Ball hull(const Ball& a, const Ball& b);

  Ball& operator+=(const Ball& b);
  Ball& operator-=(const Ball& b);
  Ball& operator*=(const Ball& b);
  /// Where b holds 0 the result is the whole line.
  Ball& operator/=(const Ball& b);
  /// *this += a·b
  Ball& add_product(const Ball& a, const Ball& b);
  Ball operator-() const;
  friend Ball operator+(Ball a, const Ball& b) { return a += b; }
  friend Ball operator-(Ball a, const Ball& b) { return a -= b; }
  friend Ball operator*(Ball a, const Ball& b) { return a *= b; }
  friend Ball operator/(Ball a, const Ball& b) { return a /= b; }

  [[nodiscard]] bool is_exactly_zero() const;  ///< the ball is the number 0
  [[nodiscard]] bool is_finite() const;
  [[nodiscard]] bool holds_zero() const;
  [[nodiscard]] bool is_positive() const;  ///< all of it
  [[nodiscard]] bool is_negative() const;  ///< all of it
  /// Every number of a is less than every number of b.
  friend bool is_less(const Ball& a, const Ball& b);
  /// Every number of *this is one of `outer`, and none is an end of it.
  [[nodiscard]] bool is_strictly_inside(const Ball& outer) const;
  /// Some number is in both.
  [[nodiscard]] bool overlaps(const Ball& other) const;

  [[nodiscard]] double approx() const;  ///< the midpoint
  [[nodiscard]] double lower() const;   ///< a double ≤ all of it
  [[nodiscard]] double upper() const;   ///< a double ≥ all of it
  [[nodiscard]] Ball middle() const;    ///< the midpoint, exactly
  [[nodiscard]] double radius() const;  ///< rounded up
  /// The same midpoint, the radius larger by `more` ≥ 0.
  [[nodiscard]] Ball widened(double more) const;
  /// All |x|.
  [[nodiscard]] Ball magnitude() const;
  /// A whole number, where the ball is exactly that one.
  [[nodiscard]] std::optional<long long> integer() const;
  /// For people: digits that are known, "0.5625 ± 1e-30".
  [[nodiscard]] std::string to_string(int digits = 12) const;

  friend Ball cos(const Ball& a);
  friend Ball sin(const Ball& a);
  friend Ball sqrt(const Ball& a);  ///< the whole line where a holds negative numbers

 private:
  struct Access;                    // ball.cpp
  alignas(8) std::byte parts_[48];  // an arb_struct lives here
};

[[nodiscard]] Ball cos(const Ball& a);
[[nodiscard]] Ball sin(const Ball& a);
[[nodiscard]] Ball sqrt(const Ball& a);
[[nodiscard]] bool is_less(const Ball& a, const Ball& b);

template <>
struct Arithmetic<Ball> {
  static Ball from(const Rational& q) { return Ball(q); }
  static Ball pi() { return Ball::pi(); }
  static Result<Ball> add(const Ball& a, const Ball& b) { return finite(a + b); }
  static Result<Ball> subtract(const Ball& a, const Ball& b) { return finite(a - b); }
  static Result<Ball> multiply(const Ball& a, const Ball& b) { return finite(a * b); }
  static Result<Ball> divide(const Ball& a, const Ball& b) {
    if (b.is_exactly_zero()) return Error{"division by zero"};
    return finite(a / b);
  }
  static Result<Ball> cos(const Ball& a) { return limn::number::cos(a); }
  static Result<Ball> sin(const Ball& a) { return limn::number::sin(a); }
  static Result<Ball> sqrt(const Ball& a) {
    if (a.is_negative()) return Error{"square root of a negative number"};
    return finite(limn::number::sqrt(a));
  }
  /// Fails where the ball does not show it.
  static Result<int> sign(const Ball& a) {
    if (a.is_exactly_zero()) return 0;
    if (a.is_positive()) return 1;
    if (a.is_negative()) return -1;
    return Error{"cannot decide the sign of a number that may be 0"};
  }
  static Result<long long> integer(const Ball& a) {
    const std::optional<long long> whole = a.integer();
    if (!whole) return Error{"an integer is needed here"};
    return *whole;
  }
  static double approx(const Ball& a) { return a.approx(); }

 private:
  static Result<Ball> finite(Ball a) {
    if (!a.is_finite()) return Error{"the number cannot be enclosed: a division by what may be 0"};
    return a;
  }
};

using BallMatrix = DenseMatrix<Ball>;

/// a·b. Precondition: a.columns() == b.rows(). Cost: the product of the three sizes.
[[nodiscard]] BallMatrix product(const BallMatrix& a, const BallMatrix& b);
/// The largest sum of moduli in a row: an upper bound, rounded up. 0 for an empty matrix.
[[nodiscard]] double row_norm(const BallMatrix& a);

}  // namespace limn::number
