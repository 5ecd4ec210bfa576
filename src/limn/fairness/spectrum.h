#pragma once
/// Eigenvalues of the Laplacian of a mesh, its natural frequencies, and eigenvectors, its natural
/// modes of vibration [KS §3.1]. All lie in [0, 2]; 0 comes once for each connected component
/// (isolated vertices count), 2 once for each that is bipartite (has no odd cycle).

#include <vector>

#include <Eigen/Core>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"

namespace limn::fairness {

/// Some of the eigenvalues, rising, each as often as its multiplicity says.
struct LaplacianModes {
  std::vector<double> eigenvalues;
  /// Column j belongs to eigenvalue j, row v to vertex v. Orthonormal with valences as weights,
  /// Σ valence(v) m_i(v) m_j(v) = δ_ij; an isolated vertex weighs 1.
  Eigen::MatrixXd modes;
};

/// How many vertices `approx_all_modes` takes at most.
inline constexpr Index kMostDenseVertices = 2000;

/// All of them, by a dense solver: to about 1e-14. Fails above kMostDenseVertices. Cost
/// O(vertices³).
[[nodiscard]] Result<LaplacianModes> approx_all_modes(const Mesh& mesh);

/// Whether this build has Spectra, which finds a few modes of large meshes.
[[nodiscard]] bool spectra_available();

enum class SpectrumEnd { smallest, largest };

/// The `count` ≥ 1 smallest or largest (or all, where there are fewer), to about 1e-10. Of meshes
/// above some hundred vertices by Lanczos' method on a factored shifted matrix. That finds one
/// vector of a multiple eigenvalue at a time; it is therefore repeated orthogonally to all that was
/// found, until nothing new belongs there. Fails where the method does not converge, and for meshes
/// above kMostDenseVertices where there is no Spectra. Cost: a sparse Cholesky factorization and,
/// for each time, some ten to hundred solutions with it.
[[nodiscard]] Result<LaplacianModes> approx_modes(const Mesh& mesh, SpectrumEnd end, int count);

/// |Σ_v valence(v) m_j(v) p(v)| for each mode j: how much of the points vibrates with it. Over all
/// modes the squares sum to Σ valence(v) |p(v)|².
[[nodiscard]] std::vector<double> approx_amplitudes(const Mesh& mesh, const LaplacianModes& modes,
                                                    const std::vector<Point3>& points);

}  // namespace limn::fairness
