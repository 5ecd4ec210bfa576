#include "limn/certify/all/power_ball.h"

#include <algorithm>

#include "limn/certify/all/turn_range.h"

namespace limn::certify {
namespace {

thread_local number::Ball range = number::Ball::between(0, 1);

constexpr int kNever = 1 << 20;  // the step of a number whose `rest` is 0

number::Ball power_of_t(int power) {
  number::Ball result(1);
  for (int i = 0; i < power; ++i) result *= ValenceRange::t();
  return result;
}

}  // namespace

ValenceRange::ValenceRange(number::Ball t) : outer_(range) { range = std::move(t); }
ValenceRange::~ValenceRange() { range = std::move(outer_); }
const number::Ball& ValenceRange::t() { return range; }

PowerBall::PowerBall(const Rational& value)
    : factor_(value), head_(Head{value, kNever, number::Ball(0)}) {}

PowerBall::PowerBall(int power, number::Ball factor, std::optional<Head> head, bool constant)
    : power_(power), factor_(std::move(factor)), head_(std::move(head)), constant_(constant) {
  if (head_ && head_->value == 0 && !head_->rest.is_exactly_zero()) {
    power_ += head_->step;
    factor_ = head_->rest;
    head_.reset();
  } else if (factor_.is_exactly_zero() || (head_ && head_->value == 0)) {
    *this = PowerBall();
    constant_ = constant;
  }
}

PowerBall PowerBall::valence() {
  return {-1, number::Ball(1), Head{Rational(1), kNever, number::Ball(0)}, false};
}

number::Ball PowerBall::Head::with_step(int other) const {
  return rest.is_exactly_zero() ? rest : rest * power_of_t(step - other);
}

std::optional<PowerBall::Head> PowerBall::head_over(int power) const {
  if (power < power_) return Head{Rational(0), power_ - power, factor_};
  return head_;
}

number::Ball PowerBall::over(int power) const {
  if (is_zero()) return {};
  const int left = power_ - power;
  return left >= 0 ? factor_ * power_of_t(left) : factor_ / power_of_t(-left);
}

PowerBall operator+(const PowerBall& a, const PowerBall& b) {
  const bool constant = a.constant_ && b.constant_;
  if (a.is_zero()) return {b.power_, b.factor_, b.head_, constant};
  if (b.is_zero()) return {a.power_, a.factor_, a.head_, constant};
  const int power = std::min(a.power_, b.power_);
  const auto first = a.head_over(power);
  const auto second = b.head_over(power);
  std::optional<PowerBall::Head> head;
  if (first && second) {
    const int step = std::min(first->step, second->step);
    head = {first->value + second->value, step, first->with_step(step) + second->with_step(step)};
  }
  return {power, a.over(power) + b.over(power), head, constant};
}

PowerBall operator-(const PowerBall& a, const PowerBall& b) { return a + PowerBall(-1) * b; }

PowerBall operator*(const PowerBall& a, const PowerBall& b) {
  std::optional<PowerBall::Head> head;
  if (a.head_ && b.head_) {
    const int step = std::min(a.head_->step, b.head_->step);
    const number::Ball first = a.head_->with_step(step);
    head = {a.head_->value * b.head_->value, step,
            first * b.factor_ + number::Ball(a.head_->value) * b.head_->with_step(step)};
  }
  return {a.power_ + b.power_, a.factor_ * b.factor_, head, a.constant_ && b.constant_};
}

PowerBall operator/(const PowerBall& a, const PowerBall& b) {
  std::optional<PowerBall::Head> head;
  if (a.head_ && b.head_ && b.head_->value != 0) {
    const int step = std::min(a.head_->step, b.head_->step);
    const Rational value = a.head_->value / b.head_->value;
    head = {
        value, step,
        (a.head_->with_step(step) - number::Ball(value) * b.head_->with_step(step)) / b.factor_};
  }
  return {a.power_ - b.power_, a.factor_ / b.factor_, head, a.constant_ && b.constant_};
}

}  // namespace limn::certify

namespace limn::number {

using certify::PowerBall;

Result<PowerBall> Arithmetic<PowerBall>::finite(PowerBall a) {
  if (!a.factor_.is_finite())
    return Error{
        "the number cannot be enclosed for all these valences: a division by what may be 0"};
  return a;
}

Result<PowerBall> Arithmetic<PowerBall>::divide(const PowerBall& a, const PowerBall& b) {
  if (b.factor_.is_exactly_zero()) return Error{"division by zero"};
  return finite(a / b);
}

Result<PowerBall> Arithmetic<PowerBall>::cos(const PowerBall& a) {
  if (a.power_ < 0) return Error{"the cosine of an angle that grows with n cannot be enclosed"};
  if (a.is_zero()) return PowerBall(1);
  if (a.power_ == 0) return PowerBall(0, number::cos(a.ball()), std::nullopt, a.constant_);
  const Ball angle = a.ball();
  const Ball half = a.factor_ * certify::enclose_sinc(angle * angle / Ball(4));
  const Ball loss = half * half / Ball(2);  // 1 - cos α = α²/2 · sinc²(α/2)
  return PowerBall(0, certify::enclose_cosine(angle * angle),
                   PowerBall::Head{Rational(1), 2 * a.power_, -loss}, a.constant_);
}

Result<PowerBall> Arithmetic<PowerBall>::sin(const PowerBall& a) {
  if (a.power_ < 0) return Error{"the sine of an angle that grows with n cannot be enclosed"};
  if (a.is_zero()) return PowerBall(0);
  if (a.power_ == 0) return PowerBall(0, number::sin(a.ball()), std::nullopt, a.constant_);
  const Ball angle = a.ball();
  return PowerBall(a.power_, a.factor_ * certify::enclose_sinc(angle * angle), std::nullopt,
                   a.constant_);
}

Result<PowerBall> Arithmetic<PowerBall>::sqrt(const PowerBall& a) {
  if (a.factor_.is_negative()) return Error{"square root of a negative number"};
  const int half = a.power_ >= 0 ? a.power_ / 2 : -((1 - a.power_) / 2);
  return finite(PowerBall(half, number::sqrt(a.over(2 * half)), std::nullopt, a.constant_));
}

Result<long long> Arithmetic<PowerBall>::integer(const PowerBall& a) {
  const std::optional<long long> whole = a.power_ == 0 ? a.factor_.integer() : std::nullopt;
  if (!whole) return Error{"an integer is needed here, the same for all these valences"};
  return *whole;
}

}  // namespace limn::number
