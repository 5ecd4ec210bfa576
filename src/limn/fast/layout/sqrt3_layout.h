#pragma once
/// Numbers for the vertices of a √3-subdivided mesh, by arithmetic alone.
///
/// Two steps of the split cut every edge in three. So with n = 3^k the even level 2k is the grid of
/// TriangleLayout(control, n), as it is; the odd level 2k+1 has the same vertices, with the same
/// numbers, and after them the centroids of the grid's small triangles, n² for each control face,
/// in the order of the faces there: row by row, triangles that point up and down by turns.
///
/// All places are given in the grid of the next even level, N = 3n edges a side: in the frame of a
/// half-edge (triangle_layout.h) vertices lie at (3x, 3y), centroids of triangles that point up at
/// (3x+1, 3y+1), and down at (3x+2, 3y+2). These are the points with X ≡ Y (mod 3), in every frame.
///
/// Faces of an odd level come small triangle by small triangle, in the grid's order, and of each
/// small triangle half-edge by half-edge: its origin, the centroid across, the small triangle's
/// own; at a boundary edge: its origin, its target, the centroid.

#include "limn/fast/layout/triangle_layout.h"

namespace limn::fast {

/// Of an exponent ≥ 0.
[[nodiscard]] constexpr Index power_of_3(int exponent) {
  Index power = 1;
  while (exponent-- > 0) power *= 3;
  return power;
}

/// An odd level.
class CentroidLayout {
 public:
  /// As for TriangleLayout; the faces have fewer than 2^31 corners.
  CentroidLayout(const Mesh& control, Index n)
      : grid_(control, n), n_(n), centroids_at_(grid_.vertex_count()) {}

  [[nodiscard]] const Mesh& control() const { return grid_.control(); }
  /// The even level before.
  [[nodiscard]] const TriangleLayout& grid() const { return grid_; }
  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Index vertex_count() const {
    return centroids_at_ + control().face_count() * n_ * n_;
  }
  [[nodiscard]] Index face_count() const { return 3 * grid_.face_count(); }

  /// The centroids of control face f: n² consecutive numbers.
  [[nodiscard]] Index centroid_begin(Index f) const { return centroids_at_ + f * n_ * n_; }

  /// Point (X, Y) in the frame of h: X ≡ Y (mod 3), X, Y ≥ 0, X + Y ≤ N.
  [[nodiscard]] Index point(Index h, Index x, Index y) const {
    return x % 3 == 0 ? grid_.point(h, x / 3, y / 3) : centroid(h, x / 3, y / 3, x % 3 == 2);
  }

  /// The same beyond the patch's sides, as far as its three neighbours go: X, Y, N - X - Y ≤ N;
  /// kNone where there is no neighbour.
  [[nodiscard]] Index point_beyond(Index h, Index x, Index y) const;

  /// The points (X, Y) of one X in the frame of h, Y ascending from X mod 3, into out[0], out[1],
  /// …; 0 < X ≤ N. Returns past the last.
  Index* column(Index h, Index x, Index* out) const;

  /// The corners of the faces of patches first … last-1: 9 n² indices each.
  void write_faces(Index first, Index last, Index* out) const;

 private:
  class Writer;

  /// That of the small triangle at (x, y) of the grid in the frame of h which points up, or down.
  [[nodiscard]] Index centroid(Index h, Index x, Index y, bool down) const {
    const Index f = control().face(h), k = h - 3 * f;
    const Index z = n_ - 1 - x - y - (down ? 1 : 0);
    const Index column = k == 0 ? x : k == 1 ? z : y, row = k == 0 ? y : k == 1 ? x : z;
    const Index above = n_ - row;  // rows that are not before it
    return centroid_begin(f) + n_ * n_ - above * above + 2 * column + (down ? 1 : 0);
  }

  TriangleLayout grid_;
  Index n_, centroids_at_;
};

}  // namespace limn::fast
