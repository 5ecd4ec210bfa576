// Vertices are joined; faces that are none are dropped.

#include <algorithm>
#include <numeric>
#include <utility>

#include "limn/mesh/finite_point.h"
#include "limn/mesh/io/stl_slivers.h"
#include "limn/mesh/repair/face_shape.h"
#include "limn/mesh/repair/places.h"
#include "limn/mesh/repair/steps.h"

namespace limn::mesh::detail {
namespace {

bool has_vertices(const Polygons& mesh, Index f) {
  for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
    if (mesh.corners[c] < 0 || mesh.corners[c] >= mesh.vertex_count()) return false;
  return true;
}

bool is_finite_face(const Polygons& mesh, Index f) {
  for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
    if (!is_finite(mesh.positions[mesh.corners[c]])) return false;
  return true;
}

/// The corners of a face, numbers of `mesh.corners`, cut into loops that meet no vertex twice: what
/// lies between two corners at one vertex is a loop of its own.
class Loops {
 public:
  explicit Loops(Index vertices) : place_(static_cast<std::size_t>(vertices), kNone) {}

  template <class Use>
  void for_each(const Polygons& mesh, Index f, const Use& use) {
    std::vector<Index> stack;
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      const Index v = mesh.corners[c];
      if (place_[v] != kNone) {  // the loop from there to here is closed
        const Index begin = place_[v];
        use(std::vector<Index>(stack.begin() + begin, stack.end()));
        for (auto k = static_cast<std::size_t>(begin); k < stack.size(); ++k)
          place_[mesh.corners[stack[k]]] = kNone;
        stack.resize(static_cast<std::size_t>(begin));
      }
      place_[v] = static_cast<Index>(stack.size());
      stack.push_back(c);
    }
    for (const Index c : stack) place_[mesh.corners[c]] = kNone;
    use(stack);
  }

 private:
  std::vector<Index> place_;  // of each vertex in the stack
};

/// Keeps the faces that `gone` does not mark.
void keep_faces(RepairWork& work, const std::vector<char>& gone) {
  FaceWriter writer(work);
  const Polygons& mesh = work.polygons;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (gone[f] != 0) continue;
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
      writer.add_corner(mesh.corners[c], work.corner_of[c]);
    writer.end_face(work.face_of[f]);
  }
  writer.finish();
}

/// Which faces lie on an edge of more than two.
std::vector<char> crowding_faces(const Polygons& mesh) {
  std::vector<char> crowding(static_cast<std::size_t>(mesh.face_count()), 0);
  for (const MeshFault& fault : find_mesh_faults(mesh).list)
    if (fault.kind == MeshFault::Kind::crowded_edge)
      for (const Index f : fault.faces) crowding[f] = 1;
  return crowding;
}

/// Triangles: where one alone meets the longest side of a flat one, it is cut. Returns how many.
Index take_out_flat_triangles(RepairWork& work, const std::vector<Index>& flat) {
  const std::vector<Index> before = work.polygons.corners;
  const io::SliverRemoval removal = io::take_out_slivers(work.polygons, flat);
  for (std::size_t c = 0; c < before.size(); ++c)
    if (work.polygons.corners[c] != before[c]) work.corner_of[c] = kNone;
  keep_faces(work, removal.removed);
  return static_cast<Index>(removal.cut);
}

}  // namespace

void weld_vertices(RepairWork& work, double of_diagonal, std::vector<char>& joined) {
  Polygons& mesh = work.polygons;
  const double distance = of_diagonal > 0 ? of_diagonal * diagonal_of(mesh.positions) : 0;
  const std::vector<Index> place = places_of(mesh.positions, distance);
  joined.assign(place.size(), 0);
  Index count = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    joined[v] = place[v] != v ? 1 : 0;
    count += joined[v];
  }
  if (count == 0) return;
  work.joined_with = place;
  std::vector<char> touched(static_cast<std::size_t>(mesh.face_count()), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!has_vertices(mesh, f)) continue;
    for (Index c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      touched[f] |= joined[mesh.corners[c]];
      mesh.corners[c] = place[mesh.corners[c]];
    }
  }
  note(work, "vertices_welded", count, "vertex", "vertices",
       distance > 0 ? " joined with one nearby" : " joined with one in the same place");
  split_repeated_corners(work, &touched);
}

void split_repeated_corners(RepairWork& work, const std::vector<char>* only) {
  const Polygons& mesh = work.polygons;
  Index dropped = 0, changed = 0;
  FaceWriter writer(work);
  Loops loops(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index degree = mesh.degree(f);
    Index written = 0, corners = 0;
    const auto write = [&](const std::vector<Index>& loop) {
      for (const Index c : loop) writer.add_corner(mesh.corners[c], work.corner_of[c]);
      writer.end_face(work.face_of[f]);
      ++written;
      corners += static_cast<Index>(loop.size());
    };
    if ((only != nullptr && (*only)[f] == 0) || !has_vertices(mesh, f)) {
      std::vector<Index> whole(static_cast<std::size_t>(degree));
      std::iota(whole.begin(), whole.end(), mesh.face_begin[f]);
      write(whole);
      continue;
    }
    loops.for_each(mesh, f, [&](const std::vector<Index>& loop) {
      if (loop.size() >= 3) write(loop);
    });
    dropped += written == 0 ? 1 : 0;
    changed += written > 1 || (written == 1 && corners < degree) ? 1 : 0;
  }
  if (dropped + changed == 0) return;
  writer.finish();
  note(work, "degenerate_faces_dropped", dropped, "face", "faces",
       " of less than three different corners dropped");
  note(work, "faces_cut", changed, "face", "faces", " rid of repeated corners");
}

void drop_repeated_faces(RepairWork& work) {
  const Index count = work.polygons.face_count();
  std::vector<char> gone(static_cast<std::size_t>(count), 0);
  Index dropped = 0;
  for (const MeshFault& fault : find_mesh_faults(work.polygons).list) {
    if (fault.kind != MeshFault::Kind::repeated_face) continue;
    gone[fault.faces[1]] = 1;
    ++dropped;
  }
  if (dropped == 0) return;
  keep_faces(work, gone);
  note(work, "duplicate_faces_dropped", dropped, "repeated face", "repeated faces", " dropped");
}

bool drop_flat_faces(RepairWork& work) {
  const Polygons& mesh = work.polygons;
  std::vector<Index> flat;
  bool triangles = true;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    triangles = triangles && mesh.degree(f) == 3 && has_vertices(mesh, f);
    if (has_vertices(mesh, f) && is_finite_face(mesh, f) && is_flat_face(mesh, f))
      flat.push_back(f);
  }
  const Index before = mesh.face_count();
  if (flat.empty() || static_cast<Index>(flat.size()) == before) return false;
  Index cut = 0;
  if (triangles) {
    cut = take_out_flat_triangles(work, flat);
  } else {
    const std::vector<char> crowding = crowding_faces(mesh);
    std::vector<char> gone(crowding.size(), 0);
    // others hold the surface together: without them it would have a crack
    for (const Index f : flat) gone[f] = crowding[f];
    keep_faces(work, gone);
  }
  const Index dropped = before - work.polygons.face_count() + cut;
  note(work, "flat_faces_dropped", dropped, "face whose corners lie on a line",
       "faces whose corners lie on a line",
       " dropped" + (cut == 0 ? std::string()
                              : ", " + std::to_string(cut) +
                                    " of them by cutting its neighbour, so that no crack opens"));
  return dropped > 0;
}

}  // namespace limn::mesh::detail
