#include "limn/scheme/mask.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "limn/scheme/mask_rules.h"
#include "limn/scheme/scope.h"

namespace limn {
namespace {

constexpr int kMostFactors = 64;
constexpr int kLargestReach = 24;  // of a mask, in refined edges; bounds the lattices it is read on

Error at(const Place& place, std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint), place.file, place.line, place.column};
}

Result<Rational> rational_value(const Scheme& scheme, const Formula& formula) {
  Result<number::Exact> value =
      scheme::Scope<number::Exact>(scheme, std::nullopt, std::nullopt)(formula);
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
  return numerator(*value).convert_to<int>();
}

Error too_far(const Place& place) {
  return at(place, fmt::format("the mask reaches farther than {} refined edges from its centre",
                               kLargestReach));
}

/// Rows into coefficients by twice the offset from the centre; all of one parity, or an error.
Result<Laurent> polynomial_from_rows(const Scheme& scheme, const Rows& rows) {
  Rational scale = 1;
  if (rows.scale) {
    Result<Rational> value = rational_value(scheme, *rows.scale);
    if (!value) return value.error();
    scale = *value;
  }
  const bool triangles = scheme.split->lattice == Lattice::triangle;
  const int height = static_cast<int>(rows.rows.size());
  if (height > 2 * kLargestReach + 1) return too_far(rows.place);
  Laurent result;
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

/// What the new points of a coset are, by one of its members.
std::string points_of_coset(const Scheme& scheme, LatticeVector member) {
  const auto [x, y] = member;
  const Split& split = *scheme.split;
  if (split.is_dual()) return split.births.corners ? "of one corner" : "on one kind of edge";
  if (x == 0 && y == 0) return "at the vertices";
  if (!split.births.edges)
    return split.dilation.growth() > 2 ? "of one kind of face" : "of the faces";
  const std::string ends = split.births.thirds ? ", near one of their ends" : "";
  if (y == 0) return "on the edges along (1, 0)" + ends;
  if (x == 0) return "on the edges along (0, 1)" + ends;
  if (x == y && split.lattice == Lattice::triangle) return "on the edges along (1, 1)" + ends;
  return split.births.corners ? "of one corner" : "of the faces";
}

Status check_cosets(const Scheme& scheme, const Mask& mask, const Place& place) {
  const int parity = scheme.split->is_dual() ? 1 : 0;
  const std::vector<LatticeVector> members = cosets(mask.dilation);
  std::vector<Rational> sums(members.size());
  for (const auto& [offset, value] : mask.coefficients) {
    const LatticeVector k{(offset[0] - parity) / 2, (offset[1] - parity) / 2};
    sums[static_cast<std::size_t>(coset_of(mask.dilation, k))] += value;
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] != 1)
      return at(place,
                fmt::format("the mask's coefficients for the new points {} sum to {}, not 1",
                            points_of_coset(scheme, members[i]), to_string(sums[i])),
                "a coset of the mask makes one kind of new point: in a dyadic scheme, every second "
                "coefficient of every second row (in a ternary one, every third of every third)");
  return Done{};
}

/// All offsets must have the parity that the split needs, and each coset must sum to 1.
Result<Mask> checked(const Scheme& scheme, Laurent polynomial, const Place& place) {
  const int parity = scheme.split->is_dual() ? 1 : 0;
  const auto fits = [parity](int doubled) { return std::abs(doubled % 2) == parity; };
  const auto far = [](int doubled) { return std::abs(doubled) > 2 * kLargestReach; };
  Mask mask{scheme.split->lattice, scheme.split->dilation, {}};
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
int reach(const std::vector<std::pair<LatticeVector, int>>& directions) {
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

bool interpolates(const Mask& mask) {
  return std::all_of(mask.coefficients.begin(), mask.coefficients.end(), [&](const auto& one) {
    const auto& [twice, coefficient] = one;
    if (twice == LatticeVector{0, 0}) return coefficient == 1;
    const bool between = twice[0] % 2 != 0 || twice[1] % 2 != 0;  // of a dual split
    return !between && coset_of(mask.dilation, {twice[0] / 2, twice[1] / 2}) != 0;
  });
}

Laurent scheme::smoothing_direction(LatticeVector step, const LatticeMatrix& dilation) {
  const int box = arity(dilation);
  return scaled(centred_box(step, box), Rational(1, box));
}

Result<Mask> scheme::mask_from_rows(const Scheme& scheme, const Rows& rows) {
  Result<Laurent> polynomial = polynomial_from_rows(scheme, rows);
  if (!polynomial) return polynomial.error();
  return checked(scheme, std::move(*polynomial), rows.place);
}

Result<Mask> scheme::mask_from_factors(const Scheme& scheme, const Factors& factors) {
  const Split& split = *scheme.split;
  std::vector<std::pair<LatticeVector, int>> directions;
  if (factors.stages) {
    const Result<int> stages = count_value(scheme, *factors.stages);
    if (!stages) return stages.error();
    for (const LatticeVector step : edge_directions(split.lattice))
      directions.emplace_back(step, *stages);
  }
  for (const auto& [step, formula] : factors.directions) {
    const Result<int> count = count_value(scheme, formula);
    if (!count) return count.error();
    directions.push_back({step, *count});
  }
  if (reach(directions) * (arity(split.dilation) - 1) > kLargestReach)
    return too_far(factors.place);
  Laurent polynomial{{{0, 0}, Rational(split.dilation.growth())}};
  for (const auto& [step, count] : directions) {
    const Laurent smoothing = scheme::smoothing_direction(step, split.dilation);
    for (int i = 0; i < count; ++i) polynomial = product(polynomial, smoothing);
  }
  if (factors.kernel) {
    Result<Laurent> kernel = polynomial_from_rows(scheme, *factors.kernel);
    if (!kernel) return kernel.error();
    polynomial = product(polynomial, *kernel);
  }
  return checked(scheme, std::move(polynomial), factors.place);
}

}  // namespace limn
