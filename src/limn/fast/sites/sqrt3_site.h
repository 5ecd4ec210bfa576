#pragma once
/// A star or fan taken through the two steps of √3 that make a grid of thirds, and where the
/// vertices of the three levels lie.
///
/// Places are those of sqrt3_layout.h with n = 1: thirds of a control edge in the sectors of the
/// star (star_places.h). Level 0 is at the points whose coordinates are multiples of 3, level 1 at
/// those with X ≡ Y (mod 3), level 2 everywhere.

#include <array>
#include <vector>

#include "limn/fast/sites/star_places.h"
#include "limn/mesh/split.h"

namespace limn::fast {

/// The two kinds of steps: from a grid to its triangles' centroids as well, the boundary staying as
/// it is; and from these to the grid of thirds.
enum class Sqrt3Step { centroids, thirds };

/// Whether a step reads (makes) a vertex at that place.
[[nodiscard]] constexpr bool is_old(Sqrt3Step step, Index x, Index y) {
  return (x - y) % 3 == 0 && (step == Sqrt3Step::thirds || x % 3 == 0);
}
[[nodiscard]] constexpr bool is_new(Sqrt3Step step, Index x, Index y) {
  return step == Sqrt3Step::thirds || (x - y) % 3 == 0;
}

/// The vertex of level 2 that lies a third along half-edge h of level 0, or where `near_target` two
/// thirds; `second` is what the second step bears. Cost: logarithmic in the size of the mesh.
[[nodiscard]] Index third_along(const Mesh& control, const Births& second, Index h,
                                bool near_target = false);

class Sqrt3Site {
 public:
  /// So many sectors (faces round the middle vertex) and rings of control edges; `open`: a fan.
  Sqrt3Site(const Split& split, Index sectors, bool open, Index rings);

  /// The mesh that a step refines, and what is born there.
  [[nodiscard]] const Mesh& mesh(Sqrt3Step step) const {
    return step == Sqrt3Step::centroids ? control_ : first_.mesh;
  }
  [[nodiscard]] const Births& births(Sqrt3Step step) const {
    return step == Sqrt3Step::centroids ? first_.births : second_;
  }

  /// Where an old vertex of either step lies.
  [[nodiscard]] const SectorPoint& place(Index old) const { return places_[old]; }
  /// The vertex of level 2 at a place; where X ≡ Y (mod 3), also that of level 1.
  [[nodiscard]] Index vertex(const SectorPoint& place) const;

  /// What a new vertex is born from, as a half-edge of mesh(step): one out of the old vertex, or of
  /// the old face, or of a boundary edge and the end that it is near.
  enum class Birth { vertex, face, edge_end };
  struct Origin {
    Birth kind = Birth::vertex;
    Index halfedge = kNone;
    bool at_target = false;
  };
  [[nodiscard]] Origin origin(Sqrt3Step step, const SectorPoint& place) const;

  /// Everything from this ring (X + Y) on is too near the rim to be as if the lattice went on.
  [[nodiscard]] Index rim() const { return 3 * rings_ - 1; }

 private:
  [[nodiscard]] Index triangle_up(Index sector, Index x, Index y) const;
  [[nodiscard]] Index old_vertex(const SectorPoint& place) const;
  /// On which half-edge of level 0 a third lies, and whether near its target.
  struct Third {
    Index halfedge = kNone;
    bool near_target = false;
  };
  [[nodiscard]] Third third(const SectorPoint& place) const;
  void place_all();

  Index sectors_, rings_;
  bool open_;
  Mesh control_;
  SplitResult first_;
  Births second_;
  std::vector<SectorPoint> places_;
};

}  // namespace limn::fast
