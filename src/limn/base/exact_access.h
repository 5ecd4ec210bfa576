#pragma once
/// What lives in an Integer and in a Rational. For integer.cpp and rational.cpp alone.

#include <boost/multiprecision/cpp_int.hpp>
#include <new>

#include "limn/base/rational.h"

namespace limn::base {

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                             boost::multiprecision::et_off>;
using Fraction = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
    boost::multiprecision::et_off>;

struct ExactAccess {
  static_assert(sizeof(Digits) <= sizeof(Integer));
  static_assert(alignof(Digits) <= alignof(Integer));
  static_assert(sizeof(Fraction) <= sizeof(Rational));
  static_assert(alignof(Fraction) <= alignof(Rational));

  static void* place(Integer& a) { return a.digits_; }
  static void* place(Rational& a) { return a.parts_; }
  static Digits& of(Integer& a) { return *std::launder(reinterpret_cast<Digits*>(a.digits_)); }
  static const Digits& of(const Integer& a) {
    return *std::launder(reinterpret_cast<const Digits*>(a.digits_));
  }
  static Fraction& of(Rational& a) { return *std::launder(reinterpret_cast<Fraction*>(a.parts_)); }
  static const Fraction& of(const Rational& a) {
    return *std::launder(reinterpret_cast<const Fraction*>(a.parts_));
  }
};

/// @{
/// What lives in it.
inline Digits& in(Integer& a) { return ExactAccess::of(a); }
inline const Digits& in(const Integer& a) { return ExactAccess::of(a); }
inline Fraction& in(Rational& q) { return ExactAccess::of(q); }
inline const Fraction& in(const Rational& q) { return ExactAccess::of(q); }
/// @}

inline Integer integer(Digits digits) {
  Integer result;
  ExactAccess::of(result) = std::move(digits);
  return result;
}

}  // namespace limn::base
