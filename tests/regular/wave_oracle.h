#pragma once
/// Waves on the regular lattice by the definitions of [ADS] alone: a wave is refined by summing the
/// mask over an infinite lattice, and the waves that came of it are found by solving for them.
/// Nothing here calls the code under test but Mask and LatticeMatrix's entries.

#include <complex>
#include <string>
#include <vector>

#include "limn/regular/artifacts.h"

namespace limn::test {

using Complex = std::complex<double>;
using Place = std::array<double, 2>;

inline constexpr double kSqrt3 = 1.7320508075688772;

/// The Cartesian place with these coordinates in the lattice's basis: e1 = (1, 0) and
/// e2 = (-1/2, √3/2) or (0, 1).
[[nodiscard]] Place plane(Lattice lattice, Place coordinates);
/// e^{2πi g·x}
[[nodiscard]] Complex wave(Frequency g, Place x);
/// The frequency with f·e1 = a, f·e2 = b.
[[nodiscard]] Frequency frequency_along(Lattice lattice, double a, double b);
/// The same 'random' frequencies in every run, in about the Nyquist region.
[[nodiscard]] std::vector<Frequency> some_frequencies(int count, unsigned seed = 7);

[[nodiscard]] const Mask& shipped_mask(const std::string& scheme);
[[nodiscard]] const ArtifactAnalysis& shipped_analysis(const std::string& scheme);
[[nodiscard]] bool is_dual(const Mask& mask);
/// of(mask).value(), with its error on the screen where there is one.
[[nodiscard]] ArtifactAnalysis analysis_of(const Mask& mask);

/// One member of each class of refined lattice vectors modulo M Z², by search.
[[nodiscard]] std::vector<LatticeVector> class_members(const LatticeMatrix& dilation);
/// M⁻¹ k where that is integer: true and `quotient`.
[[nodiscard]] bool divides(const LatticeMatrix& dilation, LatticeVector k, LatticeVector& quotient);

/// Σ_j a(m − M j) e^{2πi f·j} for `doubled` = 2m: the refined wave there. And where that is in the
/// plane, in control edges: M⁻¹ m.
[[nodiscard]] Complex refined_wave(const Mask& mask, Frequency f, LatticeVector doubled);
[[nodiscard]] Place refined_place(const Mask& mask, LatticeVector doubled);

/// Amplitudes of these |det M| waves in the refined wave, fitted to one point of each class;
/// the points are those near M·(shift, …).
[[nodiscard]] std::vector<double> fitted_amplitudes(const Mask& mask, Frequency f,
                                                    const std::vector<Frequency>& waves, int shift);

/// The signal first.
[[nodiscard]] std::vector<double> all(const Components& components);
/// The frequency f, then those of its artifacts.
[[nodiscard]] std::vector<Frequency> all_frequencies(const ArtifactAnalysis& analysis, Frequency f);
/// Largest |a - b|, or of |a| and |b| where signs are free; infinite where sizes differ.
[[nodiscard]] double distance(const std::vector<double>& a, const std::vector<double>& b,
                              bool up_to_sign = false);

/// Every shipped scheme's mask, those of some with other parameters, and of splits that limn does
/// not have; by name.
[[nodiscard]] std::vector<std::pair<std::string, Mask>> many_masks();

/// A ternary box spline on triangles: two boxes of three along each edge direction.
[[nodiscard]] Mask ternary_box_spline();
/// The quincunx M = [[1, 1], [1, -1]], linear interpolation: 1, and 1/4 at the four neighbours.
[[nodiscard]] Mask quincunx();
/// A point-symmetric mask with random weights that sum to 1 over each class.
[[nodiscard]] Mask random_mask(Lattice lattice, const LatticeMatrix& dilation, unsigned seed);
/// Such masks of eight splits.
[[nodiscard]] std::vector<Mask> random_masks(unsigned seed);

}  // namespace limn::test
