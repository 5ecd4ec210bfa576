#pragma once
/// Bisection and golden sections. Private to tune/.

#include <cmath>

namespace limn::tune {

/// The least value of f between a and b, to where f is flat in double, or the first x found with
/// f(x) < 0. f: double → double, with one minimum there. Cost: 60 values at most.
template <class Function>
double approx_minimum(double a, double b, Function f) {
  constexpr double kGolden = 0.6180339887498949;
  double left = b - kGolden * (b - a);
  double right = a + kGolden * (b - a);
  double at_left = f(left);
  double at_right = f(right);
  for (int i = 0; i < 60; ++i) {
    if (at_left < 0) return left;
    if (at_right < 0) return right;
    if (at_left < at_right) {
      b = right;
      right = left;
      at_right = at_left;
      left = b - kGolden * (b - a);
      at_left = f(left);
    } else {
      a = left;
      left = right;
      at_left = at_right;
      right = a + kGolden * (b - a);
      at_right = f(right);
    }
  }
  return at_left < at_right ? left : right;
}

/// Bisection stops here: x is of order 1, and 0 itself would take a thousand steps.
inline constexpr double kNarrowest = 1e-18;

/// The last x, from a towards b, at which `holds`: it does at a and not at b.
template <class Predicate>
double last_holding(double a, double b, Predicate holds) {
  for (;;) {
    const double middle = a + (b - a) / 2;
    if (middle == a || middle == b || std::abs(b - a) < kNarrowest) return a;
    (holds(middle) ? a : b) = middle;
  }
}

}  // namespace limn::tune
