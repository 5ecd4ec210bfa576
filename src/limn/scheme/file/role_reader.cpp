#include <fmt/core.h>

#include "limn/base/near_word.h"
#include "limn/scheme/file/role_reader.h"
#include "limn/scheme/file/scheme_words.h"
#include "limn/scheme/placement.h"

namespace limn::scheme {

void RoleReader::read(const toml::key& rule, const toml::node& table) {
  const std::optional<RuleKind> kind = find_rule(rule.str());
  if (!kind) {
    const Place at = in_.place(rule);
    in_.fail(Error{fmt::format("unknown key '{}' in roles", rule.str()),
                   base::did_you_mean(rule.str(), rule_names(),
                                      "expected the name of a rule, as edge or \"boundary.edge\""),
                   at.file, at.line, at.column});
    has_unread_roles_ = true;
    return;
  }
  in_.each(table, rule.str(), [&](const toml::key& role, const toml::node& v) {
    own_[{*kind, std::string(role.str())}] = read_walk(*kind, role, v);
  });
}

std::optional<Walk> RoleReader::read_walk(RuleKind kind, const toml::key& role,
                                          const toml::node& node) {
  const std::size_t before = in_.faults();
  const std::string text = in_.text(node, role.str());
  if (!in_.unharmed_since(before)) return std::nullopt;
  const Place at = in_.place(node);
  Result<Walk> walk = parse_walk(text);
  if (!walk) {
    in_.fail(Error{fmt::format("role '{}': {}", role.str(), walk.error().message),
                   walk.error().hint, at.file, at.line, at.column + walk.error().column});
    return std::nullopt;
  }
  if (role.str() == "when") {
    in_.fail(node, "'when' cannot be the name of a role", "it stands for the guard of a case");
    return std::nullopt;
  }
  if (split_ != nullptr && !check(kind, role.str(), *walk, at)) return std::nullopt;
  return std::move(*walk);
}

std::optional<Walk> RoleReader::find(RuleKind kind, const toml::key& key) {
  const std::string name(key.str());
  if (split_ == nullptr) {
    tell_missing_split(key);
    return std::nullopt;
  }
  if (const auto own = own_.find({kind, name}); own != own_.end())
    return own->second ? checked(kind, *own->second, key) : std::nullopt;
  for (const NamedRole& role : named_roles(kind, split_->lattice))
    if (role.name == name) return checked(kind, parse_walk(role.walk).value(), key);
  if (!has_unread_roles_)
    in_.unknown_key(key, fmt::format("the {} rule of a {} scheme", rule_name(kind), split_->name),
                    known_in(kind),
                    fmt::format("a role defined under [roles.{}]", rule_name(kind)));
  return std::nullopt;
}

void RoleReader::tell_missing_split(const toml::key& key) {
  if (!has_faulty_split_)
    in_.fail(Error{"a file that extends another and states rules must name its split",
                   "add split = \"...\", the same as there", in_.file(), in_.place(key).line,
                   in_.place(key).column});
  has_faulty_split_ = true;  // told once
}

/// The keys that the rule may have. Precondition, as for the next: the split is known.
std::vector<std::string> RoleReader::known_in(RuleKind kind) const {
  std::vector<std::string> known{"when"};
  for (const NamedRole& role : named_roles(kind, split_->lattice))
    if (!parse_walk(role.walk).value().reads_face || gives_every_face_a_vertex())
      known.emplace_back(role.name);
  for (const auto& [own, walk] : own_)
    if (own.first == kind) known.push_back(own.second);
  return known;
}

bool RoleReader::gives_every_face_a_vertex() const {
  return split_->births.faces && !split_->boundary_rests();
}

/// Whether the walk makes sense in the rule; else it fails at `at`. Precondition: the split is
/// known.
bool RoleReader::check(RuleKind kind, std::string_view name, const Walk& walk, const Place& at) {
  if (const Result<Placement> placement = place(kind, split_->lattice, walk); !placement) {
    in_.fail(Error{fmt::format("role '{}' of the {} rule: {}", name, rule_name(kind),
                               placement.error().message),
                   placement.error().hint, at.file, at.line, at.column});
    return false;
  }
  if (!walk.reads_face || gives_every_face_a_vertex()) return true;
  in_.fail(Error{fmt::format("role '{}' reads the new vertex of a face, and the split {} does not "
                             "give every face one",
                             name, split_->name),
                 {},
                 at.file,
                 at.line,
                 at.column});
  return false;
}

std::optional<Walk> RoleReader::checked(RuleKind kind, const Walk& walk, const toml::key& key) {
  return check(kind, key.str(), walk, in_.place(key)) ? std::optional<Walk>(walk) : std::nullopt;
}

}  // namespace limn::scheme
