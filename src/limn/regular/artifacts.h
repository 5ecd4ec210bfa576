#pragma once
/// Artifacts on the regular lattice [ADS]: what one refinement makes of a pure wave on the
/// control points. The wave comes back as |det M| waves: the signal, which has its frequency f, and
/// |det M| - 1 artifacts, one for each other class κ of the dual lattice (dual_cosets), which no
/// movement of control points can remove.
///
/// Components are signed and relative to the wave's amplitude. All are computed in double
/// precision from the exact mask; they are right to about 1e-14.
///
/// An artifact's frequency is f + κ, with κ the member of its class for which |f + κ| is least:
/// the ripple that one sees. (On the first refined lattice all members are the same wave. Of dual
/// splits, where the new points lie between lattice points, the choice fixes the sign.)

#include <optional>
#include <vector>

#include "limn/regular/regular_mask.h"
#include "limn/regular/symbol.h"
#include "limn/scheme/mask.h"

namespace limn {

/// Magnitudes of the signal and of the artifacts, in the order of dual_cosets.
struct Components {
  double signal = 0;              ///< signed, relative to the wave's amplitude
  std::vector<double> artifacts;  ///< |det M| - 1 of them, signed

  /// The sum of the artifacts.
  [[nodiscard]] double sum() const;
  /// sqrt(mean of their squares)
  [[nodiscard]] double mean_energy() const;
  /// 100 · mean_energy / |signal|; 0 without artifacts, infinite where the signal alone vanishes.
  [[nodiscard]] double percent_of_signal() const;
};

/// What a mask makes of waves of any frequency. It does not change once it is made: any number of
/// threads may ask. Cost of a question: the number of the mask's coefficients, times that of steps.
class ArtifactAnalysis {
 public:
  /// Fails where the mask is not point-symmetric: its components would not be real. Cost:
  /// milliseconds for masks of the usual width; it grows with the sixth power of that, and with the
  /// symmetries that the mask lacks (seconds at 1000 coefficients).
  [[nodiscard]] static Result<ArtifactAnalysis> of(const Mask& mask);

  /// The mask that is analysed.
  [[nodiscard]] const Mask& mask() const { return mask_; }
  /// Its factors.
  [[nodiscard]] const Factorization& factors() const { return factors_; }
  /// |det M| - 1
  [[nodiscard]] int artifact_count() const { return mask_.dilation.growth() - 1; }

  /// The frequencies of the artifacts of f: f + κ.
  [[nodiscard]] std::vector<Frequency> artifact_frequencies(Frequency f) const;

  /// After one refinement and `stages` smoothing stages alone, 0 ≤ stages [ADS §2.3]. (ADS's R_N^s;
  /// the scheme's kernel and single directions are left out.)
  [[nodiscard]] Components after_stages(Frequency f, int stages) const;
  /// After `steps` ≥ 1 steps: each wave, once made by the first step, is multiplied by its symbol
  /// on each finer lattice. (Later steps make further artifacts: see StepsEnergy.)
  [[nodiscard]] Components after_steps(Frequency f, int steps) const;

  /// Whether the scheme has limit values, and if not, why. Needed by the functions below.
  [[nodiscard]] const Status& limit_status() const { return limit_status_; }
  /// The limit surface at the points of the first refined lattice [ADS §2.4]: one step, times the
  /// symbol of the limit stencil. Higher harmonics are folded in.
  [[nodiscard]] Components in_limit(Frequency f) const;
  /// The limit stencil's symbol, at phases of the lattice it is applied on.
  [[nodiscard]] const Symbol& limit_symbol() const { return limit_; }

  /// Amplitude in the limit surface of the wave of any frequency g itself, φ̂(g) = Π_j m(M⁻ᵀʲ t(g)).
  /// The limit of the wave f holds f + κ with amplitude φ̂(f + κ), for every κ of the dual lattice.
  [[nodiscard]] double amplitude(Frequency g) const;
  /// Whether the limit has finite energy (φ in L²), and if not, why.
  [[nodiscard]] const Status& energy_status() const { return energy_status_; }
  /// All waves of the limit surface but f together: Σ_κ |φ̂(f + κ)|² - |φ̂(f)|², exact up to rounding
  /// (the relative error is about 1e-13: only positive terms are added), from the inner products of
  /// φ. Precondition: energy_status().ok().
  [[nodiscard]] double energy(Frequency f) const;
  /// 100 · sqrt(energy(f)) / |φ̂(f)|
  [[nodiscard]] double energy_percent(Frequency f) const;

  /// The one-step symbol, at phases of the refined lattice.
  [[nodiscard]] const Symbol& symbol() const { return symbol_; }

 private:
  explicit ArtifactAnalysis(const Mask& mask);
  friend class StepsEnergy;
  /// Phases on the first refined lattice of f and of its artifacts.
  [[nodiscard]] std::vector<Phase> refined_phases(Frequency f) const;
  /// magnitude(θ) at each of these phases.
  template <class Magnitude>
  [[nodiscard]] Components components(Frequency f, Magnitude magnitude) const;
  /// Σ |m|² · energies over the artifacts that one step makes of a wave with phases t.
  [[nodiscard]] double made_by_one_step(Phase t, const Symbol& energies) const;

  Mask mask_;
  Factorization factors_;
  std::vector<LatticeVector> aliases_;  // κ, the signal's 0 first
  Symbol symbol_, stage_, limit_, inner_products_;
  Status limit_status_ = Done{};
  Status energy_status_ = Done{};
};

/// The energy of all |det M|^steps - 1 artifacts after some steps, at any number of frequencies.
class StepsEnergy {
 public:
  /// Keeps a reference to the analysis. steps ≥ 1.
  StepsEnergy(const ArtifactAnalysis& analysis, int steps);
  /// At the frequency f, in units of the wave's squared amplitude.
  [[nodiscard]] double operator()(Frequency f) const;
  /// 100 · sqrt(energy) / |signal|
  [[nodiscard]] double percent(Frequency f) const;

 private:
  const ArtifactAnalysis& analysis_;
  std::vector<Symbol> energies_;  // [j]: of all waves after j steps together
};

// How densely a surface must be sampled: control edges per wavelength for a tolerance.

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
