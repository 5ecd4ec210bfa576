#include "limn/certify/blocks/valence_balls.h"

namespace limn::certify {
namespace {

/// An exact number, or that it would cost more than the ExactBudget that is open.
class Affordable {
 public:
  Affordable() = default;
  Affordable(int value) : value_(value) {}
  explicit Affordable(const Rational& value) : value_(value) {}
  explicit Affordable(number::Exact value) : value_(std::move(value)) {}
  explicit Affordable(const Result<number::Exact>& value) : failed_(!value.ok()) {
    if (value) value_ = *value;
  }
  friend Affordable operator+(const Affordable& a, const Affordable& b) {
    return sum(number::Exact::add(a.value_, b.value_), a, b);
  }
  friend Affordable operator-(const Affordable& a, const Affordable& b) {
    return sum(number::Exact::subtract(a.value_, b.value_), a, b);
  }
  friend Affordable operator*(const Affordable& a, const Affordable& b) {
    return sum(number::Exact::multiply(a.value_, b.value_), a, b);
  }
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] const number::Exact& value() const { return value_; }

 private:
  static Affordable sum(const Result<number::Exact>& value, const Affordable& a,
                        const Affordable& b) {
    Affordable result(value);
    result.failed_ = result.failed_ || a.failed_ || b.failed_;
    return result;
  }

  number::Exact value_;
  bool failed_ = false;
};

}  // namespace

number::BallMatrix without_one(const number::BallMatrix& whole, const RealBasis& basis) {
  EnclosedPair one{number::Ball(1), {}, 0};
  for (const int entry : constant_vector(basis)) one.vector.emplace_back(entry);
  return deflated(whole, one);
}

Result<ValenceBalls> ValenceBalls::make(const Scheme& scheme, int n) {
  Result<spectrum::SectorPattern> pattern = exact_pattern(scheme, n);
  if (!pattern) return pattern.error();
  ValenceBalls balls;
  balls.n_ = n;
  balls.pattern_ = std::move(*pattern);
  balls.basis_ = real_basis(balls.pattern_);
  Result<NamedValues<number::Ball>> values = named_values<number::Ball>(scheme, balls.pattern_, n);
  if (!values) return values.error();
  balls.values_ = std::move(*values);
  return balls;
}

Phase<number::Ball> ValenceBalls::phase(int frequency) const {
  return [frequency, n = n_](int numerator, int denominator) {
    const number::Ball angle = number::Ball(2) * number::Ball::pi() *
                               number::Ball(Rational(Integer(frequency) * Integer(numerator),
                                                     Integer(denominator) * Integer(n)));
    return std::pair{number::cos(angle), number::sin(angle)};
  };
}

number::BallMatrix ValenceBalls::whole_block(int frequency) const {
  const Phase<number::Ball> at = phase(frequency);
  return RealBlock<number::Ball>(pattern_, basis_, values_, at, frequency == 0).make();
}

number::BallMatrix ValenceBalls::block(int frequency) const {
  number::BallMatrix whole = whole_block(frequency);
  if (frequency > 0) return whole;
  return without_one(whole, basis_);
}

ValenceBalls::WholeVector ValenceBalls::whole_vector(int frequency,
                                                     const EnclosedPair& pair) const {
  if (frequency > 0) return {number::Ball(0), pair};
  const number::BallMatrix whole = whole_block(0);
  number::Ball first;  // row 0: first + Σ a_j y_j = λ first, rows summing to 1
  for (std::size_t j = 0; j < pair.vector.size(); ++j)
    first.add_product(whole(0, j + 1), pair.vector[j]);
  first /= pair.value - number::Ball(1);
  const std::vector<int> ones = constant_vector(basis_);
  WholeVector result{number::Ball(0), {pair.value, {first}, pair.pivot + 1}};
  for (std::size_t j = 0; j < pair.vector.size(); ++j)
    result.pair.vector.push_back(pair.vector[j] + number::Ball(ones[j + 1]) * first);
  if (!basis_.has_center) return result;
  result.center = first;
  result.pair.vector.erase(result.pair.vector.begin());
  --result.pair.pivot;
  return result;
}

Result<number::DenseMatrix<number::Exact>> ValenceBalls::exact_block(const Scheme& scheme,
                                                                     int frequency) const {
  const Result<NamedValues<number::Exact>> found =
      named_values<number::Exact>(scheme, pattern_, n_);
  if (!found) return found.error();
  NamedValues<Affordable> values{Affordable(found->n), {}};
  for (const std::vector<number::Exact>& list : found->values) {
    values.values.emplace_back();
    for (const number::Exact& value : list) values.values.back().emplace_back(value);
  }
  const Phase<Affordable> at = [&](int numerator, int denominator) {
    const number::Exact angle =
        number::Exact::pi() * number::Exact(Rational(Integer(2 * frequency) * Integer(numerator),
                                                     Integer(denominator) * Integer(n_)));
    return std::pair{Affordable(number::Exact::cos(angle)), Affordable(number::Exact::sin(angle))};
  };
  const number::DenseMatrix<Affordable> block =
      RealBlock<Affordable>(pattern_, basis_, values, at, frequency == 0).make();
  number::DenseMatrix<number::Exact> result(block.rows(), block.rows());
  for (std::size_t i = 0; i < block.rows(); ++i)
    for (std::size_t j = 0; j < block.rows(); ++j) {
      if (block(i, j).failed()) return Error{"exact numbers that would be too large"};
      result(i, j) = block(i, j).value();
    }
  return result;
}

Result<number::DenseMatrix<number::Exact>> ValenceBalls::exact_rest(const Scheme& scheme,
                                                                    int frequency) const {
  Result<number::DenseMatrix<number::Exact>> block = exact_block(scheme, frequency);
  if (!block || frequency > 0) return block;
  const std::vector<int> ones = constant_vector(basis_);
  number::DenseMatrix<number::Exact> rest(block->rows() - 1, block->rows() - 1);
  for (std::size_t i = 0; i < rest.rows(); ++i)
    for (std::size_t j = 0; j < rest.rows(); ++j) {
      rest(i, j) = (*block)(i + 1, j + 1);
      if (ones[i + 1] != 0) rest(i, j) += number::Exact(-1) * (*block)(0, j + 1);
    }
  return rest;
}

std::vector<int> squarings_of_others(const ValenceBalls& balls, int leader_frequency,
                                     const EnclosedPair& leader, const number::Ball& bound,
                                     int most_squarings) {
  std::vector<int> result;
  for (int frequency = 0; frequency <= balls.valence() / 2; ++frequency) {
    number::BallMatrix block = balls.block(frequency);
    if (frequency == leader_frequency) block = deflated(block, leader);
    result.push_back(squarings_below(block, bound, most_squarings).value_or(-1));
  }
  return result;
}

}  // namespace limn::certify
