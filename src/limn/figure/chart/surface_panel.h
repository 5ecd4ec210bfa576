#pragma once
/// Small surfaces in parallel projection, with a control net over them.

#include <array>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/chart/level_sets.h"

namespace limn::figure {

/// A panel (see map_panel.h) of a polygon mesh in grey shading, far faces painted before near ones,
/// which is right for surfaces whose faces are small and do not cross. Faces with a vertex that
/// is not finite are left out.
struct SurfacePanel {
  std::vector<std::array<double, 3>> vertices = {};
  std::vector<std::vector<int>> faces = {};  ///< indices in range

  /// The net is drawn in black over everything.
  std::vector<std::array<double, 3>> net_vertices = {};
  std::vector<std::array<int, 2>> net_edges = {};
  bool net_points = true;  ///< a dot at each vertex of the net

  std::string title = {};
  double azimuth = -50;     ///< degrees, of the viewer about the z axis, from x towards y
  double elevation = 30;    ///< degrees, of the viewer over the xy plane, in [−90, 90]
  double z_scale = 1;       ///< heights are drawn larger by this
  bool mesh_lines = false;  ///< also the edges of the faces, thin

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

/// A panel of the surface z over the nodes of the grid; the rest of the panel as it is by default.
[[nodiscard]] SurfacePanel height_field(const TriangleGrid& grid, const std::vector<double>& z);

}  // namespace limn::figure
