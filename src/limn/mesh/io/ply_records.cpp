#include "limn/mesh/io/ply_records.h"

#include <cstdint>
#include <cstring>

#include "limn/mesh/io/bytes.h"

namespace limn::io {
namespace {

char* put_face(char* to, const Index* corners, Index degree, bool wide) {
  to = wide ? store_little(to, degree) : store_little(to, static_cast<std::uint8_t>(degree));
  for (Index c = 0; c < degree; ++c) to = store_little(to, corners[c]);
  return to;
}

/// Faces of so many corners, known to the compiler.
template <Index degree>
char* put_equal_faces(char* to, std::size_t count, const Index* corners, bool wide) {
  for (std::size_t f = 0; f < count; ++f, corners += degree)
    to = put_face(to, corners, degree, wide);
  return to;
}

}  // namespace

std::string PlyRecords::header(const std::string& of_vertices, const std::string& of_faces) const {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(vertices) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  if (normals) text += "property double nx\nproperty double ny\nproperty double nz\n";
  text += of_vertices;
  text += "element face " + std::to_string(faces);
  text += wide ? "\nproperty list int int vertex_indices\n"
               : "\nproperty list uchar int vertex_indices\n";
  text += of_faces;
  if (edges > 0)
    text += "element edge " + std::to_string(edges) +
            "\nproperty int vertex1\nproperty int vertex2\nproperty double sharpness\n";
  return text + "end_header\n";
}

void append_ply_edge(std::string& out, Index from, Index to, double sharpness) {
  append_little(out, from, to, sharpness);
}

char* put_ply_vertices(char* to, std::size_t count, const double* positions,
                       const double* normals) {
  if (normals == nullptr && kLittleEndianHost) {
    std::memcpy(to, positions, count * 3 * sizeof(double));
    return to + count * 3 * sizeof(double);
  }
  for (std::size_t v = 0; v < count; ++v) {
    for (int i = 0; i < 3; ++i) to = store_little(to, *positions++);
    for (int i = 0; i < 3 && normals != nullptr; ++i) to = store_little(to, *normals++);
  }
  return to;
}

char* put_ply_faces(char* to, std::size_t count, const Index* corners, Index each,
                    const Index* begin, bool wide) {
  if (each == 3) return put_equal_faces<3>(to, count, corners, wide);
  if (each == 4) return put_equal_faces<4>(to, count, corners, wide);
  for (std::size_t f = 0; f < count; ++f) {
    const Index degree = each > 0 ? each : begin[f + 1] - begin[f];
    to = put_face(to, corners, degree, wide);
    corners += degree;
  }
  return to;
}

}  // namespace limn::io
