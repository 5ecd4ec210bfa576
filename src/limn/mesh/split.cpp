#include "limn/mesh/split.h"

#include "limn/mesh/split_list.h"

namespace limn {

const std::vector<Split>& splits() {
  static const std::vector<Split> list{
      {"triangle-dyadic", "each triangle into four, by the midpoints of its edges",
       Lattice::triangle, false, true, true, false, false, false, 4, detail::split_triangle_dyadic},
      {"quad-dyadic", "a quad for each corner of each face, round a point of the face",
       Lattice::quad, true, true, true, true, false, false, 4, detail::split_quad_dyadic},
      {"quad-dual", "a face for each face, inner edge and inner vertex; vertices from corners",
       Lattice::quad, true, false, false, false, true, false, 4, detail::split_quad_dual},
      {"sqrt3", "each triangle into three, by a point of the face, and the old edges flipped",
       Lattice::triangle, false, true, false, true, false, true, 3, detail::split_sqrt3},
  };
  return list;
}

const Split* find_split(std::string_view name) {
  for (const Split& split : splits())
    if (split.name == name) return &split;
  return nullptr;
}

}  // namespace limn
