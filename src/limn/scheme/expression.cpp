#include "limn/scheme/expression.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace limn {
namespace {

// so that a hostile file can exhaust neither the stack (a small one: docs/architecture.md) nor our
// patience
constexpr int kDeepestNesting = 100;
constexpr std::size_t kLongestText = 4096;
constexpr std::size_t kMostDigits = 100;
constexpr std::size_t kShownBytes = 12;  // of what was found

bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The beginning of what stands at `where`, in quotes and fit for one line.
std::string shown(std::string_view text, std::size_t where) {
  if (where >= text.size()) return "the end";
  if (text[where] == '\n' || text[where] == '\r') return "a line break";
  if (static_cast<unsigned char>(text[where]) < ' ') return "a control character";
  std::size_t end = where + 1;
  while (end < text.size() && end < where + kShownBytes &&
         static_cast<unsigned char>(text[end]) >= ' ')
    ++end;
  // no character is cut in two: the bytes 10xxxxxx belong to the one before them
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  return "'" + std::string(text.substr(where, end - where)) + "'";
}

}  // namespace

/// Recursive descent over the text; emits the postfix program as it goes.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, Decimals decimals) : decimals_(decimals) {
    result_.text_ = text;
  }

  Result<Expression> run() {
    if (text().size() > kLongestText) {
      refuse("the expression has more than " + std::to_string(kLongestText) + " bytes",
             "name its parts under [let]", kLongestText);
      return error_;
    }
    if (!disjunction()) return error_;
    skip_blanks();
    if (at_ < text().size()) {
      (void)fail("an operator or the end", at_);
      if (text()[at_] == '=') error_.hint = "equality is written ==";
      return error_;
    }
    return std::move(result_);
  }

 private:
  using Op = Expression::Op;
  struct Spelling {
    std::string_view text;
    Op op;
  };

  [[nodiscard]] std::string_view text() const { return result_.text_; }

  void skip_blanks() {
    while (at_ < text().size() && (text()[at_] == ' ' || text()[at_] == '\t')) ++at_;
  }

  Status fail(const std::string& expected, std::size_t where) {
    error_ = {"found " + shown(text(), where) + ", expected " + expected,
              {},
              {},
              0,
              static_cast<int>(where) + 1};
    return error_;
  }
  bool refuse(std::string message, std::string hint, std::size_t where) {
    error_ = {std::move(message), std::move(hint), {}, 0, static_cast<int>(where) + 1};
    return false;
  }

  void emit(Op op, std::size_t where, int operand = 0) {
    result_.program_.push_back({op, operand, static_cast<int>(where) + 1});
  }

  /// Whether `symbol` (or, if it is a word, that whole word) comes next; consumes it.
  bool accept(std::string_view symbol) {
    skip_blanks();
    if (text().substr(at_, symbol.size()) != symbol) return false;
    const std::size_t after = at_ + symbol.size();
    if (is_name_start(symbol[0]) && after < text().size() &&
        (is_name_start(text()[after]) || is_digit(text()[after])))
      return false;
    at_ = after;
    return true;
  }

  /// left { operator right }, all operators of one precedence.
  template <std::size_t N>
  bool chain(bool (ExpressionParser::*operand)(), const std::array<Spelling, N>& operators,
             bool repeat = true) {
    if (!(this->*operand)()) return false;
    for (bool again = true; again;) {
      again = false;
      skip_blanks();
      const std::size_t where = at_;
      for (const Spelling& spelling : operators) {
        if (!accept(spelling.text)) continue;
        if (!(this->*operand)()) return false;
        emit(spelling.op, where);
        again = repeat;
        break;
      }
    }
    return true;
  }

  bool disjunction() {
    if (++depth_ > kDeepestNesting) return refuse("the expression is nested too deeply", {}, at_);
    const bool ok =
        chain(&ExpressionParser::conjunction, std::array<Spelling, 1>{{{"or", Op::either}}});
    --depth_;
    return ok;
  }
  bool conjunction() {
    return chain(&ExpressionParser::negation, std::array<Spelling, 1>{{{"and", Op::both}}});
  }
  bool negation() {
    skip_blanks();
    const std::size_t where = at_;
    std::size_t count = 0;
    while (accept("not")) ++count;
    if (!comparison()) return false;
    for (; count > 0; --count) emit(Op::invert, where);
    return true;
  }
  bool comparison() {
    return chain(&ExpressionParser::sum,
                 std::array<Spelling, 6>{{{"==", Op::equal},
                                          {"!=", Op::differ},
                                          {"<=", Op::less_equal},
                                          {">=", Op::greater_equal},
                                          {"<", Op::less},
                                          {">", Op::greater}}},
                 false);
  }
  bool sum() {
    return chain(&ExpressionParser::product,
                 std::array<Spelling, 2>{{{"+", Op::add}, {"-", Op::subtract}}});
  }
  bool product() {
    return chain(
        &ExpressionParser::signed_power,
        std::array<Spelling, 3>{{{"*", Op::multiply}, {"/", Op::divide}, {"%", Op::modulo}}});
  }
  bool signed_power() {
    skip_blanks();
    const std::size_t where = at_;
    std::size_t count = 0;
    while (accept("-")) ++count;
    if (!power()) return false;
    if (count % 2 == 1) emit(Op::negate, where);
    return true;
  }
  bool power() {
    if (!primary()) return false;
    skip_blanks();
    const std::size_t where = at_;
    if (!accept("^")) return true;
    if (++depth_ > kDeepestNesting) return refuse("the expression is nested too deeply", {}, at_);
    if (!signed_power()) return false;
    --depth_;
    emit(Op::power, where);
    return true;
  }

  bool primary() {
    skip_blanks();
    const std::size_t where = at_;
    if (accept("(")) {
      if (!disjunction()) return false;
      return accept(")") || fail("')'", at_).ok();
    }
    if (at_ < text().size() && is_digit(text()[at_])) return number();
    if (at_ < text().size() && is_name_start(text()[at_])) return name();
    if (at_ + 1 < text().size() && text()[at_] == '.' && is_digit(text()[at_ + 1])) return number();
    return fail("a number, a name or '('", where).ok();
  }

  /// The digits from here on.
  std::string digits() {
    const std::size_t where = at_;
    while (at_ < text().size() && is_digit(text()[at_])) ++at_;
    return std::string(text().substr(where, at_ - where));
  }

  bool number() {
    const std::size_t where = at_;
    std::string all = digits();
    std::size_t places = 0;
    const auto comes = [&](char c) { return at_ < text().size() && text()[at_] == c; };
    if (comes('.') && decimals_ == Decimals::admitted) {
      ++at_;
      const std::string after = digits();
      places = after.size();
      all += after;
    }
    if (comes('e') || comes('E') || comes('.')) return refuse_decimal(where);
    if (all.empty()) return fail("a digit", at_).ok();
    if (all.size() > kMostDigits)
      return refuse("the number has more than " + std::to_string(kMostDigits) + " digits", {},
                    where);
    // a leading zero would make Integer read the digits as octal
    const std::size_t first = std::min(all.find_first_not_of('0'), all.size() - 1);
    Rational value = Integer(all.substr(first));
    for (; places > 0; --places) value /= 10;
    result_.constants_.push_back(std::move(value));
    emit(Op::constant, where, static_cast<int>(result_.constants_.size()) - 1);
    return true;
  }

  bool refuse_decimal(std::size_t where) {
    if (decimals_ == Decimals::admitted)
      return refuse("a decimal is written in digits with one point, as 0.375",
                    "write 1e-3 as 0.001", where);
    return refuse(std::string(kDecimalRefused), "write the fraction itself, as 3/8", where);
  }

  bool name() {
    const std::size_t where = at_;
    while (at_ < text().size() && (is_name_start(text()[at_]) || is_digit(text()[at_]))) ++at_;
    const std::string word(text().substr(where, at_ - where));
    constexpr std::array<Spelling, 3> functions{
        {{"cos", Op::cosine}, {"sin", Op::sine}, {"sqrt", Op::root}}};
    for (const Spelling& function : functions) {
      if (word != function.text) continue;
      if (!accept("(")) return fail("'(' after " + word, at_).ok();
      if (!disjunction()) return false;
      if (!accept(")")) return fail("')'", at_).ok();
      emit(function.op, where);
      return true;
    }
    if (word == "pi") {
      emit(Op::pi, where);
      return true;
    }
    if (word == "and" || word == "or" || word == "not")
      return fail("a number, a name or '('", where).ok();
    skip_blanks();
    if (at_ < text().size() && text()[at_] == '(')
      return refuse("unknown function '" + word + "'", "the functions are cos, sin and sqrt",
                    where);
    auto& names = result_.names_;
    const auto found = std::find(names.begin(), names.end(), word);
    emit(Op::name, where, static_cast<int>(found - names.begin()));
    if (found == names.end()) names.push_back(word);
    return true;
  }

  Expression result_;
  Decimals decimals_;
  Error error_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Result<Expression> Expression::parse(std::string_view text, Decimals decimals) {
  return ExpressionParser(text, decimals).run();
}

Expression Expression::constant(Rational value) {
  Expression result;
  result.text_ = to_string(value);
  result.constants_.push_back(std::move(value));
  result.program_.push_back({Op::constant, 0, 1});
  return result;
}

int Expression::column_of(std::string_view name) const {
  for (const Instruction& step : program_)
    if (step.op == Op::name && names_[static_cast<std::size_t>(step.operand)] == name)
      return step.column;
  return 0;
}

}  // namespace limn
