#include "limn/certify/power_ball.h"

#include <algorithm>

#include "limn/certify/turn_range.h"

namespace limn::certify {
namespace {

thread_local Ball range = Ball::between(0, 1);

Ball power_of_t(int power) {
  Ball result(1);
  for (int i = 0; i < power; ++i) result *= ValenceRange::t();
  return result;
}

}  // namespace

ValenceRange::ValenceRange(Ball t) : outer_(range) { range = std::move(t); }
ValenceRange::~ValenceRange() { range = std::move(outer_); }
const Ball& ValenceRange::t() { return range; }

PowerBall PowerBall::known(int power, Ball factor, bool constant) {
  PowerBall result(power, std::move(factor));
  result.constant_ = constant;
  if (result.factor_.is_exactly_zero()) result.power_ = 0;
  return result;
}

Ball PowerBall::over(int power) const {
  if (factor_.is_exactly_zero()) return {};
  const int left = power_ - power;
  return left >= 0 ? factor_ * power_of_t(left) : factor_ / power_of_t(-left);
}

PowerBall operator+(const PowerBall& a, const PowerBall& b) {
  const bool constant = a.constant_ && b.constant_;
  if (a.factor_.is_exactly_zero()) return PowerBall::known(b.power_, b.factor_, constant);
  if (b.factor_.is_exactly_zero()) return PowerBall::known(a.power_, a.factor_, constant);
  const int power = std::min(a.power_, b.power_);
  return PowerBall::known(power, a.over(power) + b.over(power), constant);
}

PowerBall operator-(const PowerBall& a, const PowerBall& b) {
  return a + PowerBall::known(b.power_, -b.factor_, b.constant_);
}

PowerBall operator*(const PowerBall& a, const PowerBall& b) {
  return PowerBall::known(a.power_ + b.power_, a.factor_ * b.factor_, a.constant_ && b.constant_);
}

PowerBall operator/(const PowerBall& a, const PowerBall& b) {
  return PowerBall::known(a.power_ - b.power_, a.factor_ / b.factor_, a.constant_ && b.constant_);
}

}  // namespace limn::certify

namespace limn {

using certify::PowerBall;

Result<PowerBall> Arithmetic<PowerBall>::finite(PowerBall a) {
  if (!a.factor_.is_finite())
    return Error{"the number cannot be enclosed for all these valences: a division by what may be 0"};
  return a;
}

Result<PowerBall> Arithmetic<PowerBall>::divide(const PowerBall& a, const PowerBall& b) {
  if (b.factor_.is_exactly_zero()) return Error{"division by zero"};
  return finite(a / b);
}

Result<PowerBall> Arithmetic<PowerBall>::cos(const PowerBall& a) {
  if (a.power_ < 0) return Error{"the cosine of an angle that grows with n cannot be enclosed"};
  return PowerBall::known(0, limn::cos(a.ball()), a.constant_);
}

Result<PowerBall> Arithmetic<PowerBall>::sin(const PowerBall& a) {
  if (a.power_ < 0) return Error{"the sine of an angle that grows with n cannot be enclosed"};
  if (a.power_ == 0) return PowerBall::known(0, limn::sin(a.ball()), a.constant_);
  const Ball angle = a.ball();
  return PowerBall::known(a.power_, a.factor_ * certify::enclose_sinc(angle * angle), a.constant_);
}

Result<PowerBall> Arithmetic<PowerBall>::sqrt(const PowerBall& a) {
  if (a.factor_.is_negative()) return Error{"square root of a negative number"};
  const int half = a.power_ >= 0 ? a.power_ / 2 : -((1 - a.power_) / 2);
  return finite(PowerBall::known(half, limn::sqrt(a.over(2 * half)), a.constant_));
}

Result<long long> Arithmetic<PowerBall>::integer(const PowerBall& a) {
  const std::optional<long long> whole = a.power_ == 0 ? a.factor_.integer() : std::nullopt;
  if (!whole) return Error{"an integer is needed here, the same for all these valences"};
  return *whole;
}

}  // namespace limn
