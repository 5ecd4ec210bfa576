#pragma once
/// Numbers for the vertices of a regularly subdivided triangle mesh, by arithmetic alone.
///
/// At grid n = 2^level every control edge is cut into n edges. Face f's *patch* is its triangle of
/// points (x, y), x, y ≥ 0, x + y ≤ n, with the face's corners 0, 1, 2 at (0, 0), (n, 0), (0, n).
/// The *frame* of half-edge h is the same with the origin of h at (0, 0) and its target at (n, 0).
/// Vertices are numbered in blocks: the control vertices, as they are; the n-1 inner points of
/// each edge, from the origin of halfedge_of_edge(e); the (n-1)(n-2)/2 inner points of each patch,
/// row by row (y = 1, 2, …), x ascending.
/// Faces come patch by patch, row by row: (x, y) (x+1, y) (x, y+1), and but for the last of a row
/// (x+1, y) (x+1, y+1) (x, y+1), then the next x.

#include "limn/fast/layout/edge_points.h"

namespace limn::fast {

class TriangleLayout : public EdgePoints {
 public:
  /// `control` has triangles only and must outlive the layout. n ≥ 1, and all faces together have
  /// fewer than 2^31 corners.
  TriangleLayout(const Mesh& control, Index n)
      : EdgePoints(control, n), face_size_((n - 1) * (n - 2) / 2), faces_at_(edges_end()) {}

  [[nodiscard]] Index vertex_count() const {
    return faces_at_ + control().face_count() * face_size_;
  }
  [[nodiscard]] Index face_count() const { return control().face_count() * n() * n(); }

  /// The inner points of face f, and how many these are.
  [[nodiscard]] Index face_begin(Index f) const { return faces_at_ + f * face_size_; }
  [[nodiscard]] Index face_size() const { return face_size_; }
  /// Inner points of a patch before row y ≥ 1.
  [[nodiscard]] Index row_begin(Index y) const { return (y - 1) * (n() - 1) - (y - 1) * y / 2; }

  /// Point (x, y) in the frame of h: x, y ≥ 0, x + y ≤ n.
  [[nodiscard]] Index point(Index h, Index x, Index y) const;

  /// The same beyond the patch's sides, as far as its three neighbours go: x, y, n - x - y ≤ n;
  /// kNone where there is no neighbour.
  [[nodiscard]] Index point_beyond(Index h, Index x, Index y) const;

  /// Points (x, 0), (x, 1), …, (x, n-x) in the frame of h into out[0], out[stride], …; 0 < x ≤ n.
  void column(Index h, Index x, Index* out, std::ptrdiff_t stride) const;

  /// The corners of the faces of patches first … last-1: 3 n² indices each.
  void write_faces(Index first, Index last, Index* out) const;

 private:
  class Rows;

  Index face_size_, faces_at_;
};

}  // namespace limn::fast
