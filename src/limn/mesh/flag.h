#pragma once
/// Flags and walks. A *flag* is a vertex, an edge at it and a face at that edge. Three moves
/// change one of the three and keep the other two:
///
///     v  to the other end of the edge,      e  to the face's other edge at the vertex,
///     f  to the other face at the edge,
///
/// and a fourth, for boundary vertices, b, goes to the vertex's other boundary edge.
/// A *walk* is a word of moves: from an edge of a triangle mesh, "ev" is the third vertex of the
/// face (the wing) and "efev" the vertex beyond the next edge. Because a rotation or a
/// reflection of the mesh carries flags to flags and commutes with every move, a stencil that
/// is written in walks from all flags of its anchor is symmetric by construction.

#include <cstdint>
#include <string_view>
#include <vector>

#include "limn/mesh/mesh.h"

namespace limn {

/// A vertex, an edge at it and a face at that edge.
struct Flag {
  Index halfedge = kNone;  ///< names the face and the edge
  bool at_target = false;  ///< which end of the edge is the vertex
  /// The same vertex, edge and face.
  friend bool operator==(const Flag&, const Flag&) = default;
};

/// One of the four moves between flags.
enum class Move : std::uint8_t {
  vertex,   ///< v: to the other end of the edge
  edge,     ///< e: to the face's other edge at the vertex
  face,     ///< f: to the other face at the edge
  boundary  ///< b: to the other boundary edge of a boundary vertex
};
/// A walk: moves from left to right.
using Moves = std::vector<Move>;

/// The flag's vertex. Cost O(1).
[[nodiscard]] inline Index vertex_of(const Mesh& mesh, Flag flag) {
  return flag.at_target ? mesh.target(flag.halfedge) : mesh.origin(flag.halfedge);
}

/// The boundary flag at the other end of the fan round a boundary vertex. Cost O(valence).
[[nodiscard]] inline Flag other_boundary_flag(const Mesh& mesh, Flag flag) {
  // turn counterclockwise from the outgoing boundary half-edge to the incoming one
  Index h = flag.halfedge;
  if (flag.at_target) return {mesh.halfedge_of_vertex(mesh.target(h)), false};
  for (Index in = mesh.prev(h);; in = mesh.prev(h)) {
    h = mesh.twin(in);
    if (h == kNone) return {in, true};
  }
}

/// Makes the move; false, and the flag unchanged, where f would leave the mesh.
/// Precondition of Move::boundary: the flag's edge lies on the boundary. Cost O(1), of that one
/// O(valence).
[[nodiscard]] inline bool apply(const Mesh& mesh, Move move, Flag& flag) {
  switch (move) {
    case Move::vertex: flag.at_target = !flag.at_target; return true;
    case Move::edge:
      flag.halfedge = flag.at_target ? mesh.next(flag.halfedge) : mesh.prev(flag.halfedge);
      flag.at_target = !flag.at_target;
      return true;
    case Move::face: {
      const Index twin = mesh.twin(flag.halfedge);
      if (twin == kNone) return false;
      flag = {twin, !flag.at_target};
      return true;
    }
    case Move::boundary: flag = other_boundary_flag(mesh, flag); return true;
  }
  return false;
}

/// Makes the moves; false where one would leave the mesh, with the flag as it was before that one.
/// Cost O(moves), O(valence) for a move along the boundary.
[[nodiscard]] inline bool apply(const Mesh& mesh, const Moves& moves, Flag& flag) {
  for (const Move move : moves)
    if (!apply(mesh, move, flag)) return false;
  return true;
}

}  // namespace limn
