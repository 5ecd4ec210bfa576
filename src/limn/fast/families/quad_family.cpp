#include "limn/fast/families/quad_family.h"

#include "limn/fast/families/grid_family.h"
#include "limn/fast/layout/quad_frame.h"

namespace limn::fast {
namespace {

struct QuadGrid {
  static constexpr Lattice kLattice = Lattice::quad;
  static constexpr Index kSides = 4;
  using Layout = QuadLayout;
  using Topology = QuadTopology;
  using Frames = QuadFrames;

  static Topology topology(const Mesh& mesh, Index f) { return quad_topology(mesh, f); }
  static std::vector<Offset> frame_places(Index n, Index halo) {
    return quad_frame_places(n, halo);
  }
  static std::vector<Offset> inner_places(Index n) { return quad_inner_places(n); }
  static Offset in_patch(Index n, Index side, Offset place) {
    return in_quad_patch(n, side, place);
  }

  template <class Visit>
  static void walk(const Mesh& mesh, Index row, Index n, Visit visit) {
    for (Index y = 0; y < n; ++y) {
      Index h = row;  // from (x, y) to (x + 1, y)
      for (Index x = 0; x < n; ++x) {
        const Index top = mesh.next(mesh.next(h));
        visit(x, y, mesh.origin(h));
        visit(x + 1, y, mesh.target(h));
        visit(x, y + 1, mesh.target(top));
        visit(x + 1, y + 1, mesh.origin(top));
        if (x + 1 < n) h = mesh.next(mesh.twin(mesh.next(h)));
      }
      if (y + 1 < n) row = mesh.twin(mesh.next(mesh.next(row)));
    }
  }
};

}  // namespace

std::unique_ptr<Family> make_quad_family(const Scheme& scheme, const Mesh& control, int levels) {
  return std::make_unique<GridFamily<QuadGrid>>(scheme, control, levels);
}

}  // namespace limn::fast
