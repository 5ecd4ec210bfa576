#pragma once
/// The second fundamental form of a smooth surface that is known at the vertices of a mesh.

#include <vector>

#include <Eigen/Core>

#include "limn/mesh/mesh.h"

namespace limn::fairness {

/// At one point: Σ κ_i e_i e_iᵀ with the principal curvatures κ_i and directions e_i, as a
/// symmetric tensor of space that vanishes along the normal. Curvatures are positive where the
/// surface bends towards its normal. In this form neighbours can be compared without a choice of
/// coordinates, and nothing is singular where the curvatures are equal.
struct SecondForm {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, by the orientation of the faces
  bool known = false;  ///< false where the neighbours determine none; then all is zero
  /// The most that the tensor may change where each position does by one unit of length.
  double gain = 0;
};

/// One per vertex: of the quadratic surface through the vertex that fits the other corners of its
/// faces best (least squares of the heights over the tangent plane). Where these are too few or
/// lie ill – at valences 3 and 4 of triangles, at the boundary –, the corners of the faces round
/// these as well; at the boundary the fit is thus one-sided. On a smooth surface the error is of
/// second order in the mesh width at vertices with a symmetric neighbourhood, of first order at
/// others. None is known where the neighbours do not determine the quadratic surface (isolated
/// vertices, degenerate faces, or where faces are no larger than rounding of their coordinates), or
/// are not finite. Any polygons. Cost O(corners), in parallel.
[[nodiscard]] std::vector<SecondForm> approx_second_forms(const Mesh& mesh,
                                                          const std::vector<Point3>& positions);

}  // namespace limn::fairness
