#include "limn/study/artifact_values.h"

#include <cmath>

#include <fmt/core.h>

namespace limn::study {

std::string to_string(Stage stage) {
  const std::string plural = stage.count == 1 ? "" : "s";
  switch (stage.kind) {
    case Stage::Kind::limit: return "in the limit";
    case Stage::Kind::steps: return fmt::format("after {} step{}", stage.count, plural);
    case Stage::Kind::smoothing:
      return fmt::format("after refinement and {} smoothing stage{}", stage.count, plural);
  }
  return {};
}

std::string artifact_name(int artifact) { return fmt::format("Y{}", artifact + 1); }

StageValuesAt::StageValuesAt(const ArtifactAnalysis& analysis, Stage stage)
    : analysis_(&analysis), stage_(stage) {
  if (stage.kind == Stage::Kind::steps) steps_.emplace(analysis, stage.count);
}

Result<StageValuesAt> StageValuesAt::of(const ArtifactAnalysis& analysis, Stage stage) {
  if (stage.kind == Stage::Kind::limit)
    for (const Status* status : {&analysis.limit_status(), &analysis.energy_status()})
      if (!*status) return status->error();
  return StageValuesAt(analysis, stage);
}

StageValues StageValuesAt::operator()(Frequency f) const {
  switch (stage_.kind) {
    case Stage::Kind::steps: return {analysis_->after_steps(f, stage_.count), steps_->percent(f)};
    case Stage::Kind::limit: return {analysis_->in_limit(f), analysis_->energy_percent(f)};
    case Stage::Kind::smoothing: break;
  }
  const Components components = analysis_->after_stages(f, stage_.count);
  // after one refinement alone these artifacts are all there are
  return {components, components.percent_of_signal() *
                          std::sqrt(static_cast<double>(analysis_->artifact_count()))};
}

Result<SamplingDensity> SamplingDensities::at(const ArtifactAnalysis& analysis, double tolerance,
                                              ArtifactMeasure measure) {
  const Mask& mask = analysis.mask();
  for (const Known& known : known_)
    if (known.measure == measure && known.density.tolerance == tolerance &&
        known.mask.lattice == mask.lattice && known.mask.dilation.rows == mask.dilation.rows &&
        known.mask.coefficients == mask.coefficients)
      return known.density;
  Result<SamplingDensity> density = sampling_density(analysis, tolerance, measure);
  if (density) known_.push_back({mask, measure, *density});
  return density;
}

}  // namespace limn::study
