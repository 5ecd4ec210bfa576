#pragma once
/// Exact rationals of any size. A literal in a scheme file is one; so is everything that
/// is computed exactly from it.

#include <compare>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <string>

#include "limn/base/integer.h"

namespace limn {

/// A fraction in lowest terms, its denominator positive.
class Rational {
 public:
  Rational() noexcept;  ///< 0
  /// That number.
  template <std::integral T>
  Rational(T value) : Rational(Integer(value)) {}
  Rational(const Integer& value);  ///< that number
  /// Throws std::overflow_error where the denominator is 0.
  Rational(const Integer& numerator, const Integer& denominator);
  /// The number that the double is, exactly. Precondition: finite.
  explicit Rational(double value);
  /// From "3" or "-7/24". Throws std::runtime_error where it is something else.
  explicit Rational(const std::string& text);
  /// @{
  /// Copies and moves; what was moved from is valid and of no known value.
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  /// @}
  ~Rational();

  /// @{
  /// Exact. Division throws std::overflow_error where b is 0.
  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b);
  Rational& operator*=(const Rational& b);
  Rational& operator/=(const Rational& b);
  Rational operator-() const;

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend bool operator==(const Rational& a, const Rational& b) { return a.equals(b); }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.compare(b) <=> 0;
  }
  /// @}
  /// @{
  /// With a number of the machine, without making a fraction of it.
  template <std::signed_integral T>
  friend bool operator==(const Rational& a, T b) {
    return a.compare(static_cast<long long>(b)) == 0;
  }
  template <std::signed_integral T>
  friend std::strong_ordering operator<=>(const Rational& a, T b) {
    return a.compare(static_cast<long long>(b)) <=> 0;
  }
  /// @}

  explicit operator double() const;       ///< the nearest, as by to_double, but slower
  [[nodiscard]] int sign() const;         ///< -1, 0 or 1
  [[nodiscard]] std::string str() const;  ///< "3", "-7/24"

  /// Without its sign.
  friend Rational abs(const Rational& q) { return q.sign() < 0 ? -q : q; }
  friend Integer numerator(const Rational& q);    ///< in lowest terms, with the sign
  friend Integer denominator(const Rational& q);  ///< positive
  friend std::ostream& operator<<(std::ostream& out, const Rational& q);  ///< as `str`

 private:
  friend struct ExactAccess;
  [[nodiscard]] bool equals(const Rational& b) const;
  [[nodiscard]] int compare(const Rational& b) const;  // negative, 0, positive
  [[nodiscard]] int compare(long long b) const;

  alignas(16) std::byte parts_[64];  // a cpp_rational lives here
};

Integer numerator(const Rational& q);                            ///< in lowest terms, with the sign
Integer denominator(const Rational& q);                          ///< positive
std::ostream& operator<<(std::ostream& out, const Rational& q);  ///< as `str`

/// The nearest double (to within one unit in the last place).
[[nodiscard]] double to_double(const Rational& q);

/// "3", "-7/24".
[[nodiscard]] inline std::string to_string(const Rational& q) { return q.str(); }

/// Whether the denominator is 1.
[[nodiscard]] bool is_integer(const Rational& q);

}  // namespace limn
