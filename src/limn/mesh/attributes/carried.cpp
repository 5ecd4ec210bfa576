#include "limn/mesh/attributes/carried.h"

#include <algorithm>
#include <numeric>

#include "limn/mesh/index.h"

namespace limn::mesh {
namespace {

/// Gives new corners the points of others, and takes those of faces that lack some.
void fill_new_corners(const Repaired& repaired, TextureCoordinates& texture) {
  if (texture.empty()) return;
  const Polygons& mesh = repaired.polygons;
  std::vector<Index> of_vertex(mesh.positions.size(), kNone);
  const auto is_vertex = [&](Index v) { return v >= 0 && v < mesh.vertex_count(); };
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    if (texture.of_corner[c] != kNone && is_vertex(mesh.corners[c]))
      of_vertex[at(mesh.corners[c])] = texture.of_corner[c];
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const std::size_t first = at(mesh.face_begin[at(f)]), last = at(mesh.face_begin[at(f) + 1]);
    std::size_t fresh = 0, without = 0;
    for (std::size_t c = first; c < last; ++c) {
      fresh += repaired.corner_of[c] == kNone ? 1 : 0;
      without += texture.of_corner[c] == kNone ? 1 : 0;
    }
    if (fresh == 0 || without > fresh) continue;  // nothing is new, or the face had none before
    bool whole = true;
    for (std::size_t c = first; c < last; ++c) {
      const Index v = mesh.corners[c];
      if (texture.of_corner[c] == kNone && is_vertex(v)) texture.of_corner[c] = of_vertex[at(v)];
      whole = whole && texture.of_corner[c] != kNone;
    }
    for (std::size_t c = first; !whole && c < last; ++c) texture.of_corner[c] = kNone;
  }
}

}  // namespace

MeshAttributes carried(const MeshAttributes& attributes, const Repaired& repaired) {
  MeshAttributes result =
      mapped(attributes, {&repaired.vertex_of, &repaired.corner_of, &repaired.face_of});
  const std::vector<Index>& joined = repaired.joined_with;
  bool any = false;
  for (std::size_t v = 0; v < joined.size(); ++v) any = any || at(joined[v]) != v;
  if (std::find(repaired.corner_of.begin(), repaired.corner_of.end(), kNone) !=
      repaired.corner_of.end())
    fill_new_corners(repaired, result.texture);
  if (any) join_equal_points(repaired.polygons, result.texture);
  return result;
}

MeshAttributes carried(const MeshAttributes& attributes, const Triangulation& cut) {
  std::vector<Index> vertices(cut.polygons.positions.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  return mapped(attributes, {&vertices, &cut.corner_of, &cut.face_of});
}

}  // namespace limn::mesh
