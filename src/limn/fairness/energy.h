#pragma once
/// Energies of a smooth surface that is known at the vertices of a mesh; the smaller, the fairer.
///
/// The positions are points of the surface itself: whoever refines a control mesh takes its
/// vertices to the limit first (limit/limit_points.h), at any level.

#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"

namespace limn {

/// What `approx_energies` finds. Lengths are in the unit of the positions.
struct SurfaceEnergies {
  double area = 0;  ///< ∫ dA, length²
  /// ∫ κ1² + κ2² dA. It has no unit: larger and smaller copies of a shape have the same.
  double thin_plate = 0;
  /// ∫ ‖∇II‖² dA of the covariant derivative of the second fundamental form, 1/length². Along the
  /// principal directions ‖∇II‖² = κ1,1² + κ2,2² + 3 (κ1,2² + κ2,1²) by Codazzi's equations: the
  /// two terms of the MVS energy [MoretonSequin1992] and, three times, the two that it leaves out.
  /// It does not ask for principal directions, which umbilics do not have, and it vanishes on
  /// planes, spheres and cylinders of revolution only.
  double curvature_variation = 0;
  /// Faces that count in the area alone, because a corner has no known second form.
  Index left_out = 0;
  /// What rounding of the positions may change each by, at most by the order of magnitude.
  struct Rounding {
    double area = 0;                 ///< length²
    double thin_plate = 0;           ///< no unit
    double curvature_variation = 0;  ///< 1/length²
  };
  Rounding rounding = {};  ///< of the three energies above
};

/// The integrals by second fundamental forms at the vertices (second_form.h): over each face the
/// area of triangles (of polygons, those round the mean of the corners), the mean of ‖II‖² at the
/// corners, and the derivative of the linear interpolant. On a surface with smooth curvature all
/// three converge with the square of the mesh width; where curvatures have kinks or jumps along
/// curves, as in polynomial patches, the variation with its first power; where they are not
/// square-integrable the values grow without bound as the mesh is refined (trend.h). Faces
/// without area add nothing. The same for models of any size, up to a power of two exactly, as far
/// as the energies can be represented. Fails, naming a vertex, where a position is not finite. Cost
/// O(corners), in parallel; the same bits on any number of threads.
[[nodiscard]] Result<SurfaceEnergies> approx_energies(const Mesh& mesh,
                                                      const std::vector<Point3>& positions);

}  // namespace limn
