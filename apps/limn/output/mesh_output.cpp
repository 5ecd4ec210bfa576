#include "output/mesh_output.h"

#include <algorithm>
#include <array>
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
  if (overwrite || mesh == base::kStandardStream || base::is_standard_output(path) ||
      !base::is_same_output(mesh, path))
    return Done{};
  return Error{fmt::format("the output {} is the control mesh itself", base::printable(path)),
               "give it another name, or replace the control mesh by --overwrite"};
}

bool MeshOutput::is_printed() const { return base::is_standard_output(path); }

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

std::string MeshOutput::lower_extension() const {
  std::string lower = extension();
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

const char* MeshOutput::missing_normal() const {
  return lower_extension() == "glb" ? "0 0 1" : "0 0 0";
}

Warnings MeshOutput::rounding_warnings(const Polygons& mesh) const {
  const std::string format_name = lower_extension();
  if (format_name != "stl" && format_name != "glb") return {};
  const auto rounded = [](const Point3& p) {
    return std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  std::size_t lost = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Index before = mesh.face_begin[f + 1] - 1;
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; before = c++) {
      const Point3 &p = mesh.positions[mesh.corners[before]], &q = mesh.positions[mesh.corners[c]];
      if ((p.x != q.x || p.y != q.y || p.z != q.z) && rounded(p) == rounded(q)) ++lost;
    }
  }
  if (lost == 0) return {};
  Error warning(
      fmt::format("{} no length any more in {}, which holds floats of 7 digits",
                  lost == 1 ? "1 edge of a face has" : fmt::format("{} edges of faces have", lost),
                  format_name),
      "move the mesh towards the origin, or write obj, off or ply, which hold doubles");
  warning.file = path;
  return {warning};
}

Status MeshOutput::write(const Polygons& mesh, const WriteOptions& options) const {
  return write_mesh(path, extension(), mesh, options);
}

}  // namespace limn::app
