#include "limn/number/laurent.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace limn {
namespace {

void add_to(Laurent& a, Exponents at, const Rational& value) {
  const auto [entry, fresh] = a.try_emplace(at, value);
  if (!fresh) entry->second += value;
  if (entry->second == 0) a.erase(entry);
}

}  // namespace

Laurent product(const Laurent& a, const Laurent& b) {
  Laurent result;
  for (const auto& [p, x] : a)
    for (const auto& [q, y] : b) add_to(result, {p[0] + q[0], p[1] + q[1]}, x * y);
  return result;
}

Laurent power(const Laurent& a, int exponent) {
  Laurent result{{{0, 0}, Rational(1)}};
  for (int i = 0; i < exponent; ++i) result = product(result, a);
  return result;
}

Laurent scaled(const Laurent& a, const Rational& factor) {
  Laurent result = a;
  for (auto& [exponents, value] : result) value *= factor;
  return result;
}

Laurent reflected(const Laurent& a) {
  Laurent result;
  for (const auto& [exponents, value] : a) result[{-exponents[0], -exponents[1]}] = value;
  return result;
}

Rational total(const Laurent& a) {
  Rational sum = 0;
  for (const auto& [exponents, value] : a) sum += value;
  return sum;
}

Laurent centred_box(Exponents step, int count) {
  Laurent box;
  for (int i = 0; i < count; ++i) {
    const int way = 2 * i - count + 1;
    box[{way * step[0], way * step[1]}] = 1;
  }
  return box;
}

std::optional<Laurent> divided_by_box(const Laurent& a, Exponents step, int count) {
  // Each line along `step` is a polynomial in one variable. The least term that is left of a line
  // fixes the quotient's next term, until that would reach beyond every term of a.
  if (step < Exponents{0, 0}) step = {-step[0], -step[1]};
  const auto along = [&](Exponents e) { return e[0] * step[0] + e[1] * step[1]; };
  int farthest = std::numeric_limits<int>::min();
  for (const auto& [exponents, value] : a) farthest = std::max(farthest, along(exponents));
  Laurent rest = a;
  Laurent quotient;
  while (!rest.empty()) {
    const auto [least, value] = *rest.begin();
    const int last = 2 * (count - 1);
    if (along({least[0] + last * step[0], least[1] + last * step[1]}) > farthest)
      return std::nullopt;
    quotient.emplace(Exponents{least[0] + last / 2 * step[0], least[1] + last / 2 * step[1]},
                     value);
    for (int i = 0; i <= last; i += 2)
      add_to(rest, {least[0] + i * step[0], least[1] + i * step[1]}, -value);
  }
  return quotient;
}

}  // namespace limn
