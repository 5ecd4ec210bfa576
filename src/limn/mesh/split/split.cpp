#include "limn/mesh/split/split.h"

#include "limn/mesh/split/split_list.h"

namespace limn {
namespace {

constexpr LatticeMatrix kDyadic{{{{2, 0}, {0, 2}}}};
constexpr LatticeMatrix kTernary{{{{3, 0}, {0, 3}}}};
/// The refined basis is (2 e1 + e2)/3, the way to the centroid of a triangle, and that turned by
/// 120°.
constexpr LatticeMatrix kSqrt3{{{{1, 1}, {-1, 2}}}};
/// The refined basis is (e1 + e2)/2, the way to the centroid of a quad, and that turned by 90°.
constexpr LatticeMatrix kSqrt2{{{{1, 1}, {-1, 1}}}};

}  // namespace

const std::vector<Split>& splits() {
  static const std::vector<Split> list{
      {.name = "triangle-dyadic",
       .description = "each triangle into four, by the midpoints of its edges",
       .lattice = Lattice::triangle,
       .births = {.vertices = true, .edges = true},
       .dilation = kDyadic,
       .apply = mesh::detail::split_triangle_dyadic},
      {.name = "quad-dyadic",
       .description = "a quad for each corner of each face, round a point of the face",
       .lattice = Lattice::quad,
       .any_polygons = true,
       .births = {.vertices = true, .edges = true, .faces = true},
       .dilation = kDyadic,
       .apply = mesh::detail::split_quad_dyadic},
      {.name = "quad-dual",
       .description = "a face for each face, inner edge and inner vertex; vertices from corners",
       .lattice = Lattice::quad,
       .any_polygons = true,
       .births = {.corners = true},
       .dilation = kDyadic,
       .apply = mesh::detail::split_quad_dual},
      {.name = "sqrt3",
       .description = "each triangle into three, by a point of the face, and the old edges flipped",
       .lattice = Lattice::triangle,
       .births = {.vertices = true, .faces = true},
       .odd_step_cut = 3,
       .dilation = kSqrt3,
       .apply = mesh::detail::split_sqrt3},
      {.name = "quad-sqrt2",
       .description = "a quad for each inner edge, between its ends and points of its faces",
       .lattice = Lattice::quad,
       .any_polygons = true,
       .births = {.vertices = true, .faces = true},
       .odd_step_cut = 2,
       .dilation = kSqrt2,
       .apply = mesh::detail::split_quad_sqrt2},
      {.name = "midedge",
       .description = "a face for each face and vertex; vertices from edges",
       .lattice = Lattice::quad,
       .any_polygons = true,
       .births = {.edges = true},
       .dilation = kSqrt2,
       .apply = mesh::detail::split_midedge},
      {.name = "triangle-ternary",
       .description = "each triangle into nine, by two points on each edge and one of the face",
       .lattice = Lattice::triangle,
       .births = {.vertices = true, .edges = true, .thirds = true, .faces = true},
       .dilation = kTernary,
       .apply = mesh::detail::split_triangle_ternary},
      {.name = "quad-ternary",
       .description = "each quad into nine, by two points on each edge and one for each corner",
       .lattice = Lattice::quad,
       .births = {.vertices = true, .edges = true, .thirds = true, .corners = true},
       .dilation = kTernary,
       .apply = mesh::detail::split_quad_ternary},
      {.name = "quad-triangle",
       .description = "each triangle into four, by the midpoints of its edges; of any other face a "
                      "quad for each corner",
       .lattice = Lattice::quad,
       .any_polygons = true,
       .mixed = true,
       .births = {.vertices = true, .edges = true, .faces = true},
       .dilation = kDyadic,
       .apply = mesh::detail::split_quad_triangle},
  };
  return list;
}

const Split* find_split(std::string_view name) {
  for (const Split& split : splits())
    if (split.name == name) return &split;
  return nullptr;
}

}  // namespace limn
