#if !LIMN_HAS_ARB

// Without Arb every ball is the whole line: all that is said of it is true, and nothing is proved.

#include <cmath>
#include <limits>

#include "limn/number/ball.h"

namespace limn::number {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

BallPrecision::BallPrecision(int) : outer_(0) {}
BallPrecision::~BallPrecision() = default;

bool Ball::is_available() { return false; }
Ball::Ball() noexcept : parts_{} {}
Ball::Ball(int) noexcept : parts_{} {}
Ball::Ball(double) noexcept : parts_{} {}
Ball::Ball(const Rational&) : parts_{} {}
Ball::Ball(const Ball&) = default;
Ball::Ball(Ball&&) noexcept = default;
Ball& Ball::operator=(const Ball&) = default;
Ball& Ball::operator=(Ball&&) noexcept = default;
Ball::~Ball() = default;

Ball Ball::pi() { return {}; }
Ball Ball::between(double, double) { return {}; }
Ball Ball::hull(const Ball&, const Ball&) { return {}; }
Ball& Ball::operator+=(const Ball&) { return *this; }
Ball& Ball::operator-=(const Ball&) { return *this; }
Ball& Ball::operator*=(const Ball&) { return *this; }
Ball& Ball::operator/=(const Ball&) { return *this; }
Ball& Ball::add_product(const Ball&, const Ball&) { return *this; }
Ball Ball::operator-() const { return {}; }
bool Ball::is_exactly_zero() const { return false; }
bool Ball::is_finite() const { return false; }
bool Ball::holds_zero() const { return true; }
bool Ball::is_positive() const { return false; }
bool Ball::is_negative() const { return false; }
bool is_less(const Ball&, const Ball&) { return false; }
bool Ball::is_strictly_inside(const Ball&) const { return false; }
bool Ball::overlaps(const Ball&) const { return true; }
double Ball::approx() const { return std::numeric_limits<double>::quiet_NaN(); }
double Ball::lower() const { return -kInfinity; }
double Ball::upper() const { return kInfinity; }
Ball Ball::middle() const { return {}; }
double Ball::radius() const { return kInfinity; }
Ball Ball::widened(double) const { return {}; }
Ball Ball::magnitude() const { return {}; }
std::optional<long long> Ball::integer() const { return std::nullopt; }
std::string Ball::to_string(int) const { return "unknown"; }
Ball cos(const Ball&) { return {}; }
Ball sin(const Ball&) { return {}; }
Ball sqrt(const Ball&) { return {}; }
BallMatrix product(const BallMatrix& a, const BallMatrix& b) { return {a.rows(), b.columns()}; }
double row_norm(const BallMatrix&) { return kInfinity; }

}  // namespace limn::number

#endif
