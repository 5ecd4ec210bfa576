#pragma once
/// Smooth surfaces, given by many small triangles with the normals of the surface at their
/// corners, and how one looks at them. shaded_panel.h and reflection_line_panel.h draw such scenes.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/canvas/space_vector.h"
#include "limn/figure/space/scene_marks.h"

namespace limn::figure {

/// Surfaces less than this, of the size of the cube that holds all that is drawn, apart along the
/// line of sight are at one place.
inline constexpr double kEqualDepth = 2e-5;

/// And those less than this apart are nearly so: pictures of ties (`TieLook`) fade from the one to
/// the other.
inline constexpr double kNearDepth = 4e-4;

/// Triangles may be oriented either way, if the normals are alike; both sides are drawn. A triangle
/// is left out if an index is out of range, if a corner or its normal is not `placeable`, or if a
/// normal is 0.
struct SmoothSurface {
  std::vector<SpaceVector> vertices = {};
  std::vector<SpaceVector> normals = {};  ///< one per vertex, of any length
  std::vector<std::array<int, 3>> triangles = {};
  /// Coordinates (u, v) of a texture, one for each vertex, or empty; not finite: there are none.
  std::vector<std::array<double, 2>> texture = {};
  Colour colour = {0.80, 0.83, 0.88};       ///< of the shaded surface
  Colour line_colour = {0.10, 0.12, 0.16};  ///< of its reflection lines and outlines
};

/// Whether a point or direction can be drawn: finite and not beyond 1e100.
[[nodiscard]] bool placeable(const SpaceVector& a);

/// Vertices joined by edges. What is not placeable or out of range is left out.
struct ControlNet {
  std::vector<SpaceVector> vertices = {};
  std::vector<std::array<int, 2>> edges = {};
  bool points = true;  ///< a dot at each vertex
};

/// Two opposite corners of a box with sides along the axes.
struct SpaceBox {
  SpaceVector low = {}, high = {};
};

struct SurfaceScene {
  std::vector<SmoothSurface> surfaces = {};
  /// Drawn over the surfaces: in full where it is seen, pale and dashed where a surface hides it.
  ControlNet net = {};
  std::vector<SceneMarks> marks = {};  ///< over the net, the later over the earlier
  double azimuth = -50;   ///< degrees, of the viewer about the z axis, from x towards y
  double elevation = 30;  ///< degrees, of the viewer over the xy plane, in [−90, 90]
  /// What just fits into the panel, so that panels of several scenes share a scale. Without it: all
  /// that is drawn.
  std::optional<SpaceBox> frame = {};
  /// The same as a rectangle of the viewer's plane, `frame_of` another scene; goes before `frame`.
  std::optional<ViewFrame> seen_frame = {};
};

/// The usable triangles of a surface in the viewer's coordinates. Normals are of length 1, and 0
/// at vertices that are not usable.
struct SeenSurface {
  std::vector<SpaceVector> vertices = {};
  std::vector<SpaceVector> normals = {};
  std::vector<std::array<int, 3>> triangles = {};
};

/// Multiplies all coordinates of the scene by one power of two, so that the largest that is finite
/// comes to about 1, where it is beyond 1e60 or below 1e-60: products of coordinates then neither
/// over- nor underflow, and the picture is that of the same surfaces at another size. The scene has
/// no `seen_frame` yet. O(vertices).
void scale_to_draw(SurfaceScene& scene);

/// O(vertices + triangles).
[[nodiscard]] SeenSurface seen_surface(const SmoothSurface& surface, const ParallelView& view);

/// The box that holds all triangles.
struct SeenBox {
  SpaceVector low, high;
  double longest = 0;  ///< of its sides
};
/// Nothing where there is no triangle. O(triangles).
[[nodiscard]] std::optional<SeenBox> seen_box(const std::vector<SeenSurface>& surfaces);

/// Those of all surfaces of the scene.
[[nodiscard]] std::vector<SeenSurface> seen_surfaces(const SurfaceScene& scene);

/// What the scene's panel shows.
[[nodiscard]] ViewFrame frame_of(const SurfaceScene& scene);

/// In points, of a panel of the given width; and the place of the scene in it.
[[nodiscard]] double scene_height(const SurfaceScene& scene, const std::string& title,
                                  double width);
[[nodiscard]] FramePlacement scene_placement(const SurfaceScene& scene, const std::string& title,
                                             const Box& box);

}  // namespace limn::figure
