#include "limn/report/eigen/eigen_formula_report.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/number/polynomial_text.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

const std::string& written(const ClosedRoot& root, number::Notation notation) {
  return notation == number::Notation::text ? root.text : root.latex;
}

/// The end of the cosine that begins at `at`: past its parenthesis, or past its fraction.
std::size_t cosine_end(const std::string& text, std::size_t at, number::Notation notation) {
  const char open = notation == number::Notation::text ? '(' : '{';
  const char close = notation == number::Notation::text ? ')' : '}';
  int groups = notation == number::Notation::text ? 1 : 2;
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == open) ++depth;
    if (text[at] == close && --depth == 0 && --groups == 0) return at + 1;
  }
  return std::string::npos;
}

/// With c for a cosine that comes more than once, and what c is.
std::string abbreviated(std::string text, number::Notation notation) {
  const std::string begin = notation == number::Notation::text ? "cos(" : "\\cos\\frac";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t end = cosine_end(text, at, notation);
    if (end == std::string::npos) break;
    const std::string cosine = text.substr(at, end - at);
    if (text.find(cosine, end) == std::string::npos) continue;
    for (std::size_t i = text.find(cosine); i != std::string::npos; i = text.find(cosine, i + 1))
      text.replace(i, cosine.size(), "c");
    return text + (notation == number::Notation::text ? "  with c = " : ",\\quad c = ") + cosine;
  }
  return text;
}

std::string frequency_text(const std::string& name, const FrequencyFormulas& formulas,
                           number::Notation notation) {
  const std::string omega = notation == number::Notation::text ? name : number::latex_name(name);
  const std::string relation = !formulas.and_above                  ? "="
                               : notation == number::Notation::text ? "≥"
                                                                    : "\\ge";
  return fmt::format("{} {} {}", omega, relation, formulas.frequency);
}

std::string formula_line(const EigenFormula& one, number::Notation notation) {
  std::string line = written(one.root, notation);
  if (one.by_lets) line = written(*one.by_lets, notation) + " = " + line;
  line = abbreviated(line, notation);
  if (one.root.multiplicity > 1)
    line += notation == number::Notation::text
                ? fmt::format("  ({} times)", one.root.multiplicity)
                : fmt::format("\\quad ({}\\times)", one.root.multiplicity);
  return line;
}

std::string equation_line(const EigenEquation& one, const std::string& unknown,
                          number::Notation notation) {
  if (notation == number::Notation::latex)
    return fmt::format("{}\\colon\\ {} = 0", number::latex_name(unknown), one.polynomial.latex);
  return fmt::format("{} values {} with {} = 0 (degree {}, no closed form)",
                     one.degree * one.polynomial.multiplicity, unknown, one.polynomial.text,
                     one.degree);
}

/// A row of align* each, without the breaks between them; or a line of text.
std::vector<std::string> frequency_lines(const EigenFormulas& formulas, const FrequencyFormulas& at,
                                         number::Notation notation) {
  const bool latex = notation == number::Notation::latex;
  const std::string head = frequency_text(formulas.frequency, at, notation);
  std::vector<std::string> lines;
  const auto add = [&](int ring, const std::string& line) {
    const std::string shown = lines.empty() ? head : std::string();
    lines.push_back(latex ? fmt::format("  {} & {} & \\text{{ring {}}}",
                                        lines.empty() ? head + "\\colon" : shown, line, ring)
                          : fmt::format("  {:<12}  ring {}  {}\n", shown, ring, line));
  };
  for (const EigenFormula& one : at.eigenvalues) add(one.ring, formula_line(one, notation));
  for (const EigenEquation& one : at.left)
    add(one.ring, equation_line(one, formulas.unknown, notation));
  return lines;
}

Json root_json(int ring, const ClosedRoot& root) {
  return {{"ring", ring},
          {"text", root.text},
          {"latex", root.latex},
          {"multiplicity", root.multiplicity}};
}

Json frequency_json(const EigenFormulas& formulas, const ValenceFormulas& at,
                    const FrequencyFormulas& frequency) {
  Json spans = Json::array();
  for (const ValenceSpan span : at.valences)
    spans.push_back({span.first, span.last ? Json(*span.last) : Json()});
  Json eigenvalues = Json::array();
  for (const EigenFormula& one : frequency.eigenvalues) {
    Json entry = root_json(one.ring, one.root);
    entry["by_lets"] =
        one.by_lets ? Json{{"text", one.by_lets->text}, {"latex", one.by_lets->latex}} : Json();
    eigenvalues.push_back(std::move(entry));
  }
  Json left = Json::array();
  for (const EigenEquation& one : frequency.left) {
    Json entry = root_json(one.ring, one.polynomial);
    entry["degree"] = one.degree;
    left.push_back(std::move(entry));
  }
  return {{"valences", valences_text(at, number::Notation::text)},
          {"spans", std::move(spans)},
          {"rings", at.rings},
          {"frequency", frequency.and_above ? Json(frequency_text(formulas.frequency, frequency,
                                                                  number::Notation::text))
                                            : Json(frequency.frequency)},
          {"eigenvalues", std::move(eigenvalues)},
          {"left", std::move(left)}};
}

}  // namespace

std::string valences_text(const ValenceFormulas& formulas, number::Notation notation) {
  const bool latex = notation == number::Notation::latex;
  const std::string at_most = latex ? "\\le" : "≤";
  const std::string at_least = latex ? "\\ge" : "≥";
  std::string text;
  for (const ValenceSpan span : formulas.valences) {
    if (!text.empty()) text += latex ? ",\\ " : ", ";
    if (!span.last)
      text += fmt::format("n {} {}", at_least, span.first);
    else if (*span.last == span.first)
      text += fmt::format("n = {}", span.first);
    else
      text += fmt::format("{} {} n {} {}", span.first, at_most, at_most, *span.last);
  }
  return text;
}

std::string eigen_formulas_text(const std::string& scheme, const EigenFormulas& formulas,
                                number::Notation notation) {
  const bool latex = notation == number::Notation::latex;
  std::string text = (latex ? "% " : "") + base::printable(scheme) + "\n";
  for (const RegularName& name : formulas.regular_names)
    text += fmt::format("{}{}: {} at valence {}\n", latex ? "% " : "", name.name, name.parameter,
                        name.n);
  for (const ValenceFormulas& at : formulas.valences) {
    const std::string valences = valences_text(at, notation);
    std::vector<std::string> lines;
    for (const FrequencyFormulas& frequency : at.frequencies)
      for (std::string& line : frequency_lines(formulas, frequency, notation))
        lines.push_back(std::move(line));
    if (latex)
      text += fmt::format("For ${}$:\n\\begin{{align*}}\n{}\n\\end{{align*}}\n", valences,
                          fmt::join(lines, " \\\\\n"));
    else
      text += fmt::format("{}\n{}", valences, fmt::join(lines, ""));
  }
  return text;
}

nlohmann::ordered_json eigen_formulas_json(const std::string& scheme,
                                           const EigenFormulas& formulas) {
  Json list = Json::array();
  for (const ValenceFormulas& at : formulas.valences)
    for (const FrequencyFormulas& frequency : at.frequencies)
      list.push_back(frequency_json(formulas, at, frequency));
  Json names = Json::array();
  for (const RegularName& name : formulas.regular_names)
    names.push_back({{"name", name.name}, {"parameter", name.parameter}, {"n", name.n}});
  return {{"scheme", scheme},
          {"formulas", std::move(list)},
          {"unknown", formulas.unknown},
          {"names", std::move(names)}};
}

}  // namespace limn::report
