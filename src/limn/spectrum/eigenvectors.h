#pragma once
/// Eigenvectors of frequency blocks, as amplitudes per orbit and as values at the star's vertices.

#include <array>
#include <vector>

#include "limn/spectrum/eigencomponents.h"

namespace limn {

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
