#include "limn/scheme/mask.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace limn {
namespace {

using Offset = std::array<int, 2>;
using Polynomial = std::map<Offset, Rational>;  // offsets from an arbitrary origin

constexpr int kMostFactors = 64;
constexpr int kLargestReach = 24;  // of a mask, in refined edges; bounds the lattices it is read on

Error at(const Place& place, std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint), place.file, place.line, place.column};
}

Result<Rational> rational_value(const Scheme& scheme, const Formula& formula) {
  Result<Exact> value = Scope<Exact>(scheme, std::nullopt, std::nullopt)(formula);
  if (!value) return value.error();
  if (!value->is_rational())
    return at(formula.place, fmt::format("a mask needs rational numbers, found {} = {:.6g}",
                                         formula.expression.text(), value->approx()));
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

Error too_far(const Place& place) {
  return at(place, fmt::format("the mask reaches farther than {} refined edges from its centre",
                               kLargestReach));
}

Status check_dyadic(const Scheme& scheme, const Place& place) {
  if (scheme.split->growth == 4) return Done{};
  return at(place, fmt::format("a {} scheme cannot be given by a mask yet", scheme.split->name),
            "write its rules");
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
  if (height > 2 * kLargestReach + 1) return too_far(rows.place);
  Polynomial result;
  for (int r = 0; r < height; ++r) {
    const auto& row = rows.rows[static_cast<std::size_t>(r)];
    if (row.size() > 2 * kLargestReach + 1) return too_far(rows.place);
    const int width = static_cast<int>(row.size());
    for (int i = 0; i < width; ++i) {
      const int y = height - 1 - 2 * r;
      const int x = 2 * i - (width - 1);
      // on triangles e2 leans back by half an edge: Cartesian x = a - b/2
      if (triangles && (y % 2 != 0 || (x + y / 2) % 2 != 0))
        return at(rows.place,
                  fmt::format("row {} of the mask, with {} coefficients, does not lie "
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

/// What a coset's new points are; `x`, `y`: whether the offset in the refined lattice is odd.
std::string_view points_of_coset(const Scheme& scheme, int x, int y) {
  if (scheme.split->births_corners) return "of one corner";
  if (x == 0 && y == 0) return "at the vertices";
  if (y == 0) return "on the edges along (1, 0)";
  if (x == 0) return "on the edges along (0, 1)";
  return scheme.split->births_faces ? "of the faces" : "on the edges along (1, 1)";
}

Status check_cosets(const Scheme& scheme, const Mask& mask, const Place& place) {
  const int parity = scheme.split->births_corners ? 1 : 0;
  const auto odd = [parity](int doubled) { return std::abs((doubled - parity) / 2 % 2); };
  std::array<Rational, 4> sums;
  for (const auto& [offset, value] : mask.coefficients)
    sums[static_cast<std::size_t>(2 * odd(offset[0]) + odd(offset[1]))] += value;
  for (int i = 0; i < 4; ++i)
    if (const Rational& sum = sums[static_cast<std::size_t>(i)]; sum != 1)
      return at(place,
                fmt::format("the mask's coefficients for the new points {} sum to {}, not 1",
                            points_of_coset(scheme, i / 2, i % 2), to_string(sum)),
                "a coset of the mask, every second coefficient of every second row, makes one "
                "kind of new point");
  return Done{};
}

/// All offsets must have the parity that the split needs, and each coset must sum to 1.
Result<Mask> checked(const Scheme& scheme, Polynomial polynomial, const Place& place) {
  const int parity = scheme.split->births_corners ? 1 : 0;
  const auto fits = [parity](int doubled) { return std::abs(doubled % 2) == parity; };
  const auto far = [](int doubled) { return std::abs(doubled) > 2 * kLargestReach; };
  Mask mask{scheme.split->lattice, {}};
  for (auto& [offset, value] : polynomial) {
    if (value == 0) continue;
    const auto [x, y] = offset;
    if (!fits(x) || !fits(y))
      return at(place,
                fmt::format("the mask's centre does not fit the split {}", scheme.split->name),
                parity == 0 ? "a primal split needs a coefficient at the centre: an odd number of "
                              "rows, the middle one of odd length"
                            : "a dual split needs none at the centre: an even number of rows, of "
                              "even length");
    if (far(x) || far(y)) return too_far(place);
    mask.coefficients.emplace(offset, std::move(value));
  }
  if (Status status = check_cosets(scheme, mask, place); !status) return status.error();
  return mask;
}

/// The longest way that the directions take from the centre, in refined edges along an axis.
int reach(const std::vector<std::pair<Offset, int>>& directions) {
  int x = 0;
  int y = 0;
  for (const auto& [step, count] : directions) {
    x += std::abs(step[0]) * count;
    y += std::abs(step[1]) * count;
    if (std::max(x, y) > 2 * kLargestReach) break;
  }
  return std::max(x, y) / 2;
}

}  // namespace

Result<Mask> mask_from_rows(const Scheme& scheme, const Rows& rows) {
  if (Status status = check_dyadic(scheme, rows.place); !status) return status.error();
  Result<Polynomial> polynomial = polynomial_from_rows(scheme, rows);
  if (!polynomial) return polynomial.error();
  return checked(scheme, std::move(*polynomial), rows.place);
}

Result<Mask> mask_from_factors(const Scheme& scheme, const Factors& factors) {
  if (Status status = check_dyadic(scheme, factors.place); !status) return status.error();
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
  if (reach(directions) > kLargestReach) return too_far(factors.place);
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
