#pragma once
/// The dense subdivision matrix of a star or fan whose faces need not be alike, and its
/// eigenvectors.

#include <Eigen/Dense>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/lattice.h"
#include "limn/scheme/scheme.h"

namespace limn::limit {

/// The vertices that may control a surface round one vertex, so that a matrix of them takes
/// seconds.
inline constexpr Index kMostStarVertices = 1000;

/// That a place has more.
[[nodiscard]] Error too_large(const std::string& place);

/// On as many rings as control the surface there.
struct SectorMatrix {
  mesh::Sectors sectors;
  int rings = 0;
  /// Row i: the weights of the vertex that plays the part of vertex i (`sector_star`) a step later,
  /// or two steps where the boundary moves in every second one only.
  Eigen::MatrixXd entries;
  std::vector<Eigen::Index> invariant;  ///< sizes of leading parts that are closed, ascending
};

/// "a boundary vertex of 3 faces", "a vertex of the faces 3, 3, 4".
[[nodiscard]] std::string place_text(const mesh::Sectors& sectors);

/// Of the surroundings of a vertex whose faces begin sectors of their lattices. At the rim, which
/// stands for nothing, rules may be missing. Fails where one is that the matrix depends on, where
/// the scheme looks too far, and beyond kMostStarVertices. Lattices are those that the scheme's
/// split takes; it keeps old vertices and, of a closed star, does not turn. Cost: that of a
/// refinement.
[[nodiscard]] Result<SectorMatrix> sector_matrix(const Scheme& scheme,
                                                 const mesh::Sectors& sectors);

/// Left and right eigenvectors of a real eigenvalue: biorthonormal columns, on the smallest
/// invariant part that has all of them.
struct SectorVectors {
  Eigen::MatrixXd left, right;
};

/// Nothing where λ is defective. Cost: the cube of the matrix's size.
[[nodiscard]] std::optional<SectorVectors> sector_vectors(const SectorMatrix& matrix,
                                                          double lambda);

/// All eigenvalues, largest modulus first. Cost as above.
[[nodiscard]] std::vector<std::complex<double>> eigenvalues_of(const SectorMatrix& matrix);

/// Those other than the first 1; nothing where 1 does not lead.
[[nodiscard]] std::optional<std::vector<std::complex<double>>> eigenvalues_beside_one(
    const SectorMatrix& matrix);

/// The two eigenvectors that lead all others, given the eigenvalues beside 1; nothing where there
/// are no such two.
[[nodiscard]] std::optional<SectorVectors> leading_pair(
    const SectorMatrix& matrix, const std::vector<std::complex<double>>& values);

}  // namespace limn::limit
