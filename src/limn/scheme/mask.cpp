#include "limn/scheme/mask.h"

#include <fmt/core.h>

namespace limn {
namespace {

using Offset = std::array<int, 2>;
using Polynomial = std::map<Offset, Rational>;  // offsets from an arbitrary origin

constexpr int kMostFactors = 64;

Error at(const Place& place, std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint), place.file, place.line, place.column};
}

Result<Rational> rational_value(const Scheme& scheme, const Formula& formula) {
  Result<Exact> value = Scope<Exact>(scheme, std::nullopt, std::nullopt)(formula);
  if (!value) return value.error();
  if (!value->is_rational())
    return at(formula.place, "a mask's coefficient must be rational at the regular lattice");
  return value->rational();
}

Result<int> count_value(const Scheme& scheme, const Formula& formula) {
  Result<Rational> value = rational_value(scheme, formula);
  if (!value) return value.error();
  if (!is_integer(*value) || *value < 0 || *value > kMostFactors)
    return at(formula.place, fmt::format("a count must be an integer from 0 to {}, found {}",
                                         kMostFactors, to_string(*value)));
  return value->convert_to<int>();
}

/// Rows into coefficients by twice the offset from the centre; all of one parity, or an error.
Result<Polynomial> polynomial_from_rows(const Scheme& scheme, const Rows& rows) {
  Rational scale = 1;
  if (rows.scale) {
    Result<Rational> value = rational_value(scheme, *rows.scale);
    if (!value) return value.error();
    scale = *value;
  }
  const bool triangles = scheme.split->lattice == Lattice::triangle;
  const int height = static_cast<int>(rows.rows.size());
  Polynomial result;
  for (int r = 0; r < height; ++r) {
    const auto& row = rows.rows[static_cast<std::size_t>(r)];
    const int width = static_cast<int>(row.size());
    for (int i = 0; i < width; ++i) {
      const int y = height - 1 - 2 * r;
      const int x = 2 * i - (width - 1);
      // on triangles e2 leans back by half an edge: Cartesian x = a - b/2
      if (triangles && (y % 2 != 0 || (x + y / 2) % 2 != 0))
        return at(rows.place, fmt::format("row {} of the mask, with {} coefficients, does not lie "
                                          "on the triangle lattice",
                                          r + 1, width),
                  "a hexagon has an odd number of rows, each one longer or shorter than the next");
      const Formula& entry = row[static_cast<std::size_t>(i)];
      Result<Rational> value = rational_value(scheme, entry);
      if (!value) return value.error();
      if (*value != 0) result[{triangles ? x + y / 2 : x, y}] = *value * scale;
    }
  }
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [p, x] : a)
    for (const auto& [q, y] : b) result[{p[0] + q[0], p[1] + q[1]}] += x * y;
  return result;
}

/// a·(1 + z^step)/2, centred: in doubled offsets the two terms lie at ±step.
Polynomial smoothed(const Polynomial& a, Offset step) {
  const Rational half(1, 2);
  return product(a, {{step, half}, {{-step[0], -step[1]}, half}});
}

/// The parity of the first coefficient must be that of all, and what the split needs.
Result<Mask> checked(const Scheme& scheme, Polynomial polynomial, const Place& place) {
  if (scheme.split->growth != 4)
    return at(place, fmt::format("a {} scheme cannot be given by a mask yet", scheme.split->name),
              "write its rules");
  const int parity = scheme.split->births_corners ? 1 : 0;
  std::array<Rational, 4> cosets;
  Mask mask{scheme.split->lattice, {}};
  for (auto& [offset, value] : polynomial) {
    if (value == 0) continue;
    const auto wrong = [&](int i) { return ((i % 2) + 2) % 2 != parity; };
    if (wrong(offset[0]) || wrong(offset[1]))
      return at(place, fmt::format("the mask's centre does not fit the split {}",
                                   scheme.split->name),
                "primal splits need a coefficient at the centre, dual ones none");
    const auto coset = [&](int i) { return (((offset[static_cast<std::size_t>(i)] - parity) / 2) % 2 + 2) % 2; };
    cosets[static_cast<std::size_t>(2 * coset(0) + coset(1))] += value;
    mask.coefficients.emplace(offset, std::move(value));
  }
  for (const Rational& sum : cosets)
    if (sum != 1)
      return at(place, fmt::format("the coefficients of a coset of the mask sum to {}, not 1",
                                   to_string(sum)),
                "each coset makes one kind of new point; its weights must sum to 1");
  return mask;
}

}  // namespace

Result<Mask> mask_from_rows(const Scheme& scheme, const Rows& rows) {
  Result<Polynomial> polynomial = polynomial_from_rows(scheme, rows);
  if (!polynomial) return polynomial.error();
  return checked(scheme, std::move(*polynomial), rows.place);
}

Result<Mask> mask_from_factors(const Scheme& scheme, const Factors& factors) {
  std::vector<std::pair<Offset, int>> directions;
  if (factors.stages) {
    const Result<int> stages = count_value(scheme, *factors.stages);
    if (!stages) return stages.error();
    directions = {{{1, 0}, *stages}, {{0, 1}, *stages}};
    if (scheme.split->lattice == Lattice::triangle) directions.push_back({{1, 1}, *stages});
  }
  for (const auto& [step, formula] : factors.directions) {
    const Result<int> count = count_value(scheme, formula);
    if (!count) return count.error();
    directions.push_back({step, *count});
  }
  Polynomial polynomial{{{0, 0}, Rational(4)}};
  for (const auto& [step, count] : directions)
    for (int i = 0; i < count; ++i) polynomial = smoothed(polynomial, step);
  if (factors.kernel) {
    Result<Polynomial> kernel = polynomial_from_rows(scheme, *factors.kernel);
    if (!kernel) return kernel.error();
    polynomial = product(polynomial, *kernel);
  }
  return checked(scheme, std::move(polynomial), factors.place);
}

}  // namespace limn
