#include "limn/number/laurent.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace limn {
namespace {

Laurent random_laurent() {
  Laurent a;
  for (int i = *rc::gen::inRange(1, 7); i > 0; --i) {
    const int value = *rc::gen::inRange(-4, 5);
    const Exponents at{*rc::gen::inRange(-5, 6), *rc::gen::inRange(-5, 6)};
    if (value != 0) a[at] = Rational(value, *rc::gen::inRange(1, 4));
  }
  return a;
}

Exponents random_step() {
  const Exponents step{*rc::gen::inRange(-2, 3), *rc::gen::inRange(-2, 3)};
  RC_PRE(step != (Exponents{0, 0}));
  return step;
}

RC_GTEST_PROP(Laurent, DivisionUndoesMultiplication, ()) {
  const Laurent a = random_laurent();
  const Exponents step = random_step();
  const int count = *rc::gen::inRange(2, 5);
  const auto quotient = divided_by_box(product(a, centred_box(step, count)), step, count);
  RC_ASSERT(quotient.has_value());
  RC_ASSERT(*quotient == a);
}

RC_GTEST_PROP(Laurent, DivisionThatLeavesSomethingOverIsRefused, ()) {
  const Laurent a = random_laurent();
  const Exponents step = random_step();
  const int count = *rc::gen::inRange(2, 5);
  if (const auto quotient = divided_by_box(a, step, count))
    RC_ASSERT(product(*quotient, centred_box(step, count)) == a);
  Laurent more = product(a, centred_box(step, count));
  more[{7, 9}] += 1;  // one term more is divisible by no box
  if (more[{7, 9}] != 0) RC_ASSERT(!divided_by_box(more, step, count).has_value());
}

RC_GTEST_PROP(Laurent, ProductsCommuteAndSumsMultiply, ()) {
  const Laurent a = random_laurent();
  const Laurent b = random_laurent();
  RC_ASSERT(product(a, b) == product(b, a));
  RC_ASSERT(total(product(a, b)) == total(a) * total(b));
  RC_ASSERT(reflected(product(a, b)) == product(reflected(a), reflected(b)));
  RC_ASSERT(power(a, 3) == product(a, product(a, a)));
}

}  // namespace
}  // namespace limn
