#include "output/mesh_output.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "limn/base/printable.h"

namespace limn::app {

CLI::Option* MeshOutput::declare(CLI::App& command, const std::string& written) {
  CLI::Option* const output =
      command
          .add_option("-o,--output", path,
                      written + " to FILE (.obj, .off, .ply, .stl or .glb; - is standard output)")
          ->type_name("FILE");
  command
      .add_option("--format", format,
                  "obj, off, ply, stl or glb, whatever the output is called (default: its "
                  "extension, or obj on standard output)")
      ->type_name("FORMAT")
      ->needs(output);
  return output;
}

Status MeshOutput::check_keeps(const std::string& mesh, bool overwrite) const {
  if (overwrite || mesh == kStandardStream || is_standard_output(path) ||
      !is_same_output(mesh, path))
    return Done{};
  return Error{fmt::format("the output {} is the control mesh itself", printable(path)),
               "give it another name, or replace the control mesh by --overwrite"};
}

bool MeshOutput::is_printed() const { return is_standard_output(path); }

std::string MeshOutput::extension() const {
  if (!format.empty()) return format;
  return is_printed() && !check_writable(path) ? "obj" : extension_of(path);
}

Status MeshOutput::check(bool json) const {
  if (is_printed() && json)
    return Error{"the mesh and the JSON object cannot both go to standard output",
                 "leave out --json, or name a file after -o"};
  if (!format.empty()) {
    Status known = check_writable("mesh." + format);
    if (!known) {
      known.error().file.clear();
      known.error().message = "--format: " + known.error().message;
    }
    return known;
  }
  Status known = is_printed() ? Status(Done{}) : check_writable(path);
  if (!known && extension_of(path).empty()) known.error().hint += "; or name it by --format";
  return known;
}

const char* MeshOutput::missing_normal() const {
  std::string lower = extension();
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "glb" ? "0 0 1" : "0 0 0";
}

Status MeshOutput::write(const Polygons& mesh, const WriteOptions& options) const {
  return write_mesh(path, extension(), mesh, options);
}

}  // namespace limn::app
