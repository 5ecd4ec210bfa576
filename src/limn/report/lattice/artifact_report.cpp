#include "limn/report/lattice/artifact_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/report/json_number.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json direction_json(const DirectionalDensity& density) {
  return {{"direction_degrees", density.direction},
          {"frequency", density.frequency},
          {"edges_per_wavelength", density.edges_per_wavelength},
          {"reached", density.reached}};
}

Error named(const study::NamedAnalysis& scheme, Error error) {
  error.message = fmt::format("scheme '{}': {}", scheme.name, error.message);
  return error;
}

std::size_t longest_name(const std::vector<study::NamedAnalysis>& schemes) {
  std::size_t longest = 6;
  for (const study::NamedAnalysis& scheme : schemes)
    longest = std::max(longest, base::printable(scheme.name).size());
  return longest;
}

std::string percent_text(double percent) {
  return std::isfinite(percent) ? fmt::format("{:.6g} %", percent) : "no signal is left";
}

/// A waves' frequency, as people read it.
std::string wave_text(Frequency f) {
  const double length = std::hypot(f[0], f[1]);
  return length == 0 ? "constant" : fmt::format("{:.4g} edges long", 1 / length);
}

/// Nine decimals, and no minus before a rounded 0.
std::string magnitude(double value) {
  return fmt::format("{: .9f}", std::abs(value) < 5e-10 ? 0.0 : value);
}

std::string values_text(const study::NamedAnalysis& scheme, Frequency f,
                        const study::StageValues& values, study::Stage stage) {
  std::string text = base::printable(scheme.name) + "\n";
  text += fmt::format("  signal   {}  {}\n", magnitude(values.components.signal), wave_text(f));
  const std::vector<Frequency> waves = scheme.analysis.artifact_frequencies(f);
  for (std::size_t i = 0; i < waves.size(); ++i)
    text += fmt::format("  {:<7}  {}  {}\n", study::artifact_name(static_cast<int>(i)),
                        magnitude(values.components.artifacts[i]), wave_text(waves[i]));
  text +=
      fmt::format("  sum      {}\n  mean     {}  (energy) {} of the signal\n",
                  magnitude(values.components.sum()), magnitude(values.components.mean_energy()),
                  percent_text(values.components.percent_of_signal()));
  const char* what = stage.kind == study::Stage::Kind::limit
                         ? "all waves of the limit surface but the signal"
                         : "all artifacts together";
  return text +
         fmt::format("  {}: {} of the signal\n", what, percent_text(values.total_energy_percent));
}

std::string density_text(const DirectionalDensity& density) {
  return fmt::format("{:>6.3f}{} at {:>3.0f}°", density.edges_per_wavelength,
                     density.reached ? " " : "≤", density.direction);
}

}  // namespace

Result<nlohmann::ordered_json> artifacts_json(const study::NamedAnalysis& scheme, Frequency f,
                                              study::Stage stage) {
  const Result<study::StageValuesAt> values_at = study::StageValuesAt::of(scheme.analysis, stage);
  if (!values_at) return named(scheme, values_at.error());
  const study::StageValues values = (*values_at)(f);
  const Components& components = values.components;
  Json json{{"scheme", scheme.name}, {"frequency", {f[0], f[1]}}};
  if (stage.kind == study::Stage::Kind::smoothing)
    json["smoothing_stages"] = stage.count;
  else
    json["stage"] = stage.kind == study::Stage::Kind::limit ? Json("limit") : Json(stage.count);
  json["signal"] = components.signal;
  json["artifacts"] = components.artifacts;
  json["artifact_frequencies"] = Json::array();
  for (const Frequency& g : scheme.analysis.artifact_frequencies(f))
    json["artifact_frequencies"].push_back({g[0], g[1]});
  json["sum"] = components.sum();
  json["mean_energy"] = components.mean_energy();
  json["percent_of_signal"] = finite(components.percent_of_signal());
  json["total_energy_percent"] = finite(values.total_energy_percent);
  return json;
}

Result<std::string> artifacts_text(const std::vector<study::NamedAnalysis>& schemes, Frequency f,
                                   study::Stage stage) {
  std::string text = fmt::format("wave of frequency ({:g}, {:g}) cycles per control edge, {}\n",
                                 f[0], f[1], study::to_string(stage));
  for (const study::NamedAnalysis& scheme : schemes) {
    const Result<study::StageValuesAt> values_at = study::StageValuesAt::of(scheme.analysis, stage);
    if (!values_at) return named(scheme, values_at.error());
    text += values_text(scheme, f, (*values_at)(f), stage);
  }
  return text;
}

nlohmann::ordered_json density_json(const SamplingDensity& density) {
  return {{"worst", direction_json(density.worst)}, {"best", direction_json(density.best)}};
}

Result<nlohmann::ordered_json> sampling_json(const study::NamedAnalysis& scheme, double tolerance,
                                             study::SamplingDensities& densities) {
  Json json{{"scheme", scheme.name}, {"tolerance_percent", tolerance}};
  for (const auto& [key, measure] : {std::pair{"total_energy", ArtifactMeasure::total_energy},
                                     std::pair{"mean_energy", ArtifactMeasure::mean_energy}}) {
    const Result<SamplingDensity> density = densities.at(scheme.analysis, tolerance, measure);
    if (!density) return named(scheme, density.error());
    json["sampling"][key] = density_json(*density);
  }
  return json;
}

Result<std::string> sampling_text(const std::vector<study::NamedAnalysis>& schemes,
                                  double tolerance, study::SamplingDensities& densities) {
  const std::size_t width = longest_name(schemes);
  std::string text = fmt::format(
      "control edges per wavelength that keep artifacts within {:g} % of the signal\n"
      "{:<{}}  all artifacts of the limit surface   mean energy on the first refined lattice\n"
      "{:<{}}  worst             best                worst             best\n",
      tolerance, "", width, "scheme", width);
  for (const study::NamedAnalysis& scheme : schemes) {
    text += fmt::format("{:<{}}", base::printable(scheme.name), width);
    for (const ArtifactMeasure measure :
         {ArtifactMeasure::total_energy, ArtifactMeasure::mean_energy}) {
      const Result<SamplingDensity> density = densities.at(scheme.analysis, tolerance, measure);
      if (!density) return named(scheme, density.error());
      text += fmt::format("  {}   {}  ", density_text(density->worst), density_text(density->best));
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

}  // namespace limn::report
