#include "limn/base/rational.h"

#include <ostream>
#include <utility>

#include "limn/base/exact_access.h"

namespace limn {

using base::in;

Integer::Integer() noexcept { new (digits_) base::Digits(); }
Integer::Integer(double value) { new (digits_) base::Digits(value); }
Integer::Integer(const std::string& digits) { new (digits_) base::Digits(digits); }
Integer::Integer(const Integer& other) { new (digits_) base::Digits(in(other)); }
Integer::Integer(Integer&& other) noexcept { new (digits_) base::Digits(std::move(in(other))); }
Integer::~Integer() { std::destroy_at(&in(*this)); }

void Integer::set(long long value) noexcept { new (digits_) base::Digits(value); }
void Integer::set(unsigned long long value) noexcept { new (digits_) base::Digits(value); }

Integer& Integer::operator=(const Integer& other) {
  if (this != &other) in(*this) = in(other);
  return *this;
}
Integer& Integer::operator=(Integer&& other) noexcept {
  in(*this) = std::move(in(other));
  return *this;
}

Integer& Integer::operator+=(const Integer& b) {
  in(*this) += in(b);
  return *this;
}
Integer& Integer::operator-=(const Integer& b) {
  in(*this) -= in(b);
  return *this;
}
Integer& Integer::operator*=(const Integer& b) {
  in(*this) *= in(b);
  return *this;
}
Integer& Integer::operator/=(const Integer& b) {
  in(*this) /= in(b);
  return *this;
}
Integer& Integer::operator%=(const Integer& b) {
  in(*this) %= in(b);
  return *this;
}
Integer& Integer::operator<<=(unsigned bits) {
  in(*this) <<= bits;
  return *this;
}
Integer Integer::operator-() const {
  Integer result(*this);
  in(result).backend().negate();
  return result;
}

int Integer::compare(const Integer& b) const { return in(*this).compare(in(b)); }
int Integer::sign() const { return in(*this).sign(); }
std::string Integer::str() const { return in(*this).str(); }

template <class T>
T Integer::convert_to() const {
  return in(*this).convert_to<T>();
}
template int Integer::convert_to() const;
template long long Integer::convert_to() const;
template unsigned long Integer::convert_to() const;
template unsigned long long Integer::convert_to() const;
template double Integer::convert_to() const;

Integer gcd(const Integer& a, const Integer& b) {
  return base::integer(boost::multiprecision::gcd(in(a), in(b)));
}
Integer lcm(const Integer& a, const Integer& b) {
  return base::integer(boost::multiprecision::lcm(in(a), in(b)));
}
Integer pow(const Integer& a, unsigned exponent) {
  return base::integer(boost::multiprecision::pow(in(a), exponent));
}
Integer sqrt(const Integer& a) { return base::integer(boost::multiprecision::sqrt(in(a))); }
std::size_t msb(const Integer& a) { return boost::multiprecision::msb(in(a)); }
std::ostream& operator<<(std::ostream& out, const Integer& a) { return out << a.str(); }

}  // namespace limn
