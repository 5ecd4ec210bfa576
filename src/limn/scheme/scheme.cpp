#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/files/file.h"
#include "limn/base/near_word.h"
#include "limn/number/exact.h"
#include "limn/scheme/check.h"
#include "limn/scheme/decimals.h"
#include "limn/scheme/file/names.h"
#include "limn/scheme/file/scheme_files.h"
#include "limn/scheme/file/scheme_reader.h"
#include "limn/scheme/file/shipped_files.h"
#include "limn/scheme/mask.h"
#include "limn/scheme/mask_rules.h"
#include "limn/scheme/parameter_setter.h"
#include "limn/scheme/scheme_size.h"
#include "limn/scheme/scope.h"
#include "limn/scheme/shipped_scheme.h"
#include "limn/scheme/stages.h"

namespace limn {
namespace {

constexpr std::size_t kDeepestExtension = 8;

/// Whether a scheme with this split can have such a rule.
bool has_use_for(const Split& split, RuleKind kind) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::boundary_vertex: return split.births.vertices;
    case RuleKind::edge:
    case RuleKind::boundary_spoke: return split.halves_edges();
    case RuleKind::edge_end: return split.births.edges && split.births.vertices;
    case RuleKind::edge_third: return split.births.thirds;
    case RuleKind::edge_side: return false;  // but in smooth-triangles
    case RuleKind::boundary_edge: return split.halves_edges() || split.odd_step_cut == 2;
    case RuleKind::face: return split.births.faces;
    case RuleKind::face_end: return split.births.faces && split.births.vertices;
    case RuleKind::corner: return split.births.corners;
    case RuleKind::boundary_edge_end:
      return split.births.vertices && (split.births.edges || split.boundary_rests());
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
void check_rules_fit(const Scheme& scheme, const scheme::Unread& unread, base::Faults& faults) {
  const Split& split = *scheme.split;
  const bool given_by_mask = scheme.mask || scheme.factors;
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    const bool used = has_use_for(split, kind);
    const bool optional = kind >= RuleKind::boundary_vertex || stands_in_for(kind, split);
    if (unread.something && !scheme.rule(kind)) continue;  // it may be that rule, by another name
    if (used && !optional && !given_by_mask && !scheme.rule(kind))
      faults.add(scheme::missing_rule(scheme, kind, regular_valence(kind, split.lattice)));
    if (!used && scheme.rule(kind)) {
      const Place& place = scheme.rule(kind)->front().place;
      faults.add(
          {fmt::format("the split {} has no use for a rule '{}'", split.name, rule_name(kind)),
           "its rules are " + rules_of(split), place.file, place.line, place.column});
    }
  }
}

/// Whether the weights are checked, which is nearly all of the cost, or have been.
enum class Weights { checked, trusted };

/// Names that the scheme's own file defines, and those whose values depend on them.
std::set<std::string> own_names(const Scheme& scheme) {
  std::vector<std::pair<std::string, const Formula*>> definitions;
  for (const auto& [name, value] : scheme.lets) definitions.emplace_back(name, &value);
  for (const Parameter& one : scheme.parameters) definitions.emplace_back(one.name, &one.value);
  std::set<std::string> names;
  for (std::size_t before = 1; before != names.size();) {
    before = names.size();
    for (const auto& [name, value] : definitions)
      if (value->place.file == scheme.file || scheme::uses_any(*value, names)) names.insert(name);
  }
  return names;
}

/// Whether a rule is as the extended scheme has it: it was checked there, which may cost seconds.
bool is_as_extended(const Scheme& scheme, const Rule& rule, const std::set<std::string>& own) {
  return std::all_of(rule.begin(), rule.end(), [&](const RuleCase& one) {
    return one.place.file != scheme.file && !(one.when && scheme::uses_any(*one.when, own)) &&
           std::none_of(one.weights.begin(), one.weights.end(),
                        [&](const Weight& weight) { return scheme::uses_any(weight.value, own); });
  });
}

/// Whether two rules have the same weights on the regular lattice, role by role.
bool says_the_same(const Scheme& scheme, RuleKind one, RuleKind other) {
  const int n = regular_valence(one, scheme.split->lattice);
  const Result<const RuleCase*> a = scheme::applicable_case(scheme, one, n);
  const Result<const RuleCase*> b = scheme::applicable_case(scheme, other, n);
  if (!a || !b || *a == nullptr || *b == nullptr) return false;
  const auto weighs = [&](const RuleCase& from, const RuleCase& in) {
    scheme::Scope<number::Exact> scope(scheme, n, std::nullopt);
    return std::all_of(from.weights.begin(), from.weights.end(), [&](const Weight& weight) {
      Result<number::Exact> rest = scope(weight.value);
      for (const Weight& same : in.weights)
        if (rest && same.walk == weight.walk) {
          const Result<number::Exact> value = scope(same.value);
          if (!value) return false;
          rest = number::Exact::subtract(*rest, *value);
        }
      return rest.ok() && rest->is_zero();
    });
  };
  return weighs(**a, **b) && weighs(**b, **a);
}

/// The rule for smooth triangles, and that there is a use for it.
void check_smooth_triangles(const Scheme& scheme, const std::set<std::string>& valueless,
                            base::Faults& faults) {
  const Split& split = *scheme.split;
  if (!split.any_polygons || !split.halves_edges()) {
    const Place& place = scheme.smooth_triangles->front().place;
    faults.add({fmt::format("the split {} has no use for smooth-triangles", split.name),
                "it is for splits of faces with any number of corners that halve edges", place.file,
                place.line, place.column});
    return;
  }
  Scheme smooth = scheme;
  use_smooth_triangles(smooth);
  scheme::check_rules(
      smooth, valueless, [](RuleKind kind) { return kind != RuleKind::edge_side; }, faults);
  if (faults.none() && !says_the_same(smooth, RuleKind::edge_side, RuleKind::edge)) {
    const Place& place = scheme.smooth_triangles->back().place;
    faults.add({"the smooth-triangles rule says of quads something else than the edge rule",
                "it is for the first step; its case at n = 4 needs the weights of edge", place.file,
                place.line, place.column});
  }
}

/// That facts are of one lattice where meshes have both kinds of faces.
void check_lattices_of_facts(const Scheme& scheme, base::Faults& faults) {
  const bool both = scheme.stages && scheme.stages->is_mixed();
  for (const Fact& fact : scheme.facts)
    if (both != fact.lattice.has_value() && !(scheme.stages && scheme.stages->only))
      faults.add({both ? "the fact names no lattice" : "a lattice is named, but there is only one",
                  both ? "add lattice = \"triangle\" or \"quad\"" : "leave it out", fact.place.file,
                  fact.place.line, fact.place.column});
}

/// From the parameters of a scheme of stages follows its split. Where something is wrong already it
/// may be what these depend on.
void check_stages(Scheme& scheme, base::Faults& faults, Weights weights) {
  if (!faults.none()) return;
  check_lattices_of_facts(scheme, faults);
  if (Status status = scheme::settle_stages(scheme); !status) return faults.add(status.error());
  if (weights == Weights::checked)
    scheme::check_rules(
        scheme, {}, [](RuleKind) { return false; }, faults);
}

/// All that can be judged of what was read. `base`: the split of the scheme that it extends, if
/// any.
void check_scheme(Scheme& scheme, const scheme::Unread& unread, const Split* base,
                  base::Faults& faults, Weights weights = Weights::checked) {
  const number::ExactBudget budget(scheme::kExactWork);
  scheme::check_names(scheme, unread, faults);
  if (scheme.stages) return check_stages(scheme, faults, weights);
  check_lattices_of_facts(scheme, faults);
  if (scheme.split == nullptr) return;
  const std::set<std::string> valueless = scheme::valueless_names(scheme, unread);
  if (scheme.mask || scheme.factors) {
    if (!faults.none()) return;
    if (Status status = scheme::add_rules_from_mask(scheme); !status) {
      faults.add(status.error());
      return;
    }
  }
  check_rules_fit(scheme, unread, faults);
  if (scheme.has_decimals && faults.none()) scheme::divide_by_sums(scheme);
  if (weights == Weights::trusted) return;
  const std::set<std::string> own = own_names(scheme);
  const bool extends = base == scheme.split && !scheme.has_decimals;
  scheme::check_rules(
      scheme, valueless,
      [&](RuleKind kind) {
        return unread.rule(kind) || !has_use_for(*scheme.split, kind) ||
               (extends && is_as_extended(scheme, *scheme.rule(kind), own));
      },
      faults);
  if (scheme.smooth_triangles && faults.none()) check_smooth_triangles(scheme, valueless, faults);
}

/// The files that are being read, each extended by the one before it.
struct Link {
  std::string id, path;
};
using Chain = std::vector<Link>;

std::string text_of(const Chain& chain) {
  std::string text;
  for (const Link& link : chain) text += (text.empty() ? "" : " -> ") + link.path;
  return text;
}

std::optional<Scheme> parse_in_chain(const SchemeText& file, const SchemeLoader& load, Chain chain,
                                     Weights weights, base::Faults& faults) {
  if (chain.size() > kDeepestExtension) {
    faults.add({fmt::format("more than {} schemes extend one another", kDeepestExtension)});
    return std::nullopt;
  }
  const bool again =
      std::any_of(chain.begin(), chain.end(), [&](const Link& link) { return link.id == file.id; });
  chain.push_back({file.id, file.path});
  if (again) {
    faults.add({"circular: " + text_of(chain)});
    return std::nullopt;
  }
  const Split* base_split = nullptr;
  const auto extended = [&](const std::string& name,
                            base::Faults& of_base) -> std::optional<Scheme> {
    const Result<SchemeText> base = load(name, file.path.empty() ? "." : file.path);
    if (!base) of_base.add(base.error());
    std::optional<Scheme> scheme =
        base ? parse_in_chain(*base, load, chain, weights, of_base) : std::nullopt;
    if (scheme) base_split = scheme->split;
    return scheme;
  };
  scheme::Draft draft = scheme::read_scheme_text(file.text, file.path, extended, faults);
  if (draft.unread.everything) return std::nullopt;
  Scheme& scheme = draft.scheme;
  if (scheme.name.empty()) scheme.name = std::filesystem::path(file.path).stem().string();
  check_scheme(scheme, draft.unread, base_split, faults, weights);
  if (!faults.none()) return std::nullopt;
  return std::move(scheme);
}

Result<Scheme> parse_first(const SchemeText& file, const SchemeLoader& load,
                           Weights weights = Weights::checked) {
  const number::ExactBudget budget(scheme::kExactWork);  // of all the files together
  std::vector<SourceText> texts{{file.path, file.text}};
  const SchemeLoader noting = [&](const std::string& name, const std::string& from) {
    Result<SchemeText> found = load(name, from);
    if (found) texts.push_back({name, found->text});
    return found;
  };
  base::Faults faults;
  std::optional<Scheme> scheme = parse_in_chain(file, noting, {}, weights, faults);
  if (!scheme) return faults.joined();
  scheme->texts = std::move(texts);
  return *std::move(scheme);
}

Error unknown_scheme(const std::string& name) {
  const std::string near = base::did_you_mean(name, shipped_schemes());
  return {fmt::format("no shipped scheme and no file is called '{}'", name),
          near.empty() ? "`limn schemes` lists the shipped ones; else give the path of a .toml file"
                       : near};
}

/// A scheme file is small, and a file: a device or a pipe may never end.
Result<std::string> read_scheme_file(const std::string& path) {
  return base::read_file(path, {.bytes = scheme::kMostSchemeBytes, .pipes = false});
}

/// The same for every way to write the path; the path itself where there is no such file.
std::string file_id(const std::string& path) {
  std::error_code fault;
  const std::filesystem::path canonical = std::filesystem::canonical(path, fault);
  return fault ? path : canonical.string();
}

}  // namespace

Result<SchemeText> load_scheme_text(const std::string& name, const std::string& from) {
  namespace fs = std::filesystem;
  for (const scheme::ShippedFile& shipped : scheme::shipped_files())
    if (shipped.name == name)
      return SchemeText{std::string(shipped.text), name + ".toml", "shipped " + name};
  if (name.find('\0') != std::string::npos)
    return Error{fmt::format("'{}' is no file's name: it holds a NUL", name)};
  fs::path path(name);
  const bool looks_like_path = path.has_parent_path() || path.extension() == ".toml";
  if (!from.empty() && path.is_relative())
    path = (fs::path(from).parent_path() / path).lexically_normal();
  std::error_code ignored;
  if (!looks_like_path && (name.empty() || !fs::exists(path, ignored))) return unknown_scheme(name);
  Result<std::string> text = read_scheme_file(path.string());
  if (!text) return text.error();
  return SchemeText{std::move(*text), path.string(), file_id(path.string())};
}

Result<Scheme> parse_scheme(std::string_view text, const std::string& path,
                            const SchemeLoader& load) {
  return parse_first({std::string(text), path, path}, load);
}

Result<Scheme> parse_texts(const std::vector<SourceText>& texts) {
  if (texts.empty()) return Error{"there is no text of a scheme in it"};
  std::size_t next = 1;
  const SchemeLoader load = [&](const std::string& name, const std::string&) -> Result<SchemeText> {
    if (next >= texts.size() || texts[next].name != name)
      return Error{fmt::format("the text of '{}' is not in it", name)};
    const SourceText& text = texts[next++];
    return SchemeText{text.text, name, fmt::format("{} {}", next, name)};
  };
  Result<Scheme> scheme = parse_scheme(texts.front().text, texts.front().name, load);
  if (scheme && next != texts.size()) return Error{"it has texts that the scheme does not use"};
  return scheme;
}

std::vector<std::string> scheme_files(const Scheme& scheme) {
  std::vector<std::string> files;
  std::filesystem::path path;
  for (const SourceText& text : scheme.texts) {
    path = path.parent_path() / text.name;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) files.push_back(path.string());
  }
  return files;
}

Result<Scheme> parse_scheme(std::string_view text, const std::string& path) {
  return parse_first({std::string(text), path, path.empty() ? path : file_id(path)},
                     load_scheme_text);
}

Result<Scheme> read_scheme(const std::string& path) {
  Result<std::string> text = read_scheme_file(path);
  if (!text) return text.error();
  return parse_scheme(*text, path);
}

Result<Scheme> find_scheme(const std::string& name_or_path) {
  const Result<SchemeText> text = load_scheme_text(name_or_path, {});
  if (!text) return text.error();
  return parse_first(*text, load_scheme_text);
}

Result<Scheme> scheme::shipped_scheme(const std::string& name) {
  for (const scheme::ShippedFile& file : scheme::shipped_files())
    if (file.name == name)
      return parse_first({std::string(file.text), name + ".toml", "shipped " + name},
                         load_scheme_text, Weights::trusted);
  return unknown_scheme(name);
}

std::vector<std::string> shipped_schemes() {
  std::vector<std::string> names;
  for (const scheme::ShippedFile& file : scheme::shipped_files()) names.emplace_back(file.name);
  std::sort(names.begin(), names.end());  // the files are in the order of NAME.toml
  return names;
}

Status set_parameters(Scheme& scheme, const std::vector<std::string>& assignments) {
  if (assignments.empty()) return Done{};
  Scheme changed = scheme;
  if (Status status = scheme::detail::assign_parameters(changed, assignments); !status)
    return status;
  base::Faults faults;
  check_scheme(changed, {}, nullptr, faults);
  // the others mostly follow from the same value
  if (!faults.none()) return scheme::detail::in_assignments(assignments, faults.list().front());
  scheme = std::move(changed);
  return Done{};
}

Status set_parameter(Scheme& scheme, const std::string& assignment) {
  return set_parameters(scheme, {assignment});
}

bool use_smooth_triangles(Scheme& scheme) {
  if (!scheme.smooth_triangles) return false;
  scheme.rules[static_cast<std::size_t>(RuleKind::edge_side)] = scheme.smooth_triangles;
  return true;
}

}  // namespace limn
