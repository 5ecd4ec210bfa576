#pragma once
/// Weight expressions of scheme files: exact rationals, names (n, k, parameters, lets),
/// + - * / % ^, cos, sin, sqrt, pi, comparisons (1 where true, 0 where false), and, or, not.
///
///   expression := conjunction { "or" conjunction }
///   conjunction := negation { "and" negation }
///   negation   := "not" negation | comparison
///   comparison := sum [ ("==" | "!=" | "<" | "<=" | ">" | ">=") sum ]
///   sum        := product { ("+" | "-") product }
///   product    := signed { ("*" | "/" | "%") signed }
///   signed     := "-" signed | power
///   power      := primary [ "^" signed ]          (the exponent must come out an integer)
///   primary    := integer | name | function "(" expression ")" | "(" expression ")"
///
/// A decimal is refused: it would stand for a fraction. Parsing yields a short postfix program;
/// `evaluate` runs it in any number type that has an `Arithmetic` (number/arithmetic.h).

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/number/arithmetic.h"

namespace limn {

class Expression {
 public:
  /// Fails with `column` set to the 1-based byte of the fault in `text`.
  static Result<Expression> parse(std::string_view text);
  static Expression constant(Rational value);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// The names used, each once, in order of first use.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The 1-based byte of `text()` where `name` is first used; 0 where it is not.
  [[nodiscard]] int column_of(std::string_view name) const;

  /// The value, with `lookup(name)` → Result<Number> for each name. Fails, with the column of
  /// the operation at fault, on division by zero, on sqrt of a negative number, on an exponent
  /// beyond 4096, and where the number type cannot hold the result. Cost: one operation per
  /// instruction.
  template <class Number, class Lookup>
  [[nodiscard]] Result<Number> evaluate(Lookup&& lookup) const;

 private:
  friend class ExpressionParser;
  enum class Op : unsigned char {
    constant,
    name,
    pi,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    negate,
    cosine,
    sine,
    root,
    equal,
    differ,
    less,
    less_equal,
    greater,
    greater_equal,
    both,
    either,
    invert
  };
  struct Instruction {
    Op op;
    int operand;  // index into constants_ or names_
    int column;   // where it stands in text_
  };

  template <class Number>
  static Result<Number> apply_unary(Op op, const Number& a);
  template <class Number>
  static Result<Number> apply_binary(Op op, const Number& a, const Number& b);
  template <class Number>
  static Result<Number> apply_integer(Op op, const Number& a, const Number& b);
  template <class Number>
  static Result<Number> compare(Op op, const Number& a, const Number& b);

  std::string text_;
  std::vector<Instruction> program_;
  std::vector<Rational> constants_;
  std::vector<std::string> names_;
};

// ---------------------------------------------------------------------------------------------

template <class Number>
Result<Number> Expression::apply_unary(Op op, const Number& a) {
  using A = Arithmetic<Number>;
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
Result<Number> Expression::compare(Op op, const Number& a, const Number& b) {
  using A = Arithmetic<Number>;
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
Result<Number> Expression::apply_integer(Op op, const Number& a, const Number& b) {
  using A = Arithmetic<Number>;
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
Result<Number> Expression::apply_binary(Op op, const Number& a, const Number& b) {
  using A = Arithmetic<Number>;
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

template <class Number, class Lookup>
Result<Number> Expression::evaluate(Lookup&& lookup) const {
  using A = Arithmetic<Number>;
  std::vector<Number> stack;
  stack.reserve(program_.size());
  for (const Instruction& step : program_) {
    Result<Number> value = [&]() -> Result<Number> {
      switch (step.op) {
        case Op::constant: return A::from(constants_[static_cast<std::size_t>(step.operand)]);
        case Op::pi: return A::pi();
        case Op::name: return lookup(names_[static_cast<std::size_t>(step.operand)]);
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

}  // namespace limn
