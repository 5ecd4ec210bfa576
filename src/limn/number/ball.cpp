#if LIMN_HAS_ARB

#include "limn/number/ball.h"

#include <arb.h>

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace limn::number {
namespace {

thread_local int precision = 128;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

struct Ball::Access {
  static arb_ptr of(Ball& a) { return std::launder(reinterpret_cast<arb_ptr>(a.parts_)); }
  static arb_srcptr of(const Ball& a) {
    return std::launder(reinterpret_cast<arb_srcptr>(a.parts_));
  }
};

static_assert(sizeof(arb_struct) <= 48 && alignof(arb_struct) <= 8);

BallPrecision::BallPrecision(int bits) : outer_(precision) { precision = bits; }
BallPrecision::~BallPrecision() { precision = outer_; }

Ball::Ball() noexcept { arb_init(new (parts_) arb_struct); }
Ball::Ball(int value) noexcept : Ball() { arb_set_si(Access::of(*this), value); }
Ball::Ball(double value) noexcept : Ball() {
  if (std::isnan(value))
    arb_zero_pm_inf(Access::of(*this));
  else
    arb_set_d(Access::of(*this), value);
}

Ball::Ball(const Rational& value) : Ball() {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_str(fraction, value.str().c_str(), 10);
  arb_set_fmpq(Access::of(*this), fraction, precision);
  fmpq_clear(fraction);
}

Ball::Ball(const Ball& other) : Ball() { arb_set(Access::of(*this), Access::of(other)); }
Ball::Ball(Ball&& other) noexcept : Ball() { arb_swap(Access::of(*this), Access::of(other)); }
Ball& Ball::operator=(const Ball& other) {
  if (this != &other) arb_set(Access::of(*this), Access::of(other));
  return *this;
}
Ball& Ball::operator=(Ball&& other) noexcept {
  arb_swap(Access::of(*this), Access::of(other));
  return *this;
}
Ball::~Ball() { arb_clear(Access::of(*this)); }

bool Ball::is_available() { return true; }

Ball Ball::pi() {
  Ball result;
  arb_const_pi(Access::of(result), precision);
  return result;
}

Ball Ball::between(double low, double high) { return hull(Ball(low), Ball(high)); }

Ball Ball::hull(const Ball& a, const Ball& b) {
  Ball result;
  arb_union(Access::of(result), Access::of(a), Access::of(b), precision);
  return result;
}

Ball& Ball::operator+=(const Ball& b) {
  arb_add(Access::of(*this), Access::of(*this), Access::of(b), precision);
  return *this;
}
Ball& Ball::operator-=(const Ball& b) {
  arb_sub(Access::of(*this), Access::of(*this), Access::of(b), precision);
  return *this;
}
Ball& Ball::operator*=(const Ball& b) {
  arb_mul(Access::of(*this), Access::of(*this), Access::of(b), precision);
  return *this;
}
Ball& Ball::operator/=(const Ball& b) {
  if (b.holds_zero())
    arb_zero_pm_inf(Access::of(*this));
  else
    arb_div(Access::of(*this), Access::of(*this), Access::of(b), precision);
  return *this;
}
Ball& Ball::add_product(const Ball& a, const Ball& b) {
  arb_addmul(Access::of(*this), Access::of(a), Access::of(b), precision);
  return *this;
}
Ball Ball::operator-() const {
  Ball result;
  arb_neg(Access::of(result), Access::of(*this));
  return result;
}

bool Ball::is_exactly_zero() const { return arb_is_zero(Access::of(*this)) != 0; }
bool Ball::is_finite() const { return arb_is_finite(Access::of(*this)) != 0; }
bool Ball::holds_zero() const { return arb_contains_zero(Access::of(*this)) != 0; }
bool Ball::is_positive() const { return arb_is_positive(Access::of(*this)) != 0; }
bool Ball::is_negative() const { return arb_is_negative(Access::of(*this)) != 0; }
bool is_less(const Ball& a, const Ball& b) {
  return arb_lt(Ball::Access::of(a), Ball::Access::of(b)) != 0;
}
bool Ball::is_strictly_inside(const Ball& outer) const {
  return arb_contains_interior(Access::of(outer), Access::of(*this)) != 0;
}
bool Ball::overlaps(const Ball& other) const {
  return arb_overlaps(Access::of(*this), Access::of(other)) != 0;
}

double Ball::approx() const { return arf_get_d(arb_midref(Access::of(*this)), ARF_RND_NEAR); }
double Ball::lower() const {
  if (!is_finite()) return -kInfinity;
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, Access::of(*this), 64);
  const double result = arf_get_d(end, ARF_RND_FLOOR);
  arf_clear(end);
  return result;
}
double Ball::upper() const {
  if (!is_finite()) return kInfinity;
  arf_t end;
  arf_init(end);
  arb_get_ubound_arf(end, Access::of(*this), 64);
  const double result = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return result;
}
Ball Ball::middle() const {
  Ball result;
  arb_get_mid_arb(Access::of(result), Access::of(*this));
  return result;
}
double Ball::radius() const { return mag_get_d(arb_radref(Access::of(*this))); }

Ball Ball::widened(double more) const {
  Ball result(*this);
  mag_t extra;
  mag_init(extra);
  mag_set_d(extra, more);
  arb_add_error_mag(Access::of(result), extra);
  mag_clear(extra);
  return result;
}

Ball Ball::magnitude() const {
  Ball result;
  arb_abs(Access::of(result), Access::of(*this));
  if (holds_zero()) {  // arb_abs keeps the negative side
    const double high = std::max(upper(), -lower());
    if (std::isfinite(high)) return between(0, high);
  }
  return result;
}

std::optional<long long> Ball::integer() const {
  if (arb_is_int(Access::of(*this)) == 0 || !(std::abs(approx()) < 1e15)) return std::nullopt;
  return std::llround(approx());
}

std::string Ball::to_string(int digits) const {
  char* printed = arb_get_str(Access::of(*this), digits, 0);
  std::string result(printed);
  flint_free(printed);
  return result;
}

Ball cos(const Ball& a) {
  Ball result;
  arb_cos(Ball::Access::of(result), Ball::Access::of(a), precision);
  return result;
}
Ball sin(const Ball& a) {
  Ball result;
  arb_sin(Ball::Access::of(result), Ball::Access::of(a), precision);
  return result;
}
Ball sqrt(const Ball& a) {
  Ball result;
  arb_sqrt(Ball::Access::of(result), Ball::Access::of(a), precision);
  if (!result.is_finite()) arb_zero_pm_inf(Ball::Access::of(result));
  return result;
}

BallMatrix product(const BallMatrix& a, const BallMatrix& b) {
  BallMatrix result(a.rows(), b.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t k = 0; k < a.columns(); ++k) {
      if (a(i, k).is_exactly_zero()) continue;
      for (std::size_t j = 0; j < b.columns(); ++j)
        if (!b(k, j).is_exactly_zero()) result(i, j).add_product(a(i, k), b(k, j));
    }
  return result;
}

double row_norm(const BallMatrix& a) {
  double largest = 0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    Ball sum;
    for (std::size_t j = 0; j < a.columns(); ++j) sum += a(i, j).magnitude();
    largest = std::max(largest, sum.upper());
  }
  return largest;
}

}  // namespace limn::number

#endif
