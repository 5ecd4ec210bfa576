/// libFuzzer target: the input is a glTF file, binary or JSON. Nothing may crash, whatever is read
/// is written so that it reads back as floats have it, and a file whose faults are kept is surveyed
/// and repaired.
///
///     clang++ -fsanitize=fuzzer,address,undefined … && ./gltf_fuzz -max_len=4096 CORPUS

#include <cstdint>
#include <string>

#include "mesh_checks.h"

namespace {

using limn::Index;
using limn::Polygons;
using limn::fuzz::check;

void check_triangles(const Polygons& mesh) {
  limn::fuzz::check_mesh(mesh);
  for (Index face = 0; face < mesh.face_count(); ++face)
    check(mesh.degree(face) == 3, "three corners");
}

void check_round_trip(const Polygons& mesh) {
  const limn::Result<std::string> once = limn::format_mesh("glb", mesh);
  if (!once) return;  // transforms may leave what floats hold
  const limn::Result<Polygons> again = limn::parse_mesh(*once, "glb", "again");
  check(again.ok() && again->corners == mesh.corners, "what was written reads back");
  check(*limn::format_mesh("glb", *again) == *once, "the second trip changes nothing");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string content(reinterpret_cast<const char*>(data), size);
  const limn::Result<limn::MeshFile> file = limn::parse_mesh_file(content, "gltf", "fuzz");
  if (file) {
    check_triangles(file->polygons);
    check_round_trip(file->polygons);
  } else {
    check(!file.error().message.empty(), "an error has a message");
  }
  limn::fuzz::check_kept_faults(content, "gltf");
  return 0;
}
