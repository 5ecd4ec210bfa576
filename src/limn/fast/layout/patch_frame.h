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
  static std::ptrdiff_t size(Index sides) { return sides * (2 * sides + 1); }
  Index sides_ = 0;
  HugeArray<Index> data_;
};

/// The places of a frame, and their numbers patch by patch.
class PatchFrame {
 public:
  /// The corners, the points on the sides, where there are centres also the inner points of the
  /// grid, and `halo` ≤ side() rows of points beyond each side.
  PatchFrame(const GridLayout& layout, Index halo);

  [[nodiscard]] const std::vector<Offset>& places() const { return places_; }
  /// Where there is no neighbour, a corner's number. Cost some ns a number.
  void number(Index f, const PatchTopology::Face& face, Index* out) const;

 private:
  /// A number is origin ± at of one of a face's series: a corner, the points of a side, the inner
  /// points, the centres.
  struct Entry {
    Index series = 0, at = 0;
  };
  /// Entries in a row that are of one series: numbers `begin` … of the list `at`.
  struct Part {
    Index series = 0, begin = 0, count = 0;
  };
  struct Entries {
    std::vector<Part> parts;
    std::vector<Index> at;      ///< and what vectors may read after them
    std::vector<Index> series;  ///< that are in use
    Index count = 0;
    void add(Entry entry);
  };
  class Series;
  [[nodiscard]] Entry entry(Index k, Index x, Index y) const;

  GridLayout layout_;
  std::vector<Offset> places_;
  Entries own_;
  std::vector<Entries> beyond_;  ///< a side, by the number of its half-edge there
};

}  // namespace limn::fast
