#pragma once
/// Artifacts of schemes at a stage of the process, and sampling densities of many schemes.

#include <optional>
#include <string>
#include <vector>

#include "limn/regular/artifacts.h"

namespace limn::study {

/// A scheme's name and its analysis.
struct NamedAnalysis {
  std::string name;
  ArtifactAnalysis analysis;
};

/// Where in the process magnitudes are taken.
struct Stage {
  enum class Kind {
    limit,     ///< the limit, on the points of the first refined lattice [ADS]
    steps,     ///< after `count` ≥ 1 whole steps
    smoothing  ///< after one refinement and `count` ≥ 0 smoothing stages alone
  };
  Kind kind = Kind::limit;
  int count = 0;
};

/// "in the limit", "after 2 steps", "after refinement and 1 smoothing stage".
[[nodiscard]] std::string to_string(Stage stage);

/// Magnitudes at that stage, and all artifacts together in percent of the signal: in the limit
/// by their energy in the limit surface.
struct StageValues {
  Components components;
  double total_energy_percent = 0;
};

/// A scheme at one stage, at any number of frequencies.
class StageValuesAt {
 public:
  /// Keeps a reference to the analysis. Fails where the stage is the limit and there is none.
  [[nodiscard]] static Result<StageValuesAt> of(const ArtifactAnalysis& analysis, Stage stage);
  [[nodiscard]] StageValues operator()(Frequency f) const;

 private:
  StageValuesAt(const ArtifactAnalysis& analysis, Stage stage);

  const ArtifactAnalysis* analysis_;
  Stage stage_;
  std::optional<StepsEnergy> steps_;
};

/// What an artifact is called: Y1, Y2, ….
[[nodiscard]] std::string artifact_name(int artifact);

/// Sampling densities of many schemes: those with one mask share theirs, which is found once.
class SamplingDensities {
 public:
  /// As sampling_density.
  [[nodiscard]] Result<SamplingDensity> at(const ArtifactAnalysis& analysis, double tolerance,
                                           ArtifactMeasure measure);
  /// How many were computed.
  [[nodiscard]] std::size_t computed() const { return known_.size(); }

 private:
  struct Known {
    Mask mask;
    ArtifactMeasure measure;
    SamplingDensity density;
  };
  std::vector<Known> known_;
};

}  // namespace limn::study
