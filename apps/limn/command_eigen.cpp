#include <memory>
#include <set>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/regular/smoothness/second_differences.h"
#include "limn/report/eigen/eigen_figures.h"
#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/report/eigen/eigenvector_report.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/least_valence.h"
#include "options/scheme_argument.h"
#include "options/valences.h"

namespace limn::app {
namespace {

constexpr int kMostRings = 6;
constexpr int kMostSectors = 2000;  // of all maps of one figure together
constexpr int kMapSteps = 4;        // with which maps are judged: 16 faces along each edge
constexpr int kFineSectors = 125;   // drawn with all steps; four times as many with a step less

struct EigenOptions {
  SchemeOptions scheme;
  std::string valence = "3..12";
  int rings = 0;
  bool vectors = false;
  std::string map, chart, table;
  bool json = false;
  bool formulas = false;
  bool latex = false;
};

/// Sectors of the maps at all these valences, n at each.
long long sectors_of(Valences range) {
  const long long last = range.last, first = range.first;
  return (last * (last + 1) - first * (first - 1)) / 2;
}

/// Steps with which maps are drawn, so that a figure of many has no more faces than one of few.
int drawn_steps(long long sectors) {
  int steps = kMapSteps;
  for (long long most = kFineSectors; sectors > most; most *= 4) --steps;
  return steps;
}

Status check_map(const EigenOptions& options, Valences range) {
  if (options.map.empty()) return Done{};
  if (const Result<FigureFormat> format = figure_format(options.map); !format)
    return format.error();
  if (sectors_of(range) <= kMostSectors) return Done{};
  return Error{fmt::format("--map: the maps at the valences {}..{} have {} sectors together, and a "
                           "figure holds {} at most",
                           range.first, range.last, sectors_of(range), kMostSectors),
               "draw fewer valences at a time, as 3..60, or leave out --map"};
}

/// What is printed of one valence, gathered as text or as JSON.
class Output {
 public:
  Output(const EigenOptions& options, const Scheme& scheme, int map_steps)
      : options_(options),
        scheme_(scheme),
        regular_(find_regular_part(scheme)),
        map_steps_(map_steps),
        text_(printable(scheme.name) + "\n" + regular_part_text(regular_) + eigen_heading()) {}

  void add(const FrequencyBlocks& blocks) {
    const Eigencomponents components = approx_eigencomponents(blocks, regular_);
    nlohmann::ordered_json json;
    if (options_.json) json = eigen_json(blocks, components);
    text_ += eigen_text(components);
    if (options_.vectors && options_.json) add_vectors_json(blocks, components, json);
    if (options_.vectors) text_ += vectors_text(blocks, components);
    if (!options_.map.empty()) {
      Result<CharacteristicMap> map = approx_characteristic_map(scheme_, blocks.valence, kMapSteps);
      const std::string regular(to_string(map ? map->regular : Truth::undecided));
      const std::string reason = map ? map->reason : map.error().message;
      json["characteristic_map"] = {{"regular", regular}, {"reason", reason}};
      if (map) json["characteristic_map"]["turned_over"] = map->turned_over;
      text_ += fmt::format("           characteristic map regular, by samples: {} ({})\n", regular,
                           reason);
      if (map) keep(std::move(*map));
    }
    list_.push_back(std::move(json));
    all_.push_back(components);
  }

  [[nodiscard]] Status finish() const {
    if (!options_.map.empty())
      if (Status status = characteristic_maps_figure(scheme_.name, maps_).write(options_.map);
          !status)
        return status;
    const DataTable table = eigenvalue_table(all_);
    if (!options_.chart.empty())
      if (Status status = eigenvalue_figure(scheme_.name, table).write(options_.chart); !status)
        return status;
    if (!options_.table.empty())
      if (Status status = write_eigenvalues(options_.table, scheme_.name, table); !status)
        return status;
    if (options_.json)
      print_json({{"scheme", scheme_.name},
                  {"regular_part", regular_part_json(regular_)},
                  {"valences", list_}});
    else
      print_text(text_ + eigen_legend());
    return Done{};
  }

 private:
  /// Judged with all steps, a map may be drawn with fewer.
  void keep(CharacteristicMap map) {
    if (map_steps_ < kMapSteps)
      if (Result<CharacteristicMap> coarse =
              approx_characteristic_map(scheme_, map.valence, map_steps_))
        map.image = std::move(coarse->image);
    maps_.push_back(std::move(map));
  }

  const EigenOptions& options_;
  const Scheme& scheme_;
  RegularPart regular_;
  int map_steps_;
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
  std::string text_;
  std::vector<CharacteristicMap> maps_;
  std::vector<Eigencomponents> all_;
};

/// Parameters that the command line gives a value have it in the formulas too.
int print_formulas(const EigenOptions& options) {
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  const std::set<std::string> given =
      given_parameters(options.scheme.name, options.scheme.parameters);
  const Result<EigenFormulas> formulas = eigen_formulas(*scheme, given, options.rings);
  if (!formulas) return report(formulas.error());
  if (options.json)
    print_json(eigen_formulas_json(scheme->name, *formulas));
  else
    print_text(eigen_formulas_text(scheme->name, *formulas,
                                   options.latex ? Notation::latex : Notation::text));
  return kDone;
}

int analyse(const EigenOptions& options) {
  if (Status status = check_outputs({options.map, options.chart, options.table}); !status)
    return report(status.error());
  for (const std::string& figure : {options.map, options.chart})
    if (!figure.empty())
      if (const Result<FigureFormat> format = figure_format(figure); !format)
        return report(format.error());
  if (!options.table.empty() && !is_eigenvalue_path(options.table))
    return report({fmt::format("--table: '{}' is no table", options.table),
                   "it ends in .csv, .json or .tex"});
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  const Result<Valences> range = read_valences(options.valence, 2);
  if (!range) return report(range.error());
  if (Status status = check_map(options, *range); !status) return report(status.error());
  FrequencyAnalysis analysis(*scheme, options.rings);
  Output output(options, *scheme, drawn_steps(sectors_of(*range)));
  ProgressLine line;
  for (int n = range->first; n <= range->last; ++n) {
    line.show(fmt::format("valence {}", n));
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return report(blocks.error());
    output.add(*blocks);
  }
  if (Status status = output.finish(); !status) return report(status.error());
  return kDone;
}

}  // namespace

void declare_eigen(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "eigen",
      "frequency blocks, labelled eigencomponents and verdicts at extraordinary vertices");
  const auto options = std::make_shared<EigenOptions>();
  command->add_option("SCHEME", options->scheme.name, kSchemeArgumentHelp)->required();
  CLI::Option* const valence =
      command
          ->add_option("--valence", options->valence,
                       "a valence, or a range of them; from 2 on, of faces (dual splits) from 3 on")
          ->type_name("N or A..B")
          ->capture_default_str();
  command
      ->add_option("--rings", options->rings,
                   "analyse so many rings; 0: as many as control the surface")
      ->check(CLI::Range(0, kMostRings));
  CLI::Option* const vectors =
      command->add_flag("--vectors", options->vectors,
                        "also the eigenvectors, and the stencils of limit point and tangents");
  CLI::Option* const map = command->add_option(
      "--map", options->map,
      fmt::format("also draw the characteristic maps into FILE ({}), and say whether samples of "
                  "them fold",
                  kFigureFiles));
  map->type_name("FILE");
  CLI::Option* const chart =
      command
          ->add_option("--chart", options->chart,
                       fmt::format("also draw the eigenvalues over the valences into FILE ({})",
                                   kFigureFiles))
          ->type_name("FILE");
  CLI::Option* const table =
      command
          ->add_option("--table", options->table,
                       "also write the eigenvalues over the valences to FILE (.csv, .json or .tex)")
          ->type_name("FILE");
  options->scheme.declare_parameters(*command);
  CLI::Option* const json = command->add_flag("--json", options->json, "print one JSON object");
  CLI::Option* const formulas =
      command
          ->add_flag("--formulas", options->formulas, "closed formulas, for all valences at once")
          ->excludes(valence)
          ->excludes(vectors)
          ->excludes(map)
          ->excludes(chart)
          ->excludes(table);
  command->add_flag("--latex", options->latex, "formulas as LaTeX (eigenvalues: --table FILE.tex)")
      ->needs(formulas)
      ->excludes(json);
  command->footer(
      "Example: limn eigen loop --valence 3..12\n"
      "         limn eigen catmull-clark --valence 5 --vectors\n"
      "         limn eigen sqrt3 --valence 3..10 --map maps.pdf\n"
      "         limn eigen butterfly --valence 3..20 --chart chart.svg --table numbers.csv\n"
      "         limn eigen catmull-clark --formulas");
  command->callback([&action, options] {
    action = [options] { return options->formulas ? print_formulas(*options) : analyse(*options); };
  });
}

}  // namespace limn::app
