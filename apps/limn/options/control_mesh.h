#pragma once
/// The control mesh that a command line names.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/cuts.h"
#include "options/mesh_preparation.h"

namespace limn::app {

/// What a mesh file gives reason to say.
struct MeshRemarks {
  Warnings warnings;              ///< of the file, of the mesh, and of what is made of it
  std::vector<LeftOut> left_out;  ///< content of the file that limn does not keep
  std::vector<mesh::RepairStep> repaired = {};  ///< what was done to the mesh, as asked
};

struct ControlMesh {
  Mesh mesh;
  std::vector<Point3> points;
  MeshRemarks remarks;
  MeshSource source;
  SharpnessTags tags;              ///< of the file, where the caller has asked for them
  mesh::Cuts cuts;                 ///< see Prepared
  MeshAttributes attributes = {};  ///< where the caller has asked for them
};

/// Whether a command knows what to do with sharp edges and corners; the others leave them out, and
/// say so.
enum class TagUse { leave_out, keep };
/// The same of attributes.
enum class AttributeUse { leave_out, keep };

/// What the help of an option says of MESH.
inline constexpr const char* kMeshArgumentHelp =
    "control mesh: .obj, .off, .ply, .stl, .glb or .gltf; - is standard input, in any of these "
    "formats";

/// Whether the name of a mesh tells its format; "-" is standard input, whose content tells.
[[nodiscard]] Status check_mesh_path(const std::string& path);

/// Warns on standard error, and keeps the warnings for `add_remarks`.
void add_warnings(MeshRemarks& remarks, const Warnings& warnings);

/// Adds "warnings", a list of message and line (and file, where no line is known), "left_out", a
/// list of what, count, unit and line, and "repaired", a list of what, count and text; line 0: none
/// is known.
void add_remarks(nlohmann::ordered_json& json, const MeshRemarks& remarks);

/// A mesh file, or standard input, which can be had once only, to be read any number of times.
class MeshInput {
 public:
  explicit MeshInput(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] Result<MeshFile> read(const ReadOptions& options);

 private:
  std::string path_;
  std::optional<std::string> content_;  // of standard input
};

/// What was done to a mesh before it is used.
struct Prepared {
  std::vector<mesh::RepairStep> done;  ///< by repair
  mesh::Cuts cuts;                     ///< what it cut
};

/// Repairs a mesh and cuts its polygons into triangles, as asked, with what it carries, and says so
/// in `warnings` and on standard error.
[[nodiscard]] Result<Prepared> prepare(MeshFile& file, const MeshPreparation& preparation);

/// What reading gave reason to say, on standard error.
void report_remarks(const MeshFile& file);

/// Reads a mesh file or standard input, prepares it as asked, and builds the mesh. Warnings and
/// notes go to standard error; errors speak in the numbers and lines of the file.
[[nodiscard]] Result<ControlMesh> load_control_mesh(
    const std::string& path, const MeshPreparation& preparation, TagUse use = TagUse::leave_out,
    AttributeUse attributes = AttributeUse::leave_out);

}  // namespace limn::app
