#include <memory>
#include <set>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/report/eigen/eigen_figures.h"
#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/report/eigen/eigenvector_report.h"
#include "limn/report/eigen/faces_report.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/least_valence.h"
#include "options/scheme_argument.h"
#include "options/valences.h"
#include "output/lattice_objects.h"

namespace limn::app {
namespace {

constexpr int kMostRings = 6;
constexpr int kMostSectors = 2000;  // of all maps of one figure together
constexpr int kMapSteps = 4;        // with which maps are judged: 16 faces along each edge
constexpr int kFineSectors = 125;   // drawn with all steps; four times as many with a step less

struct EigenOptions {
  SchemeOptions scheme;
  std::string valence = "3..12";
  std::string faces;
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
  if (const Result<figure::FigureFormat> format = figure::figure_format(options.map); !format)
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
        text_(base::printable(scheme::label_on_lattice(scheme.name, scheme)) + "\n" +
              report::regular_part_text(regular_) + report::eigen_heading()) {}

  void add(const FrequencyBlocks& blocks) {
    const Eigencomponents components = approx_eigencomponents(blocks, regular_);
    nlohmann::ordered_json json;
    if (options_.json) json = report::eigen_json(blocks, components);
    text_ += report::eigen_text(components);
    if (options_.vectors && options_.json) report::add_vectors_json(blocks, components, json);
    if (options_.vectors) text_ += report::vectors_text(blocks, components);
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

  /// Writes the files that were asked for.
  [[nodiscard]] Status write() const {
    if (!options_.map.empty())
      if (Status status =
              report::characteristic_maps_figure(scheme_.name, maps_).write(options_.map);
          !status)
        return status;
    const report::DataTable table = report::eigenvalue_table(all_);
    if (!options_.chart.empty())
      if (Status status = report::eigenvalue_figure(scheme_.name, table).write(options_.chart);
          !status)
        return status;
    if (!options_.table.empty())
      if (Status status = report::write_eigenvalues(options_.table, scheme_.name, table); !status)
        return status;
    return Done{};
  }
  [[nodiscard]] nlohmann::ordered_json json() const {
    return {{"regular_part", report::regular_part_json(regular_)}, {"valences", list_}};
  }
  [[nodiscard]] const std::string& text() const { return text_; }

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
  const std::vector<Scheme> lattices = scheme::lattice_schemes(*scheme);
  LatticeObjects json(scheme->name, lattices.size() > 1);
  std::string text;
  for (const Scheme& one : lattices) {
    const Result<EigenFormulas> formulas = eigen_formulas(one, given, options.rings);
    if (!formulas) return report(formulas.error());
    json.add(one, report::eigen_formulas_json(scheme->name, *formulas));
    text += (text.empty() ? "" : "\n") +
            report::eigen_formulas_text(
                scheme::label_on_lattice(scheme->name, one), *formulas,
                options.latex ? number::Notation::latex : number::Notation::text);
  }
  if (options.json)
    print_json(json.object());
  else
    print_text(text);
  return kDone;
}

/// "3,3,4,3,4": the corners of each face round a vertex, counterclockwise.
Result<mesh::Sectors> read_faces(const std::string& text) {
  constexpr std::size_t kLeast = 3, kMost = 100;
  const Error wrong{
      fmt::format("--faces: '{}' is no list of faces", text),
      fmt::format("the corners of each, 3 or 4, counterclockwise round the vertex, {} "
                  "to {} faces, as 3,3,4,3,4",
                  kLeast, kMost)};
  mesh::Sectors sectors;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool comma = i % 2 != 0;
    if (comma ? text[i] != ',' || i + 1 == text.size() : text[i] != '3' && text[i] != '4')
      return wrong;
    if (!comma) sectors.lattices.push_back(text[i] == '3' ? Lattice::triangle : Lattice::quad);
  }
  if (sectors.lattices.size() < kLeast || sectors.lattices.size() > kMost) return wrong;
  return sectors;
}

int analyse_faces(const EigenOptions& options) {
  const Result<mesh::Sectors> sectors = read_faces(options.faces);
  if (!sectors) return report(sectors.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  Result<limit::SectorSpectrum> spectrum = limit::approx_sector_spectrum(*scheme, *sectors);
  if (!spectrum) {
    spectrum.error().message = "--faces: " + spectrum.error().message;
    return report(spectrum.error());
  }
  if (options.json)
    print_json(report::faces_json(scheme->name, *spectrum));
  else
    print_text(report::faces_text(base::printable(scheme->name), *spectrum));
  return kDone;
}

/// Files hold one lattice's numbers.
Status check_files(const EigenOptions& options, const Scheme& scheme) {
  if (options.map.empty() && options.chart.empty() && options.table.empty()) return Done{};
  return scheme::check_one_lattice(scheme);
}

int analyse(const EigenOptions& options) {
  if (Status status = check_outputs({options.map, options.chart, options.table}); !status)
    return report(status.error());
  for (const std::string& figure : {options.map, options.chart})
    if (!figure.empty())
      if (const Result<figure::FigureFormat> format = figure::figure_format(figure); !format)
        return report(format.error());
  if (!options.table.empty() && !report::is_eigenvalue_path(options.table))
    return report({fmt::format("--table: '{}' is no table", options.table),
                   "it ends in .csv, .json or .tex"});
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  const Result<Valences> range = read_valences(options.valence, 2);
  if (!range) return report(range.error());
  if (Status status = check_map(options, *range); !status) return report(status.error());
  if (Status status = check_files(options, *scheme); !status) return report(status.error());
  base::ProgressLine line;
  const std::vector<Scheme> lattices = scheme::lattice_schemes(*scheme);
  LatticeObjects json(scheme->name, lattices.size() > 1);
  std::string text;
  for (const Scheme& one : lattices) {
    FrequencyAnalysis analysis(one, options.rings);
    Output output(options, one, drawn_steps(sectors_of(*range)));
    for (int n = range->first; n <= range->last; ++n) {
      line.show(fmt::format("valence {}", n));
      const Result<FrequencyBlocks> blocks = analysis.blocks(n);
      if (!blocks) return report(blocks.error());
      output.add(*blocks);
    }
    if (Status status = output.write(); !status) return report(status.error());
    json.add(one, output.json());
    text += output.text() + (lattices.size() > 1 ? "\n" : "");
  }
  if (lattices.size() > 1)
    text += "where triangles meet quads: --faces 3,3,3,4,4, the faces round a vertex\n";
  if (options.json)
    print_json(json.object());
  else
    print_text(text + report::eigen_legend());
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
  CLI::Option* const faces =
      command
          ->add_option("--faces", options->faces,
                       "in place of valences the faces round a vertex, by their corners, where "
                       "triangles meet quads")
          ->type_name("LIST")
          ->excludes(valence);
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
  for (CLI::Option* const other : {vectors, map, chart, table}) faces->excludes(other);
  options->scheme.declare_parameters(*command);
  CLI::Option* const json = command->add_flag("--json", options->json, "print one JSON object");
  CLI::Option* const formulas =
      command
          ->add_flag("--formulas", options->formulas, "closed formulas, for all valences at once")
          ->excludes(valence)
          ->excludes(faces)
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
      "         limn eigen catmull-clark --formulas\n"
      "         limn eigen quad-triangle --faces 3,3,4,3,4");
  command->callback([&action, options] {
    action = [options] {
      if (!options->faces.empty()) return analyse_faces(*options);
      return options->formulas ? print_formulas(*options) : analyse(*options);
    };
  });
}

}  // namespace limn::app
