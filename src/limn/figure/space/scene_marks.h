#pragma once
/// Lines and points that are marked on surfaces: creases, corners, seams.

#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/canvas/space_vector.h"

namespace limn::figure {

/// Lines and points of one kind, on the surfaces of a scene or near them. They are seen where no
/// surface hides them; what is not placeable (surface_scene.h) is left out.
struct SceneMarks {
  std::vector<std::vector<SpaceVector>> curves = {};
  std::vector<SpaceVector> points = {};  ///< a dot at each
  Colour colour = {};
  Stroke stroke = {};
  std::string name = {};  ///< in the legend; empty: it is not there
};

}  // namespace limn::figure
