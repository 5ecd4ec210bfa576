#pragma once
/// Frequencies of a dense subdivision matrix by brute force: the space of vectors that rotation by
/// one sector multiplies by e^{2πiω/n}, spanned orbit by orbit, and the matrix on it.

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "limn/refine/subdivision_matrix.h"

namespace limn::test {

/// Vertices per sector in ring r of the star that the split is analysed on (mesh/lattice.h).
[[nodiscard]] int sector_size(const Split& split, int ring);

/// image[i] = the vertex to which rotation by one sector carries vertex i.
[[nodiscard]] std::vector<int> rotation(const Split& split, int n, int rings);

[[nodiscard]] Eigen::MatrixXd dense(const refine::SubdivisionMatrix<double>& matrix);

/// The matrix on frequency ω, one row and column per orbit (the centre first, where ω = 0), the
/// rings outwards. Under sqrt3 the new vertices have their phases at their own angles, half a
/// sector on, which makes the blocks' eigenvalues real [BGSK §3].
[[nodiscard]] Eigen::MatrixXcd frequency_block(const Split& split,
                                               const refine::SubdivisionMatrix<double>& matrix,
                                               int n, int rings, int omega);

/// frequency_block of a scheme on `rings` rings; throws where there is no such matrix.
[[nodiscard]] Eigen::MatrixXcd frequency_block(const Scheme& scheme, int n, int rings, int omega);

/// Rings enough for a verdict: the invariant neighbourhood, and two at least.
[[nodiscard]] int analysis_rings(const Scheme& scheme, int n);

/// Eigenvalues, largest modulus first. Multiple ones with Jordan blocks are off by up to 1e-5.
[[nodiscard]] std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXcd& block);

/// Singular values, the largest first.
[[nodiscard]] Eigen::VectorXd singular_values(const Eigen::MatrixXcd& matrix);

/// Smallest singular value of block - λ: 0 if and only if λ is an eigenvalue, and as exact as the
/// arithmetic even where λ is defective.
[[nodiscard]] double eigenvalue_defect(const Eigen::MatrixXcd& block, double lambda);

/// Eigenvalues within 1e-4 of λ, counted with multiplicity.
[[nodiscard]] int multiplicity(const Eigen::MatrixXcd& block, double lambda);

}  // namespace limn::test
