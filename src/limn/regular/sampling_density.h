#pragma once
/// How densely a surface must be sampled: control edges per wavelength for a tolerance.

#include "limn/regular/artifacts.h"

namespace limn {

/// What is held below the tolerance, in percent of the signal.
enum class ArtifactMeasure {
  total_energy,  ///< all artifacts of the limit surface together, ArtifactAnalysis::energy_percent
  mean_energy    ///< [ADS]'s: mean energy of the artifacts on the first refined lattice
};

/// The density that one direction of waves asks for.
struct DirectionalDensity {
  double direction = 0;             ///< of f, in degrees from the x axis, 0 ≤ direction < 180
  double frequency = 0;             ///< the largest |f| up to which the tolerance is kept
  double edges_per_wavelength = 0;  ///< 1/|f|
  bool reached = true;              ///< false: kept in the whole Nyquist region, |f| is its border
};

/// The densities over all directions.
struct SamplingDensity {
  double tolerance = 0;      ///< percent
  DirectionalDensity worst;  ///< the direction that needs the most edges per wavelength
  DirectionalDensity best;   ///< the one that needs the fewest
  std::vector<DirectionalDensity> directions;  ///< one a degree
};

/// The least tolerance that is computed: below it rounding begins to show.
inline constexpr double kLeastTolerance = 1e-6;

/// In each direction the |f| where the measure first exceeds the tolerance, to 1e-12 once it is
/// enclosed by steps of 1/256 of the way to the border. Fails on a tolerance outside
/// [kLeastTolerance, 100] percent, and where the limit does not exist.
/// Cost: in each of 180 directions up to 256 evaluations of the measure and some forty more.
[[nodiscard]] Result<SamplingDensity> sampling_density(const ArtifactAnalysis& analysis,
                                                       double tolerance, ArtifactMeasure measure);

}  // namespace limn
