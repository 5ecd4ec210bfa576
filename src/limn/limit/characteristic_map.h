#pragma once
/// The characteristic map [Reif 1995]: the planar surface whose control net is the tangent pair of
/// eigenvectors. C1 needs it regular and injective.

#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/truth.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn {

// The limit surface on the faces round an extraordinary vertex, sampled finely.

/// A piece of the limit surface as a mesh.
struct StarSurface {
  Mesh mesh;                      ///< what became of the faces round the centre
  std::vector<Point3> positions;  ///< limit points, one per vertex
  std::vector<Point3> normals;    ///< unit normals there, zero where there is none
};

/// The surface whose control points are `values` on the star of n ≥ 3 sectors and `rings` rings
/// (dual splits: face star; refine/star_step.h), after so many steps; every second one for sqrt3,
/// whose steps turn the star, and of sqrt2 twice as many. `rings` must be those that control the
/// surface round the centre (FrequencyBlocks) and one more. Without boundary rules. `values` has an
/// entry for each vertex of the star. Cost: that of approx_limit_points on n |det M|^steps faces.
/// Fails as `approx_limit_points`.
[[nodiscard]] Result<StarSurface> approx_star_surface(const Scheme& scheme, int n, int rings,
                                                      const std::vector<Point3>& values, int steps);

/// The map at one valence, and what samples of it say.
struct CharacteristicMap {
  int valence = 0;        ///< n ≥ 3; of dual splits: corners of the face
  double eigenvalue = 0;  ///< the tangent's
  Mesh net;               ///< the star of the rings that control the surface
  /// (u, v, 0), one per vertex of `net`; the first spoke's neighbour of the centre is (1, 0).
  std::vector<Point3> net_points;
  StarSurface image;  ///< of the faces round the vertex, in the plane z = 0
  /// Whether the eigenvectors gave the map turned over: most Jacobians were negative. An
  /// eigenvector has no sign, so this is no fault; the second coordinate was negated, and all that
  /// is here is of the map that keeps the orientation.
  bool turned_over = false;
  /// Smallest signed area of a face of the image over the mean of all, each divided by the square
  /// of its distance from the centre; negative where it folds.
  double smallest_area = 0;
  /// Of samples, which prove nothing. yes: the Jacobian has one sign at all sampled points, so have
  /// the areas of faces, and the image goes round the centre once; no: it is not so; undecided:
  /// rounding could be it, also where the Jacobian vanishes at all points.
  Truth regular = Truth::undecided;
  std::string reason;  ///< what `regular` rests on, one sentence
};

/// At valence n ≥ 3, after `steps` ≥ 0 steps (4: 16 faces along each edge, √3: 9;
/// of √2 twice as many steps). In double
/// precision. Cost: that of the frequency blocks, then O(n |det M|^steps). Fails where the scheme
/// has no real tangent pair at n, and as `FrequencyAnalysis::blocks` does.
[[nodiscard]] Result<CharacteristicMap> approx_characteristic_map(const Scheme& scheme, int n,
                                                                  int steps = 4);

}  // namespace limn
