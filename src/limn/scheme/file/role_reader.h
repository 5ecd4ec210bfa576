#pragma once
/// The roles of a scheme file: those that it defines under [roles.RULE], and the walk that a key of
/// a rule stands for. Private to scheme/.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/scheme/file/toml_reader.h"

namespace limn::scheme {

class RoleReader {
 public:
  /// `in` must outlive the reader.
  explicit RoleReader(TomlReader& in) : in_(in) {}

  /// The split that the file names: nullptr where it names none, or where that was a fault, which
  /// is told already.
  void use_split(const Split* split, bool faulty) {
    split_ = split;
    has_faulty_split_ = faulty;
  }

  /// [roles.RULE]: defines roles of that rule.
  void read(const toml::key& rule, const toml::node& table);

  /// The walk of the role that `key` names in that rule; nothing, after a fault, where it is not
  /// known, makes no sense in the rule, or was faulty when it was defined.
  [[nodiscard]] std::optional<Walk> find(RuleKind kind, const toml::key& key);

 private:
  std::optional<Walk> read_walk(RuleKind kind, const toml::key& role, const toml::node& node);
  void tell_missing_split(const toml::key& key);
  [[nodiscard]] std::vector<std::string> known_in(RuleKind kind) const;
  [[nodiscard]] bool gives_every_face_a_vertex() const;
  [[nodiscard]] bool check(RuleKind kind, std::string_view name, const Walk& walk, const Place& at);
  [[nodiscard]] std::optional<Walk> checked(RuleKind kind, const Walk& walk, const toml::key& key);

  TomlReader& in_;
  const Split* split_ = nullptr;
  bool has_faulty_split_ = false;  // and that was told
  bool has_unread_roles_ = false;  // of a rule that is not known
  // nothing: its definition is faulty
  std::map<std::pair<RuleKind, std::string>, std::optional<Walk>> own_;
};

}  // namespace limn::scheme
