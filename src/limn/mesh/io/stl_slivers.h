#pragma once
/// Facets of a triangle soup whose corners are three places on a line.

#include <cstddef>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::io {

/// Whether the points lie on a line: exact, at any size.
[[nodiscard]] bool lie_on_a_line(Point3 a, Point3 b, Point3 c);

struct SliverRemoval {
  std::vector<char> removed;  ///< by face: whether it is to be left out
  std::size_t cut = 0;        ///< facets that were cut in two, each in place of a sliver
};

/// Takes out the triangles `slivers` of `mesh`, whose corners lie on a line. Where another triangle
/// alone meets the longest side of a sliver, it is cut at the corner between, and its second part
/// takes the sliver's place: without it there would be a crack. All others are `removed`, for the
/// caller to leave out. Cost O(faces), expected.
[[nodiscard]] SliverRemoval take_out_slivers(Polygons& mesh, const std::vector<Index>& slivers);

}  // namespace limn::io
