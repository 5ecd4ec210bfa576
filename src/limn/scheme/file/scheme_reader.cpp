#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/fault_order.h"
#include "limn/base/near_word.h"
#include "limn/scheme/check.h"
#include "limn/scheme/file/role_reader.h"
#include "limn/scheme/file/scheme_reader.h"
#include "limn/scheme/file/scheme_words.h"
#include "limn/scheme/file/toml_data.h"
#include "limn/scheme/file/toml_reader.h"
#include "limn/scheme/stages.h"

namespace limn::scheme {
namespace {

/// Reads one file into one Scheme.
class SchemeFileReader {
 public:
  SchemeFileReader(std::string file, const ExtendedScheme& extended, base::Faults& faults)
      : in_(std::move(file), faults), extended_(extended) {}

  Draft run(std::string_view text) {
    const toml::table root = in_.parse(text);
    scheme_.file = in_.file();
    if (in_.faults() > 0) {
      unread_.everything = true;
      return {std::move(scheme_), std::move(unread_)};
    }
    read_split(root);
    read_weights(root);  // what expressions may hold, before any is read
    in_.each(root, "the file",
             [&](const toml::key& key, const toml::node& node) { read_header(key, node); });
    read_rules(root);
    if (extends_) inherit(*extends_);
    if (lattice_ != nullptr) restrict_to_lattice(*lattice_);
    check_given_once();
    unread_.something = in_.faults() > 0;
    return {std::move(scheme_), std::move(unread_)};
  }

 private:
  void read_split(const toml::table& root) {
    const toml::node* node = root.get("split");
    std::vector<std::string> known;
    for (const Split& split : splits()) known.emplace_back(split.name);
    const std::string hint = fmt::format("expected one of {}", fmt::join(known, ", "));
    if (root.get("stages") != nullptr) {
      roles_.use_split(nullptr, true);  // nor are there any
      if (node != nullptr)
        in_.fail(
            *node, "a scheme of stages names no split",
            "leave it out: it is quad-dyadic where times is even, quad-dual where it is odd, and "
            "quad-triangle where the first of them is linear");
      return;
    }
    if (node == nullptr) {
      if (root.get("extends") != nullptr) return;               // it comes from there
      if (const toml::node* misspelt = misspelt_split(root)) {  // which is told as an unknown key
        if (const auto* name = misspelt->as_string()) scheme_.split = find_split(name->get());
      } else {
        in_.fail(Error{"the file names no split", hint, in_.file(), 1, 1});
      }
      roles_.use_split(scheme_.split, scheme_.split == nullptr);
      return;
    }
    const std::size_t before = in_.faults();
    const std::string name = in_.text(*node, "split");
    scheme_.split = find_split(name);
    roles_.use_split(scheme_.split, scheme_.split == nullptr);
    if (in_.unharmed_since(before) && scheme_.split == nullptr)
      in_.fail(*node, fmt::format("unknown split '{}'", name),
               base::did_you_mean(name, known, hint));
    if (scheme_.split != nullptr && scheme_.split->mixed) {
      in_.fail(*node, fmt::format("the split {} is one of stages", name),
               fmt::format("leave it out: it follows from stages whose first is \"{}\"", kLinear));
      scheme_.split = nullptr;
    }
  }

  void read_weights(const toml::table& root) {
    const toml::node* node = root.get("weights");
    if (node == nullptr) return;
    const std::string text = in_.text(*node, "weights");
    if (!node->is_string() || text == "exact") return;
    if (text == "decimal") {
      scheme_.has_decimals = true;
      in_.admit_decimals();
    } else {
      in_.fail(*node, fmt::format("unknown kind of weights '{}'", text),
               base::did_you_mean(text, {"exact", "decimal"}, "expected \"exact\" or \"decimal\""));
    }
  }

  /// The value of a key that was meant to be "split".
  static const toml::node* misspelt_split(const toml::table& root) {
    const std::vector<std::string> known = known_keys();
    for (const auto& [key, node] : root) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      const std::vector<std::string> near = base::near_words(key.str(), known);
      if (std::find(near.begin(), near.end(), "split") != near.end()) return &node;
    }
    return nullptr;
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
      extends_place_ = in_.place(node);
      const std::string text = in_.text(node, name);
      if (node.is_string())
        extends_ = text;
      else
        unread_.everything = true;
    } else if (name == "lattice") {
      lattice_ = &node;
    } else if (name == "let") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { read_let(k, v); });
    } else if (name == "parameter") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { read_parameter(k, v); });
    } else if (name == "roles") {
      in_.each(node, name, [&](const toml::key& k, const toml::node& v) { roles_.read(k, v); });
    } else if (name == "facts") {
      in_.each_element(node, name, [&](const toml::node& v) { read_fact(in_, v, scheme_); });
    } else if (name == "mask") {
      const std::size_t before = in_.faults();
      scheme_.mask = read_rows(in_, node, name);
      if (!in_.unharmed_since(before)) unread_.everything = true;  // all rules follow from it
    } else if (name == "factors") {
      const std::size_t before = in_.faults();
      scheme_.factors = read_factors(in_, node);
      if (!in_.unharmed_since(before)) unread_.everything = true;
    } else if (name == "stages") {
      const std::size_t before = in_.faults();
      scheme_.stages = read_stages(in_, node, [&](const toml::node& v) {
        in_pair_ = true;
        Rule pair = cases_of(RuleKind::vertex, v);
        in_pair_ = false;
        return pair;
      });
      if (!in_.unharmed_since(before)) unread_.everything = true;
    } else if (name != "split" && name != "weights" && name != "boundary" &&
               name != "smooth-triangles" && (!find_rule(name) || name.starts_with(kBoundary))) {
      in_.unknown_key(key, "a scheme file", known_keys());
      unread_.tables = unread_.tables || node.is_table() || node.is_array();
    }
  }

  /// Whether it can be defined by that name here.
  bool check_name(const toml::key& key) {
    const Place at = in_.place(key);
    const std::string name(key.str());
    const bool possible = is_identifier(name) && !is_reserved(name);
    if (!possible)
      in_.fail(Error{fmt::format("'{}' cannot be the name of a let or a parameter", name),
                     "use letters, digits and _; n, k, pi and the functions are taken", at.file,
                     at.line, at.column});
    const bool fresh = names_.insert({name, at}).second;
    if (!fresh)
      in_.fail(Error{fmt::format("'{}' is defined twice", name), {}, at.file, at.line, at.column});
    if (!possible || !fresh) unread_.definitions.insert(name);
    return possible && fresh;
  }

  void read_let(const toml::key& key, const toml::node& node) {
    if (!check_name(key)) return;
    const std::size_t before = in_.faults();
    Formula formula = in_.formula(node, key.str());
    if (in_.unharmed_since(before))
      scheme_.lets.emplace_back(key.str(), std::move(formula));
    else
      unread_.definitions.emplace(key.str());
  }

  void read_parameter(const toml::key& key, const toml::node& node) {
    if (!check_name(key)) return;
    const std::size_t before = in_.faults();
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
        in_.unknown_key(k, "a parameter", {"default", "range", "meaning"});
      }
    });
    if (in_.unharmed_since(before) && !has_default)
      in_.fail(node, fmt::format("parameter '{}' has no default", parameter.name),
               "add default = \"...\"");
    if (in_.unharmed_since(before))
      scheme_.parameters.push_back(std::move(parameter));
    else
      unread_.definitions.emplace(key.str());
  }

  void read_range(const toml::node& node, Parameter& parameter) {
    std::vector<Formula> bounds;
    const std::size_t before = in_.faults();
    in_.each_element(node, "range",
                     [&](const toml::node& v) { bounds.push_back(in_.formula(v, "range")); });
    if (!in_.unharmed_since(before)) return;
    if (bounds.size() != 2) {
      in_.fail(node, "a range needs two bounds, as [\"0\", \"1\"]");
      return;
    }
    parameter.low = bounds[0];
    parameter.high = bounds[1];
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
      if (node != nullptr) read_rule(kind, *node);
    }
    if (const toml::node* smooth = root.get("smooth-triangles")) read_smooth_triangles(*smooth);
    if (const toml::node* boundary = root.get("boundary"))
      in_.each(*boundary, "boundary", [&](const toml::key& key, const toml::node&) {
        if (!find_rule(std::string(kBoundary) + std::string(key.str())))
          in_.unknown_key(key, "boundary", boundary_keys());
      });
  }

  /// A rule of its own, under the name of the kind that it is.
  void read_smooth_triangles(const toml::node& node) {
    const std::string name(rule_name(RuleKind::edge_side));
    in_.each(node, "smooth-triangles", [&](const toml::key& key, const toml::node& value) {
      if (key.str() != name) return in_.unknown_key(key, "smooth-triangles", {name});
      const std::size_t before = in_.faults();
      Rule rule = cases_of(RuleKind::edge_side, value);
      if (in_.unharmed_since(before)) scheme_.smooth_triangles = std::move(rule);
    });
  }

  void read_rule(RuleKind kind, const toml::node& node) {
    const std::size_t before = in_.faults();
    bool& unread = unread_.rules[static_cast<std::size_t>(kind)];
    Rule rule = cases_of(kind, node);
    unread = unread || !in_.unharmed_since(before);
    if (!rule.empty()) scheme_.rules[static_cast<std::size_t>(kind)] = std::move(rule);
  }

  /// As messages call it; stages have a rule of their own.
  [[nodiscard]] std::string_view name_of(RuleKind kind) const {
    return in_pair_ ? "stages.pair" : rule_name(kind);
  }

  std::optional<Walk> find_pair_role(const toml::key& key) {
    const std::vector<std::string> known(kPairRoles.begin(), kPairRoles.end());
    if (std::find(known.begin(), known.end(), key.str()) != known.end())
      return pair_walk(key.str());
    in_.unknown_key(key, "stages.pair", {"when", "self", "ring", "diagonal"});
    return std::nullopt;
  }

  Rule cases_of(RuleKind kind, const toml::node& node) {
    const std::size_t before = in_.faults();
    Rule rule;
    if (node.is_array()) {
      in_.each_element(node, name_of(kind),
                       [&](const toml::node& v) { rule.push_back(read_case(kind, v)); });
    } else {
      rule.push_back(read_case(kind, node));
    }
    for (std::size_t i = 0; in_.unharmed_since(before) && i + 1 < rule.size(); ++i)
      if (!rule[i].when)
        in_.fail(Error{"a case without a guard hides the cases after it",
                       "give it a guard, as when = \"n == 3\", or put it last", in_.file(),
                       rule[i].place.line, rule[i].place.column});
    if (in_.unharmed_since(before) && rule.empty())
      in_.fail(node, fmt::format("the {} rule has no case", name_of(kind)));
    return rule;
  }

  /// Weights that cannot be read are left out.
  RuleCase read_case(RuleKind kind, const toml::node& node) {
    RuleCase result;
    result.place = in_.place(node);
    const std::size_t before = in_.faults();
    bool any = false;
    in_.each(node, name_of(kind), [&](const toml::key& key, const toml::node& v) {
      const std::size_t before_key = in_.faults();
      if (key.str() == "when") {
        Formula guard = in_.formula(v, "when");
        if (in_.unharmed_since(before_key)) result.when = std::move(guard);
        if (!rule_has_valence(kind))
          in_.fail(v, fmt::format("the {} rule has no n to guard", name_of(kind)));
        return;
      }
      any = true;
      std::optional<Walk> walk = in_pair_ ? find_pair_role(key) : roles_.find(kind, key);
      Formula value = in_.formula(v, key.str());
      if (!walk) unread_.rules[static_cast<std::size_t>(kind)] = true;
      if (walk && in_.unharmed_since(before_key))
        result.weights.push_back({std::string(key.str()), std::move(*walk), std::move(value)});
    });
    if (in_.unharmed_since(before) && !any)
      in_.fail(node, fmt::format("the {} rule has no weights", name_of(kind)));
    return result;
  }

  /// Takes from the extended scheme what this file does not state.
  void inherit(const std::string& name) {
    const auto fail = [&](std::string message, std::string hint = {}) {
      in_.fail(Error{std::move(message), std::move(hint), in_.file(), extends_place_.line,
                     extends_place_.column});
      unread_.everything = true;
    };
    if (name.empty()) {
      fail("extends names no scheme", "give a shipped name or a path, or leave it out");
      return;
    }
    base::Faults of_base;
    std::optional<Scheme> base = extended_(name, of_base);
    for (Error fault : base::by_place(of_base.list())) {
      std::string hint = std::exchange(fault.hint, {});
      fail(fault_of_base(name, fault), std::move(hint));
    }
    if (!base) return;
    if (scheme_.split != nullptr && base->split != scheme_.split) {
      fail(fmt::format("'{}' has the split {}, this file {}", name, base->split->name,
                       scheme_.split->name));
      return;
    }
    if (!scheme_.stages) scheme_.stages = std::move(base->stages);
    scheme_.split = base->split;
    scheme_.has_decimals = scheme_.has_decimals || base->has_decimals;
    if (!scheme_.smooth_triangles && !scheme_.rule(RuleKind::edge))  // it belongs to that one
      scheme_.smooth_triangles = std::move(base->smooth_triangles);
    for (std::size_t i = 0; i < kRuleKinds; ++i)
      if (!scheme_.rules[i]) scheme_.rules[i] = std::move(base->rules[i]);
    for (auto& let : base->lets)
      if (names_.find(let.first) == names_.end()) scheme_.lets.push_back(std::move(let));
    for (Parameter& parameter : base->parameters)
      if (names_.find(parameter.name) == names_.end())
        scheme_.parameters.push_back(std::move(parameter));
  }

  /// A file may ask for what a scheme of both kinds of faces is on one.
  void restrict_to_lattice(const toml::node& node) {
    const std::optional<Lattice> lattice = read_lattice(in_, node);
    if (!lattice || unread_.everything) return;
    if (!scheme_.stages || scheme_.stages->first != Stages::First::linear)
      return in_.fail(node, "a lattice is named, but there is only one",
                      "it is for stages that begin linearly, on triangles and quads");
    if (const auto taken = names_.find(std::string(kQuads)); taken != names_.end())
      in_.fail(Error{fmt::format("'{}' cannot be the name of a let or a parameter here", kQuads),
                     "it is the number of quads at a vertex", in_.file(), taken->second.line,
                     taken->second.column});
    restrict_stages(scheme_, *lattice);
    scheme_.split = split_of_stages(*scheme_.stages);
  }

  /// Rules follow from a mask or from factors, and stages are in place of them, so stating them too
  /// would say them twice.
  void check_given_once() {
    if (!scheme_.mask && !scheme_.factors && !scheme_.stages) return;
    const std::size_t before = in_.faults();
    const bool extends_stages = scheme_.stages && scheme_.stages->place.file != in_.file();
    const Place place = scheme_.mask      ? scheme_.mask->place
                        : scheme_.factors ? scheme_.factors->place
                        : extends_stages  ? extends_place_
                                          : scheme_.stages->place;
    const std::string_view given = scheme_.mask      ? "its mask"
                                   : scheme_.factors ? "factors"
                                   : extends_stages  ? "the stages that it extends"
                                                     : "stages";
    const auto twice = [&](std::string_view also) {
      in_.fail(Error{fmt::format("the scheme is given by {} and by {} too", given, also),
                     scheme_.stages ? "keep the stages, or leave them out"
                                    : "keep the rules, the mask or the factors",
                     place.file, place.line, place.column});
    };
    if (scheme_.mask && scheme_.factors) twice("factors");
    if (scheme_.stages && (scheme_.mask || scheme_.factors))
      twice(extends_stages ? "the stages that it extends" : "stages");
    if (scheme_.stages && scheme_.smooth_triangles) twice("smooth-triangles");
    for (const auto& rule : scheme_.rules)
      if (rule) twice(extends_ && !extends_stages ? "the rules that it extends" : "rules");
    if (!in_.unharmed_since(before)) unread_.everything = true;
  }

  TomlReader in_;
  RoleReader roles_{in_};
  const ExtendedScheme& extended_;
  Scheme scheme_;
  Unread unread_;
  bool in_pair_ = false;  // while that is read
  std::optional<std::string> extends_;
  const toml::node* lattice_ = nullptr;  // what the file says of it
  Place extends_place_;
  std::map<std::string, Place> names_;
};

}  // namespace

Draft read_scheme_text(std::string_view text, const std::string& file,
                       const ExtendedScheme& extended, base::Faults& faults) {
  return SchemeFileReader(file, extended, faults).run(text);
}

}  // namespace limn::scheme
