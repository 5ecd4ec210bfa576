#pragma once
/// Meshes that the analyses live on: regular tori, and the star around one extraordinary
/// vertex (or face, for dual splits) in an otherwise regular mesh.

#include <array>
#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/mesh/split/split.h"

namespace limn::mesh {

/// The regular torus of nx × ny vertices (both ≥ 3; vertex (i, j) has index j*nx + i).
/// Lattice basis: e1 = (1, 0) and, on triangles, e2 = (-1/2, sqrt(3)/2), so that the edge
/// directions are e1, e2 and e1 + e2; on quads e2 = (0, 1).
/// Triangles 2c and 2c+1 of cell c = j*nx + i are (i,j) (i+1,j) (i+1,j+1) and
/// (i,j) (i+1,j+1) (i,j+1); quad c is (i,j) (i+1,j) (i+1,j+1) (i,j+1).
[[nodiscard]] Mesh torus(Lattice lattice, Index nx, Index ny);

/// Lattice coordinates in twelfths of a control edge, in which vertices, midpoints of edges,
/// centroids of triangles and corner points of dual splits are all integers.
using Twelfths = std::array<Index, 2>;

/// Where a split of `torus(lattice, nx, ny)` puts its new vertex number `vertex` on the plane, if
/// edges give their midpoints or thirds, faces their centroids, and corners the points halfway to
/// those, or on quads, where old vertices stay, two thirds of the way;
/// modulo (12 nx, 12 ny).
[[nodiscard]] Twelfths torus_birth_place(const Mesh& torus, Index nx, Index ny,
                                         const Births& births, Index vertex);
/// to − from on a torus of that many vertices along each side, each coordinate the one of least
/// size.
[[nodiscard]] Twelfths torus_difference(Twelfths from, Twelfths to, Index nx, Index ny);

/// The kinds of faces round a vertex, counterclockwise.
struct Sectors {
  std::vector<Lattice> lattices;  ///< at least one; of a closed star two or more
  bool open = false;  ///< the vertex is on the boundary: before the first and after the last sector
};

/// The disc of `rings` rings round one vertex with such faces, each of which begins a sector of its
/// lattice: what any surroundings become when triangles are cut into triangles and quads into
/// quads. Inside, vertices are regular but for the centre and where sectors of different kinds
/// meet: on spokes, with three triangles and two quads. Numbered as `star` and `fan`, which it is
/// where all sectors are alike: ring r has r vertices in a sector of triangles, 2r in one of quads,
/// from its first spoke on, and in an open star one more, on the last spoke.
[[nodiscard]] Mesh sector_star(const Sectors& sectors, Index rings);

/// The disc of `rings` rings round one vertex of valence n, every other interior vertex
/// regular. Vertex 0 is the centre. Ring r of triangles holds n*r vertices, ring r of quads
/// 2*n*r (all vertices of the faces that touch ring r-1); rings follow one another, each
/// counterclockwise from the spoke of sector 0, so rotation by one sector adds r (2r) within
/// ring r. Half-edge 0 runs from the centre along the spoke of sector 0, in sector 0's face.
/// n ≥ 2, rings ≥ 1. At n = 2 two edges join the two neighbours of the centre in triangles.
[[nodiscard]] Mesh star(Lattice lattice, Index n, Index rings);

/// The same of quads, but each corner of a square ring r counts to ring r + 1: ring r ≥ 2 has the
/// points of the square ring r but for its n corners, and in their places those of the square ring
/// r - 1; ring 1 the n neighbours of the centre. The outermost square lacks its corners, and the
/// faces at them. Where a step turns the lattice by half a sector, the refined star of such rings
/// lies within the old one, neighbours included; the corners of squares would not. rings ≥ 2.
[[nodiscard]] Mesh cropped_star(Index n, Index rings);

/// The same as `star` round a vertex on the boundary, with so many sectors (faces) ≥ 1: both outer
/// spokes lie on the boundary, whose other vertices are regular. Rings follow one another as in
/// `star`, each from the spoke of sector 0, on which half-edge 0 lies, to the last spoke: one
/// vertex more a ring.
[[nodiscard]] Mesh fan(Lattice lattice, Index sectors, Index rings);

/// The dual star on quads: `rings` rings of vertices round a face of n corners (face 0), every
/// other face a quad and every interior vertex of valence 4. Ring r = 1 is the n corners of the
/// face; ring r holds n*(2r-1) vertices; order as in `star`, each ring counterclockwise,
/// ring r of sector s being the 2r-1 vertices that a corner of ring r's square contributes, the
/// diagonal one in the middle. Half-edge 0 has origin vertex 0.
[[nodiscard]] Mesh face_star(Index n, Index rings);

/// Number of vertices in rings 0 … rings of `sector_star`, `star`, `cropped_star` and `fan`, or 1 …
/// rings of `face_star`.
[[nodiscard]] Index sector_star_size(const Sectors& sectors, Index rings);
[[nodiscard]] Index star_size(Lattice lattice, Index n, Index rings);
[[nodiscard]] Index cropped_star_size(Index n, Index rings);
[[nodiscard]] Index fan_size(Lattice lattice, Index sectors, Index rings);
[[nodiscard]] Index face_star_size(Index n, Index rings);

/// Faces glued along a tree, so that no fan ever closes and no two walks of fewer than `depth`
/// face crossings meet by accident: grown `depth` faces deep from
/// face 0. Two words of flag moves end at the same vertex here if and only if they do so on
/// every mesh of that lattice, whatever its valences.
[[nodiscard]] Mesh tree(Lattice lattice, int depth);

}  // namespace limn::mesh
