#pragma once
/// What keeps polygons from being an oriented 2-manifold: every fault as data, for whoever mends
/// or counts them, and one function that words them in the numbers and lines of a file.

#include <array>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

struct MeshFault {
  enum class Kind {
    offsets,          ///< `face_begin` is no list of offsets into the corners; then the only fault
    few_corners,      ///< a face of less than three
    out_of_range,     ///< a corner, `corner` of its face, that is no vertex: vertices[0]
    repeated_corner,  ///< a face that meets vertices[0] twice
    repeated_face,    ///< faces[1] has the corners of faces[0], in the same order up to where it
                      ///< begins; in the opposite order only where an edge of it has more than two
                      ///< faces
    crowded_edge,     ///< an edge between the vertices that has three `faces` or more
    flipped_edge,     ///< both faces of an edge run from vertices[0] to vertices[1]
    several_fans,  ///< the faces round vertices[0] are not one fan: `faces` are one, `others` the
                   ///< rest
  };
  Kind kind = Kind::offsets;
  std::array<Index, 2> vertices{kNone, kNone};
  Index corner = 0;           ///< from 0, within its face
  std::vector<Index> faces;   ///< those that take part
  std::vector<Index> others;  ///< see several_fans
  bool turned_over = false;   ///< repeated_face: in the opposite order
  bool one_sided = false;     ///< flipped_edge: of a surface that no reversing of faces orients
};

struct MeshFaults {
  std::vector<MeshFault> list;    ///< kind by kind, each in order of faces, edges or vertices
  std::vector<Index> to_reverse;  ///< reversing these mends each flipped edge that is not one-sided
};

/// All faults; none exactly where `Mesh::build` accepts. Faces with a fault of their own and
/// repeated ones take no further part, so that one cause is one fault; a vertex of a crowded edge
/// or of such a face is not looked at for fans. Cost O(corners log corners). Precondition: not
/// `too_many` (mesh_limits.h).
[[nodiscard]] MeshFaults find_mesh_faults(const Polygons& polygons);

/// The faults in words: how many of each kind, the first few of each, and the remedy.
/// Precondition: there is one.
[[nodiscard]] Error error_of(const MeshFaults& faults, const Polygons& polygons,
                             const MeshSource& source);

/// One fault in words, with the lines of its faces.
[[nodiscard]] std::string sentence_of(const MeshFault& fault, const Polygons& polygons,
                                      const MeshSource& source);

/// "1 face is repeated", "3 faces are repeated".
[[nodiscard]] std::string count_of(MeshFault::Kind kind, std::size_t count);

/// What mends all faults of a kind, in words that name the option of the command that does it;
/// empty where there is none of that kind.
[[nodiscard]] std::string remedy_of(const MeshFaults& faults, MeshFault::Kind kind,
                                    const Polygons& polygons, const MeshSource& source);

/// `Mesh::build` whose errors and warnings speak in the numbers and lines of `source`.
[[nodiscard]] Result<Mesh> build_mesh(const Polygons& polygons, const MeshSource& source,
                                      Warnings* warnings = nullptr);

}  // namespace limn::mesh
