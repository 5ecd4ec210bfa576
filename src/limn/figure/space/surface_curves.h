#pragma once
/// Curves on a seen surface: reflection lines and outlines. They lie on the triangles; hidden parts
/// are theirs as well (see space_curves.h).

#include <vector>

#include "limn/figure/space/light_lines.h"
#include "limn/figure/space/space_curves.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// The surface with its triangles cut, until the mirror direction r of interpolated normals is
/// linear along their edges to within what shifts a reflection line by `tolerance` (in the units of
/// space); at most 6 times in halves. The triangles remain joined along their edges. New normals
/// are means, not of length 1: interpolated normals stay what they were.
[[nodiscard]] SeenSurface refined_for_mirror(SeenSurface surface, double tolerance);

/// Where the surface shows light line `line`: on each triangle r is interpolated between its
/// corners, so the place is exact for that r, and the angle's branch cut plays no part.
/// O(triangles + n log n) for n pieces.
[[nodiscard]] std::vector<SpaceCurve> reflection_line(const SeenSurface& surface,
                                                      const MirroredLights& lights, int line);

/// All lines' curves, line by line; each as `reflection_line` gives it. O(triangles + lines + n log
/// n) for n pieces.
[[nodiscard]] std::vector<std::vector<SpaceCurve>> reflection_lines(const SeenSurface& surface,
                                                                    const MirroredLights& lights);

/// How long all reflection lines are together on the viewer's plane, hidden or not, nearly, without
/// making them; proportional to the number of lights. O(triangles).
[[nodiscard]] double approx_line_length(const SeenSurface& surface, const MirroredLights& lights);

/// Of all triangles on the viewer's plane, hidden or not.
[[nodiscard]] double seen_area(const SeenSurface& surface);

/// Edges of only one triangle, and edges at which the surface turns away from the viewer.
[[nodiscard]] std::vector<SpaceCurve> outlines(const SeenSurface& surface);

}  // namespace limn::figure
