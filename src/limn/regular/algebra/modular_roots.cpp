#include "limn/regular/algebra/modular_roots.h"

#include <utility>

namespace limn::regular {
namespace {

/// Coefficients by exponent; the last is not 0.
using ModularPolynomial = std::vector<Modular>;

void trim(ModularPolynomial& a) {
  while (!a.empty() && a.back() == Modular(0)) a.pop_back();
}

/// a modulo f.
ModularPolynomial remainder(ModularPolynomial a, const ModularPolynomial& f) {
  const Modular lead = f.back().inverse();
  trim(a);
  while (a.size() >= f.size()) {
    const Modular factor = a.back() * lead;
    const std::size_t shift = a.size() - f.size();
    for (std::size_t i = 0; i < f.size(); ++i) a[shift + i] -= factor * f[i];
    trim(a);
  }
  return a;
}

ModularPolynomial product_modulo(const ModularPolynomial& a, const ModularPolynomial& b,
                                 const ModularPolynomial& f) {
  if (a.empty() || b.empty()) return {};
  ModularPolynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return remainder(std::move(c), f);
}

ModularPolynomial power_modulo(ModularPolynomial base, std::uint64_t exponent,
                               const ModularPolynomial& f) {
  ModularPolynomial result{Modular(1)};
  base = remainder(std::move(base), f);
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = product_modulo(result, base, f);
    base = product_modulo(base, base, f);
  }
  return remainder(std::move(result), f);
}

ModularPolynomial common_divisor(ModularPolynomial a, ModularPolynomial b) {
  while (!b.empty()) a = std::exchange(b, remainder(std::move(a), b));
  return a;
}

/// a less `value` at the exponent.
ModularPolynomial less(ModularPolynomial a, std::size_t exponent) {
  if (a.size() <= exponent) a.resize(exponent + 1);
  a[exponent] -= Modular(1);
  trim(a);
  return a;
}

/// The shortest recurrence of a sequence (Berlekamp, Massey), as a polynomial that it annihilates.
ModularPolynomial recurrence(const std::vector<Modular>& s) {
  ModularPolynomial c{Modular(1)};
  ModularPolynomial previous{Modular(1)};
  std::size_t length = 0;
  std::size_t gap = 1;
  Modular last = 1;
  for (std::size_t n = 0; n < s.size(); ++n) {
    Modular discrepancy = s[n];
    for (std::size_t i = 1; i <= length && i < c.size(); ++i) discrepancy += c[i] * s[n - i];
    if (discrepancy == Modular(0)) {
      ++gap;
      continue;
    }
    const ModularPolynomial kept = c;
    const Modular factor = discrepancy / last;
    if (c.size() < previous.size() + gap) c.resize(previous.size() + gap);
    for (std::size_t i = 0; i < previous.size(); ++i) c[i + gap] -= factor * previous[i];
    if (2 * length > n) {
      ++gap;
      continue;
    }
    length = n + 1 - length;
    previous = kept;
    last = discrepancy;
    gap = 1;
  }
  c.resize(length + 1);
  return {c.rbegin(), c.rend()};
}

/// The minimal polynomial of the matrix, for all but few starts (Wiedemann).
ModularPolynomial minimal_polynomial(const FieldMatrix<Modular>& a) {
  FieldVector<Modular> x;
  FieldVector<Modular> weights;
  std::uint64_t state = 88172645463325252ULL;
  const auto next = [&] {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return Modular(state);
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    x.push_back(next());
    weights.push_back(next());
  }
  std::vector<Modular> sequence;
  for (std::size_t i = 0; i < 2 * a.size() + 2; ++i) {
    Modular sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) sum += weights[j] * x[j];
    sequence.push_back(sum);
    x = product(a, x);
  }
  return recurrence(sequence);
}

/// f / part, which leaves nothing over.
ModularPolynomial quotient_of(ModularPolynomial f, const ModularPolynomial& part) {
  ModularPolynomial quotient(f.size() - part.size() + 1);
  const Modular lead = part.back().inverse();
  for (std::size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = f[i + part.size() - 1] * lead;
    for (std::size_t j = 0; j < part.size(); ++j) f[i + j] -= quotient[i] * part[j];
  }
  return quotient;
}

/// Roots of f, a product of different linear factors.
void collect_roots(const ModularPolynomial& f, int most, std::uint64_t shift,
                   std::vector<Modular>& roots) {
  constexpr std::uint64_t kMostShifts = 64;
  if (f.size() < 2 || static_cast<int>(roots.size()) >= most) return;
  if (f.size() == 2) {
    roots.push_back(Modular(0) - f[0] / f[1]);
    return;
  }
  for (; shift < kMostShifts; ++shift) {
    // half of all numbers are squares
    const ModularPolynomial half =
        less(power_modulo({Modular(shift), Modular(1)}, (Modular::kPrime - 1) / 2, f), 0);
    const ModularPolynomial part = common_divisor(f, half);
    if (part.size() < 2 || part.size() == f.size()) continue;
    collect_roots(part, most, shift + 1, roots);
    if (static_cast<int>(roots.size()) >= most) return;
    const ModularPolynomial quotient = quotient_of(f, part);
    collect_roots(quotient, most, shift + 1, roots);
    return;
  }
}

}  // namespace

std::vector<Modular> eigenvalues_in_field(const FieldMatrix<Modular>& a, int most) {
  const ModularPolynomial f = minimal_polynomial(a);
  std::vector<Modular> roots;
  if (f.size() < 2) return roots;
  const ModularPolynomial linear =
      common_divisor(f, less(power_modulo({Modular(0), Modular(1)}, Modular::kPrime, f), 1));
  collect_roots(linear, most, 1, roots);
  return roots;
}

}  // namespace limn::regular
