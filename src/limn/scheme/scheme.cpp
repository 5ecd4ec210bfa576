#include <algorithm>
#include <filesystem>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/file.h"
#include "limn/scheme/check.h"
#include "limn/scheme/mask.h"
#include "limn/scheme/names.h"
#include "limn/scheme/scheme_reader.h"
#include "limn/scheme/scheme_size.h"
#include "limn/scheme/shipped_files.h"

namespace limn {
namespace {

constexpr std::size_t kDeepestExtension = 8;

/// The files that are being read, each extended by the one before it.
using Chain = std::vector<std::string>;

Result<Scheme> read_any(const std::string& name_or_path, const Chain& chain);

/// Whether a scheme with this split can have such a rule.
bool has_use_for(const Split& split, RuleKind kind) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::boundary_vertex: return split.births_vertices;
    case RuleKind::edge:
    case RuleKind::edge_end: return split.births_edges;
    case RuleKind::boundary_edge: return split.births_edges && !split.trisects_boundary;
    case RuleKind::face: return split.births_faces;
    case RuleKind::corner: return split.births_corners;
    case RuleKind::boundary_edge_end: return split.trisects_boundary;
  }
  return false;
}

std::string rules_of(const Split& split) {
  std::vector<std::string_view> names;
  for (int i = 0; i < kRuleKinds; ++i)
    if (const auto kind = static_cast<RuleKind>(i); has_use_for(split, kind))
      names.push_back(rule_name(kind));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Which rules the split calls for: missing ones and ones that it has no use for.
Status check_rules_fit(const Scheme& scheme) {
  const Split& split = *scheme.split;
  const bool given_by_mask = scheme.mask || scheme.factors;
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    const bool used = has_use_for(split, kind);
    const bool optional = kind >= RuleKind::boundary_vertex || kind == RuleKind::edge_end;
    if (used && !optional && !given_by_mask && !scheme.rule(kind))
      return missing_rule(scheme, kind, regular_valence(kind, split.lattice));
    if (!used && scheme.rule(kind)) {
      const Place& place = scheme.rule(kind)->front().place;
      return Error{
          fmt::format("the split {} has no use for a rule '{}'", split.name, rule_name(kind)),
          "its rules are " + rules_of(split), place.file, place.line, place.column};
    }
  }
  return Done{};
}

Status check_scheme(Scheme& scheme) {
  const ExactBudget budget(kExactWork);
  if (Status status = check_names(scheme); !status) return status;
  if (scheme.mask || scheme.factors)
    if (Status status = add_rules_from_mask(scheme); !status) return status;
  if (Status status = check_rules_fit(scheme); !status) return status;
  return check_rules(scheme);
}

/// `chain` ends with `path`.
Result<Scheme> parse_in_chain(std::string_view text, const std::string& path, const Chain& chain) {
  Result<Scheme> scheme = read_scheme_text(
      text, path, [&](const std::string& extended) { return read_any(extended, chain); });
  if (!scheme) return scheme;
  if (scheme->name.empty()) scheme->name = std::filesystem::path(path).stem().string();
  if (Status status = check_scheme(*scheme); !status) return status.error();
  return scheme;
}

/// `id`: the path, or the name of a shipped scheme (which a user's file may be called after).
Result<Scheme> parse_next(std::string_view text, const std::string& path, const std::string& id,
                          Chain chain) {
  if (chain.size() > kDeepestExtension)
    return Error{
        fmt::format("more than {} schemes extend one another", kDeepestExtension), {}, {}, 0, 0};
  if (std::find(chain.begin(), chain.end(), id) != chain.end())
    return Error{fmt::format("circular: {} -> {}", fmt::join(chain, " -> "), id), {}, {}, 0, 0};
  chain.push_back(id);
  return parse_in_chain(text, path, chain);
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1] ? 1U : 0U)});
      diagonal = above;
    }
  }
  return row.back();
}

Error unknown_scheme(const std::string& name) {
  std::vector<std::string> near;
  for (const std::string& known : shipped_schemes())
    if (edit_distance(name, known) <= 2 || (name.size() > 2 && known.find(name) != known.npos))
      near.push_back(known);
  return {fmt::format("no shipped scheme and no file is called '{}'", name),
          near.empty() ? "`limn schemes` lists the shipped ones; else give the path of a .toml file"
                       : fmt::format("did you mean {}?", fmt::join(near, " or ")),
          {},
          0,
          0};
}

/// A scheme file is small, and a file: a device or a pipe may never end.
Result<std::string> read_scheme_file(const std::string& path) {
  return read_file(path, {.bytes = kMostSchemeBytes, .pipes = false});
}

/// A shipped name, or a path: relative to the folder of the file that extends it, if one does.
Result<Scheme> read_any(const std::string& name_or_path, const Chain& chain) {
  namespace fs = std::filesystem;
  for (const ShippedFile& shipped : shipped_files())
    if (shipped.name == name_or_path)
      return parse_next(shipped.text, name_or_path + ".toml", name_or_path, chain);
  fs::path path(name_or_path);
  const bool looks_like_path = path.has_parent_path() || path.extension() == ".toml";
  if (!chain.empty() && path.is_relative())
    path = (fs::path(chain.back()).parent_path() / path).lexically_normal();
  std::error_code ignored;
  if (!looks_like_path && !fs::exists(path, ignored)) return unknown_scheme(name_or_path);
  Result<std::string> text = read_scheme_file(path.string());
  if (!text) return text.error();
  return parse_next(*text, path.string(), path.string(), chain);
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

Error unknown_parameter(const Scheme& scheme, const std::string& name) {
  std::vector<std::string_view> known;
  known.reserve(scheme.parameters.size());
  for (const Parameter& parameter : scheme.parameters) known.push_back(parameter.name);
  return {fmt::format("scheme '{}' has no parameter '{}'", scheme.name, name),
          known.empty() ? "it has no parameters" : fmt::format("it has {}", fmt::join(known, ", ")),
          {},
          0,
          0};
}

/// Puts the expression in place; nothing is checked yet.
Status assign(Scheme& scheme, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    return Error{fmt::format("'{}' sets no parameter", assignment),
                 "write name=expression, as a=1/8",
                 {},
                 0,
                 0};
  const std::string name = trimmed(assignment.substr(0, equals));
  const auto found = std::find_if(scheme.parameters.begin(), scheme.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  if (found == scheme.parameters.end()) return unknown_parameter(scheme, name);
  Result<Expression> expression = Expression::parse(assignment.substr(equals + 1));
  if (!expression) {
    Error error = expression.error();
    error.message = fmt::format("-p {}: column {}: {}", assignment,
                                static_cast<int>(equals) + 1 + error.column, error.message);
    error.column = 0;
    return error;
  }
  found->value = {std::move(*expression), {}};
  return Done{};
}

}  // namespace

Result<Scheme> parse_scheme(std::string_view text, const std::string& path) {
  return parse_in_chain(text, path, {path});
}

Result<Scheme> read_scheme(const std::string& path) {
  Result<std::string> text = read_scheme_file(path);
  if (!text) return text.error();
  return parse_scheme(*text, path);
}

Result<Scheme> find_scheme(const std::string& name_or_path) { return read_any(name_or_path, {}); }

std::vector<std::string> shipped_schemes() {
  std::vector<std::string> names;
  for (const ShippedFile& file : shipped_files()) names.emplace_back(file.name);
  std::sort(names.begin(), names.end());  // the files are in the order of NAME.toml
  return names;
}

Status set_parameters(Scheme& scheme, const std::vector<std::string>& assignments) {
  if (assignments.empty()) return Done{};
  Scheme changed = scheme;
  for (const std::string& assignment : assignments)
    if (Status status = assign(changed, assignment); !status) return status;
  if (Status status = check_scheme(changed); !status) {
    Error error = status.error();
    error.message = fmt::format("-p {}: {}", fmt::join(assignments, " -p "), error.message);
    if (error.line == 0) error.column = 0;
    return error;
  }
  scheme = std::move(changed);
  return Done{};
}

Status set_parameter(Scheme& scheme, const std::string& assignment) {
  return set_parameters(scheme, {assignment});
}

}  // namespace limn
