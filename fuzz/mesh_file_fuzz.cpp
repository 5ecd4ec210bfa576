/// libFuzzer target: the first byte chooses the format, the rest is the file. Nothing may crash,
/// and whatever is read must be written so that it reads back equal.
///
///     clang++ -fsanitize=fuzzer,address,undefined … && ./mesh_file_fuzz -max_len=4096 CORPUS

#include <cstdint>
#include <cstring>
#include <string>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/polygon/triangulate.h"
#include "mesh_checks.h"

namespace {

using limn::Polygons;
using limn::fuzz::check;
using limn::fuzz::check_mesh;

void check_round_trip(const Polygons& mesh, const char* extension) {
  const limn::Result<std::string> text = limn::format_mesh(extension, mesh);
  const bool keeps_floats =
      std::strcmp(extension, "stl") == 0 || std::strcmp(extension, "glb") == 0;
  if (!text) return check(keeps_floats, "only a double that is no float cannot be written");
  if (std::strcmp(extension, "glb") == 0) return;
  const limn::Result<Polygons> again = limn::parse_mesh(*text, extension, "again");
  // STL drops triangles without three places; there may be no other.
  if (keeps_floats && !again) return;
  check(again.ok(), "what was written reads back");
  check_mesh(*again);
  // STL merges and rounds, so the first trip may change the mesh, the second must not; the
  // comparison of bytes also tells -0 from +0.
  if (!keeps_floats) check(*again == mesh, "the mesh read back is equal");
  const std::string second = *limn::format_mesh(extension, *again);
  if (!keeps_floats) check(second == *text, "the second trip changes nothing");
  const limn::Result<Polygons> third = limn::parse_mesh(second, extension, "third");
  check(third.ok() && *limn::format_mesh(extension, *third) == second, "nor does the third");
}

/// Topology: what is refused has a fault, what is not has none; triangles are as many as they must.
void check_topology(const limn::MeshFile& file) {
  const limn::Result<limn::Mesh> mesh = limn::mesh::build_mesh(file.polygons, file.source);
  check(mesh.ok() == limn::mesh::find_mesh_faults(file.polygons).list.empty(),
        "faults are those of build");
  check(mesh.ok() || !mesh.error().message.empty(), "a refusal has a message");
  const limn::mesh::Triangulation cut = limn::mesh::triangulate(file.polygons).value();
  check_mesh(cut.polygons);
  check(
      cut.polygons.corners.size() == 3 * (file.polygons.corners.size() -
                                          2 * static_cast<std::size_t>(file.polygons.face_count())),
      "a polygon of n corners gives n - 2 triangles");
}

/// What is carried fits the mesh, and once written stays as it is.
void check_attributes(const std::string& content, const char* extension) {
  const auto read = [](const std::string& text, const char* format) {
    return limn::parse_mesh_file(text, format, "fuzz", {.attributes = true});
  };
  const limn::Result<limn::MeshFile> file = read(content, extension);
  if (!file) return check(!file.error().message.empty(), "an error has a message");
  check(limn::attributes_fit(file->attributes, file->polygons), "attributes fit");
  for (const char* format : {"obj", "ply", "glb"}) {
    limn::WriteOptions options;
    options.attributes = limn::kept_attributes(format, file->attributes);
    const limn::Result<std::string> text = limn::format_mesh(format, file->polygons, options);
    if (!text || std::strcmp(format, "glb") == 0) continue;
    const limn::Result<limn::MeshFile> again = read(*text, format);
    check(again.ok(), "what was written reads back");
    check(limn::attributes_fit(again->attributes, again->polygons), "attributes fit again");
    limn::WriteOptions once;
    once.attributes = again->attributes;
    check(*limn::format_mesh(format, again->polygons, once) == *text,
          "the second trip changes nothing");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* extensions[] = {"obj", "off", "ply", "stl"};
  const std::string content(reinterpret_cast<const char*>(data + 1), size - 1);
  (void)limn::parse_mesh_file(content, "", "by content");
  limn::fuzz::check_kept_faults(content, extensions[data[0] % 4]);
  check_attributes(content, extensions[data[0] % 4]);
  const limn::Result<limn::MeshFile> file =
      limn::parse_mesh_file(content, extensions[data[0] % 4], "fuzz");
  if (!file) {
    check(!file.error().message.empty(), "an error has a message");
    return 0;
  }
  const Polygons* mesh = &file->polygons;
  check_mesh(*mesh);
  check_topology(*file);
  for (const char* extension : {"obj", "off", "ply", "stl", "glb"}) {
    check_round_trip(*mesh, extension);
  }
  return 0;
}
