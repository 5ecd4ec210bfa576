#pragma once
/// Exact rationals of any size. A literal in a scheme file is one; so is everything that
/// is computed exactly from it.

#include <compare>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace limn {

namespace base {
struct ExactAccess;  // exact_access.h
}

// Exact integers of any size. Their digits are kept by Boost's cpp_int, which integer.cpp and
// rational.cpp alone see: it costs every source that reads it two seconds to compile.

/// An integer of any size. Cost of an operation: grows with the digits; no memory is asked for up
/// to some 128 bits.
class Integer {
 public:
  Integer() noexcept;  ///< 0
  template <std::integral T>
  Integer(T value) noexcept {  ///< that number
    if constexpr (std::signed_integral<T>)
      set(static_cast<long long>(value));
    else
      set(static_cast<unsigned long long>(value));
  }
  /// Cut off towards 0. Precondition: finite.
  explicit Integer(double value);
  /// From digits, with a sign or not; as in C++, 0… is octal and 0x… hexadecimal. Throws
  /// std::runtime_error where it is something else.
  explicit Integer(const std::string& digits);
  /// @{
  /// Copies and moves; what was moved from is valid and of no known value.
  Integer(const Integer& other);
  Integer(Integer&& other) noexcept;
  Integer& operator=(const Integer& other);
  Integer& operator=(Integer&& other) noexcept;
  /// @}
  ~Integer();

  /// @{
  /// Exact.
  Integer& operator+=(const Integer& b);
  Integer& operator-=(const Integer& b);
  Integer& operator*=(const Integer& b);
  /// @}
  /// @{
  /// Cut off towards 0; the remainder has the sign of the dividend. Precondition: b is not 0.
  Integer& operator/=(const Integer& b);
  Integer& operator%=(const Integer& b);
  /// @}
  Integer& operator<<=(unsigned bits);  ///< times 2 to this power
  /// @{
  /// As of the machine's integers, without their limits.
  Integer& operator++() { return *this += 1; }
  Integer& operator--() { return *this -= 1; }
  Integer operator-() const;

  friend Integer operator+(Integer a, const Integer& b) { return a += b; }
  friend Integer operator-(Integer a, const Integer& b) { return a -= b; }
  friend Integer operator*(Integer a, const Integer& b) { return a *= b; }
  friend Integer operator/(Integer a, const Integer& b) { return a /= b; }
  friend Integer operator%(Integer a, const Integer& b) { return a %= b; }
  friend Integer operator<<(Integer a, unsigned bits) { return a <<= bits; }
  friend bool operator==(const Integer& a, const Integer& b) { return a.compare(b) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return a.compare(b) <=> 0;
  }
  /// @}

  [[nodiscard]] int sign() const;         ///< -1, 0 or 1
  [[nodiscard]] std::string str() const;  ///< decimal digits, after a minus where it is negative
  /// The nearest double, or the number as an int, long long, unsigned long or unsigned long long;
  /// one too large for these becomes the largest (or least) of them, unsigned: its last bits.
  template <class T>
  [[nodiscard]] T convert_to() const;

  /// Without its sign.
  friend Integer abs(const Integer& a) { return a.sign() < 0 ? -a : a; }
  friend Integer gcd(const Integer& a, const Integer& b);   ///< not negative
  friend Integer lcm(const Integer& a, const Integer& b);   ///< not negative
  friend Integer pow(const Integer& a, unsigned exponent);  ///< 1 where the exponent is 0
  /// The largest whose square is no more than a. Precondition: a ≥ 0.
  friend Integer sqrt(const Integer& a);
  /// The position of the highest bit set, counted from 0. Precondition: a > 0.
  friend std::size_t msb(const Integer& a);
  friend std::ostream& operator<<(std::ostream& out, const Integer& a);  ///< as `str`

 private:
  friend struct base::ExactAccess;
  void set(long long value) noexcept;
  void set(unsigned long long value) noexcept;
  [[nodiscard]] int compare(const Integer& b) const;  // negative, 0, positive

  alignas(16) std::byte digits_[32];  // a cpp_int lives here
};

/// Not negative; 0 where both are.
Integer gcd(const Integer& a, const Integer& b);
/// Not negative; 0 where one is.
Integer lcm(const Integer& a, const Integer& b);
/// 1 where the exponent is 0.
Integer pow(const Integer& a, unsigned exponent);
/// The largest whose square is no more than a. Precondition: a ≥ 0.
Integer sqrt(const Integer& a);
/// The position of the highest bit set, counted from 0. Precondition: a > 0.
std::size_t msb(const Integer& a);
std::ostream& operator<<(std::ostream& out, const Integer& a);  ///< as `str`

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
  friend struct base::ExactAccess;
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
