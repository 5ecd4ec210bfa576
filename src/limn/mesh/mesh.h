#pragma once
/// Half-edge connectivity of an oriented 2-manifold with or without boundary; no positions.
///
/// A *half-edge* is a corner of a face: half-edge h of face f runs from its origin vertex to
/// the origin of next(h), and f's half-edges are the consecutive indices
/// face_begin(f) … face_begin(f+1)-1, counterclockwise. Only faces have half-edges: the
/// boundary has none, and twin(h) = kNone says that h lies on it. Everything is an array of
/// indices, so the splits (split.h) compute a refined mesh by index arithmetic alone
/// [in the manner of Dupuy & Vanhoey, A Halfedge Refinement Rule for Parallel
/// Catmull-Clark Subdivision, 2021].
///
/// Laws (tested): next is a permutation with a cycle per face; twin is an involution without
/// fixed points off the boundary; edge(h) = edge(twin(h)); halfedge_of_edge(e) has edge e.

#include <cstdint>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"

namespace limn {

/// Half-edge connectivity. Vertices, edges, faces and half-edges are numbers from 0; indices that
/// are passed must be in range (not checked). Cost of a question O(1) unless stated.
class Mesh {
 public:
  /// Connectivity of `polygons`. Refused, with the vertices named (0-based; a caller who knows
  /// the file puts it into the error): an index out of range; a face with fewer than three corners
  /// or with a repeated vertex; an edge in more than two faces; two neighbours that run through
  /// their edge in the same direction (flipped); a vertex whose faces form more than one fan
  /// (bow-tie). Isolated vertices are kept, with one warning. Cost O(V + corners).
  static Result<Mesh> build(const Polygons& polygons, Warnings* warnings = nullptr);

  /// V, isolated vertices included.
  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(vertex_halfedge_.size()); }
  /// E; an edge between two faces counts once.
  [[nodiscard]] Index edge_count() const { return static_cast<Index>(edge_halfedge_.size()); }
  /// F.
  [[nodiscard]] Index face_count() const { return face_count_; }
  /// H, the corners of all faces together: 2 E less the boundary edges.
  [[nodiscard]] Index halfedge_count() const { return static_cast<Index>(origin_.size()); }

  /// The common degree of all faces, or 0 where they differ (or there are none).
  [[nodiscard]] Index uniform_degree() const { return degree_; }
  /// The first half-edge of face f; f = F is allowed and gives H.
  [[nodiscard]] Index face_begin(Index f) const {
    return degree_ > 0 ? f * degree_ : face_begin_[f];
  }
  /// The number of corners of face f, at least 3.
  [[nodiscard]] Index degree(Index f) const { return face_begin(f + 1) - face_begin(f); }

  /// The vertex that h starts from.
  [[nodiscard]] Index origin(Index h) const { return origin_[h]; }
  /// The vertex that h ends at.
  [[nodiscard]] Index target(Index h) const { return origin_[next(h)]; }
  /// The half-edge of the neighbouring face that runs the other way; kNone on the boundary.
  [[nodiscard]] Index twin(Index h) const { return twin_[h]; }
  /// The edge that h lies on.
  [[nodiscard]] Index edge(Index h) const { return edge_[h]; }
  /// The face that h is a corner of.
  [[nodiscard]] Index face(Index h) const {
    // dividing by a constant is a multiplication; these two are nearly every mesh
    if (degree_ == 3) return static_cast<Index>(static_cast<std::uint32_t>(h) / 3U);
    if (degree_ == 4) return static_cast<Index>(static_cast<std::uint32_t>(h) / 4U);
    return degree_ > 0 ? h / degree_ : face_[h];
  }
  /// The half-edge after h in its face, counterclockwise.
  [[nodiscard]] Index next(Index h) const {
    const Index f = face(h);
    return h + 1 == face_begin(f + 1) ? face_begin(f) : h + 1;
  }
  /// The half-edge before h in its face.
  [[nodiscard]] Index prev(Index h) const {
    const Index f = face(h);
    return h == face_begin(f) ? face_begin(f + 1) - 1 : h - 1;
  }

  /// The half-edge that stands for edge e: the lower of the two; on a boundary edge its only one.
  [[nodiscard]] Index halfedge_of_edge(Index e) const { return edge_halfedge_[e]; }
  /// A half-edge out of v: on a boundary vertex the one that lies on the boundary, so that
  /// rotating counterclockwise from it meets every face of v; kNone for an isolated vertex.
  [[nodiscard]] Index halfedge_of_vertex(Index v) const { return vertex_halfedge_[v]; }

  /// The next half-edge out of origin(h), counterclockwise; kNone past the last face of a fan.
  [[nodiscard]] Index rotate(Index h) const { return twin_[prev(h)]; }

  /// Whether no face has the vertex.
  [[nodiscard]] bool is_isolated(Index v) const { return vertex_halfedge_[v] == kNone; }
  /// Whether the faces round v leave a gap; false for an isolated vertex.
  [[nodiscard]] bool is_boundary_vertex(Index v) const {
    const Index h = vertex_halfedge_[v];
    return h != kNone && twin_[h] == kNone;
  }
  /// Whether the edge belongs to one face only.
  [[nodiscard]] bool is_boundary_edge(Index e) const { return twin_[edge_halfedge_[e]] == kNone; }
  /// Whether there is a boundary edge. Cost O(H).
  [[nodiscard]] bool has_boundary() const;

  /// Number of edges at v (0 for an isolated vertex). Cost O(valence).
  [[nodiscard]] Index valence(Index v) const;

  /// The largest number of edges at a vertex; 0 without faces. Cost O(V + H).
  [[nodiscard]] Index max_valence() const;
  /// The largest number of corners of a face; 0 without faces. Cost O(F).
  [[nodiscard]] Index max_degree() const;

  /// Faces and corners as polygons, with the given positions (V of them). Cost O(H).
  [[nodiscard]] Polygons polygons(std::vector<Point3> positions) const;

  /// The arrays of a mesh whose arithmetic is known; for splits and generators. What can be
  /// derived from them (edge_halfedge, vertex_halfedge, face of half-edge) is derived here.
  struct Arrays {
    Index vertex_count = 0;         ///< V
    Index edge_count = 0;           ///< E
    Index degree = 0;               ///< common face degree; 0: see face_begin
    std::vector<Index> face_begin;  ///< F+1 offsets; empty where degree > 0
    std::vector<Index> origin;      ///< vertex of each half-edge
    std::vector<Index> twin;        ///< kNone on the boundary
    std::vector<Index> edge;        ///< edge of each half-edge
  };
  /// Precondition: the arrays obey the laws above (asserted by `check`, in tests). Cost O(V + H).
  static Mesh from_arrays(Arrays arrays);

  /// The first law that the arrays break, in words; empty where they keep them all. For tests. Cost
  /// O(V + H).
  [[nodiscard]] std::string check() const;

 private:
  Index degree_ = 0;
  Index face_count_ = 0;
  std::vector<Index> face_begin_;  // only where degrees differ
  std::vector<Index> face_;        // only where degrees differ
  std::vector<Index> origin_, twin_, edge_;
  std::vector<Index> edge_halfedge_, vertex_halfedge_;
};

// Flags and walks. A *flag* is a vertex, an edge at it and a face at that edge. Three moves
// change one of the three and keep the other two:
//
//     v  to the other end of the edge,      e  to the face's other edge at the vertex,
//     f  to the other face at the edge,
//
// and a fourth, for boundary vertices, b, goes to the vertex's other boundary edge.
// A *walk* is a word of moves: from an edge of a triangle mesh, "ev" is the third vertex of the
// face (the wing) and "efev" the vertex beyond the next edge. Because a rotation or a
// reflection of the mesh carries flags to flags and commutes with every move, a stencil that
// is written in walks from all flags of its anchor is symmetric by construction.

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
