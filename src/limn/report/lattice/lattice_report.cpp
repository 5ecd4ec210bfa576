#include "limn/report/lattice/lattice_report.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/regular/formula.h"
#include "limn/regular/limit_values.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/symbol.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

bool is_one(const Laurent& kernel) {
  return kernel.size() == 1 && kernel.begin()->first == LatticeVector{0, 0};
}

/// Neither 1 nor the whole mask.
bool kernel_is_news(const Factorization& factors) {
  return !is_one(factors.kernel) && (factors.stages > 0 || !factors.directions.empty());
}

Mask like(const Mask& mask, Laurent coefficients) {
  return {mask.lattice, mask.dilation, std::move(coefficients)};
}

std::string indented(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    result += "  " + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return result;
}

std::string times(int count) { return count == 1 ? "once" : fmt::format("{} times", count); }

Json coefficients_json(const Laurent& coefficients) {
  Json list = Json::array();
  for (const auto& [offset, value] : coefficients)
    list.push_back({{"twice_offset", {offset[0], offset[1]}}, {"value", to_string(value)}});
  return list;
}

std::string formulas_text(const std::vector<std::string>& formulas) {
  std::string text;
  for (std::size_t i = 0; i < formulas.size(); ++i)
    text += fmt::format("  {:<5} = {}\n",
                        regular::component_name(static_cast<int>(i), number::Notation::text),
                        formulas[i]);
  return text;
}

using TextRows = std::vector<std::vector<std::string>>;

/// Each row in its place among columns that are all in use. A hexagon's rows are staggered by half
/// a cell, so that they take every second column.
TextRows in_columns(const TextRows& rows, bool staggered) {
  std::size_t widest = 0;
  for (const auto& row : rows) widest = std::max(widest, row.size());
  const std::size_t step = staggered ? 2 : 1;
  TextRows grid;
  std::vector<bool> used(step * widest, false);
  for (const auto& row : rows) {
    std::vector<std::string>& cells = grid.emplace_back(step * widest);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t column = (staggered ? widest - row.size() : 0) + step * i;
      cells[column] = row[i];
      used[column] = true;
    }
  }
  for (auto& cells : grid) {
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (used[i]) kept.push_back(std::move(cells[i]));
    cells = std::move(kept);
  }
  return grid;
}

/// One array, its scale before it.
std::string latex_array(const Mask& mask) {
  const std::string text = to_string(mask);
  std::string scale;
  TextRows rows;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (const std::size_t slash = line.find("×"); slash != std::string::npos) {
      scale = fmt::format("\\frac{{1}}{{{}}}", line.substr(2, line.find(' ') - 2));
      continue;
    }
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t from = line.find_first_not_of(' ', i);
      if (from == std::string::npos) break;
      i = std::min(line.find(' ', from), line.size());
      row.push_back(line.substr(from, i - from));
    }
  }
  const TextRows grid = in_columns(rows, mask.lattice == Lattice::triangle);
  std::string array =
      scale + "\\left[\\begin{array}{" + std::string(grid.front().size(), 'c') + "}\n";
  for (std::size_t i = 0; i < grid.size(); ++i)
    array += fmt::format("  {}{}\n", fmt::join(grid[i], " & "), i + 1 < grid.size() ? " \\\\" : "");
  return array + "\\end{array}\\right]";
}

std::string latex_formulas(const std::vector<std::string>& formulas) {
  std::string text = "\\begin{align*}\n";
  for (std::size_t i = 0; i < formulas.size(); ++i)
    text += fmt::format("  {} &= {}{}\n",
                        regular::component_name(static_cast<int>(i), number::Notation::latex),
                        formulas[i], i + 1 < formulas.size() ? " \\\\" : "");
  return text + "\\end{align*}\n";
}

}  // namespace

std::string factors_in_words(const Mask& mask) {
  const Factorization factors = factor(mask);
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (factors.stages > 0)
    add(fmt::format("{} smoothing stage{}", factors.stages, factors.stages == 1 ? "" : "s"));
  for (const auto& [step, count] : factors.directions)
    add(fmt::format("direction ({}, {}) {}", step[0], step[1], times(count)));
  if (text.empty()) return "none; the mask is its own kernel";
  if (!is_one(factors.kernel)) add("a kernel");
  return text;
}

std::string lattice_text(const Mask& mask) {
  std::string text = "\nmask on the regular lattice\n" + indented(to_string(mask));
  text += "\nfactors: " + factors_in_words(mask) + "\n";
  if (const Factorization factors = factor(mask); kernel_is_news(factors))
    text += "  kernel\n" + indented(to_string(like(mask, factors.kernel)));
  if (!is_point_symmetric(mask.coefficients)) return text;
  const Result<Laurent> stencil = regular::limit_stencil(mask);
  if (stencil) text += "\nlimit stencil\n" + indented(to_string(like(mask, *stencil)));
  const auto limit = regular::limit_formulas(mask, number::Notation::text);
  text += limit
              ? "\nsignal and artifacts in the limit, at the points of the first refined lattice\n"
              : "\nsignal and artifacts after one step (" + limit.error().message + ")\n";
  text += formulas_text(limit ? *limit : regular::step_formulas(mask, number::Notation::text));
  for (const std::string& name : regular::formula_names(mask, number::Notation::text))
    text += "  " + name + "\n";
  return text;
}

nlohmann::ordered_json lattice_json(const Mask& mask) {
  const Factorization factors = factor(mask);
  Json directions = Json::array();
  for (const auto& [step, count] : factors.directions)
    directions.push_back({{"step", {step[0], step[1]}}, {"count", count}});
  Json json{{"mask", coefficients_json(mask.coefficients)},
            {"factors",
             {{"stages", factors.stages},
              {"directions", std::move(directions)},
              {"kernel", coefficients_json(factors.kernel)}}}};
  const Result<Laurent> stencil = regular::limit_stencil(mask);
  json["limit_stencil"] = stencil ? coefficients_json(*stencil) : Json();
  json["formulas"] = Json();
  if (!is_point_symmetric(mask.coefficients)) return json;
  const auto limit = regular::limit_formulas(mask, number::Notation::text);
  json["formulas"] = {{"names", regular::formula_names(mask, number::Notation::text)},
                      {"one_step", regular::step_formulas(mask, number::Notation::text)},
                      {"limit", limit ? Json(*limit) : Json()}};
  return json;
}

std::string lattice_latex(const std::string& name, const Mask& mask) {
  std::string text =
      fmt::format("% {}: mask\n\\[\n{}\n\\]\n", base::printable(name), latex_array(mask));
  text += fmt::format("% factors: {}\n", factors_in_words(mask));
  if (const Factorization factors = factor(mask); kernel_is_news(factors))
    text += fmt::format("% kernel\n\\[\n{}\n\\]\n", latex_array(like(mask, factors.kernel)));
  if (!is_point_symmetric(mask.coefficients)) return text;
  if (const Result<Laurent> stencil = regular::limit_stencil(mask))
    text += fmt::format("% limit stencil\n\\[\n{}\n\\]\n", latex_array(like(mask, *stencil)));
  const auto limit = regular::limit_formulas(mask, number::Notation::latex);
  std::string names;
  for (const std::string& part : regular::formula_names(mask, number::Notation::latex))
    names += (names.empty() ? "$" : ", $") + part + "$";
  text += fmt::format("% magnitudes of the signal and the artifacts, {}; {}\n",
                      limit ? "in the limit" : "after one step", names);
  return text +
         latex_formulas(limit ? *limit : regular::step_formulas(mask, number::Notation::latex));
}

}  // namespace limn::report
