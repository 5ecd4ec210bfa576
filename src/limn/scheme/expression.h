#pragma once
/// Weight expressions of scheme files. They are made of exact rationals, names (n, k, parameters,
/// lets), the operators + - * / % ^, cos, sin, sqrt, pi, comparisons (1 where true, 0 where false),
/// and, or, not.
///
///     expression := conjunction { "or" conjunction }
///     conjunction := negation { "and" negation }
///     negation   := "not" negation | comparison
///     comparison := sum [ ("==" | "!=" | "<" | "<=" | ">" | ">=") sum ]
///     sum        := product { ("+" | "-") product }
///     product    := signed { ("*" | "/" | "%") signed }
///     signed     := "-" signed | power
///     power      := primary [ "^" signed ]          (the exponent must come out an integer)
///     primary    := integer | name | function "(" expression ")" | "(" expression ")"
///
/// A decimal is refused, as it would stand for a fraction, unless the file asks for decimals.
/// Parsing yields a short postfix program, which the library runs in any type of number that it
/// needs (scheme/evaluate.h).

#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"

namespace limn {

namespace scheme {
template <class Number>
class ExpressionRun;  // evaluate.h
}  // namespace scheme

/// Whether "0.375" is a number, 375/1000, or a fault.
enum class Decimals : bool { refused, admitted };
/// What is said of one that is refused.
inline constexpr std::string_view kDecimalRefused = "a decimal stands for a fraction here";

/// A parsed expression: its text, the names in it and a program. Copies cost as their text.
class Expression {
 public:
  /// Reads an expression. Fails with `column` set to the 1-based byte of the fault in `text`. Cost
  /// O(size).
  static Result<Expression> parse(std::string_view text, Decimals decimals = Decimals::refused);
  /// The expression that is this number: "3/8".
  static Expression constant(Rational value);

  /// As it was written.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// The names used, each once, in order of first use.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The 1-based byte of `text()` where `name` is first used; 0 where it is not.
  [[nodiscard]] int column_of(std::string_view name) const;

 private:
  friend class ExpressionParser;
  template <class Number>
  friend class scheme::ExpressionRun;
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

  std::string text_;
  std::vector<Instruction> program_;
  std::vector<Rational> constants_;
  std::vector<std::string> names_;
};

}  // namespace limn
