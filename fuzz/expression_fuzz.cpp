/// libFuzzer target: the input is a weight expression. It is parsed and evaluated in every number
/// type; nothing may crash or take long, and where the exact value is known well, the double is
/// near it.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "limn/scheme/evaluate.h"
#include "limn/scheme/expression.h"

namespace {

using limn::Expression;
using limn::Rational;
using limn::Result;
using limn::number::Arithmetic;
using limn::number::Exact;

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

template <class Number>
Result<Number> evaluate(const Expression& expression, int n, int k) {
  return limn::scheme::evaluate<Number>(expression, [&](const std::string& name) -> Result<Number> {
    if (name == "n") return limn::number::Arithmetic<Number>::from(Rational(n));
    if (name == "k") return limn::number::Arithmetic<Number>::from(Rational(k));
    if (name == "w") return limn::number::Arithmetic<Number>::from(Rational(1, 16));
    return limn::Error{"unknown name"};
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Result<Expression> expression = Expression::parse(text);
  if (!expression) {
    check(expression.error().column >= 1 && expression.error().column <= static_cast<int>(size) + 1,
          "the fault lies in the text");
    check(!expression.error().message.empty(), "an error has a message");
    return 0;
  }
  for (const int n : {3, 7}) {
    const limn::number::ExactBudget budget(1e6);
    const Result<double> approx = evaluate<double>(*expression, n, 2);
    const Result<limn::number::Exact> exact = evaluate<limn::number::Exact>(*expression, n, 2);
    if (!exact) check(exact.error().column >= 1, "a failure has a place");
    if (!approx) check(approx.error().column >= 1, "a failure has a place");
    if (exact) check(std::isfinite(exact->approx()), "an exact number is finite");
    if (approx) check(std::isfinite(*approx), "a double is finite");
  }
  return 0;
}
