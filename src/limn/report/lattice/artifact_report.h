#pragma once
/// Artifacts of one scheme or several, as text, JSON and tables of numbers: `limn artifacts`.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/study/artifact_values.h"

namespace limn::report {

/// {"scheme", "frequency": [fx, fy], "stage": "limit" or K, "signal", "artifacts": […],
/// "artifact_frequencies": [[gx, gy], …], "sum", "mean_energy", "percent_of_signal",
/// "total_energy_percent"}; "smoothing_stages": S takes the place of "stage" where that is asked.
/// A percentage is null where the signal vanishes.
[[nodiscard]] Result<nlohmann::ordered_json> artifacts_json(const study::NamedAnalysis& scheme,
                                                            Frequency f, study::Stage stage);
[[nodiscard]] Result<std::string> artifacts_text(const std::vector<study::NamedAnalysis>& schemes,
                                                 Frequency f, study::Stage stage);

/// {"worst", "best"}, each {"direction_degrees", "frequency", "edges_per_wavelength", "reached"}.
[[nodiscard]] nlohmann::ordered_json density_json(const SamplingDensity& density);

/// {"scheme", "tolerance_percent", "sampling": {"total_energy", "mean_energy"}}, each as
/// density_json.
[[nodiscard]] Result<nlohmann::ordered_json> sampling_json(const study::NamedAnalysis& scheme,
                                                           double tolerance,
                                                           study::SamplingDensities& densities);
/// Side by side, a line a scheme.
[[nodiscard]] Result<std::string> sampling_text(const std::vector<study::NamedAnalysis>& schemes,
                                                double tolerance,
                                                study::SamplingDensities& densities);

}  // namespace limn::report
