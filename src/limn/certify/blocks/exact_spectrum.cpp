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

Ball enclosed(const Exact& value) {
  return Ball(value.approx()).widened(1e-12 * value.magnitude());
}

std::optional<Exact> exact_leader(const DenseMatrix<Exact>& block, const EnclosedPair& leader) {
  for (Size i = 0; i < block.rows(); ++i) {
    bool alone = true;
    for (Size j = 0; j < block.rows(); ++j) alone = alone && (i == j || block(i, j).is_zero());
    // the leader is simple and no other comes near it
    if (alone && enclosed(block(i, i)).overlaps(leader.value)) return block(i, i);
  }
  const std::optional<Rational> fraction = near_rational(leader.value.approx(), 1e-13, 10'000);
  if (fraction && Ball(*fraction).overlaps(leader.value)) return Exact(*fraction);
  return std::nullopt;
}

bool add_product(Exact& to, const Exact& a, const Exact& b) {
  if (a.is_zero() || b.is_zero()) return true;
  const Result<Exact> product = Exact::multiply(a, b);
  const Result<Exact> sum = product ? Exact::add(to, *product) : product;
  if (sum) to = *sum;
  return sum.ok();
}

std::optional<std::vector<std::vector<Exact>>> null_space(DenseMatrix<Exact> a,
                                                          const Exact& value) {
  const Size size = a.rows();
  for (Size i = 0; i < size; ++i) a(i, i) += Exact(-1) * value;
  std::vector<Size> pivots;
  for (Size column = 0; column < size && pivots.size() < size; ++column) {
    Size row = pivots.size();
    while (row < size && a(row, column).is_zero()) ++row;
    if (row == size) continue;
    const Size to = pivots.size();
    const Exact pivot = a(row, column);
    // an Exact that is 0 but is not known to be so divides nothing
    if (enclosed(pivot).holds_zero()) return std::nullopt;
    for (Size j = 0; j < size; ++j) {
      std::swap(a(row, j), a(to, j));
      const Result<Exact> quotient = Exact::divide(a(to, j), pivot);
      if (!quotient) return std::nullopt;
      a(to, j) = *quotient;
    }
    for (Size i = 0; i < size; ++i) {
      if (i == to || a(i, column).is_zero()) continue;
      const Exact factor = Exact(-1) * a(i, column);
      for (Size j = 0; j < size; ++j)
        if (!add_product(a(i, j), factor, a(to, j))) return std::nullopt;
    }
    pivots.push_back(column);
  }
  std::vector<std::vector<Exact>> basis;
  for (Size free = 0; free < size; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    std::vector<Exact>& vector = basis.emplace_back(size);
    vector[free] = Exact(1);
    for (Size i = 0; i < pivots.size(); ++i) vector[pivots[i]] = Exact(-1) * a(i, free);
  }
  return basis;
}

std::string exact_tie(const Scheme& scheme, const ValenceBalls& balls, double value) {
  // double precision knows one that is not simple to few digits
  const std::optional<Rational> fraction = near_rational(value, 1e-7);
  if (!fraction) return {};
  std::size_t count = 0;
  std::string frequencies;
  for (int frequency = 0; frequency <= balls.valence() / 2; ++frequency) {
    const ExactBudget budget(kTieWork);
    const Result<DenseMatrix<Exact>> block = balls.exact_rest(scheme, frequency);
    const auto vectors = block ? null_space(*block, Exact(*fraction)) : std::nullopt;
    if (!vectors || vectors->empty()) continue;
    count += vectors->size();
    frequencies += fmt::format("{}{}", frequencies.empty() ? "" : ", ", frequency);
  }
  if (count < 2) return {};
  return fmt::format("{} exactly, with {} eigenvectors in the blocks of frequencies {}",
                     to_string(*fraction), count, frequencies);
}

}  // namespace limn::certify
