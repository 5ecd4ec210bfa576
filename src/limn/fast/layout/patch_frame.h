#pragma once
/// The frame of a patch: the old points that it reads besides those whose numbers follow one
/// another, in the order of their places and as numbers.

#include <vector>

#include "limn/base/huge_array.h"
#include "limn/fast/layout/grid_layout.h"

namespace limn::fast {

/// What the numbers round control faces depend on, whatever the level: read from the mesh once. Of
/// each face: its corners; the codes of its sides; and across each side the face there (or kNone),
/// the number of the side's half-edge in it, the corners after that one's ends and the codes of the
/// sides after it.
class PatchTopology {
 public:
  PatchTopology() = default;
  /// All faces have so many sides.
  PatchTopology(const Mesh& control, Index sides);

  /// Of one face.
  class Face {
   public:
    Face(const Index* data, Index sides) : data_(data), sides_(sides) {}
    [[nodiscard]] const Index* corners() const { return data_; }
    [[nodiscard]] const EdgeCode* codes() const { return data_ + sides_; }
    struct Neighbour {
      Index face, side;
      const Index* corners;   ///< from number 2 on
      const EdgeCode* codes;  ///< from number 1 on
    };
    [[nodiscard]] Neighbour across(Index side) const {
      const Index* at = data_ + 2 * sides_ + side * (2 * sides_ - 1);
      return {at[0], at[1], at + 2, at + sides_};
    }

   private:
    const Index* data_;
    Index sides_;
  };
  [[nodiscard]] Face face(Index f) const { return {data_.data() + f * size(sides_), sides_}; }

 private:
  template <int kSides>
  void fill(const Mesh& control);
  static std::ptrdiff_t size(Index sides) { return sides * (2 * sides + 1); }
  Index sides_ = 0;
  base::HugeArray<Index> data_;
};

/// The places of a frame, and their numbers patch by patch.
class PatchFrame {
 public:
  /// The corners, the points on the sides, where there are centres also the inner points of the
  /// grid, and `halo` ≤ side() rows of points beyond each side.
  PatchFrame(const GridLayout& layout, Index halo);

  [[nodiscard]] const std::vector<Offset>& places() const { return places_; }
  /// Where there is no neighbour, a corner's number. Cost some ns a side, and for each number less
  /// than one.
  void number(Index f, const PatchTopology::Face& face, Index* out) const;

 private:
  /// A number on a neighbour's corner or side: `series` counts its corners, then its sides.
  struct Loose {
    Index series = 0, at = 0;
  };
  /// The inner points and centres of a neighbour, from its first ones on, by the number of the
  /// common side there; and what vectors may read after them.
  struct Inside {
    std::vector<Index> points, centres;
  };
  template <int kSides>
  void number(Index f, const PatchTopology::Face& face, Index* out) const;
  void add_beyond(Index k, Index halo);

  GridLayout layout_;
  std::vector<Offset> places_;
  std::vector<Index> steps_;  // 1, 2, …
  std::vector<Loose> loose_;  // of any neighbour
  std::vector<Inside> inside_;
  Index points_ = 0, centres_ = 0;  // of a neighbour
};

}  // namespace limn::fast
