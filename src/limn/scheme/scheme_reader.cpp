#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/scheme/placement.h"
#include "limn/scheme/scheme_reader.h"
#include "limn/scheme/toml_data.h"
#include "limn/scheme/toml_reader.h"

namespace limn {
namespace {

constexpr std::string_view kKnownKeys =
    "name, title, split, source, notes, extends, let, parameter, roles, vertex, edge, edge-end, "
    "face, corner, boundary, mask, factors or facts";

constexpr std::string_view kBoundary = "boundary.";  // of rules in the table [boundary]

bool is_identifier(std::string_view name) {
  if (name.empty() || (std::isalpha(static_cast<unsigned char>(name[0])) == 0 && name[0] != '_'))
    return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
}

bool is_reserved(std::string_view name) {
  constexpr std::array<std::string_view, 9> reserved{"n",    "k",   "pi", "cos", "sin",
                                                     "sqrt", "and", "or", "not"};
  return std::find(reserved.begin(), reserved.end(), name) != reserved.end();
}

/// Reads one file into one Scheme.
class SchemeFileReader {
 public:
  SchemeFileReader(std::string file, const ExtendedScheme& extended)
      : in_(std::move(file)), extended_(extended) {}

  Result<Scheme> run(std::string_view text) {
    const toml::table root = in_.parse(text);
    if (!in_.ok()) return in_.take_error();
    scheme_.file = in_.file();
    read_split(root);
    in_.each(root, "the file",
             [&](const toml::key& key, const toml::node& node) { read_header(key, node); });
    if (in_.ok()) read_rules(root);
    if (in_.ok()) inherit();
    if (in_.ok()) check_given_once();
    if (!in_.ok()) return in_.take_error();
    return std::move(scheme_);
  }

 private:
  void read_split(const toml::table& root) {
    const toml::node* node = root.get("split");
    std::vector<std::string_view> known;
    for (const Split& split : splits()) known.push_back(split.name);
    const std::string hint = fmt::format("expected one of {}", fmt::join(known, ", "));
    if (node == nullptr) {
      if (root.get("extends") != nullptr) return;  // it comes from there
      in_.fail(Error{"the file names no split", hint, in_.file(), 1, 1});
      return;
    }
    const std::string name = in_.text(*node, "split");
    scheme_.split = find_split(name);
    if (in_.ok() && scheme_.split == nullptr)
      in_.fail(*node, fmt::format("unknown split '{}'", name), hint);
  }

  void read_header(const toml::key& key, const toml::node& node) {
    const std::string_view name = key.str();
    if (name == "name") {
      scheme_.name = in_.text(node, name);
    } else if (name == "title") {
      scheme_.title = in_.text(node, name);
    } else if (name == "source") {
      scheme_.source = in_.text(node, name);
    } else if (name == "notes") {
      scheme_.notes = in_.text(node, name);
    } else if (name == "extends") {
      extends_ = in_.text(node, name);
      extends_place_ = in_.place(node);
    } else if (name == "let") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { read_let(k, v); });
    } else if (name == "parameter") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { read_parameter(k, v); });
    } else if (name == "roles") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { read_roles(k, v); });
    } else if (name == "facts") {
      in_.each_element(node, name, [&](const toml::node& v) { read_fact(in_, v, scheme_); });
    } else if (name == "mask") {
      scheme_.mask = read_rows(in_, node, name);
    } else if (name == "factors") {
      scheme_.factors = read_factors(in_, node);
    } else if (name != "split" && name != "boundary" &&
               (!find_rule(name) || name.starts_with(kBoundary))) {
      in_.unknown_key(key, "a scheme file", std::string(kKnownKeys));
    }
  }

  bool check_name(const toml::key& key) {
    const Place at = in_.place(key);
    const std::string name(key.str());
    if (!is_identifier(name) || is_reserved(name))
      in_.fail(Error{fmt::format("'{}' cannot be the name of a let or a parameter", name),
                     "use letters, digits and _; n, k, pi and the functions are taken", at.file,
                     at.line, at.column});
    if (!names_.insert({name, at}).second)
      in_.fail(Error{fmt::format("'{}' is defined twice", name), {}, at.file, at.line, at.column});
    return in_.ok();
  }

  void read_let(const toml::key& key, const toml::node& node) {
    if (check_name(key)) scheme_.lets.emplace_back(key.str(), in_.formula(node, key.str()));
  }

  void read_parameter(const toml::key& key, const toml::node& node) {
    if (!check_name(key)) return;
    Parameter parameter;
    parameter.name = key.str();
    bool has_default = false;
    in_.each(node, key.str(), [&](const toml::key& k, const toml::node& v) {
      if (k.str() == "default") {
        parameter.value = in_.formula(v, "default");
        has_default = true;
      } else if (k.str() == "range") {
        read_range(v, parameter);
      } else if (k.str() == "meaning") {
        parameter.meaning = in_.text(v, "meaning");
      } else {
        in_.unknown_key(k, "a parameter", "default, range or meaning");
      }
    });
    if (in_.ok() && !has_default)
      in_.fail(node, fmt::format("parameter '{}' has no default", parameter.name),
               "add default = \"...\"");
    scheme_.parameters.push_back(std::move(parameter));
  }

  void read_range(const toml::node& node, Parameter& parameter) {
    std::vector<Formula> bounds;
    in_.each_element(node, "range",
                     [&](const toml::node& v) { bounds.push_back(in_.formula(v, "range")); });
    if (!in_.ok()) return;
    if (bounds.size() != 2) {
      in_.fail(node, "a range needs two bounds, as [\"0\", \"1\"]");
      return;
    }
    parameter.low = bounds[0];
    parameter.high = bounds[1];
  }

  void read_roles(const toml::key& key, const toml::node& node) {
    const std::optional<RuleKind> kind = find_rule(key.str());
    if (!kind) {
      in_.unknown_key(key, "roles", "the name of a rule, as edge or \"boundary.edge\"");
      return;
    }
    in_.each(node, key.str(), [&](const toml::key& role, const toml::node& v) {
      const std::string text = in_.text(v, role.str());
      if (!in_.ok()) return;
      const Place at = in_.place(v);
      Result<Walk> walk = parse_walk(text);
      if (!walk) {
        in_.fail(Error{fmt::format("role '{}': {}", role.str(), walk.error().message),
                       walk.error().hint, at.file, at.line, at.column + walk.error().column});
        return;
      }
      if (role.str() == "when") {
        in_.fail(v, "'when' cannot be the name of a role", "it stands for the guard of a case");
        return;
      }
      if (scheme_.split != nullptr) check_role(*kind, role.str(), *walk, at);
      own_roles_[{*kind, std::string(role.str())}] = *walk;
    });
  }

  void read_rules(const toml::table& root) {
    for (int i = 0; i < kRuleKinds; ++i) {
      const auto kind = static_cast<RuleKind>(i);
      std::string_view name = rule_name(kind);
      const toml::node* node = nullptr;
      if (name.substr(0, kBoundary.size()) == kBoundary) {
        if (const toml::node* boundary = root.get("boundary"))
          if (const toml::table* table = boundary->as_table())
            node = table->get(name.substr(kBoundary.size()));
      } else {
        node = root.get(name);
      }
      if (node != nullptr && in_.ok()) read_rule(kind, *node);
    }
    if (const toml::node* boundary = root.get("boundary"))
      in_.each(*boundary, "boundary", [&](const toml::key& key, const toml::node&) {
        if (!find_rule("boundary." + std::string(key.str())))
          in_.unknown_key(key, "boundary", "vertex, edge or edge-end");
      });
  }

  void read_rule(RuleKind kind, const toml::node& node) {
    Rule rule;
    if (node.is_array()) {
      in_.each_element(node, rule_name(kind),
                       [&](const toml::node& v) { rule.push_back(read_case(kind, v)); });
    } else {
      rule.push_back(read_case(kind, node));
    }
    for (std::size_t i = 0; in_.ok() && i + 1 < rule.size(); ++i)
      if (!rule[i].when)
        in_.fail(Error{"a case without a guard hides the cases after it",
                       "give it a guard, as when = \"n == 3\", or put it last", in_.file(),
                       rule[i].place.line, rule[i].place.column});
    if (in_.ok() && rule.empty())
      in_.fail(node, fmt::format("the {} rule has no case", rule_name(kind)));
    scheme_.rules[static_cast<std::size_t>(kind)] = std::move(rule);
  }

  RuleCase read_case(RuleKind kind, const toml::node& node) {
    RuleCase result;
    result.place = in_.place(node);
    in_.each(node, rule_name(kind), [&](const toml::key& key, const toml::node& v) {
      if (key.str() == "when") {
        result.when = in_.formula(v, "when");
        if (!rule_has_valence(kind))
          in_.fail(v, fmt::format("the {} rule has no n to guard", rule_name(kind)));
        return;
      }
      Weight weight;
      weight.role = key.str();
      weight.walk = find_role(kind, key);
      if (!in_.ok()) return;
      weight.value = in_.formula(v, key.str());
      result.weights.push_back(std::move(weight));
    });
    if (in_.ok() && result.weights.empty())
      in_.fail(node, fmt::format("the {} rule has no weights", rule_name(kind)));
    return result;
  }

  Walk find_role(RuleKind kind, const toml::key& key) {
    const std::string name(key.str());
    if (const auto own = own_roles_.find({kind, name}); own != own_roles_.end())
      return checked(kind, own->second, key);
    if (scheme_.split == nullptr) {
      in_.fail(Error{"a file that extends another and states rules must name its split",
                     "add split = \"...\", the same as there", in_.file(), in_.place(key).line,
                     in_.place(key).column});
      return {};
    }
    std::vector<std::string_view> known{"when"};
    for (const NamedRole& role : named_roles(kind, scheme_.split->lattice)) {
      if (role.name == name) return checked(kind, parse_walk(role.walk).value(), key);
      if (!parse_walk(role.walk).value().reads_face || gives_every_face_a_vertex())
        known.push_back(role.name);
    }
    in_.unknown_key(key,
                    fmt::format("the {} rule of a {} scheme", rule_name(kind), scheme_.split->name),
                    fmt::format("{}, or a role defined under [roles.{}]", fmt::join(known, ", "),
                                rule_name(kind)));
    return {};
  }

  /// Precondition, as for the next: the split is known.
  [[nodiscard]] bool gives_every_face_a_vertex() const {
    return scheme_.split->births_faces && !scheme_.split->trisects_boundary;
  }

  /// Fails at `at` where the walk makes no sense in the rule.
  void check_role(RuleKind kind, std::string_view name, const Walk& walk, const Place& at) {
    const Split& split = *scheme_.split;
    const Result<Placement> placement = place(kind, split.lattice, walk);
    if (!placement)
      in_.fail(Error{fmt::format("role '{}' of the {} rule: {}", name, rule_name(kind),
                                 placement.error().message),
                     placement.error().hint, at.file, at.line, at.column});
    if (walk.reads_face && !gives_every_face_a_vertex())
      in_.fail(Error{fmt::format("role '{}' reads the new vertex of a face, and the split {} does "
                                 "not give every face one",
                                 name, split.name),
                     {},
                     at.file,
                     at.line,
                     at.column});
  }

  Walk checked(RuleKind kind, const Walk& walk, const toml::key& key) {
    check_role(kind, key.str(), walk, in_.place(key));
    return walk;
  }

  /// Takes from the extended scheme what this file does not state.
  void inherit() {
    if (extends_.empty()) return;
    Result<Scheme> base = extended_(extends_);
    if (!base) {
      const std::string hint = std::exchange(base.error().hint, {});
      in_.fail(Error{fmt::format("extends '{}': {}", extends_, base.error().text()), hint,
                     in_.file(), extends_place_.line, extends_place_.column});
      return;
    }
    if (scheme_.split != nullptr && base->split != scheme_.split) {
      in_.fail(Error{fmt::format("'{}' has the split {}, this file {}", extends_, base->split->name,
                                 scheme_.split->name),
                     {},
                     in_.file(),
                     extends_place_.line,
                     extends_place_.column});
      return;
    }
    scheme_.split = base->split;
    for (std::size_t i = 0; i < kRuleKinds; ++i)
      if (!scheme_.rules[i]) scheme_.rules[i] = std::move(base->rules[i]);
    for (auto& let : base->lets)
      if (names_.find(let.first) == names_.end()) scheme_.lets.push_back(std::move(let));
    for (Parameter& parameter : base->parameters)
      if (names_.find(parameter.name) == names_.end())
        scheme_.parameters.push_back(std::move(parameter));
  }

  /// Rules follow from a mask or from factors, so stating them too would say them twice.
  void check_given_once() {
    if (!scheme_.mask && !scheme_.factors) return;
    const Place place = scheme_.mask ? scheme_.mask->place : scheme_.factors->place;
    const std::string_view given = scheme_.mask ? "its mask" : "factors";
    const auto twice = [&](std::string_view also) {
      in_.fail(Error{fmt::format("the scheme is given by {} and by {} too", given, also),
                     "keep the rules, the mask or the factors", place.file, place.line,
                     place.column});
    };
    if (scheme_.mask && scheme_.factors) twice("factors");
    for (const auto& rule : scheme_.rules)
      if (rule) twice(extends_.empty() ? "rules" : "the rules that it extends");
  }

  TomlReader in_;
  const ExtendedScheme& extended_;
  Scheme scheme_;
  std::string extends_;
  Place extends_place_;
  std::map<std::string, Place> names_;
  std::map<std::pair<RuleKind, std::string>, Walk> own_roles_;
};

}  // namespace

Result<Scheme> read_scheme_text(std::string_view text, const std::string& file,
                                const ExtendedScheme& extended) {
  return SchemeFileReader(file, extended).run(text);
}

}  // namespace limn
