#include "limn/report/scheme_report.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/lattice_report.h"
#include "limn/scheme/check.h"
#include "limn/scheme/decimals.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/placement.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

/// How many positions a role has: "2", "n", "2n", "q".
std::string positions(const Scheme& scheme, RuleKind kind, const Weight& weight) {
  if (scheme.split->mixed && pair_role(weight) == PairRole::diagonal)
    return std::string(scheme::kQuads);
  const scheme::Placement placement =
      scheme::place(kind, scheme.split->lattice, weight.walk).value();
  if (!placement.times_n) return to_string(placement.count);
  return placement.count == 1 ? "n" : to_string(placement.count) + "n";
}

std::string range_text(const Parameter& parameter) {
  if (!parameter.low || !parameter.high) return {};
  return fmt::format("[{}, {}]", parameter.low->expression.text(),
                     parameter.high->expression.text());
}

/// What the role's name means, where it is one of limn's; its walk, where it is the file's own.
std::string meaning(const Scheme& scheme, RuleKind kind, const Weight& weight) {
  for (const NamedRole& role : named_roles(kind, scheme.split->lattice))
    if (role.name == weight.role) return std::string(role.meaning);
  return "walk " + to_string(weight.walk);
}

std::string anchor_text(RuleKind kind) {
  switch (kind) {
    case RuleKind::vertex: return "an interior vertex with n edges";
    case RuleKind::edge: return "an interior edge";
    case RuleKind::edge_end: return "an interior edge, seen from an end with n edges";
    case RuleKind::edge_third: return "each third of an interior edge, from the near end";
    case RuleKind::edge_side: return "an interior edge, seen from a face with n corners";
    case RuleKind::face: return "a face with n corners";
    case RuleKind::face_end: return "a face, seen from a corner with n edges";
    case RuleKind::corner: return "a corner of a face with n corners";
    case RuleKind::boundary_vertex: return "a boundary vertex with n edges";
    case RuleKind::boundary_edge: return "a boundary edge";
    case RuleKind::boundary_edge_end:
      return "a boundary edge, seen from an end with n edges; if cut in three, its third there";
    case RuleKind::boundary_spoke:
      return "an interior edge, seen from its end on the boundary with n edges";
  }
  return {};
}

std::string case_text(const Scheme& scheme, RuleKind kind, const RuleCase& rule_case) {
  std::string text;
  if (rule_case.when) text += fmt::format("    when {}\n", rule_case.when->expression.text());
  std::size_t widest = 0;
  for (const Weight& weight : rule_case.weights)
    widest = std::max(widest, weight.value.expression.text().size());
  for (const Weight& weight : rule_case.weights)
    text +=
        fmt::format("    {:<9} {:>2} × {:<{}}  {}\n", weight.role, positions(scheme, kind, weight),
                    weight.value.expression.text(), widest, meaning(scheme, kind, weight));
  return text;
}

Json rule_json(const Scheme& scheme, RuleKind kind, const Rule& rule) {
  Json cases = Json::array();
  for (const RuleCase& rule_case : rule) {
    Json weights = Json::array();
    for (const Weight& weight : rule_case.weights)
      weights.push_back({{"role", weight.role},
                         {"walk", to_string(weight.walk)},
                         {"positions", positions(scheme, kind, weight)},
                         {"weight", weight.value.expression.text()}});
    Json entry;
    entry["when"] = rule_case.when ? Json(rule_case.when->expression.text()) : Json();
    entry["weights"] = std::move(weights);
    cases.push_back(std::move(entry));
  }
  return cases;
}

/// "loop-type with its b = 1/3 and beta = beta - a/n"
std::string equivalence_text(const Equivalence& same) {
  std::string text = "  " + same.scheme;
  for (std::size_t i = 0; i < same.with.size(); ++i)
    text += fmt::format("{}{} = {}", i == 0 ? ", its " : " and ", same.with[i].first,
                        same.with[i].second.expression.text());
  return text + (same.source.empty() ? "" : "  [" + base::printable(same.source) + "]") + "\n";
}

Json equivalences_json(const Scheme& scheme) {
  Json list = Json::array();
  for (const Equivalence& same : scheme.equivalences) {
    Json with = Json::object();
    for (const auto& [name, formula] : same.with) with[name] = formula.expression.text();
    list.push_back({{"scheme", same.scheme}, {"with", with}, {"source", same.source}});
  }
  return list;
}

using Lets = std::vector<std::pair<std::string, Formula>>;

/// Those of the file, and those of the schemes that it extends as far as something uses them.
Lets listed_lets(const Scheme& scheme) {
  std::set<std::string> used;
  std::vector<std::string> open;
  const auto use = [&](const Formula& formula) {
    for (const std::string& name : formula.expression.names())
      if (used.insert(name).second) open.push_back(name);
  };
  scheme::each_rule_formula(scheme, use);
  scheme::each_mask_formula(scheme, use);
  for (const auto& [name, formula] : scheme.lets)
    if (formula.place.file == scheme.file) use(formula);
  while (!open.empty()) {
    const std::string name = std::move(open.back());
    open.pop_back();
    for (const auto& [let, formula] : scheme.lets)
      if (let == name) use(formula);
  }
  Lets listed;
  for (const auto& let : scheme.lets)
    if (let.second.place.file == scheme.file || used.count(let.first) > 0) listed.push_back(let);
  return listed;
}

Json parameters_json(const Scheme& scheme) {
  Json parameters = Json::array();
  for (const Parameter& parameter : scheme.parameters) {
    Json entry{{"name", parameter.name}, {"value", parameter.value.expression.text()}};
    if (parameter.low && parameter.high)
      entry["range"] = {parameter.low->expression.text(), parameter.high->expression.text()};
    entry["meaning"] = parameter.meaning;
    parameters.push_back(std::move(entry));
  }
  return parameters;
}

std::string_view first_text(const Stages& stages) {
  return stages.first == Stages::First::linear ? "linear" : "bilinear";
}

std::string stages_text(const Scheme& scheme) {
  const Stages& stages = *scheme.stages;
  const bool linear = stages.first == Stages::First::linear;
  std::string text = fmt::format(
      "\nstages, one after the other\n"
      "  {}: cut by {}; edges give their middles, {} the means of their corners\n"
      "  average × {} ({}): from vertices to faces and from faces to vertices, in turn; values end "
      "at {}\n  two averagings: {}{}\n",
      first_text(stages), linear ? "quad-triangle" : "quad-dyadic",
      linear ? "faces that are no triangles" : "faces", stages.count,
      stages.times.expression.text(), stages.count % 2 == 0 ? "vertices" : "faces",
      anchor_text(RuleKind::vertex), linear ? " and q quads" : "");
  for (const RuleCase& pair : stages.pair) text += case_text(scheme, RuleKind::vertex, pair);
  return text;
}

Json stages_json(const Scheme& scheme) {
  const Stages& stages = *scheme.stages;
  return {{"first", first_text(stages)},
          {"then", "average"},
          {"times", stages.count},
          {"pair", rule_json(scheme, RuleKind::vertex, stages.pair)}};
}

}  // namespace

std::string describe(const Scheme& scheme) {
  std::string text = base::printable(scheme.name) +
                     (scheme.title.empty() ? "" : ": " + base::printable(scheme.title)) + '\n';
  text += fmt::format("  split   {} ({})\n", scheme.split->name, scheme.split->description);
  if (!scheme.source.empty()) text += fmt::format("  source  {}\n", base::printable(scheme.source));
  if (scheme.has_decimals)
    text += fmt::format(
        "  weights decimals as printed: a rule's sum may be 1 to rounding alone (within {}); its "
        "weights are then divided by it\n",
        scheme::kDecimalTolerance);
  if (!scheme.notes.empty())
    text += fmt::format("  notes   {}\n", base::printable_lines(scheme.notes));
  if (!scheme.parameters.empty()) text += "\nparameters\n";
  for (const Parameter& parameter : scheme.parameters)
    text += fmt::format("  {} = {}  {}  {}\n", parameter.name, parameter.value.expression.text(),
                        range_text(parameter), base::printable(parameter.meaning));
  const Lets lets = listed_lets(scheme);
  if (!lets.empty()) text += "\nlet\n";
  for (const auto& [name, formula] : lets)
    text += fmt::format("  {} = {}\n", name, formula.expression.text());
  if (!scheme.equivalences.empty()) text += "\nthe same as\n";
  for (const Equivalence& same : scheme.equivalences) text += equivalence_text(same);
  if (scheme.stages) text += stages_text(scheme);
  if (!scheme.stages) text += "\nrules: role, positions × weight\n";
  bool any = scheme.stages.has_value();
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (!scheme.rule(kind)) continue;
    any = true;
    text += fmt::format("  {}: {}\n", rule_name(kind), anchor_text(kind));
    for (const RuleCase& rule_case : *scheme.rule(kind)) text += case_text(scheme, kind, rule_case);
  }
  if (!any) text += "  none: the mask lacks the lattice's symmetry\n";
  const std::vector<Scheme> lattices = scheme::lattice_schemes(scheme);
  for (const Scheme& one : lattices) {
    if (lattices.size() > 1)
      text += fmt::format("\non {}s\n", scheme::lattice_name(one.split->lattice));
    const Result<Mask> mask = regular_mask(one);
    text += mask ? lattice_text(*mask)
                 : fmt::format("\nno analysis on the lattice: {}\n", mask.error().text());
  }
  return text;
}

nlohmann::ordered_json summary_json(const Scheme& scheme) {
  return {{"name", scheme.name},
          {"title", scheme.title},
          {"split", scheme.split->name},
          {"source", scheme.source},
          {"parameters", parameters_json(scheme)}};
}

nlohmann::ordered_json describe_json(const Scheme& scheme) {
  Json json = summary_json(scheme);
  json["notes"] = scheme.notes;
  json["file"] = scheme.file;
  json["weights"] = scheme.has_decimals ? "decimal" : "exact";
  json["lets"] = Json::object();
  for (const auto& [name, formula] : listed_lets(scheme))
    json["lets"][name] = formula.expression.text();
  json["same_as"] = equivalences_json(scheme);
  if (scheme.stages) json["stages"] = stages_json(scheme);
  json["rules"] = Json::object();
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (scheme.rule(kind))
      json["rules"][std::string(rule_name(kind))] = rule_json(scheme, kind, *scheme.rule(kind));
  }
  const std::vector<Scheme> lattices = scheme::lattice_schemes(scheme);
  for (const Scheme& one : lattices) {
    const Result<Mask> mask = regular_mask(one);
    const Json found = mask ? lattice_json(*mask) : Json{{"mask", nullptr}};
    if (lattices.size() == 1) {
      json.update(found);
      break;
    }
    json["lattices"].push_back({{"lattice", scheme::lattice_name(one.split->lattice)}});
    json["lattices"].back().update(found);
  }
  return json;
}

Result<std::string> describe_latex(const Scheme& scheme) {
  std::string latex;
  for (const Scheme& one : scheme::lattice_schemes(scheme)) {
    const Result<Mask> mask = regular_mask(one);
    if (!mask) return mask.error();
    latex += (latex.empty() ? "" : "\n") +
             lattice_latex(scheme::label_on_lattice(scheme.name, one), *mask);
  }
  return latex;
}

}  // namespace limn::report
