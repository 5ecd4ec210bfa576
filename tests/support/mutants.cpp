#include "support/mutants.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "limn/scheme/check.h"
#include "limn/scheme/placement.h"

namespace limn::test {
namespace {

// --- the text -------------------------------------------------------------------------------

struct Span {
  std::size_t begin, end;
  bool is_mask;  ///< rows of a stated mask: one change per row says enough
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of the value that begins at `at`: past the quotes or brackets it opens with, or else
/// of the word.
std::size_t value_end(const std::string& text, std::size_t at) {
  if (text[at] == '"') return text.find('"', at + 1) + 1;
  if (text[at] != '[') {
    while (at < text.size() && (is_word(text[at]) || text[at] == '-')) ++at;
    return at;
  }
  int depth = 0;
  do {
    if (text[at] == '"') {
      at = value_end(text, at);
      continue;
    }
    depth += text[at] == '[' ? 1 : text[at] == ']' ? -1 : 0;
    ++at;
  } while (depth > 0);
  return at;
}

/// The values that are numbers or weight expressions. Tables in braces and lists of them are
/// entered, since their keys are met in turn.
std::vector<Span> value_spans(const std::string& text) {
  static const std::set<std::string> kProse{"name",    "title",   "split", "source", "notes",
                                            "extends", "meaning", "range", "valence"};
  std::vector<Span> spans;
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at)) {
    std::size_t end = at;
    while (text[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    const std::string key = text.substr(begin, end - begin);
    at = text.find_first_not_of(" =", at);
    if (text[at] == '{' || (text[at] == '[' && key == "directions")) continue;
    const Span value{at, value_end(text, at), key == "rows"};
    if (!kProse.contains(key)) spans.push_back(value);
    at = value.end;
  }
  return spans;
}

class TextMutants {
 public:
  explicit TextMutants(const std::string& text) : text_(text) {}

  std::vector<TextMutant> run() {
    for (const Span& span : value_spans(text_)) {
      integers(span);
      operators(span);
      if (text_[span.begin] == '"')
        replace(span.begin + 1, span.end - 1,
                "(" + text_.substr(span.begin + 1, span.end - span.begin - 2) + ") + 1/64");
    }
    return std::move(mutants_);
  }

 private:
  void replace(std::size_t begin, std::size_t end, const std::string& with) {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(begin), '\n');
    const std::string old = text_.substr(begin, end - begin);
    mutants_.push_back({"line " + std::to_string(line) + ": " + old + " → " + with,
                        text_.substr(0, begin) + with + text_.substr(end)});
  }

  void integers(Span span) {
    for (std::size_t at = span.begin; at < span.end; ++at) {
      if (std::isdigit(static_cast<unsigned char>(text_[at])) == 0) continue;
      std::size_t end = at;
      while (std::isdigit(static_cast<unsigned char>(text_[end])) != 0) ++end;
      const bool skipped = is_word(text_[at - 1]) || (span.is_mask && text_[at - 1] != '[');
      const int value = std::stoi(text_.substr(at, end - at));
      if (!skipped) replace(at, end, std::to_string(value + 1));
      if (!skipped && value > 0) replace(at, end, std::to_string(value - 1));
      at = end;
    }
  }

  void operators(Span span) {
    static const std::vector<std::pair<std::string, std::string>> kOpposites{
        {" + ", " - "}, {" - ", " + "}, {"*", "/"},   {"/", "*"},
        {"^", "*"},     {"==", "!="},   {"!=", "=="}, {"cos(", "sin("}};
    for (const auto& [one, other] : kOpposites)
      for (std::size_t at = text_.find(one, span.begin); at < span.end;
           at = text_.find(one, at + one.size()))
        replace(at, at + one.size(), other);
  }

  const std::string& text_;
  std::vector<TextMutant> mutants_;
};

// --- the rules ------------------------------------------------------------------------------

constexpr const char* kAmount = "1/64";

/// Positions of a role, as an expression: "4", "2*n", "n".
std::optional<std::string> positions(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Result<scheme::Placement> placement = scheme::place(kind, lattice, walk);
  if (!placement) return std::nullopt;
  return "(" + to_string(placement->count) + (placement->times_n ? "*n)" : ")");
}

void increase(Weight& weight, const std::string& by) {
  weight.value.expression =
      Expression::parse("(" + weight.value.expression.text() + ") + " + by, Decimals::admitted)
          .value();
}

class RuleMutants {
 public:
  explicit RuleMutants(const Scheme& scheme) : scheme_(scheme), lattice_(scheme.split->lattice) {}

  std::vector<RuleMutant> run() {
    for (int kind = 0; kind < kRuleKinds; ++kind) {
      kind_ = static_cast<RuleKind>(kind);
      const std::optional<Rule>& rule = scheme_.rule(kind_);
      for (case_ = 0; rule && case_ < rule->size(); ++case_) of_case((*rule)[case_]);
    }
    if (scheme_.stages) of_stages();
    return std::move(mutants_);
  }

 private:
  /// Two averagings more or fewer, the split is the same; and other weights of a pair.
  void of_stages() {
    kind_ = RuleKind::vertex;
    const Rule& pair = scheme_.stages->pair;
    for (case_ = 0; case_ < pair.size(); ++case_)
      for (std::size_t i = 0; i < pair[case_].weights.size(); ++i)
        for (std::size_t j = 0; j < pair[case_].weights.size(); ++j) {
          if (i == j) continue;
          if (scheme_.split->mixed)
            exchange_in_mixed_pair(pair[case_], i, j);
          else
            exchange(pair[case_], i, j);
        }
    for (const int more : {-2, 2}) {
      Scheme mutant = scheme_;
      mutant.stages->count += more;
      mutants_.push_back({"stages: " + std::to_string(mutant.stages->count) + " times", mutant});
    }
  }

  void of_case(const RuleCase& rule_case) {
    for (std::size_t i = 0; i < rule_case.weights.size(); ++i) {
      const Weight& weight = rule_case.weights[i];
      for (std::size_t j = 0; j < rule_case.weights.size(); ++j)
        if (i != j) exchange(rule_case, i, j);
      if (weight.walk.repeated) shift_round(i, weight);
      for (const NamedRole& role : named_roles(kind_, lattice_)) add_role(rule_case, i, role);
    }
  }

  Weight& weight_of(Scheme& scheme, std::size_t i) {
    Rule& rule =
        scheme.stages ? scheme.stages->pair : scheme.rules[static_cast<std::size_t>(kind_)].value();
    return rule[case_].weights[i];
  }

  [[nodiscard]] std::string what(const std::string& change) const {
    return std::string(scheme_.stages ? "stages.pair" : rule_name(kind_)) + " case " +
           std::to_string(case_ + 1) + ": " + change;
  }

  [[nodiscard]] bool applies(const RuleCase& rule_case, int n) const {
    const Result<const RuleCase*> taken = scheme::applicable_case(scheme_, kind_, n);
    return taken.ok() && *taken == &rule_case;
  }

  void exchange(const RuleCase& rule_case, std::size_t i, std::size_t j) {
    const Weight &more = rule_case.weights[i], &less = rule_case.weights[j];
    const auto here = positions(kind_, lattice_, more.walk);
    const auto there = positions(kind_, lattice_, less.walk);
    // the amount is one of the role's sum, so that both weights are the same multiple of n
    std::vector<std::string> amounts{kAmount};
    const bool triangles_only = kind_ == RuleKind::face && !scheme_.split->any_polygons;
    for (const int n : {3, 7})
      if (rule_has_valence(kind_) && applies(rule_case, n) && !(triangles_only && n != 3))
        amounts.push_back("(n == " + std::to_string(n) + ")*" + kAmount);
    for (const std::string& amount : amounts) {
      Scheme mutant = scheme_;
      increase(weight_of(mutant, i), amount + "/" + *here);
      increase(weight_of(mutant, j), "-" + amount + "/" + *there);
      mutants_.push_back({what(more.role + " + " + amount + ", less " + less.role), mutant});
    }
  }

  /// Whether a case of a pair that knows q applies at some vertex for which `holds(n, q)`.
  template <class Holds>
  [[nodiscard]] bool applies_where(const RuleCase& rule_case, Holds holds) const {
    for (int n = 3; n <= 7; ++n)
      for (int q = 0; q <= n; ++q) {
        const Result<const RuleCase*> taken = scheme::applicable_case(scheme_, kind_, n, q);
        if (holds(n, q) && taken.ok() && *taken == &rule_case) return true;
      }
    return false;
  }

  /// The same of such a pair: everywhere, on either lattice alone, and at a seam.
  void exchange_in_mixed_pair(const RuleCase& rule_case, std::size_t i, std::size_t j) {
    using Where = std::pair<std::string, bool (*)(int n, int q)>;
    static const std::vector<Where> places{
        {"(q > 0)", [](int, int q) { return q > 0; }},
        {"(q == 0)", [](int, int q) { return q == 0; }},
        {"(q == n)", [](int n, int q) { return q == n; }},
        {"(n == 5)*(q == 2)", [](int n, int q) { return n == 5 && q == 2; }}};
    const Weight &more = rule_case.weights[i], &less = rule_case.weights[j];
    const auto share = [](const Weight& weight) -> std::string {
      if (pair_role(weight) == PairRole::self) return "";
      return pair_role(weight) == PairRole::ring ? "/n" : "/(q + (q == 0))";
    };
    for (const auto& [where, holds] : places) {
      if (!applies_where(rule_case, holds)) continue;
      const std::string amount = where + "*" + kAmount;
      Scheme mutant = scheme_;
      increase(weight_of(mutant, i), amount + share(more));
      increase(weight_of(mutant, j), "-" + amount + share(less));
      mutants_.push_back({what(more.role + " + " + amount + ", less " + less.role), mutant});
    }
  }

  void shift_round(std::size_t i, const Weight& weight) {
    for (const std::string shift : {"((k == 0)*n - 1)/(64*n)", "cos(2*pi*k/n)/64"}) {
      Scheme mutant = scheme_;
      increase(weight_of(mutant, i), shift);
      mutants_.push_back({what(weight.role + " + " + shift), mutant});
    }
  }

  void add_role(const RuleCase& rule_case, std::size_t i, const NamedRole& role) {
    const Walk walk = parse_walk(role.walk).value();
    for (const Weight& weight : rule_case.weights)
      if (weight.walk == walk) return;
    // the new vertices of faces can be read where every face has one
    if (walk.reads_face && scheme_.split->name != "quad-dyadic") return;
    const auto here = positions(kind_, lattice_, rule_case.weights[i].walk);
    const auto there = positions(kind_, lattice_, walk);
    if (!there) return;
    Scheme mutant = scheme_;
    increase(weight_of(mutant, i), std::string("-") + kAmount + "/" + *here);
    Weight added{std::string(role.name), walk, rule_case.weights[i].value};
    added.value.expression = Expression::parse(kAmount + ("/" + *there)).value();
    (*mutant.rules[static_cast<std::size_t>(kind_)])[case_].weights.push_back(added);
    mutants_.push_back(
        {what("new role " + std::string(role.name) + ", less " + rule_case.weights[i].role),
         mutant});
  }

  const Scheme& scheme_;
  Lattice lattice_;
  RuleKind kind_ = RuleKind::vertex;
  std::size_t case_ = 0;
  std::vector<RuleMutant> mutants_;
};

}  // namespace

std::vector<TextMutant> text_mutants(const std::string& text) { return TextMutants(text).run(); }

std::vector<RuleMutant> rule_mutants(const Scheme& scheme) { return RuleMutants(scheme).run(); }

}  // namespace limn::test
