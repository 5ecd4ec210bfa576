#include "limn/certify/blocks/exact_spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/number/near_rational.h"

namespace limn::certify {
namespace {

using Size = std::size_t;

constexpr double kTieWork = 3e6;  // for one frequency: some tenths of a second

}  // namespace

number::Ball enclosed(const number::Exact& value) {
  return number::Ball(value.approx()).widened(1e-12 * value.magnitude());
}

std::optional<number::Exact> exact_leader(const number::DenseMatrix<number::Exact>& block,
                                          const EnclosedPair& leader) {
  for (Size i = 0; i < block.rows(); ++i) {
    bool alone = true;
    for (Size j = 0; j < block.rows(); ++j) alone = alone && (i == j || block(i, j).is_zero());
    // the leader is simple and no other comes near it
    if (alone && enclosed(block(i, i)).overlaps(leader.value)) return block(i, i);
  }
  const std::optional<Rational> fraction =
      number::near_rational(leader.value.approx(), 1e-13, 10'000);
  if (fraction && number::Ball(*fraction).overlaps(leader.value)) return number::Exact(*fraction);
  return std::nullopt;
}

bool add_product(number::Exact& to, const number::Exact& a, const number::Exact& b) {
  if (a.is_zero() || b.is_zero()) return true;
  const Result<number::Exact> product = number::Exact::multiply(a, b);
  const Result<number::Exact> sum = product ? number::Exact::add(to, *product) : product;
  if (sum) to = *sum;
  return sum.ok();
}

std::optional<std::vector<std::vector<number::Exact>>> null_space(
    number::DenseMatrix<number::Exact> a, const number::Exact& value) {
  const Size size = a.rows();
  for (Size i = 0; i < size; ++i) a(i, i) += number::Exact(-1) * value;
  std::vector<Size> pivots;
  for (Size column = 0; column < size && pivots.size() < size; ++column) {
    Size row = pivots.size();
    while (row < size && a(row, column).is_zero()) ++row;
    if (row == size) continue;
    const Size to = pivots.size();
    const number::Exact pivot = a(row, column);
    // an Exact that is 0 but is not known to be so divides nothing
    if (enclosed(pivot).holds_zero()) return std::nullopt;
    for (Size j = 0; j < size; ++j) {
      std::swap(a(row, j), a(to, j));
      const Result<number::Exact> quotient = number::Exact::divide(a(to, j), pivot);
      if (!quotient) return std::nullopt;
      a(to, j) = *quotient;
    }
    for (Size i = 0; i < size; ++i) {
      if (i == to || a(i, column).is_zero()) continue;
      const number::Exact factor = number::Exact(-1) * a(i, column);
      for (Size j = 0; j < size; ++j)
        if (!add_product(a(i, j), factor, a(to, j))) return std::nullopt;
    }
    pivots.push_back(column);
  }
  std::vector<std::vector<number::Exact>> basis;
  for (Size free = 0; free < size; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    std::vector<number::Exact>& vector = basis.emplace_back(size);
    vector[free] = number::Exact(1);
    for (Size i = 0; i < pivots.size(); ++i) vector[pivots[i]] = number::Exact(-1) * a(i, free);
  }
  return basis;
}

std::string exact_tie(const Scheme& scheme, const ValenceBalls& balls, double value) {
  // double precision knows one that is not simple to few digits
  const std::optional<Rational> fraction = number::near_rational(value, 1e-7);
  if (!fraction) return {};
  std::size_t count = 0;
  std::string frequencies;
  for (int frequency = 0; frequency <= balls.valence() / 2; ++frequency) {
    const number::ExactBudget budget(kTieWork);
    const Result<number::DenseMatrix<number::Exact>> block = balls.exact_rest(scheme, frequency);
    const auto vectors = block ? null_space(*block, number::Exact(*fraction)) : std::nullopt;
    if (!vectors || vectors->empty()) continue;
    count += vectors->size();
    frequencies += fmt::format("{}{}", frequencies.empty() ? "" : ", ", frequency);
  }
  if (count < 2) return {};
  return fmt::format("{} exactly, with {} eigenvectors in the blocks of frequencies {}",
                     to_string(*fraction), count, frequencies);
}

}  // namespace limn::certify
