#include "limn/study/compare_record.h"

#include <algorithm>
#include <cmath>

#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/study/c1_answers.h"

namespace limn::study {
namespace {

constexpr double kTie = 1e-9;  // of directions that are alike the first is given

/// For what needs the limit and its energy.
Status has_energy(const ArtifactAnalysis& analysis) {
  if (!analysis.limit_status()) return analysis.limit_status();
  return analysis.energy_status();
}

Result<std::vector<WaveArtifacts>> artifacts_of(const Result<ArtifactAnalysis>& analysis) {
  if (!analysis) return analysis.error();
  if (const Status status = has_energy(*analysis); !status) return status.error();
  std::vector<WaveArtifacts> waves;
  for (const double edges : kWavelengths) waves.push_back(wave_artifacts(*analysis, edges));
  return waves;
}

Result<SamplingDensity> density_of(const Result<ArtifactAnalysis>& analysis, double tolerance,
                                   ArtifactMeasure measure) {
  if (!analysis) return analysis.error();
  return sampling_density(*analysis, tolerance, measure);
}

Result<ArtifactAnalysis> analysis_of(const Result<Mask>& mask) {
  if (!mask) return mask.error();
  return ArtifactAnalysis::of(*mask);
}

std::vector<ValenceRecord> valences_of(const Scheme& scheme, const RegularPart& regular,
                                       const RecordOptions& options) {
  FrequencyAnalysis analysis(scheme);
  std::vector<ValenceRecord> valences;
  const int first = std::max(options.first_valence, 3);
  const std::vector<certify::Answer> answers = first <= options.last_valence
                                                   ? c1_answers(scheme, first, options.last_valence)
                                                   : std::vector<certify::Answer>();
  for (int n = options.first_valence; n <= options.last_valence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (blocks)
      valences.push_back({n, approx_eigencomponents(*blocks, regular)});
    else
      valences.push_back({n, blocks.error()});
    if (n >= first) valences.back().c1 = answers[static_cast<std::size_t>(n - first)];
  }
  return valences;
}

}  // namespace

WaveArtifacts wave_artifacts(const ArtifactAnalysis& analysis, double edges_per_wavelength) {
  WaveArtifacts wave{.edges_per_wavelength = edges_per_wavelength, .worst = 0, .best = INFINITY};
  for (int degree = 0; degree < 180; ++degree) {
    const double angle = degree * std::acos(-1.0) / 180;
    const double percent = analysis.energy_percent(
        {std::cos(angle) / edges_per_wavelength, std::sin(angle) / edges_per_wavelength});
    if (percent > wave.worst * (1 + kTie)) {
      wave.worst = percent;
      wave.worst_direction = degree;
    }
    if (percent < wave.best * (1 - kTie)) {
      wave.best = percent;
      wave.best_direction = degree;
    }
  }
  return wave;
}

SchemeRecord approx_record(const std::string& label, const Scheme& scheme,
                           const RecordOptions& options) {
  const auto begin = [&](const std::string& what) {
    if (options.progress) options.progress(label + ": " + what);
  };
  const Result<Mask> mask = regular_mask(scheme);
  RegularityOptions regularity_options = options.regularity;
  regularity_options.progress = [&](const std::string& what) { begin("regularity, " + what); };
  Result<Regularity> regularity =
      mask ? enclose_regularity(*mask, regularity_options) : Result<Regularity>(mask.error());
  RegularPart regular_part = find_regular_part(scheme);
  begin("artifacts");
  const Result<ArtifactAnalysis> analysis = analysis_of(mask);
  Result<std::vector<WaveArtifacts>> artifacts = artifacts_of(analysis);
  begin("sampling density");
  Result<SamplingDensity> total =
      density_of(analysis, options.tolerance, ArtifactMeasure::total_energy);
  Result<SamplingDensity> mean =
      density_of(analysis, options.tolerance, ArtifactMeasure::mean_energy);
  begin("eigencomponents and proofs of C1");
  return {.label = label,
          .lattice = scheme.stages ? scheme.stages->only : std::nullopt,
          .split = std::string(scheme.split->name),
          .interpolating = mask ? Result<bool>(interpolates(*mask)) : mask.error(),
          .regularity = std::move(regularity),
          .regular_part = regular_part,
          .artifacts = std::move(artifacts),
          .sampling = std::move(total),
          .mean_sampling = std::move(mean),
          .valences = valences_of(scheme, regular_part, options)};
}

std::vector<std::string> missing_parts(const SchemeRecord& record) {
  std::vector<std::string> reasons;
  const auto add = [&](const auto& result) {
    if (result) return;
    const std::string& reason = result.error().message;
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
      reasons.push_back(reason);
  };
  add(record.interpolating);
  add(record.regularity);
  add(record.artifacts);
  add(record.sampling);
  add(record.mean_sampling);
  for (const ValenceRecord& one : record.valences)
    if (!one.components) {
      add(one.components);  // that of the first stands for all
      break;
    }
  return reasons;
}

}  // namespace limn::study
