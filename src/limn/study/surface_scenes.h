#pragma once
/// Limit surfaces as scenes to be drawn.

#include <vector>

#include "limn/figure/space/surface_scene.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"
#include "limn/surface/refine_surface.h"

namespace limn::study {

/// A point as the figures take it.
[[nodiscard]] inline figure::SpaceVector vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// The limit surface of a control mesh, sampled after so many steps, with limit normals; faces are
/// cut into triangles by fans. By the fast engine where it has the limit (fast_refiner.h), else by
/// the plain one. Fails as `refine` and `approx_limit_points` do, and before the work where that
/// and a picture of it need more memory than there is. With `gaps`, a vertex that has no limit
/// point is no failure: it stays where the steps have put it (LimitOptions::partial), and is told
/// there, as are those that have no normal. Pictures leave out the triangles at either
/// (SurfaceScene).
[[nodiscard]] Result<figure::SmoothSurface> limit_surface(const Scheme& scheme, const Mesh& control,
                                                          const std::vector<Point3>& points,
                                                          int steps, LimitGaps* gaps = nullptr);

/// Bytes for each vertex of a surface: itself, a panel's copy of it, and the tree that rays are
/// cast into (measured for pictures of triangles).
inline constexpr double kSurfaceBytes = 300;

/// What a picture of such a surface takes.
struct DrawingEstimate {
  double vertices = 0, triangles = 0;
  double bytes = 0;  ///< at most, from the control mesh to the picture
};
[[nodiscard]] DrawingEstimate estimate_drawing(const Scheme& scheme, const Mesh& control,
                                               int steps);

/// More triangles than this are not drawn: a page of pixels shows no more.
inline constexpr double kMostTriangles = 2e7;

/// An error where the surface would have more than `kMostTriangles`; it names how many steps can be
/// drawn.
[[nodiscard]] Status check_drawable(const Scheme& scheme, const Mesh& control, int steps);

/// Its vertices and triangles.
[[nodiscard]] Polygons polygons_of(const figure::SmoothSurface& surface);

/// The edges of a mesh.
[[nodiscard]] figure::ControlNet control_net(const Mesh& mesh, const std::vector<Point3>& points);

}  // namespace limn::study
