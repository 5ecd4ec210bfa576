#pragma once
/// All that limn says of one scheme, as `limn compare` puts it beside others'. What a scheme does
/// not have is an error in its place, with the reason.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/certify/certificate/certificate.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/scheme.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn::study {

/// Artifacts of waves of one length: all waves of the limit surface but the signal together, in
/// percent of it (ArtifactAnalysis::energy_percent), over one direction a degree.
struct WaveArtifacts {
  double edges_per_wavelength = 0;
  double worst = 0, best = 0;  ///< percent; infinite where no signal is left
  /// Degrees, 0 ≤ direction < 180; the first of those that are alike.
  double worst_direction = 0, best_direction = 0;
};
/// The lengths that a record has, in control edges.
inline constexpr double kWavelengths[] = {8, 4};

/// Precondition: the limit and its energy exist (limit_status, energy_status).
[[nodiscard]] WaveArtifacts wave_artifacts(const ArtifactAnalysis& analysis,
                                           double edges_per_wavelength);

struct ValenceRecord {
  int valence = 0;  ///< edges at a vertex; corners of a face under a dual split
  Result<Eigencomponents> components;
  certify::Answer c1 =
      certify::Answer::undecided;  ///< in ball arithmetic: c1_answers (c1_answers.h)
};

struct SchemeRecord {
  std::string label;  ///< what the scheme is called in reports
  /// Of a scheme with two lattices, which of them the record is of (lattice_schemes.h).
  std::optional<Lattice> lattice;
  std::string split;
  Result<bool> interpolating;  ///< on the regular lattice: old points stay where they are
  Result<Regularity> regularity;
  RegularPart regular_part;  ///< what the lattice lets the verdicts of `valences` say
  Result<std::vector<WaveArtifacts>> artifacts;
  /// By all artifacts of the limit surface, and by [ADS]'s mean energy.
  Result<SamplingDensity> sampling, mean_sampling;
  std::vector<ValenceRecord> valences;
};

struct RecordOptions {
  int first_valence = 3, last_valence = 12;
  double tolerance = 1;  ///< percent, of the sampling densities
  RegularityOptions regularity = {};
  std::function<void(const std::string& what)> progress = {};  ///< called before each part
};

/// Cost: that of enclose_regularity, mostly, and about a second.
[[nodiscard]] SchemeRecord approx_record(const std::string& label, const Scheme& scheme,
                                         const RecordOptions& options = {});

/// Why parts of the record are missing; every reason once.
[[nodiscard]] std::vector<std::string> missing_parts(const SchemeRecord& record);

}  // namespace limn::study
