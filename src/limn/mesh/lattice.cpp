#include "limn/mesh/lattice.h"

#include <algorithm>
#include <cassert>
#include <initializer_list>

namespace limn::mesh {
namespace {

// faces one after the other; then the mesh, which must be one
class FaceList {
 public:
  void add(std::initializer_list<Index> corners) {
    polygons_.corners.insert(polygons_.corners.end(), corners);
    polygons_.face_begin.push_back(static_cast<Index>(polygons_.corners.size()));
  }
  void add_ngon(Index n) {  // corners 0 … n-1
    for (Index i = 0; i < n; ++i) polygons_.corners.push_back(i);
    polygons_.face_begin.push_back(static_cast<Index>(polygons_.corners.size()));
  }
  [[nodiscard]] Mesh mesh(Index vertices) {
    polygons_.positions.resize(static_cast<std::size_t>(vertices));
    Result<Mesh> built = Mesh::build(polygons_);
    assert(built.ok());
    return *std::move(built);
  }

 private:
  Polygons polygons_;
};

Index ring_length(Lattice lattice, Index r) { return lattice == Lattice::triangle ? r : 2 * r; }

// ring r of a star: as many vertices in each sector as ring_length says. In a sector of triangles
// position k lies k steps of r on the way from its spoke to the next one; a sector of quads is a
// quadrant with x along its spoke and y along the next one, ring r its points with max(x, y) = r.
// An open star, a fan, ends with a spoke of its own.
class SectorRings {
 public:
  explicit SectorRings(const Sectors& sectors) : sectors_(sectors), before_{0} {
    for (const Lattice lattice : sectors.lattices)
      before_.push_back(before_.back() + ring_length(lattice, 1));
  }
  [[nodiscard]] Index size(Index rings) const {
    return 1 + before_.back() * (rings * (rings + 1) / 2) + (sectors_.open ? rings : 0);
  }
  [[nodiscard]] Index vertex(std::size_t s, Index r, Index k) const {
    if (r == 0) return 0;
    const Index at = r * before_[s] + k;
    return size(r - 1) + (sectors_.open ? at : at % (r * before_.back()));
  }
  [[nodiscard]] Index vertex_at(std::size_t s, Index x, Index y) const {
    const Index r = std::max(x, y);
    return vertex(s, r, x == r ? y : 2 * r - x);
  }

 private:
  const Sectors& sectors_;
  std::vector<Index> before_;  // vertices of ring 1 before each sector, and all
};

// the same without corners: those of each square are in the ring beyond
struct CroppedRings {
  Index n;
  [[nodiscard]] Index size(Index rings) const {
    return rings == 0 ? 1 : star_size(Lattice::quad, n, rings) - n;
  }
  [[nodiscard]] Index vertex(Index s, Index x, Index y) const {
    if (x == 0 && y == 0) return 0;
    if (std::max(x, y) == 1 && x != y) return 1 + (s + y) % n;
    const Index r = x == y ? x + 1 : std::max(x, y);
    const Index k = x == y ? r : x == r ? y : 2 * r - x;
    return size(r - 1) + (2 * r * s + k) % (2 * r * n);
  }
};

// the dual star: sector s is the quadrant x, y ≥ 1 beyond corner s of the middle face, its x
// axis towards sector s-1's y axis
struct DualRings {
  Index n;
  [[nodiscard]] Index size(Index rings) const { return n * rings * rings; }
  [[nodiscard]] Index vertex(Index s, Index x, Index y) const {
    const Index r = std::max(x, y);
    const Index k = x == r ? y - 1 : 2 * r - 1 - x;
    return size(r - 1) + s % n * (2 * r - 1) + k;
  }
};

// between ring r - 1 and ring r of a sector
void add_triangles(const SectorRings& at, std::size_t s, Index r, FaceList& faces) {
  for (Index k = 0; k < r; ++k) {
    faces.add({at.vertex(s, r - 1, k), at.vertex(s, r, k), at.vertex(s, r, k + 1)});
    if (k + 1 < r)
      faces.add({at.vertex(s, r - 1, k), at.vertex(s, r, k + 1), at.vertex(s, r - 1, k + 1)});
  }
}
void add_quads(const SectorRings& at, std::size_t s, Index r, FaceList& faces) {
  const auto add = [&](Index x, Index y) {
    faces.add({at.vertex_at(s, x, y), at.vertex_at(s, x + 1, y), at.vertex_at(s, x + 1, y + 1),
               at.vertex_at(s, x, y + 1)});
  };
  for (Index y = 0; y < r; ++y) add(r - 1, y);
  for (Index x = r - 1; x-- > 0;) add(x, r - 1);
}

/// The star of two sectors, whose faces' corners do not tell which of two edges with the same ends
/// they lie at: that of four sectors, of which opposite ones become one.
Mesh triangle_star_of_two(Index rings) {
  const Mesh four = star(Lattice::triangle, 4, rings);
  const auto vertex = [&](Index v) {
    Index r = 0;
    const auto wide = [](Index ring) { return star_size(Lattice::triangle, 4, ring); };
    while (v >= wide(r)) ++r;
    return r == 0 ? 0 : star_size(Lattice::triangle, 2, r - 1) + (v - wide(r - 1)) % (2 * r);
  };
  const auto halfedge = [&](Index h) {
    const Index face = h / 3;
    Index r = 1;
    while (face >= 4 * r * r) ++r;  // ring r has 4 (2r - 1) faces
    const Index before = (r - 1) * (r - 1);
    return 3 * (2 * before + (face - 4 * before) % (2 * (2 * r - 1))) + h % 3;
  };
  Mesh::Arrays arrays;
  arrays.degree = 3;
  arrays.vertex_count = star_size(Lattice::triangle, 2, rings);
  const auto size = static_cast<std::size_t>(four.halfedge_count() / 2);
  arrays.origin.resize(size);
  arrays.twin.resize(size);
  arrays.edge.resize(size);
  for (Index h = 0; h < four.halfedge_count(); ++h) {
    const auto at = static_cast<std::size_t>(halfedge(h));
    arrays.origin[at] = vertex(four.origin(h));
    arrays.twin[at] = four.twin(h) == kNone ? kNone : halfedge(four.twin(h));
  }
  for (std::size_t h = 0; h < size; ++h) {
    const Index twin = arrays.twin[h];
    arrays.edge[h] = twin != kNone && static_cast<std::size_t>(twin) < h
                         ? arrays.edge[static_cast<std::size_t>(twin)]
                         : arrays.edge_count++;
  }
  return Mesh::from_arrays(std::move(arrays));
}

Sectors alike(Lattice lattice, Index sectors, bool open) {
  return {std::vector<Lattice>(static_cast<std::size_t>(sectors), lattice), open};
}

}  // namespace

Mesh torus(Lattice lattice, Index nx, Index ny) {
  assert(nx >= 3 && ny >= 3);
  FaceList faces;
  for (Index j = 0; j < ny; ++j) {
    for (Index i = 0; i < nx; ++i) {
      const Index right = (i + 1) % nx, up = (j + 1) % ny;
      const Index a = j * nx + i, b = j * nx + right, c = up * nx + right, d = up * nx + i;
      if (lattice == Lattice::quad) {
        faces.add({a, b, c, d});
      } else {
        faces.add({a, b, c});
        faces.add({a, c, d});
      }
    }
  }
  return faces.mesh(nx * ny);
}

Mesh sector_star(const Sectors& sectors, Index rings) {
  assert(rings >= 1 && !sectors.lattices.empty());
  if (!sectors.open && sectors.lattices == std::vector{Lattice::triangle, Lattice::triangle})
    return triangle_star_of_two(rings);
  const SectorRings at(sectors);
  FaceList faces;
  for (Index r = 1; r <= rings; ++r)
    for (std::size_t s = 0; s < sectors.lattices.size(); ++s)
      (sectors.lattices[s] == Lattice::triangle ? add_triangles : add_quads)(at, s, r, faces);
  return faces.mesh(at.size(rings));
}

Index sector_star_size(const Sectors& sectors, Index rings) {
  return SectorRings(sectors).size(rings);
}

Mesh star(Lattice lattice, Index n, Index rings) {
  assert(n >= 2);
  return sector_star(alike(lattice, n, false), rings);
}

Mesh fan(Lattice lattice, Index sectors, Index rings) {
  return sector_star(alike(lattice, sectors, true), rings);
}

Mesh cropped_star(Index n, Index rings) {
  assert(n >= 2 && rings >= 2);
  const CroppedRings at{n};
  FaceList faces;
  for (Index s = 0; s < n; ++s)
    for (Index y = 0; y < rings; ++y)
      for (Index x = 0; x < rings; ++x)
        if (x + y < 2 * (rings - 1))
          faces.add({at.vertex(s, x, y), at.vertex(s, x + 1, y), at.vertex(s, x + 1, y + 1),
                     at.vertex(s, x, y + 1)});
  return faces.mesh(at.size(rings));
}

Index cropped_star_size(Index n, Index rings) { return CroppedRings{n}.size(rings); }

Index star_size(Lattice lattice, Index n, Index rings) {
  return 1 + n * ring_length(lattice, 1) * (rings * (rings + 1) / 2);
}

Index fan_size(Lattice lattice, Index sectors, Index rings) {
  return star_size(lattice, sectors, rings) + rings;
}

Mesh face_star(Index n, Index rings) {
  assert(n >= 3 && rings >= 1);
  const DualRings at{n};
  FaceList faces;
  faces.add_ngon(n);
  for (Index r = 1; r < rings; ++r) {
    for (Index s = 0; s < n; ++s) {
      const auto add = [&](Index x, Index y) {
        faces.add({at.vertex(s, x, y), at.vertex(s, x + 1, y), at.vertex(s, x + 1, y + 1),
                   at.vertex(s, x, y + 1)});
      };
      for (Index y = 1; y <= r; ++y) add(r, y);
      for (Index x = r; x-- > 1;) add(x, r);
      // across the edge between this corner's quadrant and the next one's
      faces.add({at.vertex(s + 1, r, 1), at.vertex(s, 1, r), at.vertex(s, 1, r + 1),
                 at.vertex(s + 1, r + 1, 1)});
    }
  }
  return faces.mesh(at.size(rings));
}

Index face_star_size(Index n, Index rings) { return DualRings{n}.size(rings); }

Mesh tree(Lattice lattice, int depth) {
  assert(depth >= 0);
  struct Side {
    Index from, to;  // a half-edge that waits for its neighbour
  };
  FaceList faces;
  std::vector<Side> open, next;
  Index vertices = lattice == Lattice::quad ? 4 : 3;
  faces.add_ngon(vertices);
  for (Index i = 0; i < vertices; ++i) open.push_back({i, (i + 1) % vertices});
  for (int level = 0; level < depth; ++level) {
    next.clear();
    for (const Side& side : open) {
      const Index a = vertices++;
      if (lattice == Lattice::triangle) {
        faces.add({side.to, side.from, a});
        next.insert(next.end(), {{side.from, a}, {a, side.to}});
      } else {
        const Index b = vertices++;
        faces.add({side.to, side.from, a, b});
        next.insert(next.end(), {{side.from, a}, {a, b}, {b, side.to}});
      }
    }
    open.swap(next);
  }
  return faces.mesh(vertices);
}

}  // namespace limn::mesh
