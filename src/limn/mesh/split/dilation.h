#pragma once
/// The dilation matrix M of a split: a vector with coordinates k in the control lattice has M k in
/// the refined one. Everything that the analyses on the lattice know about a split is here and in
/// its Lattice, so that a new split needs its M alone.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace limn {

/// The regular meshes: triangles, six round a vertex; quads, four round a vertex.
enum class Lattice { triangle, quad };

using LatticeVector = std::array<int, 2>;  ///< coordinates in the lattice's basis, see lattice.h

/// An integer matrix, row by row. A dilation matrix is one that stretches the plane by
/// sqrt(|det M|) > 1, and turns it perhaps.
struct LatticeMatrix {
  std::array<LatticeVector, 2> rows;  ///< entry (i, j) is rows[i][j]

  /// det M, negative where M turns the plane over.
  [[nodiscard]] constexpr int determinant() const {
    return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
  }
  /// |det M|: the number of refined faces for each old one, and of waves after one refinement.
  [[nodiscard]] constexpr int growth() const {
    return determinant() < 0 ? -determinant() : determinant();
  }
  /// Whether M turns the plane, besides stretching it: of the splits by half a sector.
  [[nodiscard]] constexpr bool turns() const { return rows[0][1] != 0; }
  /// M k
  [[nodiscard]] constexpr LatticeVector apply(LatticeVector k) const {
    return {rows[0][0] * k[0] + rows[0][1] * k[1], rows[1][0] * k[0] + rows[1][1] * k[1]};
  }
  /// det(M) M⁻¹ k
  [[nodiscard]] constexpr LatticeVector apply_adjugate(LatticeVector k) const {
    return {rows[1][1] * k[0] - rows[0][1] * k[1], rows[0][0] * k[1] - rows[1][0] * k[0]};
  }
  /// M⁻¹ k where that is a lattice vector.
  [[nodiscard]] std::optional<LatticeVector> divide(LatticeVector k) const;
  /// M⁻ᵀ t: phases per refined basis vector from phases per control basis vector.
  [[nodiscard]] constexpr std::array<double, 2> refined_phase(std::array<double, 2> t) const {
    const double det = determinant();
    return {(rows[1][1] * t[0] - rows[1][0] * t[1]) / det,
            (rows[0][0] * t[1] - rows[0][1] * t[0]) / det};
  }
  /// The same for integers and without the division: det(M) M⁻ᵀ κ.
  [[nodiscard]] constexpr LatticeVector refined_phase_times_determinant(LatticeVector k) const {
    return {rows[1][1] * k[0] - rows[1][0] * k[1], rows[0][0] * k[1] - rows[0][1] * k[0]};
  }

  /// Equal entries.
  friend constexpr bool operator==(const LatticeMatrix& a, const LatticeMatrix& b) {
    return a.rows == b.rows;
  }
};

/// The class of a refined lattice vector modulo M Z²: 0 … |det M| - 1, old vertices in class 0.
/// Classes are numbered in the lexicographic order of their least non-negative members.
[[nodiscard]] int coset_of(const LatticeMatrix& dilation, LatticeVector k);
/// One member of each class of Z² modulo M Z², (0, 0) first, in the order of coset_of.
[[nodiscard]] std::vector<LatticeVector> cosets(const LatticeMatrix& dilation);

/// One κ of each class of the dual lattice Z² modulo Mᵀ Z², (0, 0) first, the others in
/// lexicographic order: a wave with phases t, refined, is |det M| waves with phases t + 2πκ. For
/// M = 2I these are (0,0) and (0,1), (1,0), (1,1), in this order the artifacts Y1, Y2, Y3 of
/// [ADS §2.2]: Y1 leaves the phase along e1 alone, Y2 that along e2, Y3 that along e1 + e2.
[[nodiscard]] std::vector<LatticeVector> dual_cosets(const LatticeMatrix& dilation);

/// The length of the box that smooths one direction, 1 + z + … + z^{p-1}: the least p with p Z² in
/// M Z². 2 for dyadic splits and sqrt(2), 3 for ternary ones and sqrt(3).
[[nodiscard]] int arity(const LatticeMatrix& dilation);

/// Up to sign the directions of the lattice's edges: e1, e2 and, on triangles, e1 + e2.
[[nodiscard]] std::vector<LatticeVector> edge_directions(Lattice lattice);

/// Squared Cartesian length of a lattice vector, in edges.
[[nodiscard]] constexpr int squared_length(Lattice lattice, LatticeVector k) {
  const int dot = lattice == Lattice::triangle ? -k[0] * k[1] : 0;  // e1·e2 = -1/2 on triangles
  return k[0] * k[0] + k[1] * k[1] + dot;
}

/// The matrices that map the lattice to itself and keep lengths: 12 on triangles, 8 on quads.
[[nodiscard]] std::vector<LatticeMatrix> isometries(Lattice lattice);

}  // namespace limn
