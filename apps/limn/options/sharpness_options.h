#pragma once
/// What is sharp in a control mesh, as command lines say it.

#include <CLI/CLI.hpp>
#include <string>

#include "limn/scheme/scheme.h"
#include "options/control_mesh.h"

namespace limn::app {

/// The options, beside the tags of the mesh file itself.
struct SharpnessOptions {
  std::string tags_file;
  bool no_tags = false;
  double crease_angle = -1;                  // degrees; negative: none
  std::string boundary, creases, triangles;  // as USD names them; empty: as the files say

  void declare(CLI::App& command);
  /// Whether names of faces may be needed: those of `of`'s control mesh.
  [[nodiscard]] bool may_name_faces() const { return !tags_file.empty(); }
  /// Whether the mesh file's own tags count.
  [[nodiscard]] TagUse use() const { return no_tags ? TagUse::leave_out : TagUse::keep; }
  /// All of it together: what is stated later counts, in the order mesh file, --tags,
  /// --crease-angle; options count more than files. What a cut mesh holds sharp comes first, where
  /// the scheme takes it; else a warning says that it is smooth.
  /// `scheme` gets its rule for smooth triangles, where that is stated; an error where the option
  /// asks for it and there is none.
  [[nodiscard]] Result<Sharpness> of(ControlMesh& control, Scheme& scheme) const;
};

}  // namespace limn::app
