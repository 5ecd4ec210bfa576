#include "limn/figure/chart/level_sets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

namespace limn::figure {
namespace {

/// A corner's name: both nodes of the edge that it cuts, the smaller first; of a node, itself
/// twice.
long long key_of(int i, int j) {
  return static_cast<long long>(std::min(i, j)) << 32 | std::max(i, j);
}

double doubled_area(const TriangleGrid& grid, const std::array<int, 3>& triangle) {
  const auto [a, b, c] =
      std::tie(grid.nodes[triangle[0]], grid.nodes[triangle[1]], grid.nodes[triangle[2]]);
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

/// A directed side of the superlevel set, which lies on its left.
struct LevelSets::Segment {
  long long from, to;
  bool contour;  ///< within a triangle, where value == level; not on one of its sides
};

LevelSets::LevelSets(TriangleGrid grid, std::vector<double> values)
    : grid_(std::move(grid)), values_(std::move(values)) {
  assert(values_.size() == grid_.nodes.size());
  usable_.reserve(grid_.triangles.size());
  for (std::array<int, 3>& triangle : grid_.triangles) {
    if (doubled_area(grid_, triangle) < 0) std::swap(triangle[1], triangle[2]);
    usable_.push_back(std::all_of(triangle.begin(), triangle.end(),
                                  [&](int node) { return std::isfinite(values_[node]); }));
  }
  find_neighbours();
}

void LevelSets::find_neighbours() {
  struct Side {
    long long key;
    std::size_t triangle;
    int side;
    bool forward;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < grid_.triangles.size(); ++t) {
    for (int side = 0; usable_[t] && side < 3; ++side) {
      const int i = grid_.triangles[t][side], j = grid_.triangles[t][(side + 1) % 3];
      sides.push_back({key_of(i, j), t, side, i < j});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.key, a.triangle, a.side) < std::tie(b.key, b.triangle, b.side);
  });
  has_other_.assign(grid_.triangles.size(), {false, false, false});
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Side &a = sides[k], &b = sides[k + 1];
    if (a.key != b.key || a.forward == b.forward) continue;
    has_other_[a.triangle][a.side] = has_other_[b.triangle][b.side] = true;
    ++k;  // both are taken
  }
}

/// The sides of all pieces {value >= level} of triangles that do not cancel.
std::vector<LevelSets::Segment> LevelSets::boundary(double level) const {
  std::vector<Segment> segments;
  const auto inside = [&](int node) { return values_[node] >= level; };
  const auto add = [&](long long from, long long to, bool contour) {
    if (from != to) segments.push_back({from, to, contour});
  };
  for (std::size_t t = 0; t < grid_.triangles.size(); ++t) {
    if (!usable_[t]) continue;
    long long enters = -1, leaves = -1;  // where the triangle's boundary enters and leaves the set
    for (int side = 0; side < 3; ++side) {
      const int i = grid_.triangles[t][side], j = grid_.triangles[t][(side + 1) % 3];
      const bool from = inside(i), to = inside(j);
      if (!from && !to) continue;
      long long a = key_of(i, i), b = key_of(j, j);
      // A cut through a node bears the node's name.
      if (!from) enters = a = values_[j] == level ? b : key_of(i, j);
      if (!to) leaves = b = values_[i] == level ? a : key_of(i, j);
      if (!has_other_[t][side]) add(a, b, false);
    }
    if (enters >= 0) add(leaves, enters, true);
  }
  // A side of level value may be there once in each direction.
  const auto less = [](const Segment& a, const Segment& b) {
    const auto ends = [](const Segment& s) { return std::minmax(s.from, s.to); };
    return std::tuple(ends(a), a.from) < std::tuple(ends(b), b.from);
  };
  std::sort(segments.begin(), segments.end(), less);
  std::vector<Segment> left;
  for (const Segment& segment : segments) {
    if (!left.empty() && left.back().from == segment.to && left.back().to == segment.from)
      left.pop_back();
    else
      left.push_back(segment);
  }
  return left;
}

std::array<double, 2> LevelSets::position(long long key, double level) const {
  const auto i = static_cast<std::size_t>(key >> 32);
  const auto j = static_cast<std::size_t>(key & 0xffffffff);
  const auto &a = grid_.nodes[i], &b = grid_.nodes[j];
  if (i == j) return a;
  // Halves, as the difference of two finite values may be infinite.
  const double rise = values_[j] / 2 - values_[i] / 2;
  double t = (level / 2 - values_[i] / 2) / rise;
  if (!(t >= 0)) t = 0;
  if (t > 1) t = 1;
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

namespace {

/// Chains of segments [from, to]: lists of indices, each beginning where the one before it ends.
/// Those that cannot be entered come first, so that an open line is one chain.
template <class Segments>
std::vector<std::vector<std::size_t>> chains_of(const Segments& segments) {
  std::vector<std::size_t> by_start(segments.size());
  for (std::size_t k = 0; k < by_start.size(); ++k) by_start[k] = k;
  const auto starts_before = [&](std::size_t a, std::size_t b) {
    return std::pair(segments[a].from, a) < std::pair(segments[b].from, b);
  };
  std::sort(by_start.begin(), by_start.end(), starts_before);
  std::vector<char> used(segments.size(), 0);
  const auto next_from = [&](long long key) {
    auto at = std::lower_bound(by_start.begin(), by_start.end(), key,
                               [&](std::size_t k, long long x) { return segments[k].from < x; });
    while (at != by_start.end() && segments[*at].from == key && used[*at]) ++at;
    return at != by_start.end() && segments[*at].from == key ? *at : segments.size();
  };
  std::vector<std::vector<std::size_t>> chains;
  const auto follow = [&](std::size_t first) {
    std::vector<std::size_t>& chain = chains.emplace_back();
    for (std::size_t k = first; k != segments.size(); k = next_from(segments[k].to)) {
      used[k] = 1;
      chain.push_back(k);
      if (segments[k].to == segments[first].from) break;
    }
  };
  std::vector<long long> ends(segments.size());
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = segments[k].to;
  std::sort(ends.begin(), ends.end());
  for (const std::size_t k : by_start)
    if (!used[k] && !std::binary_search(ends.begin(), ends.end(), segments[k].from)) follow(k);
  for (const std::size_t k : by_start)
    if (!used[k]) follow(k);
  return chains;
}

}  // namespace

std::vector<Polyline> LevelSets::superlevel_loops(double level) const {
  const std::vector<Segment> segments = boundary(level);
  std::vector<Polyline> loops;
  for (const std::vector<std::size_t>& chain : chains_of(segments)) {
    assert(segments[chain.back()].to == segments[chain.front()].from);
    Polyline& loop = loops.emplace_back();
    for (const std::size_t k : chain) loop.push_back(position(segments[k].from, level));
  }
  return loops;
}

std::vector<Polyline> LevelSets::contour_lines(double level) const {
  std::vector<Segment> segments = boundary(level);
  std::erase_if(segments, [](const Segment& segment) { return !segment.contour; });
  std::vector<Polyline> lines;
  for (const std::vector<std::size_t>& chain : chains_of(segments)) {
    Polyline& line = lines.emplace_back();
    for (const std::size_t k : chain) line.push_back(position(segments[k].from, level));
    line.push_back(position(segments[chain.back()].to, level));
  }
  return lines;
}

std::vector<Polyline> superlevel_loops(const TriangleGrid& grid, const std::vector<double>& values,
                                       double level) {
  return LevelSets(grid, values).superlevel_loops(level);
}

std::vector<Polyline> contour_lines(const TriangleGrid& grid, const std::vector<double>& values,
                                    double level) {
  return LevelSets(grid, values).contour_lines(level);
}

}  // namespace limn::figure
