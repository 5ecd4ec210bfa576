#include <array>
#include <cmath>
#include <numbers>

#include "page_state.h"

namespace limn::page {
namespace {

/// Where corner i of a face with so many is in the face's own square.
TexturePoint place_of(Index i, Index count) {
  constexpr std::array<TexturePoint, 4> kSquare{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  constexpr std::array<TexturePoint, 3> kTriangle{{{0, 0}, {1, 0}, {0, 1}}};
  if (count == 3) return kTriangle.at(static_cast<std::size_t>(i));
  if (count == 4) return kSquare.at(static_cast<std::size_t>(i));
  const double turn = 2 * std::numbers::pi * i / count;
  return {(1 + std::cos(turn)) / 2, (1 + std::sin(turn)) / 2};
}

/// Each corner has a point of its own.
TextureCoordinates of_faces(const Mesh& mesh) {
  TextureCoordinates texture;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index i = 0; i < mesh.degree(f); ++i) {
      texture.of_corner.push_back(static_cast<Index>(texture.points.size()));
      texture.points.push_back(place_of(i, mesh.degree(f)));
    }
  return texture;
}

}  // namespace

MeshAttributes texture_for(LoadedPlan& plan) {
  MeshAttributes attributes;
  const LoadedMesh& mesh = *plan.mesh;
  if (!mesh.texture.empty()) {
    plan.pattern = "image";
    attributes.texture = mesh.texture;
    return attributes;
  }
  const bool triangles = plan.scheme->scheme.split->lattice == Lattice::triangle;
  plan.pattern = triangles ? "triangles" : "quads";
  attributes.texture = of_faces(mesh.mesh);
  return attributes;
}

void keep_texture(LoadedPlan& plan, const TextureCoordinates& texture) {
  plan.texture.clear();
  if (texture.empty()) return;
  each_triangle(plan, [&](Index a, Index b, Index c) {
    for (const Index corner : {a, b, c}) {
      const Index point = texture.of_corner[corner];
      const TexturePoint at = point == kNone ? TexturePoint{} : texture.points[point];
      plan.texture.push_back(static_cast<float>(at.u));
      plan.texture.push_back(static_cast<float>(at.v));
    }
  });
}

TextureAnswer PageCore::texture(int plan) {
  TextureAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->plans.find(plan);
    if (!found) return found.error();
    if (!(*found)->textured) return Error{"the plan was made without texture"};
    if (Status status = update(**found); !status) return status.error();
    made.coordinates = (*found)->texture;
    return Json{{"pattern", (*found)->pattern}, {"reason", (*found)->no_texture}};
  });
  return made;
}

}  // namespace limn::page
