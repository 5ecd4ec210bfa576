#pragma once
/// What is sharp in a control mesh, as command lines say it.

#include <CLI/CLI.hpp>
#include <string>

#include "control_mesh.h"

namespace limn::app {

/// The options, beside the tags of the mesh file itself.
struct SharpnessOptions {
  std::string tags_file;
  bool no_tags = false;
  double crease_angle = -1;       // degrees; negative: none
  std::string boundary, creases;  // as USD names them; empty: as the files say

  void declare(CLI::App& command);
  /// Whether the mesh file's own tags count.
  [[nodiscard]] TagUse use() const { return no_tags ? TagUse::leave_out : TagUse::keep; }
  /// All of it together: what is stated later counts, in the order mesh file, --tags,
  /// --crease-angle; options count more than files.
  [[nodiscard]] Result<Sharpness> of(ControlMesh& control) const;
};

}  // namespace limn::app
