#include "limn/certify/all/range_proof.h"

#include <algorithm>
#include <cmath>

#include "limn/certify/all/turn_range.h"
#include "limn/certify/blocks/valence_balls.h"

namespace limn::certify {
namespace {

number::Ball dot(const std::vector<number::Ball>& a, const std::vector<number::Ball>& b) {
  number::Ball sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add_product(a[i], b[i]);
  return sum;
}

std::vector<number::Ball> times(const number::BallMatrix& a, const std::vector<number::Ball>& x) {
  std::vector<number::Ball> result(a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j)
      if (!a(i, j).is_exactly_zero()) result[i].add_product(a(i, j), x[j]);
  return result;
}

number::BallMatrix part(const number::BallMatrix& a, const std::vector<std::size_t>& rows) {
  number::BallMatrix result(rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) result(i, j) = a(rows[i], rows[j]);
  return result;
}

/// Rows of the orbits' imaginary parts: of frequency 1.
std::vector<bool> imaginary_rows(const RealBasis& basis) {
  std::vector<bool> result(basis.orbits.size(), false);
  for (const RealOrbit& orbit : basis.orbits)
    if (orbit.imaginary != orbit.real) result[orbit.imaginary] = true;
  return result;
}

}  // namespace

number::Ball interval_ball(const Rational& begin, const Rational& end) {
  return number::Ball::hull(number::Ball(begin), number::Ball(end));
}

number::BallMatrix transposed(const number::BallMatrix& a) {
  number::BallMatrix result(a.columns(), a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) result(j, i) = a(i, j);
  return result;
}

Result<IntervalBlocks> IntervalBlocks::make(const RangeRules& rules, const Rational& begin,
                                            const Rational& end) {
  IntervalBlocks blocks(rules);
  blocks.t_ = interval_ball(begin, end);
  blocks.w_ = number::Ball(4) * number::Ball::pi() * number::Ball::pi() *
              interval_ball(begin * begin, end * end);
  blocks.turns_ = turns_of(blocks.w_);
  const ValenceRange range(blocks.t_);
  const Result<NamedValues<PowerBall>> first = rules.values(1);
  if (!first) return first.error();
  const Result<NamedValues<PowerBall>> zeroth = rules.values(0);
  if (!zeroth) return zeroth.error();
  blocks.tangent_ = rules.block(*first, blocks.turns_);
  blocks.whole_constant_ = rules.constant_block(*zeroth);
  const std::size_t size = blocks.whole_constant_.rows();
  number::BallMatrix whole(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) whole(i, j) = blocks.whole_constant_(i, j).ball();
  blocks.constant_ = without_one(whole, rules.basis());
  return blocks;
}

Result<number::BallMatrix> IntervalBlocks::special(int frequency) const {
  const ValenceRange range(t_);
  const Result<NamedValues<PowerBall>> values = rules_->values(frequency);
  if (!values) return values.error();
  return rules_->block(*values, turns_of(w_ * number::Ball(frequency * frequency)));
}

bool IntervalBlocks::has_gap() const {
  return rules_->basis().has_center && rules_->has_same_weights();
}

std::vector<std::size_t> IntervalBlocks::rows(bool real) const {
  const std::vector<bool> imaginary = imaginary_rows(rules_->basis());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < imaginary.size(); ++i)
    if (imaginary[i] != real) result.push_back(i);
  return result;
}

number::BallMatrix IntervalBlocks::cup_transposed() const {
  return transposed(part(constant_, rows(true)));
}

number::BallMatrix IntervalBlocks::odd() const { return part(constant_, rows(false)); }

number::Ball IntervalBlocks::cup_gap(const EnclosedPair& left, const EnclosedPair& tangent) const {
  const ValenceRange range(t_);
  const Result<NamedValues<PowerBall>> values = rules_->values(1);
  if (!values) return number::Ball(std::nan(""));
  // off the centre A - B is w · loss, less the centre's row; all of it is over t^power here
  const number::BallMatrix loss = rules_->block(*values, turn_losses_of(w_));
  const std::vector<number::Ball> lost = times(loss, tangent.vector);
  const std::vector<std::size_t> real = rows(true);
  int power = 2;
  for (const std::size_t j : real)
    if (const PowerBall& weight = whole_constant_(0, j + 1); !weight.is_zero())
      power = std::min(power, weight.power());
  number::Ball of_center;
  for (const std::size_t j : real)
    of_center.add_product(whole_constant_(0, j + 1).over(power), tangent.vector[j]);
  number::Ball w_over = number::Ball(4) * number::Ball::pi() * number::Ball::pi();
  for (int i = power; i < 2; ++i) w_over *= t_;
  number::Ball above, below;
  for (std::size_t i = 0; i < real.size(); ++i) {
    above.add_product(left.vector[i], w_over * lost[real[i]] - of_center);
    below.add_product(left.vector[i], tangent.vector[real[i]]);
  }
  return -above / below;
}

Result<TurnBlocks> turn_blocks(const RangeRules& rules, const Rational& begin,
                               const Rational& end) {
  const Result<NamedValues<PowerBall>> values = rules.values(rules.last_special() + 1);
  if (!values) return values.error();
  const number::Ball w = number::Ball::pi() * number::Ball::pi() * interval_ball(begin, end);
  return TurnBlocks{rules.block(*values, turns_of(w)), rules.block(*values, turn_slopes_of(w))};
}

number::Ball eigenvalue_slope(const TurnBlocks& blocks, const EnclosedPair& right,
                              const EnclosedPair& left) {
  return dot(left.vector, times(blocks.slope, right.vector)) / dot(left.vector, right.vector);
}

IntervalRing::IntervalRing(const CellMatrices& cells, const CellSigns& signs,
                           const RangeRules& rules, const IntervalBlocks& blocks,
                           const EnclosedPair& pair)
    : signs_(signs),
      net_(cells, rules.basis(), pair, blocks.turns()),
      // a quarter of a sector from the side where the angle is 0: the spoke, or the diagonal
      middle_(blocks.turns()(cells.dual ? 1 : -1, 4)) {}

Result<CellMap> IntervalRing::map_on(LatticeVector cell) { return signs_.map_on(net_, cell); }

std::optional<IntervalRing::Signs> IntervalRing::signs_on(const CellMap& map) const {
  const number::Ball jacobian = signs_.jacobian(map);
  if (jacobian.holds_zero() || !jacobian.is_finite()) return std::nullopt;
  const NetPoint at = signs_.values(map);
  const number::Ball along = at.u * middle_.cosine - at.v * middle_.to_real;
  if (along.holds_zero() || !along.is_finite()) return std::nullopt;
  return Signs{jacobian.is_positive(), along.is_positive()};
}

bool IntervalRing::agrees(const CellMap& map) {
  const std::optional<Signs> signs = signs_on(map);
  if (!signs) return false;
  if (!found_) found_ = signs;
  return *found_ == *signs;
}

}  // namespace limn::certify
