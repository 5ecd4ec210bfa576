#pragma once
/// Eigenvalues of the subdivision matrix, each known by its rotational frequency [BGSK §2.2], and
/// what they say about the surface.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/truth.h"
#include "limn/scheme/mask.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn {

/// A label: eigenvalue number `index` (largest first) of a frequency's block.
struct Component {
  std::string_view name;  ///< "tangent"
  int frequency;          ///< ω of the block
  std::size_t index;      ///< from 0, counted with multiplicity

  /// Whether it is a label at that valence: at n = 3 frequency 2 is the conjugate of frequency 1
  /// and has no label of its own.
  [[nodiscard]] bool exists_at(int valence) const { return frequency <= valence / 2; }
};
/// The labels, in the order in which tables list them.
inline constexpr std::array<Component, 4> kComponents{
    {{"position", 0, 0}, {"cup", 0, 1}, {"tangent", 1, 0}, {"saddle", 2, 0}}};

/// The labelled eigenvalue; nothing where it is not real. `spectrum` is that of its frequency.
[[nodiscard]] std::optional<double> labelled(const Component& component,
                                             const BlockSpectrum& spectrum);

/// A shape's eigenvalue (the cup's or the saddle's) against the square of the tangent's: less,
/// equal, greater. A comparison of two numbers: whether curvature is bounded is
/// Verdict::bounded_curvature.
enum class Curvature { flat, bounded, unbounded, undecided };
/// "flat", "bounded", "unbounded" or "undecided".
[[nodiscard]] std::string_view to_string(Curvature curvature);

/// What the eigenvalues say, and the regular surface round the vertex. `convergent`: of the vertex
/// alone. A C1 surface needs more than `c1_necessary`: a characteristic map that is regular and
/// injective, and C1 regular surfaces; none of that is looked at here.
struct Verdict {
  Truth convergent = Truth::undecided;  ///< 1 is simple, all others are smaller
  /// The tangent pair leads all others but 1, in every block. no: not C1. Undecided where the
  /// tangent's eigenvalue has a Jordan block that drowns all that ties with it: then the map of the
  /// chain's eigenvector decides, of which the standard theorem does not speak. And where others
  /// lead, but an eigenvector may have the surface 0 (RegularPart::stable).
  Truth c1_necessary = Truth::undecided;
  /// What bounded curvature needs of the eigenvalues: c1_necessary, and all others are at most
  /// tangent², those that are equal to it without Jordan blocks.
  Truth curvature_necessary = Truth::undecided;
  /// What the lattice allows, as it was given.
  RegularPart regular_part;
  /// curvature_necessary and regular_part together: whether curvature is bounded at the vertex, if
  /// the surface is C1 there.
  Truth bounded_curvature = Truth::undecided;
  std::optional<Curvature> cup;      ///< nothing where no positive eigenvalue leads frequency 1
  std::optional<Curvature> saddle;   ///< the same, and nothing at n = 3
  std::vector<std::string> reasons;  ///< of each no and undecided, and of flat shapes
};

/// The spectra at one valence, the labelled eigenvalues and the verdict.
struct Eigencomponents {
  int valence = 0;                     ///< n
  int rings = 0;                       ///< of the star that was refined
  std::vector<BlockSpectrum> spectra;  ///< ω = 0 … ⌊n/2⌋
  std::optional<double> position;      ///< dominant of ω = 0; nothing where it is not real
  std::optional<double> tangent;       ///< dominant of ω = 1; nothing where it is not real
  std::optional<double> cup;           ///< subdominant of ω = 0; nothing where it is not real
  /// Dominant of ω = 2; nothing where it is not real and at n = 3, where that is the conjugate of
  /// ω = 1.
  std::optional<double> saddle;
  Verdict verdict;  ///< what they say
};

/// In double precision: an "approximate" reading; certificates are another matter. `regular`: of
/// the scheme's regular lattice; without it bounded curvature is refuted at most. Cost: one small
/// eigenvalue problem for each frequency.
[[nodiscard]] Eigencomponents approx_eigencomponents(const FrequencyBlocks& blocks,
                                                     const RegularPart& regular = {});

// Eigenvectors of frequency blocks, as amplitudes per orbit and as values at the star's vertices.

/// The eigenvectors of one eigenvalue λ of a block S, as amplitudes: an entry for each row of the
/// block (the orbits of FrequencyBlocks; for ω = 0 the centre first, where there is one). As many
/// as λ has Jordan blocks.
struct Eigenvectors {
  int frequency = 0;           ///< ω of the block
  std::complex<double> value;  ///< λ
  Eigen::MatrixXcd right;      ///< columns: S·x = λ·x
  /// Rows: y·S = λ·y, zero beyond the eigenvalue's ring. Where Jordan blocks are of size 1, left ·
  /// right is the identity.
  Eigen::MatrixXcd left;
};

/// Of an eigenvalue that `approx_eigencomponents` found in these blocks. Several right eigenvectors
/// are each 1 on an orbit where the others vanish. A single one is scaled so that its first
/// amplitude of the innermost ring that it does not vanish on (the centre left out) is 1; for ω =
/// 0, less the centre's. For ω = n/2 that one has modulus 1, and they are the amplitudes of real
/// values, unless a step turns the star (√3): it then maps real to imaginary ones. In double
/// precision. Cost: the cube of the block's rows.
[[nodiscard]] Eigenvectors approx_eigenvectors(const FrequencyBlocks& blocks,
                                               const Eigenvalue& eigenvalue);

/// Where a vertex of the star is.
struct StarPlace {
  int row = 0;       ///< of its orbit in the block of ω = 0
  double angle = 0;  ///< in sectors from the spoke of sector 0, counterclockwise
};
/// Of the star of `blocks.rings` rings, vertex by vertex: the centre, where there is one, then ring
/// after ring, each counterclockwise from the spoke of sector 0.
[[nodiscard]] std::vector<StarPlace> star_places(const FrequencyBlocks& blocks);

/// Real eigenvectors of the whole subdivision matrix: the values Re and Im of X e^{2πiω·angle/n} at
/// the star's vertices, `amplitudes` having a row for each of the block. The second is zero for the
/// real eigenvectors of ω = 0 and n/2.
[[nodiscard]] std::array<std::vector<double>, 2> spatial_vectors(
    const FrequencyBlocks& blocks, int frequency, const Eigen::VectorXcd& amplitudes);

/// Weights of two real functionals, F = Σ weight · value, that measure how much of an eigenvector
/// the values at the star's vertices hold: for values Re(c·X e^{…}) with left · X = 1 they
/// give Re c and Im c (for ω = 0, and n/2 where the star does not turn, c is real).
[[nodiscard]] std::array<std::vector<double>, 2> spatial_functionals(
    const FrequencyBlocks& blocks, int frequency, const Eigen::RowVectorXcd& left);

}  // namespace limn
