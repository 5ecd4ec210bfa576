#pragma once
/// The faults and remarks of a mesh, kind by kind, for text and JSON alike. Private to report/.

#include <functional>
#include <string>
#include <vector>

#include "limn/report/mesh_check_report.h"

namespace limn::report {

/// One fault, or one thing that is odd.
struct CheckedFault {
  std::vector<Index> vertices, faces;  ///< of the mesh; of what reading dropped, `file_faces`
  std::vector<Index> file_faces = {};
  std::string message;
};

/// All of one kind.
struct CheckedKind {
  std::string kind;      ///< a name for machines: "non_manifold_edge"
  bool blocks = false;   ///< keeps the mesh from being refined
  bool is_fault = true;  ///< else a remark
  std::string title;     ///< "3 vertices belong to no face"
  std::string remedy;    ///< what mends it; may be empty
  std::size_t count = 0;
  std::function<CheckedFault(std::size_t)> fault;  ///< of 0 … count - 1
};

/// In the order in which they are told: what blocks, other faults, remarks. The list refers to
/// `check`.
[[nodiscard]] std::vector<CheckedKind> kinds_of(const MeshCheck& check);

}  // namespace limn::report
