#include "limn/base/rational.h"

#include <ostream>
#include <stdexcept>
#include <utility>

#include "limn/base/exact_access.h"

namespace limn {

using base::in;

Rational::Rational() noexcept { new (parts_) base::Fraction(); }
Rational::Rational(const Integer& value) { new (parts_) base::Fraction(in(value)); }
Rational::Rational(const Integer& numerator, const Integer& denominator) {
  const int sign = denominator.sign();
  if (sign == 0) throw std::overflow_error("a fraction whose denominator is 0");
  if (sign > 0)
    new (parts_) base::Fraction(in(numerator), in(denominator));
  else  // which Boost refuses
    new (parts_) base::Fraction(in(-numerator), in(-denominator));
}
Rational::Rational(double value) { new (parts_) base::Fraction(value); }
Rational::Rational(const std::string& text) { new (parts_) base::Fraction(text); }
Rational::Rational(const Rational& other) { new (parts_) base::Fraction(in(other)); }
Rational::Rational(Rational&& other) noexcept { new (parts_) base::Fraction(std::move(in(other))); }
Rational::~Rational() { std::destroy_at(&in(*this)); }

Rational& Rational::operator=(const Rational& other) {
  if (this != &other) in(*this) = in(other);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  in(*this) = std::move(in(other));
  return *this;
}

Rational& Rational::operator+=(const Rational& b) {
  in(*this) += in(b);
  return *this;
}
Rational& Rational::operator-=(const Rational& b) {
  in(*this) -= in(b);
  return *this;
}
Rational& Rational::operator*=(const Rational& b) {
  in(*this) *= in(b);
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  in(*this) /= in(b);
  return *this;
}
Rational Rational::operator-() const {
  Rational result(*this);
  in(result).backend().negate();
  return result;
}

bool Rational::equals(const Rational& b) const { return in(*this) == in(b); }
int Rational::compare(const Rational& b) const { return in(*this).compare(in(b)); }
int Rational::compare(long long b) const { return in(*this).compare(b); }
Rational::operator double() const { return in(*this).convert_to<double>(); }
int Rational::sign() const { return in(*this).sign(); }
std::string Rational::str() const { return in(*this).str(); }

Integer numerator(const Rational& q) {
  return base::integer(boost::multiprecision::numerator(in(q)));
}
Integer denominator(const Rational& q) {
  return base::integer(boost::multiprecision::denominator(in(q)));
}
std::ostream& operator<<(std::ostream& out, const Rational& q) { return out << q.str(); }

double to_double(const Rational& q) {
  const base::Digits above = boost::multiprecision::numerator(in(q));
  const base::Digits below = boost::multiprecision::denominator(in(q));
  // The general conversion works in long numbers, four times slower.
  const base::Digits exact_as_double = 1LL << 53;
  if (abs(above) <= exact_as_double && below <= exact_as_double)
    return above.convert_to<double>() / below.convert_to<double>();
  return in(q).convert_to<double>();
}

bool is_integer(const Rational& q) { return boost::multiprecision::denominator(in(q)) == 1; }

}  // namespace limn
