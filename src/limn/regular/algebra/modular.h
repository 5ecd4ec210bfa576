#pragma once
/// The field of 2⁶¹ - 1 elements: a quick shadow of the rationals. What is found in it is
/// reconstructed and then verified over the rationals, so nothing is believed on its word.

#include <cstdint>
#include <optional>

#include "limn/base/rational.h"

namespace limn::regular {

class Modular {
 public:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

  constexpr Modular() = default;
  constexpr Modular(std::uint64_t value) : value_(value % kPrime) {}

  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }
  [[nodiscard]] Modular inverse() const { return power(*this, kPrime - 2); }

  friend constexpr Modular operator+(Modular a, Modular b) { return {a.value_ + b.value_}; }
  friend constexpr Modular operator-(Modular a, Modular b) {
    return {a.value_ + (kPrime - b.value_)};
  }
  friend Modular operator*(Modular a, Modular b) {
    __extension__ using Wide = unsigned __int128;
    const Wide wide = static_cast<Wide>(a.value_) * b.value_;
    return {(static_cast<std::uint64_t>(wide) & kPrime) + static_cast<std::uint64_t>(wide >> 61)};
  }
  friend Modular operator/(Modular a, Modular b) { return a * b.inverse(); }
  Modular& operator+=(Modular b) { return *this = *this + b; }
  Modular& operator-=(Modular b) { return *this = *this - b; }
  Modular& operator*=(Modular b) { return *this = *this * b; }
  Modular& operator/=(Modular b) { return *this = *this / b; }
  friend constexpr bool operator==(Modular a, Modular b) { return a.value_ == b.value_; }
  friend constexpr bool operator!=(Modular a, Modular b) { return !(a == b); }

  [[nodiscard]] static Modular power(Modular base, std::uint64_t exponent) {
    Modular result = 1;
    for (; exponent > 0; exponent >>= 1, base *= base)
      if ((exponent & 1) != 0) result *= base;
    return result;
  }

 private:
  std::uint64_t value_ = 0;
};

/// The residue class; nothing where the denominator is divisible by the prime.
[[nodiscard]] std::optional<Modular> modular(const Rational& q);

/// The p/q with |p|, q < 2³⁰ in that class; nothing where there is none.
[[nodiscard]] std::optional<Rational> reconstructed(Modular a);

}  // namespace limn::regular
