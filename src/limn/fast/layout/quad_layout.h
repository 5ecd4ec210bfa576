#pragma once
/// Numbers for the vertices of a regularly subdivided quad mesh, by arithmetic alone.
///
/// At grid n = 2^level every control edge is cut into n edges. Face f's *patch* is its square of
/// points (x, y), 0 ≤ x, y ≤ n, with the face's corners 0, 1, 2, 3 at (0, 0), (n, 0), (n, n),
/// (0, n). The *frame* of half-edge h is the same with the origin of h at (0, 0) and its target at
/// (n, 0).
/// Vertices are numbered in blocks: the control vertices, as they are; the n-1 inner points of
/// each edge, from the origin of halfedge_of_edge(e); the (n-1)² inner points of each patch, row by
/// row (y = 1, 2, …), x ascending. So for n = 2 these are the vertices born from vertices, edges
/// and faces, in the order of the split (mesh/split.h).
/// Faces come patch by patch, row by row, x ascending: (x, y) (x+1, y) (x+1, y+1) (x, y+1).

#include <array>

#include "limn/fast/layout/edge_points.h"

namespace limn::fast {

class QuadLayout : public EdgePoints {
 public:
  /// `control` has quads only (or no faces) and must outlive the layout. n ≥ 1, and all faces
  /// together have fewer than 2^31 corners.
  QuadLayout(const Mesh& control, Index n);

  [[nodiscard]] Index vertex_count() const {
    return faces_at_ + control().face_count() * face_size_;
  }
  [[nodiscard]] Index face_count() const { return control().face_count() * n() * n(); }

  /// The first inner point of face f.
  [[nodiscard]] Index face_begin(Index f) const { return faces_at_ + f * face_size_; }

  /// The half-edge k sides after h in its face, 0 ≤ k ≤ 3.
  [[nodiscard]] static Index turned(Index h, Index k) { return (h & ~3) | ((h + k) & 3); }

  /// Point (x, y) in the frame of h: 0 ≤ x, y ≤ n.
  [[nodiscard]] Index point(Index h, Index x, Index y) const {
    if (0 < x && x < n() && 0 < y && y < n()) return inner_point(h, x, y);
    return y == 0 && 0 < x && x < n() ? edge_point(h, x) : point_on_sides(h, x, y);
  }

  /// The same beyond one of the patch's sides, as far as its neighbour there goes; kNone where
  /// there is none.
  [[nodiscard]] Index point_beyond(Index h, Index x, Index y) const;

  /// The same of an inner point, without a look at the mesh: 0 < x, y < n. A patch's inner points
  /// are numbered evenly in each of its frames.
  [[nodiscard]] Index inner_point(Index h, Index x, Index y) const {
    const Frame& frame = frames_[static_cast<std::size_t>(h & 3)];
    return face_begin(h >> 2) + frame.start + x * frame.along + y * frame.up;
  }
  /// From inner point (x, y) to (x + 1, y).
  [[nodiscard]] Index inner_step(Index h) const {
    return frames_[static_cast<std::size_t>(h & 3)].along;
  }

  /// The corners of the faces of patches first … last-1: 4 n² indices each.
  void write_faces(Index first, Index last, Index* out) const;

 private:
  class Rows;
  struct Frame {
    Index start = 0, along = 0, up = 0;  ///< of (x, y): start + x·along + y·up
  };

  /// 0 or n where x or y is.
  [[nodiscard]] Index point_on_sides(Index h, Index x, Index y) const;

  Index face_size_, faces_at_;
  std::array<Frame, 4> frames_;
};

}  // namespace limn::fast
