#include "limn/report/spectrum_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/limit/limit_points.h"

namespace limn::report {
namespace {

/// The part of the squared amplitude at each frequency and above, from the second one on.
figure::ChartPanel::Series tail_of(const NamedPoints& named, const fairness::LaplacianModes& modes,
                                   const std::vector<double>& amplitudes) {
  constexpr double kConstant = 1e-9;  // frequencies below are those of constants
  constexpr double kRounding = 1e-14;
  figure::ChartPanel::Series series;
  series.name = named.name;
  double above = 0;
  for (std::size_t j = amplitudes.size(); j-- > 0 && modes.eigenvalues[j] > kConstant;) {
    above += amplitudes[j] * amplitudes[j];
    series.x.insert(series.x.begin(), modes.eigenvalues[j]);
    series.y.insert(series.y.begin(), above);
  }
  // what rounding leaves is not shown
  for (double& y : series.y) y = y > kRounding * above ? y / above : 0;
  return series;
}

std::string line_of(const char* which, const std::vector<double>& values) {
  std::string text = which;
  for (const double value : values) text += fmt::format(" {:.8f}", value == 0 ? 0.0 : value);
  return text + '\n';
}

}  // namespace

Result<SpectrumEnds> approx_spectrum_ends(const Mesh& mesh, int count) {
  SpectrumEnds ends;
  for (const auto& [end, values] : {std::pair{fairness::SpectrumEnd::smallest, &ends.smallest},
                                    std::pair{fairness::SpectrumEnd::largest, &ends.largest}}) {
    Result<fairness::LaplacianModes> modes = fairness::approx_modes(mesh, end, count);
    if (!modes) return modes.error();
    *values = std::move(modes->eigenvalues);
  }
  return ends;
}

nlohmann::ordered_json spectrum_json(const SpectrumEnds& ends) {
  return {{"smallest", ends.smallest}, {"largest", ends.largest}};
}

std::string spectrum_text(const std::string& mesh, const SpectrumEnds& ends) {
  return fmt::format("natural frequencies of {}\n", mesh) + line_of("  lowest: ", ends.smallest) +
         line_of("  highest:", ends.largest);
}

Result<NamedPoints> limits_of_vertices(const std::string& label, const Scheme& scheme,
                                       const Mesh& control, const std::vector<Point3>& points,
                                       std::vector<LimitPoints::Refused>& refused) {
  LimitOptions options;
  options.partial = true;
  Result<LimitPoints> limit = approx_limit_points(scheme, control, points, options);
  if (!limit) return limit.error();
  refused = std::move(limit->refused);
  return NamedPoints{label, std::move(limit->positions)};
}

Result<figure::Figure> spectrum_figure(const std::string& name, const Mesh& mesh,
                                       const std::vector<NamedPoints>& points) {
  const Result<fairness::LaplacianModes> modes = fairness::approx_all_modes(mesh);
  if (!modes) return modes.error();
  figure::ChartPanel frequencies;
  frequencies.title = "natural frequencies";
  frequencies.x_label = "number";
  frequencies.y_label = "eigenvalue of L";
  figure::ChartPanel::Series all;
  for (const double value : modes->eigenvalues) {
    all.x.push_back(static_cast<double>(all.x.size() + 1));
    all.y.push_back(value);
  }
  frequencies.series.push_back(std::move(all));
  figure::ChartPanel tails;
  tails.title = "part at frequencies above";
  tails.x_label = "eigenvalue of L";
  tails.log_y = true;
  for (const NamedPoints& named : points)
    tails.series.push_back(
        tail_of(named, *modes, fairness::approx_amplitudes(mesh, *modes, named.points)));
  figure::Figure figure(2);
  figure.title(fmt::format("{}: limits of the control vertices, by natural frequency", name));
  figure.add(std::move(frequencies));
  figure.add(std::move(tails));
  return figure;
}

}  // namespace limn::report
