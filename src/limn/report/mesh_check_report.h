#pragma once
/// What a mesh is and every fault that it has, in words and in JSON. [`limn check`]

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/mesh/polygons.h"
#include "limn/mesh/repair/survey.h"

namespace limn::report {

/// A mesh that was looked at. All numbers of vertices and faces that are shown are those of
/// `source`.
struct MeshCheck {
  std::string name;            ///< of the file
  Polygons polygons;           ///< as read, or as repaired
  MeshSource source;           ///< of these
  mesh::MeshSurvey survey;     ///< of these
  std::vector<Index> dropped;  ///< faces of the file that reading dropped, from 0
};

/// Some lines of what it is, and the first few faults of each kind.
[[nodiscard]] std::string mesh_check_text(const MeshCheck& check);

/// The counts, and every fault under "faults": {"kind", "blocks": whether it keeps the mesh from
/// being refined, "vertices", "faces", "lines": of the faces, or else of the vertices, "message"}.
[[nodiscard]] nlohmann::ordered_json mesh_check_json(const MeshCheck& check);

}  // namespace limn::report
