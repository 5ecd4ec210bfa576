#pragma once
/// Eigenvalues of frequency blocks, with their rings, multiplicities and Jordan blocks.

#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "limn/spectrum/frequency_blocks.h"

namespace limn {

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

/// What becomes of eigenvalues closer than about 1e-6, which may be one defective eigenvalue that
/// rounding split: `joined` gives them their mean, exact if they are one; `apart` leaves them,
/// exact if they are several.
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
