#pragma once
/// Exact rationals of any size. A literal in a scheme file is one; so is everything that
/// is computed exactly from it.

#include <boost/multiprecision/cpp_int.hpp>
#include <string>

namespace limn {

/// An integer of any size.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;
/// An exact fraction, in lowest terms. Cost of an operation: grows with the digits, a microsecond
/// or less for short ones. Its arithmetic is Boost.Multiprecision's (operators, numerator,
/// denominator).
using Rational = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
    boost::multiprecision::et_off>;

/// The nearest double (to within one unit in the last place).
[[nodiscard]] inline double to_double(const Rational& q) {
  const Integer above = boost::multiprecision::numerator(q);
  const Integer below = boost::multiprecision::denominator(q);
  // The general conversion works in long numbers, four times slower.
  const Integer exact_as_double = 1LL << 53;
  if (abs(above) <= exact_as_double && below <= exact_as_double)
    return above.convert_to<double>() / below.convert_to<double>();
  return q.convert_to<double>();
}

/// "3", "-7/24".
[[nodiscard]] inline std::string to_string(const Rational& q) { return q.str(); }

/// Whether the denominator is 1.
[[nodiscard]] inline bool is_integer(const Rational& q) {
  return boost::multiprecision::denominator(q) == 1;
}

}  // namespace limn
