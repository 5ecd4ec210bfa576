#pragma once
/// Where the edges of a control mesh run in a refined one, whatever the split.

#include <vector>

#include "limn/mesh/split/split.h"

namespace limn::mesh {

/// Paths along control edges. Their points are means of refined vertices, and where refined edges
/// are parts of control edges, vertices alone.
struct EdgePaths {
  std::vector<Index> vertices;  ///< of point p: vertices[begin[p]] … vertices[begin[p + 1]-1]
  std::vector<std::size_t> begin{0};  ///< one more than there are points
  struct Segment {
    Index from, to;  ///< points
    Index edge;      ///< the control edge
  };
  std::vector<Segment> segments;  ///< in no order

  [[nodiscard]] Index point_count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// After so many steps. Where the split lays faces across old edges, a path goes through the middle
/// of each edge or face that it crosses; under dual splits it goes from the face of a control
/// vertex to that of another one, and a boundary edge has none. Preconditions as Split::apply. Cost
/// O(the refined mesh).
[[nodiscard]] EdgePaths edge_paths(const Split& split, const Mesh& control, int levels);

}  // namespace limn::mesh
