#pragma once
/// Levels of a split as lattices: where the points of one level and of the next lie, and which new
/// points are alike.
///
/// A cycle of one or two steps cuts every control edge in `cut`. All places of a step are given in
/// the finer grid that its cycle ends with, `cut` times as fine as the one that it begins with: in
/// the frame of a half-edge, with `side` steps along it. After a cycle of one step all points of
/// the finer grid are there. In a cycle of two, the first step adds to the grid the centres of its
/// cells: then the points are those with x ≡ y (mod cut), in every frame. Where points lie half a
/// step in (`offset`, dual splits), they are the centres of the cells alone, and places are given
/// in halves of the finer grid's steps.

#include "limn/fast/kernel/stencil.h"
#include "limn/mesh/split/split.h"

namespace limn::fast {

/// What the levels of a split are.
struct GridCycle {
  Lattice lattice = Lattice::triangle;
  Index cut = 2;
  int steps = 1;
  bool offset = false;  ///< only with one step, on quads

  /// The steps of an edge of the grid that a cycle begins with, and of the one that it ends with.
  [[nodiscard]] constexpr Index edge() const { return cut * new_edge(); }
  [[nodiscard]] constexpr Index new_edge() const { return offset ? 2 : 1; }
};

/// Of an exponent ≥ 0.
[[nodiscard]] constexpr Index power(Index base, int exponent) {
  Index power = 1;
  while (exponent-- > 0) power *= base;
  return power;
}

/// One step of a cycle.
struct LatticeStep {
  Lattice lattice = Lattice::triangle;
  Index cut = 2, edge = 2, new_edge = 1;
  bool from_centres = false;  ///< old points are those of the coarser grid and its cells' centres
  bool to_centres = false;    ///< the same of new points

  constexpr LatticeStep(const GridCycle& cycle, int level)
      : lattice(cycle.lattice),
        cut(cycle.cut),
        edge(cycle.edge()),
        new_edge(cycle.new_edge()),
        from_centres(level % cycle.steps != 0),
        to_centres(cycle.steps == 2 && level % 2 == 0) {}

  [[nodiscard]] constexpr bool is_old(Index x, Index y) const {
    return from_centres ? (x - y) % cut == 0 : modulo(x) == first() && modulo(y) == first();
  }
  [[nodiscard]] constexpr bool is_new(Index x, Index y) const {
    if (new_edge > 1) return modulo(x) % new_edge != 0 && modulo(y) % new_edge != 0;
    return !to_centres || (x - y) % cut == 0;
  }

  /// Regular new points of one class have one stencil but for a translation. A class is how far a
  /// point lies from its anchor, an old point.
  [[nodiscard]] constexpr std::size_t classes() const {
    return static_cast<std::size_t>(from_centres ? cut : cut * cut);
  }
  [[nodiscard]] constexpr std::size_t class_of(Index x, Index y) const {
    return static_cast<std::size_t>(
        from_centres ? modulo(x - y) : cut * (modulo(y) / new_edge) + modulo(x) / new_edge);
  }
  [[nodiscard]] constexpr Offset anchor_of(Index x, Index y) const {
    if (from_centres) return {x - modulo(x - y), y};
    return {x - modulo(x) + first(), y - modulo(y) + first()};
  }

  /// The lattice of old points in coordinates in which it has all integers; also of the steps from
  /// one old point to another.
  [[nodiscard]] constexpr Offset to_local(Offset old) const {
    if (!from_centres) return {(old.a - modulo(old.a)) / edge, (old.b - modulo(old.b)) / edge};
    return {(old.a - old.b) / cut, (old.a + (cut - 1) * old.b) / cut};
  }
  /// Of a step.
  [[nodiscard]] constexpr Offset from_local(Offset local) const {
    if (!from_centres) return {edge * local.a, edge * local.b};
    return {(cut - 1) * local.a + local.b, local.b - local.a};
  }

  /// Where the first old points lie on both axes.
  [[nodiscard]] constexpr Index first() const { return new_edge > 1 ? edge / 2 : 0; }
  /// Between 0 and edge - 1.
  [[nodiscard]] constexpr Index modulo(Index i) const { return ((i % edge) + edge) % edge; }
};

}  // namespace limn::fast
