#include "limn/regular/smoothness/transition_operators.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>

namespace limn::regular {
namespace {

constexpr std::size_t kMostPoints = 400;

using Points = std::set<LatticeVector>;

/// Where T_ε v can differ from 0, for some ε, if v can at these points.
Points carried(const Laurent& a, const LatticeMatrix& dilation,
               const std::vector<LatticeVector>& digits, const Points& points) {
  Points image;
  for (const LatticeVector l : points)
    for (const auto& [k, value] : a)
      for (const LatticeVector e : digits)
        if (const auto i = dilation.divide({k[0] + l[0] - e[0], k[1] + l[1] - e[1]}))
          image.insert(*i);
  return image;
}

/// The set that holds all late images of `start` and is its own image.
Points carried_forever(const Laurent& a, const LatticeMatrix& dilation,
                       const std::vector<LatticeVector>& digits, const Points& start) {
  Points all = start;
  while (all.size() <= 4 * kMostPoints) {
    Points more = carried(a, dilation, digits, all);
    const std::size_t before = all.size();
    all.merge(more);
    if (all.size() == before) break;
  }
  for (;;) {
    Points image = carried(a, dilation, digits, all);
    if (image == all || image.size() > 4 * kMostPoints) return image;
    all = std::move(image);
  }
}

/// The differences of one order fill a triangle of points; put down where it leads to fewest
/// points.
Points smallest_support(const Laurent& a, const LatticeMatrix& dilation,
                        const std::vector<LatticeVector>& digits, int order) {
  Points best;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      Points start;
      for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j) start.insert({x + i, y + j});
      Points support = carried_forever(a, dilation, digits, start);
      if (best.empty() || support.size() < best.size()) best = std::move(support);
    }
  return best;
}

/// Sequences on the points that are orthogonal to the polynomials of degree < order.
Echelon<Rational> differences_on(const std::vector<LatticeVector>& points, int order) {
  Echelon<Rational> polynomials(points.size());
  for (int i = 0; i < order; ++i)
    for (int j = 0; i + j < order; ++j) {
      FieldVector<Rational> values;
      for (const LatticeVector k : points) {
        Rational value = 1;
        for (int n = 0; n < i; ++n) value *= k[0];
        for (int n = 0; n < j; ++n) value *= k[1];
        values.push_back(value);
      }
      polynomials.insert(values);
    }
  return annihilator(polynomials);
}

RationalMatrix matrix_on(const std::vector<LatticeVector>& points, const Laurent& a,
                         const LatticeMatrix& dilation, LatticeVector digit) {
  RationalMatrix matrix;
  for (const LatticeVector i : points) {
    const LatticeVector image = dilation.apply(i);
    matrix.emplace_back();
    for (const LatticeVector l : points) {
      const auto entry = a.find({digit[0] + image[0] - l[0], digit[1] + image[1] - l[1]});
      matrix.back().push_back(entry == a.end() ? Rational(0) : entry->second);
    }
  }
  return matrix;
}

}  // namespace

Laurent integer_offsets(const Mask& mask) {
  Laurent result;
  for (const auto& [k, value] : mask.coefficients) {
    const auto whole = [](int doubled) { return (doubled - (doubled & 1)) / 2; };
    result[{whole(k[0]), whole(k[1])}] = value;
  }
  return result;
}

Laurent transition(const Laurent& a, const LatticeMatrix& dilation, LatticeVector digit,
                   const Laurent& v) {
  Laurent result;
  for (const auto& [l, value] : v)
    for (const auto& [k, weight] : a)
      if (const auto i = dilation.divide({k[0] + l[0] - digit[0], k[1] + l[1] - digit[1]}))
        result[*i] += weight * value;
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

std::vector<Laurent> unit_differences(const std::vector<LatticeVector>& directions, int order,
                                      int most_alike) {
  if (order == 0) return {{{{0, 0}, Rational(1)}}};
  if (directions.empty()) return {};
  const Laurent step{{{0, 0}, Rational(1)}, {directions.front(), Rational(-1)}};
  std::vector<Laurent> powers{{{{0, 0}, Rational(1)}}};
  for (int k = 1; k <= std::min(order, most_alike); ++k)
    powers.push_back(product(step, powers.back()));
  std::vector<Laurent> list;
  const std::vector<LatticeVector> others(directions.begin() + 1, directions.end());
  for (std::size_t k = powers.size(); k-- > 0;)
    for (const Laurent& rest : unit_differences(others, order - static_cast<int>(k), most_alike))
      list.push_back(product(powers[k], rest));
  return list;
}

Result<TransitionOperators> transition_operators(const Mask& mask, int order) {
  const Laurent a = integer_offsets(mask);
  TransitionOperators operators;
  operators.digits = cosets(mask.dilation);
  const Points support = smallest_support(a, mask.dilation, operators.digits, order);
  if (support.size() > kMostPoints)
    return Error{
        fmt::format("the mask is too wide for a regularity analysis: more than {} "
                    "control points would have to be followed",
                    kMostPoints)};
  operators.support.assign(support.begin(), support.end());
  const Echelon<Rational> differences = differences_on(operators.support, order);
  for (const LatticeVector digit : operators.digits) {
    const RationalMatrix whole = matrix_on(operators.support, a, mask.dilation, digit);
    RationalMatrix& columns = operators.on_differences.emplace_back();
    for (const FieldVector<Rational>& row : differences.rows()) {
      const FieldVector<Rational> image = product(whole, row);
      if (!differences.contains(image))
        return Error{
            fmt::format("differences of order {} of the refined data do not follow from "
                        "those of the control data: the mask's sum rules are of lower order",
                        order)};
      columns.emplace_back();
      for (const std::size_t pivot : differences.pivots()) columns.back().push_back(image[pivot]);
    }
    columns = transposed(columns);
  }
  return operators;
}

}  // namespace limn::regular
