#include "limn/scheme/file/names.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "limn/base/near_word.h"
#include "limn/scheme/check.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/stages.h"

namespace limn::scheme {
namespace {

constexpr std::size_t kMostShown = 8;  // names in a message

Error at_name(const Formula& formula, std::string_view name, std::string message,
              std::string hint = {}) {
  const Place& place = formula.place;
  const int column = place.line > 0 ? place.column + formula.expression.column_of(name) : 0;
  return {std::move(message), std::move(hint), place.file, place.line, column};
}

/// Lets and parameters by name.
using Definitions = std::map<std::string, const Formula*, std::less<>>;

Definitions definitions_of(const Scheme& scheme) {
  Definitions definitions;
  for (const auto& [name, formula] : scheme.lets) definitions[name] = &formula;
  for (const Parameter& parameter : scheme.parameters)
    definitions[parameter.name] = &parameter.value;
  return definitions;
}

/// Calls visit(formula) for every expression of the scheme but those of masks, which are checked
/// where they are evaluated.
template <class Visit>
void each_formula(const Scheme& scheme, const Visit& visit) {
  for (const auto& let : scheme.lets) visit(let.second);
  each_rule_formula(scheme, visit);
}

/// Whether q is the number of quads at a vertex.
bool knows_quads(const Scheme& scheme) { return scheme.stages && scheme.stages->is_mixed(); }

std::string names_hint(const Scheme& scheme, const Definitions& definitions,
                       const std::string& unknown) {
  if (unknown == kQuads)
    return fmt::format(
        "{}, the number of quads at a vertex, is known where stages begin with "
        "first = \"{}\"",
        kQuads, kLinear);
  std::vector<std::string> known;
  for (const auto& definition : definitions) known.push_back(definition.first);
  std::string hint = fmt::format("names are n, k, {}the parameters and the lets",
                                 knows_quads(scheme) ? "q, " : "");
  if (!known.empty() && known.size() <= kMostShown)
    hint += fmt::format(": {}", fmt::join(known, ", "));
  return base::did_you_mean(unknown, known, hint);
}

bool is_known(const Scheme& scheme, const std::string& name, const Definitions& definitions,
              const Unread& unread) {
  return name == "n" || name == "k" || (name == kQuads && knows_quads(scheme)) ||
         definitions.count(name) > 0 || unread.definitions.count(name) > 0;
}

void check_known(const Scheme& scheme, const Definitions& definitions, const Unread& unread,
                 base::Faults& faults) {
  each_formula(scheme, [&](const Formula& formula) {
    for (const std::string& name : formula.expression.names())
      if (!is_known(scheme, name, definitions, unread))
        faults.add(at_name(formula, name, fmt::format("unknown name '{}'", name),
                           names_hint(scheme, definitions, name)));
  });
}

/// A name that formula uses and that is still in `definitions`; nullptr: none.
const std::string* open_name(const Formula& formula, const Definitions& definitions) {
  for (const std::string& name : formula.expression.names())
    if (definitions.count(name) > 0) return &name;
  return nullptr;
}

/// `left`: definitions that all lead on to one another; so following them runs into a circle.
Error circle_in(const Definitions& left) {
  std::vector<std::string> path{left.begin()->first};
  std::size_t start = 0;
  do {
    const std::string& next = *open_name(*left.at(path.back()), left);
    start = static_cast<std::size_t>(std::find(path.begin(), path.end(), next) - path.begin());
    path.push_back(next);
  } while (start + 1 == path.size());  // as long as each is new
  path.pop_back();
  const std::string first = path[start];
  const std::string second = start + 1 < path.size() ? path[start + 1] : first;
  std::string circle = first;
  for (std::size_t i = start + 1; i < path.size(); ++i)
    circle += i - start < kMostShown ? " -> " + path[i] : i - start == kMostShown ? " -> ..." : "";
  return at_name(*left.at(first), second,
                 fmt::format("'{0}' is defined in terms of itself: {1} -> {0}", first, circle));
}

/// What is left when, again and again, what is defined by n, k and what was taken away before is
/// taken away. `holds_up(name)`: that a name that is no definition keeps its users from being
/// taken.
template <class HoldsUp>
Definitions unresolved(Definitions left, const HoldsUp& holds_up) {
  std::map<std::string, std::vector<std::string>> users;
  std::map<std::string, std::size_t> open;
  std::vector<std::string> ready;
  for (const auto& [name, formula] : left) {
    for (const std::string& used : formula->expression.names()) {
      if (left.count(used) == 0 && !holds_up(used)) continue;
      users[used].push_back(name);
      ++open[name];
    }
    if (open[name] == 0) ready.push_back(name);
  }
  while (!ready.empty()) {
    const std::string name = std::move(ready.back());
    ready.pop_back();
    left.erase(name);
    for (const std::string& user : users[name])
      if (--open[user] == 0) ready.push_back(user);
  }
  return left;
}

}  // namespace

void check_names(const Scheme& scheme, const Unread& unread, base::Faults& faults) {
  const Definitions definitions = definitions_of(scheme);
  if (!unread.tables) check_known(scheme, definitions, unread, faults);
  if (const auto taken = definitions.find(kQuads);
      taken != definitions.end() && knows_quads(scheme)) {
    const Place& place = taken->second->place;
    faults.add({fmt::format("'{}' cannot be the name of a let or a parameter here", kQuads),
                "it is the number of quads at a vertex", place.file, place.line, place.column});
  }
  const Definitions left = unresolved(definitions, [](const std::string&) { return false; });
  if (!left.empty()) faults.add(circle_in(left));
}

std::set<std::string> valueless_names(const Scheme& scheme, const Unread& unread) {
  const Definitions definitions = definitions_of(scheme);
  const Definitions left = unresolved(definitions, [&](const std::string& name) {
    return unread.definitions.count(name) > 0 || !is_known(scheme, name, definitions, unread);
  });
  std::set<std::string> names = unread.definitions;
  for (const auto& definition : left) names.insert(definition.first);
  each_formula(scheme, [&](const Formula& formula) {
    for (const std::string& name : formula.expression.names())
      if (!is_known(scheme, name, definitions, unread)) names.insert(name);
  });
  return names;
}

}  // namespace limn::scheme
