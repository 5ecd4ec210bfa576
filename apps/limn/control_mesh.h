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

/// What the help of an option says of MESH.
inline constexpr const char* kMeshArgumentHelp =
    "control mesh: .obj, .off, .ply or .stl; - is standard input, in any of these formats";

/// Whether the name of a mesh tells its format; "-" is standard input, whose content tells.
[[nodiscard]] Status check_mesh_path(const std::string& path);

/// Reads a mesh file or standard input, cuts its polygons into triangles if asked to, and builds
/// the mesh. Warnings go to standard error; errors name the file.
[[nodiscard]] Result<ControlMesh> load_control_mesh(const std::string& path, bool triangulate);

}  // namespace limn::app
