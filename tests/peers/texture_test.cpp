// Texture coordinates against OpenSubdiv's face-varying values: random meshes with random seams,
// sharpness and boundaries, by every rule.
//
// Values are matched by cutting both refined meshes at their seams and comparing the pieces in a
// space of u, v and one coordinate of the position.

#include <map>
#include <random>

#include "limn/mesh/attributes/texture_mesh.h"
#include "limn/mesh/sharpness/cut_mesh.h"
#include "limn/surface/refine_surface.h"
#include "peer_test.h"
#include "stated.h"
#include "textured_peer.h"

namespace limn::peers {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Read once.
const Scheme& scheme_of(Method method) {
  static const Scheme loop = find_scheme("loop").value(),
                      catmull_clark = find_scheme("catmull-clark").value();
  return method == Method::loop ? loop : catmull_clark;
}

/// A point for each fan that is left of a vertex when edges are cut at random; with `merged`, some
/// fans of a vertex have the same.
PeerTexture random_texture(const Mesh& mesh, double share, bool merged, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<bool> along(at(mesh.edge_count()));
  for (Index e = 0; e < mesh.edge_count(); ++e) along[at(e)] = unit(random) < share;
  const mesh::CutMesh cut = mesh::cut_along(mesh, along);
  std::vector<Index> point(cut.originals.size());
  PeerTexture texture;
  for (std::size_t v = 0; v < point.size(); ++v) {
    const bool copy = at(cut.originals[v]) != v;
    point[v] = static_cast<Index>(texture.points.size());
    if (merged && copy && !mesh.is_boundary_vertex(cut.originals[v]) && random() % 2 == 0)
      point[v] = point[at(cut.originals[v])];
    else
      texture.points.push_back({unit(random), unit(random)});
  }
  for (Index h = 0; h < cut.mesh.halfedge_count(); ++h)
    texture.of_corner.push_back(point[at(cut.mesh.origin(h))]);
  return texture;
}

/// Sharp edges that are no seams, so that OpenSubdiv counts them once.
PeerTags random_tags(const Mesh& mesh, const PeerTexture& texture, bool fractional, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> real(0.05F, 3.5F);
  PeerTags tags;
  const auto sharpness = [&] {
    return fractional ? real(random) : random() % 2 == 0 ? 10.0F : 1.0F + random() % 3;
  };
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h);
    if (twin == kNone || random() % 3 != 0) continue;
    if (texture.of_corner[at(h)] != texture.of_corner[at(mesh.next(twin))] ||
        texture.of_corner[at(mesh.next(h))] != texture.of_corner[at(twin)])
      continue;
    tags.edges.push_back({mesh.origin(h), mesh.target(h)});
    tags.edge_sharpness.push_back(sharpness());
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (random() % 10 != 0) continue;
    tags.corners.push_back(v);
    tags.corner_sharpness.push_back(sharpness());
  }
  return tags;
}

Sharpness sharpness_of(const Mesh& mesh, const PeerTags& tags) {
  Sharpness result;
  EXPECT_TRUE(apply_tags(mesh, {}, stated_by(tags), result).ok());
  if (tags.boundary == 2) apply_boundary_mode(mesh, BoundaryMode::edge_and_corner, result);
  return result;
}

/// The mesh cut at seams, in the space of u, v and a coordinate.
Polygons unfolded(const Polygons& mesh, TextureCoordinates texture) {
  join_equal_points(mesh, texture);
  Polygons result;
  result.face_begin = mesh.face_begin;
  std::map<std::pair<Index, Index>, Index> number;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const Index v = mesh.corners[c], point = texture.of_corner[c];
    const auto [found, fresh] = number.try_emplace({v, point}, result.vertex_count());
    if (fresh) {
      const Point3 p = mesh.positions[at(v)];
      const TexturePoint t = texture.points[at(point)];
      result.positions.push_back({t.u, t.v, 0.71 * p.x + 0.37 * p.y + 0.53 * p.z});
    }
    result.corners.push_back(found->second);
  }
  return result;
}

TextureCoordinates coordinates_of(const PeerTexture& texture) {
  TextureCoordinates result;
  for (const auto& [u, v] : texture.points) result.points.push_back({u, v});
  result.of_corner = texture.of_corner;
  return result;
}

std::string difference_of(Method method, const Polygons& control, const PeerTags& tags,
                          const PeerTexture& texture, int level, double tolerance) {
  const Mesh mesh = Mesh::build(control).value();
  const PeerTextured peer = opensubdiv_textured(method, control, tags, texture, level);
  MeshAttributes attributes;
  attributes.texture = coordinates_of(texture);
  SurfaceOptions options{.levels = level};
  options.sharpness = sharpness_of(mesh, tags);
  options.attributes = &attributes;
  options.attribute_rules.texture = static_cast<TextureRule>(texture.rule);
  const auto fine = refine_surface(scheme_of(method), mesh, control.positions, options);
  if (!fine) return fine.error().text();
  return difference(unfolded(fine->polygons, fine->attributes.texture),
                    unfolded(peer.polygons, coordinates_of(peer.texture)), tolerance);
}

/// Of the mesh refined in two parts: the second takes what the first has made.
std::string difference_in_parts(Method method, const Polygons& control,
                                const PeerTexture& texture) {
  MeshAttributes attributes;
  attributes.texture = coordinates_of(texture);
  SurfaceOptions options{.levels = 2};
  options.attributes = &attributes;
  options.attribute_rules.texture = static_cast<TextureRule>(texture.rule);
  const auto once =
      refine_surface(scheme_of(method), Mesh::build(control).value(), control.positions, options);
  options.levels = 1;
  const auto half =
      refine_surface(scheme_of(method), Mesh::build(control).value(), control.positions, options);
  options.attributes = &half->attributes;
  const auto twice = refine_surface(scheme_of(method), Mesh::build(half->polygons).value(),
                                    half->polygons.positions, options);
  return difference(unfolded(twice->polygons, twice->attributes.texture),
                    unfolded(once->polygons, once->attributes.texture), 1e-12);
}

std::vector<ControlMesh> meshes_for(Method method) {
  std::vector<ControlMesh> all = method == Method::loop ? closed_triangles() : closed_polygons();
  for (ControlMesh& mesh : method == Method::loop ? open_triangles() : open_polygons())
    all.push_back(std::move(mesh));
  std::erase_if(all, [](const ControlMesh& mesh) { return mesh.polygons.face_count() > 100; });
  return all;
}

class Textured : public ::testing::TestWithParam<std::tuple<Method, int>> {
 protected:
  static Method method() { return std::get<0>(GetParam()); }

  enum class Sharp { none, whole, fractional };
  static void compare(Sharp sharp, bool merged, double tolerance, int boundary = 1) {
    unsigned seed = 100;
    for (const ControlMesh& control : meshes_for(method())) {
      const Mesh mesh = Mesh::build(control.polygons).value();
      for (const double share : {0.0, 0.1, 0.35, 1.0}) {
        PeerTexture texture = random_texture(mesh, share, merged, ++seed);
        texture.rule = std::get<1>(GetParam());
        PeerTags tags;
        if (sharp != Sharp::none)
          tags = random_tags(mesh, texture, sharp == Sharp::fractional, seed);
        tags.boundary = boundary;
        for (int level = 1; level <= 3; ++level)
          EXPECT_EQ(difference_of(method(), control.polygons, tags, texture, level, tolerance), "")
              << control.name << ", share " << share << ", level " << level;
      }
    }
  }
};

TEST_P(Textured, Seams) { compare(Sharp::none, false, 1e-12); }
TEST_P(Textured, PointsOnBothSidesOfSeams) { compare(Sharp::none, true, 1e-12); }
TEST_P(Textured, RefinedInParts) {
  unsigned seed = 1;
  for (const ControlMesh& control : meshes_for(method()))
    for (const double share : {0.1, 0.35}) {
      PeerTexture texture =
          random_texture(Mesh::build(control.polygons).value(), share, true, ++seed);
      texture.rule = std::get<1>(GetParam());
      EXPECT_EQ(difference_in_parts(method(), control.polygons, texture), "")
          << control.name << ", share " << share;
    }
}
TEST_P(Textured, BoundaryCorners) { compare(Sharp::none, false, 1e-12, 2); }
TEST_P(Textured, InfiniteAndIntegerSharpness) { compare(Sharp::whole, false, 1e-12); }
TEST_P(Textured, FractionalSharpness) { compare(Sharp::fractional, false, 1e-6); }

INSTANTIATE_TEST_SUITE_P(
    OpenSubdiv, Textured,
    ::testing::Combine(::testing::Values(Method::loop, Method::catmull_clark),
                       ::testing::Range(0, 6)),
    [](const auto& one) {
      return std::string(std::get<0>(one.param) == Method::loop ? "Loop" : "CatmullClark") +
             texture_rules()[static_cast<std::size_t>(std::get<1>(one.param))].first;
    });

}  // namespace
}  // namespace limn::peers
