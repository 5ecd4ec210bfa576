#include "limn/fast/families/triangle_family.h"

#include "limn/fast/families/grid_family.h"
#include "limn/fast/layout/triangle_frame.h"

namespace limn::fast {
namespace {

struct TriangleGrid {
  static constexpr Lattice kLattice = Lattice::triangle;
  static constexpr Index kSides = 3;
  using Layout = TriangleLayout;
  using Topology = TriangleTopology;
  using Frames = TriangleFrames;

  static Topology topology(const Mesh& mesh, Index f) { return triangle_topology(mesh, f); }
  static std::vector<Offset> frame_places(Index n, Index halo) {
    return triangle_frame_places(n, halo);
  }
  static std::vector<Offset> inner_places(Index n) { return triangle_inner_places(n); }
  static Offset in_patch(Index n, Index side, Offset place) {
    return in_triangle_patch(n, side, place);
  }

  template <class Visit>
  static void walk(const Mesh& mesh, Index row, Index n, Visit visit) {
    for (Index y = 0; y < n; ++y) {
      Index h = row;  // from (x, y) to (x + 1, y)
      for (Index x = 0; x + y < n; ++x) {
        visit(x, y, mesh.origin(h));
        visit(x + 1, y, mesh.target(h));
        // over the face that points down, into the next one that points up
        if (x + y + 1 < n) h = mesh.next(mesh.twin(mesh.next(mesh.twin(mesh.next(h)))));
      }
      // the face that points down beside (0, y) has the next row's first edge opposite
      if (y + 1 < n) row = mesh.twin(mesh.prev(mesh.twin(mesh.next(row))));
    }
  }
};

}  // namespace

std::unique_ptr<Family> make_triangle_family(const Scheme& scheme, const Mesh& control,
                                             int levels) {
  return std::make_unique<GridFamily<TriangleGrid>>(scheme, control, levels);
}

}  // namespace limn::fast
