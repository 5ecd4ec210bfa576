#include "limn/tune/freed_scheme.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/base/near_word.h"
#include "limn/tune/margin.h"

namespace limn {
namespace {

struct VerdictName {
  std::string_view name;
  Relation relation;
};
constexpr std::array<VerdictName, 3> kVerdicts{
    {{"convergent", Relation::convergent},
     {"c1", Relation::c1},
     {"bounded-curvature", Relation::bounded_curvature}}};

Error fault(std::string_view text, int column, const std::string& message, std::string hint) {
  return {fmt::format("requirement '{}': column {}: {}", text, column, message), std::move(hint)};
}

constexpr const char* kForm =
    "write an equation, as cup = tangent^2, an inequality, as cup <= tangent^2, or c1, convergent "
    "or bounded-curvature";

/// A relation between two expressions: where it stands and what it says.
struct Sign {
  std::size_t at, length;
  Relation relation;
  bool swapped;  ///< of right - left
};

/// The relations outside parentheses. "!=" counts as one that is refused later, by its length 0.
std::vector<Sign> signs_in(std::string_view text) {
  std::vector<Sign> signs;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth > 0) continue;
    const bool equals = i + 1 < text.size() && text[i + 1] == '=';
    const std::size_t length = equals ? 2 : 1;
    const Relation order = equals ? Relation::at_least : Relation::above;
    switch (text[i]) {
      case '=': signs.push_back({i, length, Relation::equal, false}); break;
      case '<': signs.push_back({i, length, order, true}); break;
      case '>': signs.push_back({i, length, order, false}); break;
      case '!': signs.push_back({i, 0, Relation::equal, false}); break;
      default: continue;
    }
    i += length - 1;
  }
  return signs;
}

std::optional<std::size_t> component_named(const std::string& name) {
  for (std::size_t i = 0; i < kComponents.size(); ++i)
    if (kComponents[i].name == name) return i;
  return std::nullopt;
}

bool is_known(const Scheme& scheme, const std::string& name) {
  return name == "n" || component_named(name) ||
         std::any_of(scheme.lets.begin(), scheme.lets.end(),
                     [&](const auto& let) { return let.first == name; }) ||
         std::any_of(scheme.parameters.begin(), scheme.parameters.end(),
                     [&](const Parameter& parameter) { return parameter.name == name; });
}

Result<Expression> parse_side(std::string_view text, std::size_t begin, std::size_t length,
                              const Scheme& scheme) {
  const auto column = [&](int in_side) { return static_cast<int>(begin) + in_side; };
  Result<Expression> side = Expression::parse(text.substr(begin, length));
  if (!side)
    return fault(text, column(side.error().column), side.error().message, side.error().hint);
  for (const std::string& name : side->names()) {
    if (is_known(scheme, name)) continue;
    std::string hint = "names are n, the scheme's lets and parameters, and";
    std::vector<std::string> known;
    for (const Component& component : kComponents) {
      hint += " " + std::string(component.name);
      known.emplace_back(component.name);
    }
    for (const auto& let : scheme.lets) known.push_back(let.first);
    for (const Parameter& parameter : scheme.parameters) known.push_back(parameter.name);
    return fault(text, column(side->column_of(name)), fmt::format("unknown name '{}'", name),
                 base::did_you_mean(name, known, hint));
  }
  return side;
}

void note_used(const Expression& side, std::vector<std::size_t>& used) {
  for (const std::string& name : side.names())
    if (const std::optional<std::size_t> i = component_named(name);
        i && std::find(used.begin(), used.end(), *i) == used.end())
      used.push_back(*i);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The largest modulus of all eigenvalues but the leaders: `skip_0` of frequency 0, `skip_1` of 1.
double largest_other(const Eigencomponents& found, std::size_t skip_0, std::size_t skip_1) {
  double largest = 0;
  for (const BlockSpectrum& block : found.spectra) {
    const std::size_t skip = block.frequency == 0 ? skip_0 : block.frequency == 1 ? skip_1 : 0;
    if (skip < block.eigenvalues.size())
      largest = std::max(largest, std::abs(block.eigenvalues[skip].value));
  }
  return largest;
}

/// 0 where frequency 0 is led by 1; the other verdicts presuppose it.
double off_one(const Eigencomponents& found) {
  return std::abs(found.spectra.front().eigenvalues.front().value - 1.0);
}

double verdict_margin(Relation relation, const Eigencomponents& found) {
  // an eigenvalue beyond 1 leads in 1's place
  const double convergent =
      off_one(found) > kEqualBelow ? -off_one(found) : 1 - largest_other(found, 1, 0);
  if (relation == Relation::convergent) return convergent;
  if (!found.tangent || !(*found.tangent > 0)) return -1;
  const double tangent = *found.tangent;
  const double c1 = std::min(convergent, tangent - largest_other(found, 1, 1));
  if (relation == Relation::c1) return c1;
  return std::min(c1, tangent * tangent - largest_other(found, 1, 1));
}

}  // namespace

Result<Requirement> Requirement::parse(std::string_view text, const Scheme& scheme) {
  Requirement requirement;
  requirement.text = text;
  for (const auto& [name, relation] : kVerdicts)
    if (trimmed(text) == name) {
      requirement.relation = relation;
      return requirement;
    }
  const std::vector<Sign> signs = signs_in(text);
  if (signs.empty()) {
    const Result<Expression> side = parse_side(text, 0, text.size(), scheme);
    if (!side) return side.error();
    return fault(text, static_cast<int>(text.size()) + 1, "found the end, expected a relation",
                 kForm);
  }
  const bool second = signs.size() > 1;
  if (second || signs.front().length == 0)
    return fault(text, static_cast<int>(signs[second ? 1 : 0].at) + 1,
                 second ? "found a second relation" : "found '!'", kForm);
  const Sign& sign = signs.front();
  const std::size_t after = sign.at + sign.length;
  Result<Expression> left = parse_side(text, 0, sign.at, scheme);
  if (!left) return left.error();
  Result<Expression> right = parse_side(text, after, text.size() - after, scheme);
  if (!right) return right.error();
  note_used(*left, requirement.used);
  note_used(*right, requirement.used);
  requirement.relation = sign.relation;
  requirement.left = std::move(sign.swapped ? *right : *left);
  requirement.right = std::move(sign.swapped ? *left : *right);
  return requirement;
}

std::optional<std::size_t> tune::sought_component(const Requirement& requirement) {
  for (const auto* side : {&requirement.left, &requirement.right})
    if (*side && (*side)->names().size() == 1)
      if (const auto i = component_named((*side)->names().front());
          i && trimmed((*side)->text()) == kComponents[*i].name)
        return i;
  if (requirement.used.empty()) return std::nullopt;
  return requirement.used.front();
}

Result<double> tune::difference(const Requirement& requirement, FreedScheme& scheme, int n,
                                double x, const tune::ComponentValues& values) {
  std::vector<std::pair<std::string_view, double>> beside;
  for (const std::size_t i : requirement.used) {
    const Component& component = kComponents[i];
    if (!values[i])
      return Error{
          fmt::format("there is no {} at valence {}", component.name, n),
          component.exists_at(n)
              ? fmt::format("frequency {} is led by no real eigenvalue", component.frequency)
              : fmt::format("its frequency {} comes with valence {}", component.frequency,
                            2 * component.frequency)};
    beside.emplace_back(component.name, *values[i]);
  }
  const Result<double> left = scheme.evaluate(*requirement.left, n, x, beside);
  const Result<double> right = scheme.evaluate(*requirement.right, n, x, beside);
  if (left && right) return *left - *right;
  Error error = left ? right.error() : left.error();
  error.message = fmt::format("requirement '{}': {}", requirement.text, error.message);
  error.column = 0;  // of one side
  return error;
}

Result<double> tune::margin(const Requirement& requirement, FreedScheme& scheme, double x,
                            const Eigencomponents& found) {
  if (requirement.left)
    return tune::difference(requirement, scheme, found.valence, x, tune::component_values(found));
  return verdict_margin(requirement.relation, found);
}

std::string tune::known_in_digits_only(const std::string& name) {
  return fmt::format(
      "{} is known in sixteen digits only, and what the regular lattice allows depends on all",
      name);
}

RegularPart tune::allowed_by_lattice(const Requirement& requirement, FreedScheme& scheme, int n,
                                     double x) {
  if (requirement.relation != Relation::bounded_curvature) return {Truth::yes, {}};
  return scheme.regular_part(n, x);
}

bool tune::is_closed(Relation relation) {
  return relation == Relation::at_least || relation == Relation::bounded_curvature;
}

tune::ComponentValues tune::component_values(const Eigencomponents& found) {
  return {found.position, found.cup, found.tangent, found.saddle};
}

}  // namespace limn
