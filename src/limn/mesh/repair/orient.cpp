// Faces that run the other way than their neighbours are reversed, the fewest of each part.

#include <algorithm>

#include "limn/mesh/edge_sides.h"
#include "limn/mesh/joined_sets.h"
#include "limn/mesh/repair/steps.h"

namespace limn::mesh::detail {
namespace {

/// Which faces to reverse: of each part those of the side that has fewer. Where a surface is
/// one-sided, faces that run alike are joined first, so that it is cut where they do not.
std::vector<char> to_reverse(const Polygons& mesh, const std::vector<char>& out) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh, out);
  JoinedSets parts(mesh.face_count());
  for (const bool flipped : {false, true})
    for_each_edge(sides, [&](std::size_t k, std::size_t last) {
      if (last - k == 2 && is_flipped(mesh, sides[k], sides[k + 1]) == flipped)
        parts.join(sides[k].face, sides[k + 1].face, flipped);
    });
  std::vector<Index> balance(out.size(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index root = parts.root(f);
    balance[root] += parts.parity(f) ? 1 : -1;
  }
  std::vector<char> reversed(out.size(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index root = parts.root(f);
    reversed[f] = parts.parity(f) == (balance[root] <= 0) ? 1 : 0;
  }
  return reversed;
}

}  // namespace

void orient_faces(RepairWork& work) {
  Polygons& mesh = work.polygons;
  const std::vector<char> out = faulty_faces(find_mesh_faults(mesh), mesh.face_count(), true);
  const std::vector<char> reversed = to_reverse(mesh, out);
  Index count = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (reversed[f] == 0) continue;
    ++count;
    const Index first = mesh.face_begin[f] + 1, last = mesh.face_begin[f + 1];  // the first stays
    std::reverse(mesh.corners.begin() + first, mesh.corners.begin() + last);
    std::reverse(work.corner_of.begin() + first, work.corner_of.begin() + last);
  }
  note(work, "faces_reversed", count, "face", "faces", " reversed");
}

}  // namespace limn::mesh::detail
