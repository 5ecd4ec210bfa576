#include "limn/mesh/io/stl_slivers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <unordered_map>

#include "limn/mesh/polygon/orientation.h"

namespace limn::io {
namespace {

using Corners = std::array<Index, 3>;

constexpr Index kNoFace = -1, kSeveral = -2;

/// Its corners, turned so that the one in the middle of the line comes first.
Corners from_the_middle(const Polygons& mesh, Corners face) {
  const auto inside = [&](Index middle, Index from, Index to) {
    const Point3 m = mesh.positions[middle], a = mesh.positions[from], b = mesh.positions[to];
    const auto between = [](double x, double p, double q) {
      return std::min(p, q) <= x && x <= std::max(p, q);
    };
    return between(m.x, a.x, b.x) && between(m.y, a.y, b.y) && between(m.z, a.z, b.z);
  };
  for (int k = 0; k < 2 && !inside(face[0], face[1], face[2]); ++k) {
    std::rotate(face.begin(), face.begin() + 1, face.end());
  }
  return face;
}

class SliverRemover {
 public:
  SliverRemover(Polygons& mesh, const std::vector<Index>& slivers)
      : mesh_(mesh),
        queue_(slivers.begin(), slivers.end()),
        is_sliver_(static_cast<std::size_t>(mesh.face_count()), 0) {
    result_.removed.assign(is_sliver_.size(), 0);
    for (const Index face : slivers) is_sliver_[face] = 1;
    for (Index face = 0; face < mesh.face_count(); ++face) enter(face);
  }

  SliverRemoval run() {
    // A sliver beside a sliver waits until that one is gone; each wait but the last ends in a cut.
    std::size_t waits = 0;
    while (!queue_.empty()) {
      const Index face = queue_.front();
      queue_.pop_front();
      const Corners corners = from_the_middle(mesh_, corners_of(face));
      const Index across = neighbour(corners);
      if (across >= 0 && is_sliver_[across] != 0 && waits++ < queue_.size()) {
        queue_.push_back(face);
        continue;
      }
      waits = 0;
      if (across < 0 || is_sliver_[across] != 0 || !cut(face, corners, across)) remove(face);
      is_sliver_[face] = 0;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Corners corners_of(Index face) const {
    const Index* const first = mesh_.corners.data() + mesh_.face_begin[face];
    return {first[0], first[1], first[2]};
  }
  static std::uint64_t key(Index from, Index to) {
    return std::uint64_t{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
  }

  void enter(Index face) {
    const Corners c = corners_of(face);
    for (int k = 0; k < 3; ++k) {
      const auto [at, is_new] = faces_.try_emplace(key(c[k], c[(k + 1) % 3]), face);
      if (!is_new) at->second = kSeveral;
    }
  }
  void leave(Index face) {
    const Corners c = corners_of(face);
    for (int k = 0; k < 3; ++k) {
      const auto at = faces_.find(key(c[k], c[(k + 1) % 3]));
      if (at->second == face) faces_.erase(at);
    }
  }
  void replace(Index face, const Corners& corners) {
    std::copy(corners.begin(), corners.end(), mesh_.corners.begin() + mesh_.face_begin[face]);
    enter(face);
  }
  void remove(Index face) {
    leave(face);
    result_.removed[face] = 1;
  }

  /// The one face beyond the longest side, if the sliver is the only one on its own side of it.
  [[nodiscard]] Index neighbour(const Corners& sliver) const {
    if (faces_.find(key(sliver[1], sliver[2]))->second == kSeveral) return kNoFace;
    const auto beyond = faces_.find(key(sliver[2], sliver[1]));
    return beyond == faces_.end() || beyond->second < 0 ? kNoFace : beyond->second;
  }

  /// Of the sliver (m, p, q) and the face (q, p, d) makes (m, p, d) and (q, m, d).
  bool cut(Index sliver, const Corners& corners, Index face) {
    const auto [m, p, q] = corners;
    Index d = q;
    for (const Index corner : corners_of(face)) {
      if (corner != p && corner != q) d = corner;
    }
    if (d == m) return false;
    leave(sliver);
    leave(face);
    replace(sliver, {m, p, d});
    replace(face, {q, m, d});
    ++result_.cut;
    return true;
  }

  Polygons& mesh_;
  std::deque<Index> queue_;
  std::vector<char> is_sliver_;
  std::unordered_map<std::uint64_t, Index> faces_;  ///< by the corners of a side, in its direction
  SliverRemoval result_;
};

}  // namespace

bool lie_on_a_line(Point3 a, Point3 b, Point3 c) {
  double largest = 0;
  for (const Point3& p : {a, b, c}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  if (largest == 0) return true;
  // Products of coordinates of any size neither over- nor underflow then.
  const int shift = -std::ilogb(largest);
  const auto scaled = [shift](double x) { return std::ldexp(x, shift); };
  for (Point3* p : {&a, &b, &c}) *p = {scaled(p->x), scaled(p->y), scaled(p->z)};
  // As a rule the first plane decides: the one in which the triangle is largest.
  const std::array<std::array<mesh::Point2, 3>, 3> planes{{{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}},
                                                           {{{a.y, a.z}, {b.y, b.z}, {c.y, c.z}}},
                                                           {{{a.z, a.x}, {b.z, b.x}, {c.z, c.x}}}}};
  std::size_t order[] = {0, 1, 2};
  double areas[3];
  for (const std::size_t k : order) {
    areas[k] = std::abs(mesh::approx_turn(planes[k][0], planes[k][1], planes[k][2]));
  }
  std::swap(order[0], *std::max_element(order, order + 3, [&](std::size_t k, std::size_t l) {
              return areas[k] < areas[l];
            }));
  return std::all_of(order, order + 3, [&](std::size_t k) {
    return mesh::turn(planes[k][0], planes[k][1], planes[k][2]) == 0;
  });
}

SliverRemoval take_out_slivers(Polygons& mesh, const std::vector<Index>& slivers) {
  return SliverRemover(mesh, slivers).run();
}

}  // namespace limn::io
