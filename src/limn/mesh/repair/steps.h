#pragma once
/// The steps of repair. Private to repair/.

#include <string>
#include <vector>

#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/repair/repair.h"

namespace limn::mesh::detail {

/// What is repaired, between the steps: each adds what it did to `done`. Vertices are added at the
/// end, and none is taken away before `compact`.
using RepairWork = Repaired;

/// Faces are rebuilt one by one, in order.
class FaceWriter {
 public:
  explicit FaceWriter(RepairWork& work) : work_(work) {}
  /// A corner of the face to come.
  void add_corner(Index vertex, Index corner_of) {
    corners_.push_back(vertex);
    corner_of_.push_back(corner_of);
  }
  void end_face(Index face_of) {
    face_begin_.push_back(static_cast<Index>(corners_.size()));
    face_of_.push_back(face_of);
  }
  /// In place of the faces that were there.
  void finish() {
    work_.polygons.corners = std::move(corners_);
    work_.polygons.face_begin = std::move(face_begin_);
    work_.face_of = std::move(face_of_);
    work_.corner_of = std::move(corner_of_);
  }

 private:
  RepairWork& work_;
  std::vector<Index> corners_, face_begin_{0}, face_of_, corner_of_;
};

/// Notes what was done, if it was: "1 face dropped", "3 faces dropped".
void note(RepairWork& work, const char* what, Index count, const char* one, const char* many,
          const std::string& rest);

/// Faces that take no part in edges and fans: those with a fault of their own, and with `copies`
/// those that repeat another.
[[nodiscard]] std::vector<char> faulty_faces(const MeshFaults& faults, Index face_count,
                                             bool copies);

/// Joins vertices and collapses the faces that they are corners of. `joined` marks those that no
/// longer are.
void weld_vertices(RepairWork& work, double of_diagonal, std::vector<char>& joined);
/// Cuts faces that meet a vertex twice there, and drops what has less than three corners then.
/// With `only`, faces that it marks alone.
void split_repeated_corners(RepairWork& work, const std::vector<char>* only);
/// Drops copies of faces.
void drop_repeated_faces(RepairWork& work);
/// Drops faces whose corners lie on a line: of triangles all, with the neighbour on the longer side
/// cut; else those on edges of more than two faces. None where all faces are so. Returns whether.
bool drop_flat_faces(RepairWork& work);
/// Gives each sheet at a non-manifold edge or vertex its own copies.
void cut_sheets(RepairWork& work);
/// Cuts one-sided surfaces open.
void cut_one_sided(RepairWork& work);
/// Reverses faces.
void orient_faces(RepairWork& work);

}  // namespace limn::mesh::detail
