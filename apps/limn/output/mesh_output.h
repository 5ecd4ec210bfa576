#pragma once
/// Where a mesh goes, as commands that write one take it.

#include <CLI/CLI.hpp>
#include <string>

#include "limn/base/error.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn::app {

struct MeshOutput {
  std::string path;
  std::string format;  ///< an extension; empty: that of `path`, or OBJ on standard output

  /// -o and --format; `written`: "write the refined mesh". Returns -o.
  CLI::Option* declare(CLI::App& command, const std::string& written);

  /// That it is not the mesh itself, which could not be had back, but where `overwrite` allows it.
  [[nodiscard]] Status check_keeps(const std::string& mesh, bool overwrite) const;

  /// Whether the mesh itself is what standard output gets, so that a report must go elsewhere.
  [[nodiscard]] bool is_printed() const;

  /// Whether its format is known; `check_outputs` says whether it can be written.
  [[nodiscard]] Status check(bool json) const;

  /// What the mesh has where there is no normal, for a message: glTF takes unit vectors only.
  [[nodiscard]] const char* missing_normal() const;

  [[nodiscard]] Status write(const Polygons& mesh, const WriteOptions& options) const;

  /// The format.
  [[nodiscard]] std::string extension() const;

  /// What edges lose where the format holds floats: a warning, or nothing.
  [[nodiscard]] Warnings rounding_warnings(const Polygons& mesh) const;

 private:
  [[nodiscard]] std::string lower_extension() const;
};

}  // namespace limn::app
