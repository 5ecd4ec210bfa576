/// Stanford PLY as it is written: binary, little-endian, with double coordinates.

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_attributes.h"
#include "limn/mesh/io/ply_records.h"

namespace limn::io {

void format_ply(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink) {
  const PlyExtras extras(mesh, options.attributes);
  PlyRecords records{mesh.positions.size(), static_cast<std::size_t>(mesh.face_count()),
                     !options.normals.empty(), false, options.tags.creases.size()};
  for (Index face = 0; face < mesh.face_count(); ++face)
    records.wide = records.wide || mesh.degree(face) > 255;
  sink(records.header(extras.vertex_properties(), extras.face_properties()));
  const double* const positions = numbers_of(mesh.positions).data();
  const double* const normals = records.normals ? numbers_of(options.normals).data() : nullptr;
  write_blocks(mesh.vertex_count(), sink, [&](Index first, Index last, std::string& out) {
    const auto put = [&](Index from, Index to) {
      const auto count = static_cast<std::size_t>(to - from), end = out.size();
      const auto skipped = 3 * static_cast<std::ptrdiff_t>(from);
      out.resize(end + count * records.vertex_bytes());
      put_ply_vertices(out.data() + end, count, positions + skipped,
                       records.normals ? normals + skipped : nullptr);
    };
    if (extras.has_vertex_properties()) {
      for (Index v = first; v < last; ++v) {
        put(v, v + 1);
        extras.append_vertex(out, v);
      }
    } else {
      put(first, last);
    }
  });
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    const auto put = [&](Index from, Index to) {
      const auto count = static_cast<std::size_t>(to - from), end = out.size();
      const Index begin = mesh.face_begin[from], corners = mesh.face_begin[to] - begin;
      out.resize(end + records.face_bytes(count, static_cast<std::size_t>(corners)));
      put_ply_faces(out.data() + end, count, mesh.corners.data() + begin, 0, &mesh.face_begin[from],
                    records.wide);
    };
    if (extras.has_face_properties()) {
      for (Index f = first; f < last; ++f) {
        put(f, f + 1);
        extras.append_face(out, f);
      }
    } else {
      put(first, last);
    }
  });
  std::string edges;
  for (const SharpnessTags::Crease& crease : options.tags.creases)
    append_ply_edge(edges, crease.vertices[0], crease.vertices[1], crease.sharpness[0]);
  if (!edges.empty()) sink(edges);
}

}  // namespace limn::io
