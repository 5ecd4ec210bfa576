#pragma once
/// Limit surfaces of meshes with creases and texture coordinates, with marks that show these.

#include <vector>

#include "limn/figure/space/surface_scene.h"
#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/scheme/scheme.h"
#include "limn/surface/refine_surface.h"

namespace limn::study {

/// What is wanted.
struct MarkedOptions {
  int steps = 4;
  Sharpness sharpness = {};  ///< of the control mesh
  /// Of its corners; null, or empty: there is none.
  const TextureCoordinates* texture = nullptr;
  TextureRule rule = TextureRule::corners_plus1;
  bool textured = false;  ///< fill SmoothSurface::texture
  bool marks = false;     ///< fill MarkedSurface::marks
};

struct MarkedSurface {
  figure::SmoothSurface surface;
  /// The control mesh's sharp edges, by sharpness, the sharpest last; its sharp vertices likewise;
  /// the seams of its texture. Boundaries are none. Curves of one kind that meet end there.
  std::vector<figure::SceneMarks> marks;
  LimitGaps gaps;  ///< by vertices of the refined mesh
};

/// The limit surface, sampled after so many steps, with a normal for each side of a crease and a
/// texture point for each side of a seam; where sharpness leaves no normal, at a tip, faces have
/// their own. Faces of holes are left out. Vertices without a limit
/// point stay where the steps have put them. Fails as `refine_surface` does, and before the work
/// where it and a picture of it need more memory than there is. Seams are marked only where the
/// split keeps old edges.
[[nodiscard]] Result<MarkedSurface> marked_surface(const Scheme& scheme, const Mesh& control,
                                                   const std::vector<Point3>& points,
                                                   const MarkedOptions& options);

/// The same of the control mesh itself, its faces flat, by fans. There are no gaps.
[[nodiscard]] MarkedSurface marked_control(const Scheme& scheme, const Mesh& control,
                                           const std::vector<Point3>& points,
                                           const MarkedOptions& options);

}  // namespace limn::study
