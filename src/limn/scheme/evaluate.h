#pragma once
/// The value of a weight expression in any type of number that has an `Arithmetic`
/// (number/arithmetic.h): one evaluator for doubles, exact numbers, formulas.

#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/arithmetic.h"
#include "limn/scheme/expression.h"

namespace limn::scheme {

/// Runs the program of an expression; use `evaluate`.
template <class Number>
class ExpressionRun {
 public:
  template <class Lookup>
  static Result<Number> of(const Expression& expression, Lookup& lookup);

 private:
  using Op = Expression::Op;

  static Result<Number> apply_unary(Op op, const Number& a);
  static Result<Number> apply_binary(Op op, const Number& a, const Number& b);
  static Result<Number> apply_integer(Op op, const Number& a, const Number& b);
  static Result<Number> compare(Op op, const Number& a, const Number& b);
};

/// The value, with `lookup(name)` → Result<Number> for each name. Fails, with the column of the
/// operation at fault, on division by zero, on sqrt of a negative number, on an exponent beyond
/// 4096, and where the number type cannot hold the result. Cost: one operation per instruction.
template <class Number, class Lookup>
[[nodiscard]] Result<Number> evaluate(const Expression& expression, Lookup&& lookup) {
  return ExpressionRun<Number>::of(expression, lookup);
}

// ---------------------------------------------------------------------------------------------

template <class Number>
Result<Number> ExpressionRun<Number>::apply_unary(Op op, const Number& a) {
  using A = number::Arithmetic<Number>;
  switch (op) {
    case Op::negate: return A::subtract(A::from(Rational(0)), a);
    case Op::cosine: return A::cos(a);
    case Op::sine: return A::sin(a);
    case Op::root: return A::sqrt(a);
    default: break;
  }
  const Result<int> sign = A::sign(a);  // Op::invert
  if (!sign) return sign.error();
  return A::from(Rational(*sign == 0 ? 1 : 0));
}

template <class Number>
Result<Number> ExpressionRun<Number>::compare(Op op, const Number& a, const Number& b) {
  using A = number::Arithmetic<Number>;
  const Result<Number> difference = A::subtract(a, b);
  if (!difference) return difference.error();
  const Result<int> sign = A::sign(*difference);
  if (!sign) return sign.error();
  bool holds = false;
  switch (op) {
    case Op::equal: holds = *sign == 0; break;
    case Op::differ: holds = *sign != 0; break;
    case Op::less: holds = *sign < 0; break;
    case Op::less_equal: holds = *sign <= 0; break;
    case Op::greater: holds = *sign > 0; break;
    default: holds = *sign >= 0; break;
  }
  return A::from(Rational(holds ? 1 : 0));
}

template <class Number>
Result<Number> ExpressionRun<Number>::apply_integer(Op op, const Number& a, const Number& b) {
  using A = number::Arithmetic<Number>;
  const Result<long long> right = A::integer(b);
  if (op == Op::modulo) {
    const Result<long long> left = A::integer(a);
    if (!left || !right) return Error{"% needs two integers"};
    if (*right <= 0) return Error{"% needs a positive right-hand side"};
    return A::from(Rational(((*left % *right) + *right) % *right));
  }
  if (!right) return Error{"the exponent is no integer"};
  if (*right > 4096 || *right < -4096) return Error{"the exponent is beyond 4096"};
  Number result = A::from(Rational(1));
  for (long long i = 0; i < (*right < 0 ? -*right : *right); ++i) {
    Result<Number> product = A::multiply(result, a);
    if (!product) return product;
    result = std::move(*product);
  }
  return *right < 0 ? A::divide(A::from(Rational(1)), result) : Result<Number>(std::move(result));
}

template <class Number>
Result<Number> ExpressionRun<Number>::apply_binary(Op op, const Number& a, const Number& b) {
  using A = number::Arithmetic<Number>;
  switch (op) {
    case Op::add: return A::add(a, b);
    case Op::subtract: return A::subtract(a, b);
    case Op::multiply: return A::multiply(a, b);
    case Op::divide: return A::divide(a, b);
    case Op::modulo:
    case Op::power: return apply_integer(op, a, b);
    case Op::both:
    case Op::either: {
      const Result<int> left = A::sign(a);
      const Result<int> right = A::sign(b);
      if (!left) return left.error();
      if (!right) return right.error();
      const bool holds = op == Op::both ? *left != 0 && *right != 0 : *left != 0 || *right != 0;
      return A::from(Rational(holds ? 1 : 0));
    }
    default: return compare(op, a, b);
  }
}

template <class Number>
template <class Lookup>
Result<Number> ExpressionRun<Number>::of(const Expression& expression, Lookup& lookup) {
  using A = number::Arithmetic<Number>;
  std::vector<Number> stack;
  stack.reserve(expression.program_.size());
  for (const Expression::Instruction& step : expression.program_) {
    Result<Number> value = [&]() -> Result<Number> {
      switch (step.op) {
        case Op::constant:
          return A::from(expression.constants_[static_cast<std::size_t>(step.operand)]);
        case Op::pi: return A::pi();
        case Op::name: return lookup(expression.names_[static_cast<std::size_t>(step.operand)]);
        case Op::negate:
        case Op::cosine:
        case Op::sine:
        case Op::root:
        case Op::invert: {
          const Number a = std::move(stack.back());
          stack.pop_back();
          return apply_unary(step.op, a);
        }
        default: {
          const Number b = std::move(stack.back());
          stack.pop_back();
          const Number a = std::move(stack.back());
          stack.pop_back();
          return apply_binary(step.op, a, b);
        }
      }
    }();
    if (!value) {
      if (value.error().column == 0) value.error().column = step.column;
      return value;
    }
    stack.push_back(std::move(*value));
  }
  return std::move(stack.back());
}

}  // namespace limn::scheme
