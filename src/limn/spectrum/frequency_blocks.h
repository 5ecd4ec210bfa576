#pragma once
/// The subdivision matrix round an extraordinary vertex (or face, for dual splits) in the Fourier
/// domain [BGSK §3]: one small block for each rotational frequency.
///
/// Points that rotation by a sector exchanges form an orbit: n of them, one in each sector, at
/// angle (s + angle) · 2π/n. Orbit values x_s = X e^{2πiω(s+angle)/n} are mapped to such values,
/// amplitudes to amplitudes by the block of frequency ω. Phases are taken at the points' own places
/// (a twisted DFT), also where a step turns the lattice by half a sector, so √3 is analysed in one
/// step.
///
/// The star is refined once, with the weights of its centre left as names; what depends on the
/// valence is put in afterwards. A block costs the same at every valence, apart from weights that
/// depend on k, which are n numbers.

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include "limn/scheme/scheme.h"

namespace limn {

/// The n points that rotations by a sector exchange.
struct Orbit {
  int ring = 0;      ///< from 1 on
  double angle = 0;  ///< in sectors from that of sector 0's spoke (dual: corner), in (-1, 1)
};

/// The subdivision matrix at one valence, block by block.
struct FrequencyBlocks {
  int valence = 0;            ///< n; of dual splits: corners of the face
  int rings = 0;              ///< that the star has
  bool has_center = false;    ///< false for dual splits
  std::vector<Orbit> orbits;  ///< without the centre; ring after ring, counterclockwise
  /// The blocks of ω = 0 … ⌊n/2⌋; that of n-ω is the conjugate of ω's. One row and column for each
  /// orbit; for ω = 0 the centre comes first, where there is one.
  std::vector<Eigen::MatrixXcd> blocks;
};

namespace spectrum {
struct SectorPattern;  // sector_pattern.h
}

/// That FrequencyAnalysis::blocks makes all ⌊n/2⌋ + 1 blocks.
inline constexpr int kAllFrequencies = std::numeric_limits<int>::max();

/// Frequency blocks of one scheme at any number of valences.
class FrequencyAnalysis {
 public:
  /// `scheme` must outlive the analysis. rings 0: as many as control the limit surface on the
  /// faces round the vertex (at each valence: 2 for Loop and Catmull-Clark, 3 for the butterfly).
  explicit FrequencyAnalysis(const Scheme& scheme, int rings = 0);
  ~FrequencyAnalysis();
  /// A move leaves `other` good for nothing but assignment and destruction.
  FrequencyAnalysis(FrequencyAnalysis&& other) noexcept;
  /// As the constructor.
  FrequencyAnalysis& operator=(FrequencyAnalysis&& other) noexcept;

  /// At a valence n from least_valence (least_valence.h) on. In double precision. Not from two
  /// threads at once: stars are kept. Fails where a rule is missing at n or its weights do not sum
  /// to 1 (to 1e-9), and where the rings are not invariant. `frequencies`: so many blocks, ω = 0,
  /// 1, …, suffice; at least 1. Cost: a star is refined for each new set of rule cases at its
  /// centre; else O(n log n), and of each block that of its entries.
  [[nodiscard]] Result<FrequencyBlocks> blocks(int n, int frequencies = kAllFrequencies);
  /// Those of 0 and of these frequencies alone, the same to the last bit; the other blocks have no
  /// rows. `frequencies`: ascending, of 0 … ⌊n/2⌋.
  [[nodiscard]] Result<FrequencyBlocks> blocks(int n, const std::vector<int>& frequencies);

 private:
  Result<const spectrum::SectorPattern*> pattern_at(int n);

  const Scheme* scheme_;
  int rings_;
  /// A star's refinement for each set of rule cases that applies at its centre.
  std::map<std::vector<const RuleCase*>, std::unique_ptr<spectrum::SectorPattern>> patterns_;
};

// Eigenvalues of frequency blocks, with their rings, multiplicities and Jordan blocks.

/// An eigenvalue of one block of the subdivision matrix.
struct Eigenvalue {
  std::complex<double> value;  ///< taken for real where |Im| ≤ kEqualBelow
  int frequency = 0;           ///< ω of the block, 0 … ⌊n/2⌋
  /// The least number of rings that are invariant by themselves and have it.
  int ring = 0;
  int multiplicity = 1;  ///< algebraic, within its frequency's block
  int jordan = 1;        ///< size of its largest Jordan block there

  /// |value|, sooner than std::abs where it is real, as most are.
  [[nodiscard]] double modulus() const {
    return value.imag() == 0 ? std::abs(value.real()) : std::abs(value);
  }
};

/// The eigenvalues of one block, largest modulus first, repeated by multiplicity.
struct BlockSpectrum {
  int frequency = 0;                    ///< ω, 0 … ⌊n/2⌋
  std::vector<Eigenvalue> eigenvalues;  ///< as many as the block has rows
};

/// Eigenvalues closer than this are called equal.
inline constexpr double kEqualBelow = 1e-10;
/// From kEqualBelow up to this distance nothing is said of two eigenvalues: undecided.
inline constexpr double kUndecidedBelow = 1e-8;

/// What becomes of eigenvalues closer than about 1e-7 (of three or more: 1e-5), which may be one
/// defective eigenvalue that rounding split: `joined` gives them their mean, exact if they are one;
/// `apart` leaves them, exact if they are several.
enum class Near { joined, apart };

/// The spectrum of one block, 0 ≤ ω ≤ ⌊n/2⌋, in double precision. Cost: one eigenvalue problem for
/// each part of the block whose rows reach each other, most of one or two rows.
[[nodiscard]] BlockSpectrum approx_spectrum(const FrequencyBlocks& blocks, int omega,
                                            Near near = Near::joined);

/// Reads spectra of one valence's blocks one after another: what they share (the mirror's partners,
/// which rows hang together) is found once. A block may be given other entries between two calls.
class SpectrumReader {
 public:
  /// `blocks` must outlive the reader, with the same orbits.
  explicit SpectrumReader(const FrequencyBlocks& blocks);
  ~SpectrumReader();
  SpectrumReader(const SpectrumReader&) = delete;
  SpectrumReader& operator=(const SpectrumReader&) = delete;

  /// As approx_spectrum.
  [[nodiscard]] BlockSpectrum approx_spectrum(int omega, Near near = Near::joined);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// Of all blocks, ω = 0 … ⌊n/2⌋, near ones joined. Cost: one small eigenvalue problem for each.
[[nodiscard]] std::vector<BlockSpectrum> approx_spectra(const FrequencyBlocks& blocks);

}  // namespace limn
