#include "limn/mesh/split/split.h"

#include "limn/mesh/split/split_list.h"

namespace limn {
namespace {

constexpr LatticeMatrix kDyadic{{{{2, 0}, {0, 2}}}};
/// The refined basis is (2 e1 + e2)/3, the way to the centroid of a triangle, and that turned by
/// 120°.
constexpr LatticeMatrix kSqrt3{{{{1, 1}, {-1, 2}}}};

}  // namespace

const std::vector<Split>& splits() {
  static const std::vector<Split> list{
      {"triangle-dyadic", "each triangle into four, by the midpoints of its edges",
       Lattice::triangle, false, true, true, false, false, false, kDyadic,
       detail::split_triangle_dyadic},
      {"quad-dyadic", "a quad for each corner of each face, round a point of the face",
       Lattice::quad, true, true, true, true, false, false, kDyadic, detail::split_quad_dyadic},
      {"quad-dual", "a face for each face, inner edge and inner vertex; vertices from corners",
       Lattice::quad, true, false, false, false, true, false, kDyadic, detail::split_quad_dual},
      {"sqrt3", "each triangle into three, by a point of the face, and the old edges flipped",
       Lattice::triangle, false, true, false, true, false, true, kSqrt3, detail::split_sqrt3},
  };
  return list;
}

const Split* find_split(std::string_view name) {
  for (const Split& split : splits())
    if (split.name == name) return &split;
  return nullptr;
}

}  // namespace limn
