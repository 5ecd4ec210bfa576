#pragma once
/// What panels of a scene share: outlines, marks and the control net in lines, and a note where no
/// rays can be cast.

#include "limn/base/error.h"
#include "limn/figure/canvas/canvas.h"
#include "limn/figure/space/space_curves.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// What is seen of the outlines of surface `index`; width in points.
void draw_outline(Canvas& canvas, const SurfaceScene& scene, std::size_t index,
                  const RayCaster& rays, const FramePlacement& place, double width);

/// The scene's control net, pale and dashed where a surface hides it.
void draw_scene_net(Canvas& canvas, const SurfaceScene& scene, const RayCaster& rays,
                    const FramePlacement& place);

/// What is seen of the scene's marks.
void draw_scene_marks(Canvas& canvas, const SurfaceScene& scene, const RayCaster& rays,
                      const FramePlacement& place);
/// In points, of a mark's dots.
[[nodiscard]] double dot_radius(const SceneMarks& marks);

/// The error in place of the picture.
void draw_scene_note(Canvas& canvas, const FramePlacement& place, const Error& error);

/// Polylines as one path.
[[nodiscard]] Path path_of(const std::vector<Polyline>& lines);

}  // namespace limn::figure
