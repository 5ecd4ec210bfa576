#pragma once
/// What a number type must offer so that a weight expression can be evaluated in it. A new
/// number (a jet, a ball) is one specialisation of `Arithmetic`; the evaluator in
/// scheme/expression.h is written once, and tests/scheme/expression_conformance_test.cpp runs
/// over every specialisation.
///
/// Operations that can fail return a Result whose message says why (and no place: the
/// evaluator adds it).

#include <cmath>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/number/exact.h"

namespace limn::number {

template <class Number>
struct Arithmetic;

template <>
struct Arithmetic<double> {
  static double from(const Rational& q) { return to_double(q); }
  static double pi() { return M_PI; }
  static Result<double> add(double a, double b) { return finite(a + b); }
  static Result<double> subtract(double a, double b) { return finite(a - b); }
  static Result<double> multiply(double a, double b) { return finite(a * b); }
  static Result<double> divide(double a, double b) {
    if (b == 0) return Error{"division by zero"};
    return finite(a / b);
  }
  static Result<double> cos(double a) { return std::cos(a); }
  static Result<double> sin(double a) { return std::sin(a); }
  static Result<double> sqrt(double a) {
    if (a < 0) return Error{"square root of a negative number"};
    return std::sqrt(a);
  }
  /// -1, 0, 1
  static Result<int> sign(double a) { return a < 0 ? -1 : a > 0 ? 1 : 0; }
  /// The value as an integer, where it is one (double: to within 1e-9).
  static Result<long long> integer(double a) {
    const double rounded = std::nearbyint(a);
    if (!(std::abs(a - rounded) < 1e-9) || std::abs(a) > 1e15)
      return Error{"an integer is needed here"};
    return static_cast<long long>(rounded);
  }
  static double approx(double a) { return a; }

 private:
  static Result<double> finite(double a) {
    if (!std::isfinite(a)) return Error{"the number is too large"};
    return a;
  }
};

template <>
struct Arithmetic<Exact> {
  static Exact from(const Rational& q) { return {q}; }
  static Exact pi() { return Exact::pi(); }
  static Result<Exact> add(const Exact& a, const Exact& b) { return Exact::add(a, b); }
  static Result<Exact> subtract(const Exact& a, const Exact& b) { return Exact::subtract(a, b); }
  static Result<Exact> multiply(const Exact& a, const Exact& b) { return Exact::multiply(a, b); }
  static Result<Exact> divide(const Exact& a, const Exact& b) { return Exact::divide(a, b); }
  static Result<Exact> cos(const Exact& a) { return Exact::cos(a); }
  static Result<Exact> sin(const Exact& a) { return Exact::sin(a); }
  static Result<Exact> sqrt(const Exact& a) { return Exact::sqrt(a); }
  static Result<int> sign(const Exact& a) {
    if (a.is_zero()) return 0;
    if (a.is_rational()) return a.rational() < 0 ? -1 : 1;
    const double approx = a.approx();
    if (!(std::abs(approx) > 1e-9 * a.magnitude()))
      return Error{"cannot decide the sign of a number this close to 0"};
    return approx < 0 ? -1 : 1;
  }
  static Result<long long> integer(const Exact& a) {
    if (!a.is_rational() || !limn::is_integer(a.rational()) ||
        abs(a.rational()) > Rational(1'000'000'000'000'000LL))
      return Error{"an integer is needed here"};
    return numerator(a.rational()).convert_to<long long>();
  }
  static double approx(const Exact& a) { return a.approx(); }
};

}  // namespace limn::number
