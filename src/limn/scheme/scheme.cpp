#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/file.h"
#include "limn/scheme/check.h"
#include "limn/scheme/mask.h"
#include "limn/scheme/scheme_reader.h"
#include "limn/scheme/shipped_files.h"

namespace limn {
namespace {

constexpr int kDeepestExtension = 8;

Result<Scheme> read_any(const std::string& name_or_path, const std::string& base, int depth);

/// Which rules the split calls for: missing ones and ones that it has no use for.
Status check_rules_fit(const Scheme& scheme) {
  const Split& split = *scheme.split;
  const bool given_by_mask = scheme.mask || scheme.factors;
  const auto used = [&](RuleKind kind) {
    switch (kind) {
      case RuleKind::vertex:
      case RuleKind::boundary_vertex: return split.births_vertices;
      case RuleKind::edge:
      case RuleKind::edge_end:
      case RuleKind::boundary_edge: return split.births_edges;
      case RuleKind::face: return split.births_faces;
      case RuleKind::corner: return split.births_corners;
      case RuleKind::boundary_edge_end: return split.trisects_boundary;
    }
    return false;
  };
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    const bool optional = kind >= RuleKind::boundary_vertex || kind == RuleKind::edge_end;
    if (used(kind) && !optional && !given_by_mask && !scheme.rule(kind))
      return missing_rule(scheme, kind, regular_valence(kind, split.lattice));
    if (!used(kind) && scheme.rule(kind)) {
      const Place& place = scheme.rule(kind)->front().place;
      return Error{fmt::format("the split {} has no use for a rule '{}'", split.name,
                               rule_name(kind)),
                   {}, place.file, place.line, place.column};
    }
  }
  return Done{};
}

/// Every name in a let or a parameter must mean something, used or not.
Status check_names(const Scheme& scheme) {
  std::set<std::string> known{"n", "k"};
  for (const auto& [name, formula] : scheme.lets) known.insert(name);
  for (const Parameter& parameter : scheme.parameters) known.insert(parameter.name);
  const auto check = [&](const Formula& formula) -> Status {
    for (const std::string& name : formula.expression.names())
      if (known.count(name) == 0)
        return Error{fmt::format("unknown name '{}' in '{}'", name, formula.expression.text()),
                     "names are n, k, the parameters and the lets", formula.place.file,
                     formula.place.line, formula.place.column};
    return Done{};
  };
  for (const auto& [name, formula] : scheme.lets)
    if (Status status = check(formula); !status) return status;
  for (const Parameter& parameter : scheme.parameters)
    if (Status status = check(parameter.value); !status) return status;
  return Done{};
}

Status check_scheme(Scheme& scheme) {
  if (Status status = check_names(scheme); !status) return status;
  if (scheme.mask || scheme.factors)
    if (Status status = add_rules_from_mask(scheme); !status) return status;
  if (Status status = check_rules_fit(scheme); !status) return status;
  return check_rules(scheme);
}

Result<Scheme> parse_at_depth(std::string_view text, const std::string& path, int depth) {
  if (depth > kDeepestExtension)
    return Error{"the chain of 'extends' is circular or too long", {}, path, 0, 0};
  Result<Scheme> scheme = read_scheme_text(text, path, [&](const std::string& extended) {
    return read_any(extended, path, depth + 1);
  });
  if (!scheme) return scheme;
  if (scheme->name.empty()) scheme->name = std::filesystem::path(path).stem().string();
  if (Status status = check_scheme(*scheme); !status) return status.error();
  return scheme;
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
    if (edit_distance(name, known) <= 2 || known.find(name) != std::string::npos)
      near.push_back(known);
  return {fmt::format("no shipped scheme and no file is called '{}'", name),
          near.empty() ? "`limn schemes` lists the shipped ones; else give the path of a .toml file"
                       : fmt::format("did you mean {}?", fmt::join(near, " or ")),
          {}, 0, 0};
}

/// A shipped name, or a path: relative to `base`'s folder where there is one.
Result<Scheme> read_any(const std::string& name_or_path, const std::string& base, int depth) {
  namespace fs = std::filesystem;
  for (const ShippedFile& shipped : shipped_files())
    if (shipped.name == name_or_path)
      return parse_at_depth(shipped.text, name_or_path + ".toml", depth);
  fs::path path(name_or_path);
  if (!base.empty() && path.is_relative()) path = fs::path(base).parent_path() / path;
  std::error_code ignored;
  const bool looks_like_path = path.has_parent_path() || path.extension() == ".toml";
  if (!looks_like_path && !fs::exists(path, ignored)) return unknown_scheme(name_or_path);
  Result<std::string> text = read_file(path.string());
  if (!text) return text.error();
  return parse_at_depth(*text, path.string(), depth);
}

}  // namespace

Result<Scheme> parse_scheme(std::string_view text, const std::string& path) {
  return parse_at_depth(text, path, 0);
}

Result<Scheme> read_scheme(const std::string& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text.error();
  return parse_scheme(*text, path);
}

Result<Scheme> find_scheme(const std::string& name_or_path) {
  return read_any(name_or_path, {}, 0);
}

std::vector<std::string> shipped_schemes() {
  std::vector<std::string> names;
  for (const ShippedFile& file : shipped_files()) names.emplace_back(file.name);
  return names;
}

Status set_parameter(Scheme& scheme, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    return Error{fmt::format("'{}' sets no parameter", assignment), "write name=expression, as "
                 "a=1/8", {}, 0, 0};
  const std::string name = assignment.substr(0, equals);
  std::vector<std::string_view> known;
  for (Parameter& parameter : scheme.parameters) {
    known.push_back(parameter.name);
    if (parameter.name != name) continue;
    Result<Expression> expression = Expression::parse(assignment.substr(equals + 1));
    if (!expression) {
      Error error = expression.error();
      error.message = fmt::format("-p {}: column {}: {}", assignment,
                                  static_cast<int>(equals) + 1 + error.column, error.message);
      error.column = 0;
      return error;
    }
    parameter.value = {std::move(*expression), {}};
    return check_scheme(scheme);
  }
  return Error{fmt::format("scheme '{}' has no parameter '{}'", scheme.name, name),
               known.empty() ? "it has no parameters"
                             : fmt::format("it has {}", fmt::join(known, ", ")),
               {}, 0, 0};
}

}  // namespace limn
