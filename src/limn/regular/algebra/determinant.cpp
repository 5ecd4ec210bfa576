#include "limn/regular/algebra/determinant.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "limn/base/parallel.h"

namespace limn::regular {
namespace {

__extension__ using Wide = unsigned __int128;
using IntegerMatrix = std::vector<std::vector<Integer>>;

constexpr int kPrimeBits = 61;  // every prime used is above 2⁶¹ and below 2⁶²

std::uint64_t product_modulo(std::uint64_t a, std::uint64_t b, std::uint64_t p) {
  return static_cast<std::uint64_t>(static_cast<Wide>(a) * b % p);
}

std::uint64_t power_modulo(std::uint64_t base, std::uint64_t exponent, std::uint64_t p) {
  std::uint64_t result = 1;
  for (; exponent > 0; exponent >>= 1, base = product_modulo(base, base, p))
    if ((exponent & 1) != 0) result = product_modulo(result, base, p);
  return result;
}

/// Miller and Rabin, with the bases that decide every number below 3·10²⁴.
bool is_prime(std::uint64_t n) {
  std::uint64_t odd = n - 1;
  int halvings = 0;
  for (; (odd & 1) == 0; odd >>= 1) ++halvings;
  for (const std::uint64_t base : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37}) {
    std::uint64_t x = power_modulo(base, odd, n);
    bool passes = x == 1 || x == n - 1;
    for (int i = 1; i < halvings && !passes; ++i) {
      x = product_modulo(x, x, n);
      passes = x == n - 1;
    }
    if (!passes) return false;
  }
  return true;
}

std::vector<std::uint64_t> largest_primes(std::size_t count) {
  std::vector<std::uint64_t> primes;
  for (std::uint64_t n = (std::uint64_t{1} << (kPrimeBits + 1)) - 1; primes.size() < count; n -= 2)
    if (is_prime(n)) primes.push_back(n);
  return primes;
}

/// Arithmetic modulo an odd p < 2⁶² on numbers a that stand for a·2⁻⁶⁴ (Montgomery): no division.
class Residues {
 public:
  explicit Residues(std::uint64_t p) : p_(p), inverse_(1) {
    for (int i = 0; i < 6; ++i) inverse_ *= 2 - p * inverse_;  // of p modulo 2⁶⁴, by Newton
    const auto one = static_cast<std::uint64_t>((Wide{1} << 64) % p);
    square_ = product_modulo(one, one, p);
  }

  [[nodiscard]] std::uint64_t times(std::uint64_t a, std::uint64_t b) const {
    const Wide wide = static_cast<Wide>(a) * b;
    const std::uint64_t factor = static_cast<std::uint64_t>(wide) * inverse_;
    const auto down = static_cast<std::uint64_t>((static_cast<Wide>(factor) * p_) >> 64);
    const auto high = static_cast<std::uint64_t>(wide >> 64);
    return high >= down ? high - down : high + (p_ - down);
  }
  [[nodiscard]] std::uint64_t less(std::uint64_t a, std::uint64_t b) const {
    return a >= b ? a - b : a + (p_ - b);
  }
  [[nodiscard]] std::uint64_t of(const Integer& value) const {
    Integer rest = value % p_;
    if (rest < 0) rest += p_;
    return times(rest.convert_to<std::uint64_t>(), square_);
  }
  [[nodiscard]] std::uint64_t plain(std::uint64_t a) const { return times(a, 1); }
  [[nodiscard]] std::uint64_t inverse(std::uint64_t a) const {
    std::uint64_t result = times(1, square_);
    for (std::uint64_t e = p_ - 2; e > 0; e >>= 1, a = times(a, a))
      if ((e & 1) != 0) result = times(result, a);
    return result;
  }

 private:
  std::uint64_t p_, inverse_, square_;  // square_: 2¹²⁸ modulo p
};

/// By Gaussian elimination.
std::uint64_t determinant_modulo(const IntegerMatrix& a, std::uint64_t p) {
  const Residues field(p);
  const std::size_t n = a.size();
  std::vector<std::vector<std::uint64_t>> rows(n, std::vector<std::uint64_t>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = a[i][j] == 0 ? 0 : field.of(a[i][j]);
  std::uint64_t determinant = field.of(1);
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && rows[pivot][c] == 0) ++pivot;
    if (pivot == n) return 0;
    if (pivot != c) {
      std::swap(rows[pivot], rows[c]);
      determinant = field.less(0, determinant);
    }
    determinant = field.times(determinant, rows[c][c]);
    const std::uint64_t inverse = field.inverse(rows[c][c]);
    for (std::size_t r = c + 1; r < n; ++r) {
      if (rows[r][c] == 0) continue;
      const std::uint64_t factor = field.times(rows[r][c], inverse);
      for (std::size_t k = c + 1; k < n; ++k)
        rows[r][k] = field.less(rows[r][k], field.times(factor, rows[c][k]));
    }
  }
  return field.plain(determinant);
}

Integer common_denominator(const std::vector<Rational>& row) {
  Integer common = 1;
  for (const Rational& entry : row) common = lcm(common, denominator(entry));
  return common;
}

Integer scaled_entry(const Rational& entry, const Integer& by) {
  return numerator(entry) * (by / denominator(entry));
}

/// Each row times the least number that makes it whole: the determinant keeps its sign.
IntegerMatrix with_whole_rows(const RationalMatrix& a) {
  IntegerMatrix result;
  for (const std::vector<Rational>& row : a) {
    const Integer common = common_denominator(row);
    std::vector<Integer>& whole = result.emplace_back();
    for (const Rational& entry : row) whole.push_back(scaled_entry(entry, common));
  }
  return result;
}

/// Bits of |det|, by Hadamard's bound; nothing where a row is 0.
std::optional<std::size_t> bits_of_determinant(const IntegerMatrix& a) {
  std::size_t bits = 0;
  for (const std::vector<Integer>& row : a) {
    Integer squares = 0;
    for (const Integer& entry : row) squares += entry * entry;
    if (squares == 0) return std::nullopt;
    bits += (msb(squares) + 2) / 2;
  }
  return bits;
}

/// The sign of the number nearest to 0 with these residues, by mixed radix (Garner).
int sign_of(const std::vector<std::uint64_t>& residues, const std::vector<std::uint64_t>& primes) {
  std::vector<std::uint64_t> digits;
  for (std::size_t i = 0; i < primes.size(); ++i) {
    const std::uint64_t p = primes[i];
    std::uint64_t value = 0;  // of the digits so far
    std::uint64_t radix = 1;
    for (std::size_t j = 0; j < i; ++j) {
      value = (value + product_modulo(digits[j] % p, radix, p)) % p;
      radix = product_modulo(radix, primes[j] % p, p);
    }
    const std::uint64_t rest = (residues[i] + (p - value)) % p;
    digits.push_back(product_modulo(rest, power_modulo(radix, p - 2, p), p));
  }
  Integer value = 0;
  Integer range = 1;
  for (std::size_t i = primes.size(); i-- > 0;) {
    value = value * primes[i] + digits[i];
    range *= primes[i];
  }
  if (value == 0) return 0;
  return 2 * value > range ? -1 : 1;
}

}  // namespace

std::optional<int> sign_of_determinant(const RationalMatrix& a, const Stop& stop) {
  const IntegerMatrix whole = with_whole_rows(a);
  const std::optional<std::size_t> bits = bits_of_determinant(whole);
  if (!bits) return 0;
  const std::vector<std::uint64_t> primes = largest_primes((*bits + 1) / kPrimeBits + 1);
  std::vector<std::uint64_t> residues(primes.size());
  std::atomic<bool> ended{false};
  base::parallel_for(
      std::size_t{0}, primes.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          if (ended || asked(stop)) {
            ended = true;
            return;
          }
          residues[i] = determinant_modulo(whole, primes[i]);
        }
      },
      1);
  if (ended) return std::nullopt;
  return sign_of(residues, primes);
}

std::optional<bool> is_singular(const RationalMatrix& a, const Stop& stop) {
  if (determinant_modulo(with_whole_rows(a), largest_primes(1).front()) != 0) return false;
  const std::optional<int> sign = sign_of_determinant(a, stop);
  if (!sign) return std::nullopt;
  return *sign == 0;
}

RationalMatrix product_of(const std::vector<const RationalMatrix*>& factors) {
  IntegerMatrix all_together;
  Integer denominator = 1;
  for (const RationalMatrix* factor : factors) {
    std::vector<Rational> all;
    for (const std::vector<Rational>& row : *factor) all.insert(all.end(), row.begin(), row.end());
    const Integer common = common_denominator(all);
    IntegerMatrix whole;
    for (const std::vector<Rational>& row : *factor) {
      whole.emplace_back();
      for (const Rational& entry : row) whole.back().push_back(scaled_entry(entry, common));
    }
    all_together = all_together.empty() ? std::move(whole) : product(all_together, whole);
    denominator *= common;
  }
  RationalMatrix result;
  for (const std::vector<Integer>& row : all_together) {
    result.emplace_back();
    for (const Integer& entry : row) result.back().emplace_back(entry, denominator);
  }
  return result;
}

}  // namespace limn::regular
