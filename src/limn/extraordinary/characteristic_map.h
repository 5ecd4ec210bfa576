#pragma once
/// The characteristic map [Reif 1995]: the planar surface whose control net is the tangent pair of
/// eigenvectors. C1 needs it regular and injective.

#include <string>

#include "limn/base/truth.h"
#include "limn/extraordinary/frequency_blocks.h"
#include "limn/extraordinary/star_surface.h"

namespace limn {

struct CharacteristicMap {
  int valence = 0;
  double eigenvalue = 0;  ///< the tangent's
  Mesh net;               ///< the star of the rings that control the surface
  std::vector<Point3>
      net_points;     ///< (u, v, 0); the first spoke's neighbour of the centre is (1, 0)
  StarSurface image;  ///< of the faces round the vertex
  /// Smallest signed area of a face of the image over the mean of all, each divided by the square
  /// of its distance from the centre; negative where it folds.
  double smallest_area = 0;
  /// yes: the Jacobian is positive at all sampled points, no face is turned over, and the image
  /// goes round the centre once (no proof); no: it is not so; undecided: rounding could be it.
  Truth regular = Truth::undecided;
  std::string reason;
};

/// At valence n, after so many steps (4: 16 faces along each edge). Fails where the scheme has no
/// real tangent pair at n, and as `FrequencyAnalysis::blocks` does.
[[nodiscard]] Result<CharacteristicMap> approx_characteristic_map(const Scheme& scheme, int n,
                                                                  int steps = 4);

}  // namespace limn
