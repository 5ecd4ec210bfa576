#include <charconv>
#include <memory>
#include <set>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/extraordinary/eigencomponents.h"
#include "limn/report/eigen_formula_report.h"
#include "limn/report/eigen_report.h"
#include "limn/scheme/check.h"

namespace limn::app {
namespace {

constexpr int kLargestValence = 2000;
constexpr int kMostRings = 6;

struct EigenOptions {
  SchemeOptions scheme;
  std::string valence = "3..12";
  int rings = 0;
  bool json = false;
  bool formulas = false;
  bool latex = false;
};

struct ValenceRange {
  int first, last;
};

bool read_integer(std::string_view text, int& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

/// "7" or "3..12".
Result<ValenceRange> read_valences(const std::string& text) {
  ValenceRange range{};
  const std::size_t dots = text.find("..");
  const bool one = dots == std::string::npos;
  const std::string_view view = text;
  const bool read = read_integer(view.substr(0, dots), range.first) &&
                    read_integer(one ? view : view.substr(dots + 2), range.last);
  const std::string hint = "a valence, as 7, or a range, as 3..12";
  if (!read) return Error{fmt::format("--valence: '{}' is no valence", text), hint, {}, 0, 0};
  if (range.first > range.last)
    return Error{fmt::format("--valence: the range {} is empty", text), hint, {}, 0, 0};
  if (range.first < kSmallestValence || range.last > kLargestValence)
    return Error{fmt::format("--valence: {} is not between {} and {}", text, kSmallestValence,
                             kLargestValence),
                 hint,
                 {},
                 0,
                 0};
  return range;
}

/// Parameters that the command line gives a value have it in the formulas too.
int print_formulas(const EigenOptions& options) {
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  std::set<std::string> given;
  for (const std::string& assignment : options.scheme.parameters) {
    std::string name = assignment.substr(0, assignment.find('='));
    std::erase(name, ' ');
    given.insert(std::move(name));
  }
  const Result<EigenFormulas> formulas = eigen_formulas(*scheme, given, options.rings);
  if (!formulas) return report(formulas.error());
  if (options.json)
    fmt::print("{}\n", eigen_formulas_json(scheme->name, *formulas).dump());
  else
    fmt::print("{}", eigen_formulas_text(scheme->name, *formulas,
                                         options.latex ? Notation::latex : Notation::text));
  return kDone;
}

int analyse(const EigenOptions& options) {
  const Result<ValenceRange> range = read_valences(options.valence);
  if (!range) return report(range.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  FrequencyAnalysis analysis(*scheme, options.rings);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text = scheme->name + "\n" + eigen_heading();
  for (int n = range->first; n <= range->last; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return report(blocks.error());
    const Eigencomponents components = approx_eigencomponents(*blocks);
    if (options.json)
      list.push_back(eigen_json(*blocks, components));
    else
      text += eigen_text(components);
  }
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"scheme", scheme->name}, {"valences", list}}.dump());
  else
    fmt::print("{}", text);
  return kDone;
}

}  // namespace

void declare_eigen(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand(
      "eigen", "frequency blocks, labelled eigencomponents and verdicts at extraordinary vertices");
  const auto options = std::make_shared<EigenOptions>();
  command->add_option("SCHEME", options->scheme.name, "a shipped scheme, or a scheme file")
      ->required();
  CLI::Option* const valence =
      command->add_option("--valence", options->valence, "a valence, or a range of them")
          ->type_name("N or A..B")
          ->capture_default_str();
  command
      ->add_option("--rings", options->rings,
                   "analyse so many rings; 0: as many as control the surface")
      ->check(CLI::Range(0, kMostRings));
  options->scheme.declare_parameters(*command);
  CLI::Option* const json = command->add_flag("--json", options->json, "print one JSON object");
  CLI::Option* const formulas =
      command
          ->add_flag("--formulas", options->formulas, "closed formulas, for all valences at once")
          ->excludes(valence);
  command->add_flag("--latex", options->latex, "formulas as LaTeX")
      ->needs(formulas)
      ->excludes(json);
  command->footer("Example: limn eigen loop --valence 3..12");
  command->callback([&action, options] {
    action = [options] { return options->formulas ? print_formulas(*options) : analyse(*options); };
  });
}

}  // namespace limn::app
