#include "limn/regular/algebra/modular.h"

#include <utility>

namespace limn::regular {

std::optional<Modular> modular(const Rational& q) {
  const Integer prime = Modular::kPrime;
  const auto residue = [&](const Integer& value) {
    Integer rest = value % prime;
    if (rest < 0) rest += prime;
    return Modular(rest.convert_to<std::uint64_t>());
  };
  const Modular below = residue(denominator(q));
  if (below == Modular(0)) return std::nullopt;
  return residue(numerator(q)) / below;
}

std::optional<Rational> reconstructed(Modular a) {
  // half of the Euclidean algorithm on (prime, a)
  constexpr std::int64_t kBound = std::int64_t{1} << 30;
  auto rest = static_cast<std::int64_t>(Modular::kPrime);
  auto next = static_cast<std::int64_t>(a.value());
  std::int64_t factor = 0;
  std::int64_t next_factor = 1;
  while (next >= kBound) {
    const std::int64_t quotient = rest / next;
    rest = std::exchange(next, rest - quotient * next);
    factor = std::exchange(next_factor, factor - quotient * next_factor);
  }
  if (next_factor == 0 || next_factor <= -kBound || next_factor >= kBound) return std::nullopt;
  return next_factor < 0 ? Rational(-next, -next_factor) : Rational(next, next_factor);
}

}  // namespace limn::regular
