#pragma once
/// A small control mesh that stands for the surroundings of a place (a star, fan or face star,
/// mesh/lattice.h), taken through the steps of a cycle (lattice_step.h), and where the vertices of
/// its levels lie. What is special at a place is found by refining a site.
///
/// Places are those of a star (star_places.h) in the cycle's steps, of which cycle.edge() make a
/// control edge.

#include <algorithm>
#include <optional>
#include <vector>

#include "limn/fast/layout/lattice_step.h"
#include "limn/fast/layout/star_places.h"
#include "limn/fast/sites/dependence.h"

namespace limn::fast {

/// How a face of a mesh that recedes (dual splits) touches the boundary: for each side, bit 0 says
/// whether it is off the boundary, and bit 1 the same of the vertex before it. Where that is on the
/// boundary, the sector has no points but the first, those along the side, and along the side
/// before.
using RimPattern = std::vector<Index>;

/// Whether sector s has a point x, y steps from the first one.
[[nodiscard]] bool has_point(const RimPattern& pattern, const SectorPoint& point);

class Site {
 public:
  /// So many rings of control edges; of an offset cycle round a face, which may touch the boundary.
  Site(const Split& split, const GridCycle& cycle, const StarShape& shape, Index rings,
       const RimPattern& pattern = {});

  [[nodiscard]] const StarShape& shape() const { return shape_; }
  /// The mesh that the cycle's step number `step` refines, and what is born there.
  [[nodiscard]] const Mesh& mesh(int step) const { return steps_[at(step)].mesh; }
  [[nodiscard]] const Births& births(int step) const { return steps_[at(step)].births; }

  /// Where an old vertex of a step lies.
  [[nodiscard]] const SectorPoint& place(int step, Index old) const {
    return steps_[at(step)].places[at(old)];
  }
  /// The new (old) vertex of a step at a place, which must have one: x, y ≥ 0.
  [[nodiscard]] Index new_vertex(int step, const SectorPoint& place) const;
  [[nodiscard]] Index old_vertex(int step, const SectorPoint& place) const;

  /// The point at a place in the coordinates of a sector, in it or in one of the two beside it.
  /// Nothing where there is none.
  [[nodiscard]] std::optional<SectorPoint> beside(Index sector, Offset place) const;

  /// From this ring on all is too near the rim to be as if the lattice went on.
  [[nodiscard]] Index rim() const { return extent_ - std::max(first_, Index{1}); }
  [[nodiscard]] Index ring(const SectorPoint& place) const {
    return ring_of(shape_.lattice, place.x, place.y);
  }

 private:
  struct Step {
    Mesh mesh;
    Births births;
    std::vector<SectorPoint> places, made;  ///< of its old and new vertices
    std::vector<Index> vertices;            ///< new ones, by slot
  };
  template <class Int>
  static std::size_t at(Int i) {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] std::size_t slot(const SectorPoint& place) const;
  [[nodiscard]] SectorPoint normal(SectorPoint place) const;
  void place_new(Step& step) const;
  /// The place between old vertices, which have weights.
  [[nodiscard]] SectorPoint between(const std::vector<std::pair<Index, Index>>& parents,
                                    const std::vector<SectorPoint>& places) const;

  StarShape shape_;
  Index extent_;                 // steps from the middle to the rim
  Index first_;                  // where the first points lie
  std::vector<Index> controls_;  // old vertices of the first step, by slot
  std::vector<Step> steps_;
};

}  // namespace limn::fast
