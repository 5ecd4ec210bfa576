#pragma once
/// The control mesh that a command line names.

#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"

namespace limn::app {

struct ControlMesh {
  Mesh mesh;
  std::vector<Point3> points;
};

/// Reads a mesh file, cuts its polygons into triangles if asked to, and builds the mesh. Warnings
/// go to standard error; errors name the file.
[[nodiscard]] Result<ControlMesh> load_control_mesh(const std::string& path, bool triangulate);

}  // namespace limn::app
