#pragma once
/// Eigenvalues of the subdivision matrix, each known by its rotational frequency [BGSK §2.2], and
/// what they say about the surface.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/truth.h"
#include "limn/extraordinary/block_spectrum.h"

namespace limn {

/// A label: eigenvalue number `index` (largest first) of a frequency's block.
struct Component {
  std::string_view name;
  int frequency;
  std::size_t index;

  /// At n = 3 frequency 2 is the conjugate of frequency 1 and has no label of its own.
  [[nodiscard]] bool exists_at(int valence) const { return frequency <= valence / 2; }
};
inline constexpr std::array<Component, 4> kComponents{
    {{"position", 0, 0}, {"cup", 0, 1}, {"tangent", 1, 0}, {"saddle", 2, 0}}};

/// The labelled eigenvalue; nothing where it is not real. `spectrum` is that of its frequency.
[[nodiscard]] std::optional<double> labelled(const Component& component,
                                             const BlockSpectrum& spectrum);

/// How the curvature of a shape (cup or saddle) comes out at the vertex, by its eigenvalue against
/// the square of the tangent's.
enum class Curvature { flat, bounded, unbounded, undecided };
[[nodiscard]] std::string_view to_string(Curvature curvature);

struct Verdict {
  Truth convergent = Truth::undecided;  ///< 1 is simple, all others are smaller
  Truth c1_necessary =
      Truth::undecided;  ///< the tangent pair leads all others but 1, in every block
  Truth bounded_curvature = Truth::undecided;  ///< all others are at most tangent²
  std::optional<Curvature> cup, saddle;        ///< nothing where the valence has no such shape
  std::vector<std::string> reasons;
};

struct Eigencomponents {
  int valence = 0;
  int rings = 0;
  std::vector<BlockSpectrum> spectra;  ///< ω = 0 … ⌊n/2⌋
  /// Dominant of ω = 0 and of ω = 1, subdominant of ω = 0, dominant of ω = 2 (none at n = 3, where
  /// that is the conjugate of ω = 1; none where it is not real).
  std::optional<double> position, tangent, cup, saddle;
  Verdict verdict;
};

/// In double precision: an "approximate" reading; certificates are another matter. Cost: one small
/// eigenvalue problem for each frequency.
[[nodiscard]] Eigencomponents approx_eigencomponents(const FrequencyBlocks& blocks);

}  // namespace limn
