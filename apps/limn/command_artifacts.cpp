#include <cmath>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/artifact_figures.h"
#include "options/number_option.h"
#include "options/scheme_argument.h"
#include "output/lattice_objects.h"

namespace limn::app {
namespace {

constexpr double kLargestFrequency = 1000;
constexpr int kMostSteps = 30;
constexpr int kMostStages = 64;

struct ArtifactOptions {
  std::vector<std::string> schemes;
  SchemeOptions parameters;
  std::optional<std::string> frequency, tolerance, map;
  int steps = 0;
  int stages = -1;
  bool json = false;

  [[nodiscard]] bool wants_values() const { return frequency.has_value(); }
  [[nodiscard]] bool wants_sampling() const { return (!frequency && !map) || tolerance; }
  [[nodiscard]] study::Stage stage() const {
    if (steps > 0) return {study::Stage::Kind::steps, steps};
    if (stages >= 0) return {study::Stage::Kind::smoothing, stages};
    return {};
  }
};

Result<Frequency> read_frequency(const std::string& text) {
  Frequency f{};
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || !read_number(std::string_view(text).substr(0, comma), f[0]) ||
      !read_number(std::string_view(text).substr(comma + 1), f[1]))
    return Error{fmt::format("--frequency: '{}' is not a frequency", text),
                 "two numbers fx,fy, in cycles per control edge, as 0.1,0.05"};
  if (std::hypot(f[0], f[1]) > kLargestFrequency)
    return Error{fmt::format("--frequency: {} is beyond {} cycles per control edge", text,
                             kLargestFrequency),
                 "a wave beyond about half a cycle per edge is, on the control points, the same as "
                 "one below"};
  return f;
}

Result<double> read_tolerance(const std::string& text) {
  double tolerance = 0;
  if (!read_number(text, tolerance))
    return Error{fmt::format("--tolerance: '{}' is not a number", text),
                 "percent of the signal, as 1"};
  return tolerance;
}

/// The schemes of a command line, each with one lattice or two.
struct Loaded {
  struct One {
    std::string label;
    std::vector<Scheme> lattices;
  };
  std::vector<One> schemes;
  std::vector<study::NamedAnalysis> analyses;  ///< of all lattices, in this order
};

Result<Loaded> load(const ArtifactOptions& options) {
  Loaded loaded;
  for (const std::string& name : options.schemes) {
    const Result<Scheme> scheme = scheme_argument(name, options.parameters.parameters);
    if (!scheme) return scheme.error();
    if (options.map)
      if (Status status = scheme::check_one_lattice(*scheme); !status) return status.error();
    loaded.schemes.push_back({scheme_label(name, *scheme), scheme::lattice_schemes(*scheme)});
    for (const Scheme& one : loaded.schemes.back().lattices) {
      const Result<Mask> mask = regular_mask(one);
      if (!mask) return mask.error();
      Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
      if (!analysis) {
        analysis.error().file = scheme->file;
        return analysis.error();
      }
      loaded.analyses.push_back(
          {scheme::label_on_lattice(loaded.schemes.back().label, one), *std::move(analysis)});
    }
  }
  return loaded;
}

/// One scheme's object, or {"schemes": […]} of several.
template <class Make>
int print_all(const Loaded& loaded, Make make) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  auto analysis = loaded.analyses.begin();
  for (const auto& [label, lattices] : loaded.schemes) {
    LatticeObjects object(label, lattices.size() > 1);
    for (const Scheme& one : lattices) {
      const Result<nlohmann::ordered_json> json = make(*analysis++);
      if (!json) return report(json.error());
      object.add(one, *json);
    }
    list.push_back(object.object());
  }
  if (list.size() == 1)
    print_json(list.front());
  else
    print_json({{"schemes", list}});
  return kDone;
}

/// What can be refused at once is refused before any work.
Status check_map(const ArtifactOptions& options) {
  if (!options.map) return Done{};
  if (options.schemes.size() > 1) return Error{"--map draws one scheme", "call limn once for each"};
  if (!report::is_table_path(*options.map)) {
    const Result<figure::FigureFormat> format = figure::figure_format(*options.map);
    if (!format) return format.error();
  }
  return check_outputs({*options.map});
}

Result<nlohmann::ordered_json> analysis_json(const study::NamedAnalysis& scheme,
                                             const ArtifactOptions& options, Frequency f,
                                             double tolerance,
                                             study::SamplingDensities& densities) {
  nlohmann::ordered_json json;
  if (options.wants_values()) {
    const Result<nlohmann::ordered_json> values =
        report::artifacts_json(scheme, f, options.stage());
    if (!values) return values.error();
    json.update(*values);
  }
  if (options.map) json.update({{"scheme", scheme.name}, {"map", *options.map}});
  if (options.wants_sampling()) {
    const Result<nlohmann::ordered_json> sampling =
        report::sampling_json(scheme, tolerance, densities);
    if (!sampling) return sampling.error();
    json.update(*sampling);
  }
  return json;
}

int print_all_text(const std::vector<study::NamedAnalysis>& schemes, const ArtifactOptions& options,
                   Frequency f, double tolerance) {
  Result<std::string> values = std::string();
  Result<std::string> sampling = std::string();
  if (options.wants_values()) values = report::artifacts_text(schemes, f, options.stage());
  if (!values) return report(values.error());
  study::SamplingDensities densities;
  if (options.wants_sampling()) sampling = report::sampling_text(schemes, tolerance, densities);
  if (!sampling) return report(sampling.error());
  if (options.map)
    print_text(fmt::format("{}: a map of {}\n", base::printable(*options.map),
                           base::printable(schemes.front().name)));
  print_text(*values + *sampling);
  return kDone;
}

int analyse(const ArtifactOptions& options) {
  const Result<Frequency> f =
      options.wants_values() ? read_frequency(*options.frequency) : Frequency{};
  if (!f) return report(f.error());
  const Result<double> tolerance = options.tolerance ? read_tolerance(*options.tolerance) : 1.0;
  if (!tolerance) return report(tolerance.error());
  if ((options.steps > 0 || options.stages >= 0) && !options.wants_values() && !options.map)
    return report(
        {"--steps and --stages say where magnitudes are taken: --frequency or --map is missing"});
  if (Status status = check_map(options); !status) return report(status.error());
  const Result<Loaded> loaded = load(options);
  if (!loaded) return report(loaded.error());
  if (options.map)
    if (Status status =
            report::write_artifact_map(*options.map, loaded->analyses.front(), options.stage());
        !status)
      return report(status.error());
  if (!options.json) return print_all_text(loaded->analyses, options, *f, *tolerance);
  study::SamplingDensities densities;
  return print_all(*loaded, [&](const study::NamedAnalysis& scheme) {
    return analysis_json(scheme, options, *f, *tolerance, densities);
  });
}

}  // namespace

void declare_artifacts(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "artifacts", "ripples that no control point can remove, by frequency");
  const auto options = std::make_shared<ArtifactOptions>();
  command->add_option("SCHEME", options->schemes, kSchemeArgumentHelp)->required();
  command
      ->add_option("-f,--frequency", options->frequency,
                   "a wave's frequency, Cartesian, in cycles per control edge")
      ->type_name("FX,FY");
  CLI::Option* steps =
      command->add_option("--steps", options->steps, "after so many steps, not in the limit")
          ->check(CLI::Range(1, kMostSteps));
  command
      ->add_option("--stages", options->stages,
                   "after one refinement and so many smoothing stages alone")
      ->check(CLI::Range(0, kMostStages))
      ->excludes(steps);
  command
      ->add_option("--tolerance", options->tolerance,
                   "how densely to sample for artifacts of so many percent of the signal "
                   "(without --frequency: 1)")
      ->type_name("PERCENT")
      ->check(number_between(kLeastTolerance, 100));
  command
      ->add_option(
          "--map", options->map,
          fmt::format("also draw signal and artifacts over all frequencies into FILE ({}), "
                      "or write their numbers to it ({})",
                      kFigureFiles, kTableFiles))
      ->type_name("FILE");
  options->parameters.declare_parameters(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn artifacts loop --frequency 0.2,0.1\n"
      "         limn artifacts loop butterfly interpolating-loop --tolerance 1\n"
      "         limn artifacts butterfly --map butterfly.pdf");
  command->callback([&action, options] { action = [options] { return analyse(*options); }; });
}

}  // namespace limn::app
