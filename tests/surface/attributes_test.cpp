// What refinement makes of attributes: laws that hold for every scheme.

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

#include "limn/surface/refine_surface.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// A mesh with positions, and attributes that repeat them: x, y, z as numbers, (x, y) as texture
/// coordinates by vertex, and its own number as each face's group.
struct Repeating {
  Mesh mesh;
  std::vector<Point3> points;
  MeshAttributes attributes;
};

Repeating repeating(Mesh mesh, unsigned seed) {
  Repeating result{std::move(mesh), {}, {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (Index v = 0; v < result.mesh.vertex_count(); ++v)
    result.points.push_back({unit(random), unit(random), unit(random)});
  MeshAttributes& attributes = result.attributes;
  attributes.vertices = {{"a", NumberType::float64, {}},
                         {"b", NumberType::float64, {}},
                         {"c", NumberType::float64, {}},
                         {"d", NumberType::float64, {}}};
  for (const Point3& p : result.points) {
    attributes.texture.points.push_back({p.x, p.y});
    for (const auto& [k, value] : {std::pair{0U, p.x}, {1U, p.y}, {2U, p.z}, {3U, p.x}})
      attributes.vertices[k].values.push_back(value);
  }
  for (Index h = 0; h < result.mesh.halfedge_count(); ++h)
    attributes.texture.of_corner.push_back(result.mesh.origin(h));
  FaceLabels& groups = attributes.of(LabelKind::group);
  for (Index f = 0; f < result.mesh.face_count(); ++f) {
    groups.names.push_back(std::to_string(f));
    groups.of_face.push_back(f);
  }
  return result;
}

Mesh random_mesh(const Scheme& scheme, unsigned seed) {
  RandomMesh random(seed);
  if (scheme.split->lattice == Lattice::triangle) return random.triangles();
  const Mesh mesh = random.polygons();
  return scheme.split->any_polygons ? mesh : find_split("quad-dyadic")->apply(mesh, 0).mesh;
}

void expect_repeated(const RefinedSurface& fine, const std::string& what) {
  const MeshAttributes& got = fine.attributes;
  ASSERT_TRUE(attributes_fit(got, fine.polygons)) << what;
  ASSERT_EQ(got.vertices.size(), 4U);
  for (std::size_t v = 0; v < fine.polygons.positions.size(); ++v) {
    const Point3& p = fine.polygons.positions[v];
    EXPECT_EQ(got.vertices[0].values[v], p.x) << what;
    EXPECT_EQ(got.vertices[1].values[v], p.y) << what;
    EXPECT_EQ(got.vertices[2].values[v], p.z) << what;
    EXPECT_EQ(got.vertices[3].values[v], p.x) << what;
  }
  for (std::size_t c = 0; c < fine.polygons.corners.size(); ++c) {
    const Point3& p = fine.polygons.positions[at(fine.polygons.corners[c])];
    const TexturePoint t = got.texture.points[at(got.texture.of_corner[c])];
    EXPECT_EQ(t, (TexturePoint{p.x, p.y})) << what;
  }
}

class Attributes : public ::testing::TestWithParam<std::string> {};

TEST_P(Attributes, ThatRepeatPositionsAreRefinedLikeThem) {
  const Scheme& scheme = shipped(GetParam());
  int refined = 0;
  for (unsigned seed = 1; seed < 12; ++seed) {
    const Repeating control = repeating(random_mesh(scheme, seed), seed);
    SurfaceOptions options{.levels = 2};
    options.attributes = &control.attributes;
    options.attribute_rules.texture = TextureRule::none;
    for (const auto engine : {SurfaceOptions::Engine::quick, SurfaceOptions::Engine::plain}) {
      options.engine = engine;
      const auto fine = refine_surface(scheme, control.mesh, control.points, options);
      if (!fine) continue;  // no rule for this mesh
      ++refined;
      expect_repeated(*fine, GetParam() + ", seed " + std::to_string(seed));
    }
  }
  EXPECT_GT(refined, 1);
}

/// Faces by their middles, with their group.
using Middles = std::vector<std::tuple<double, double, double, Index>>;
Middles middles(const RefinedSurface& surface) {
  Middles list;
  const Polygons& mesh = surface.polygons;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Point3 sum;
    for (Index c = mesh.face_begin[at(f)]; c < mesh.face_begin[at(f) + 1]; ++c)
      sum = sum + mesh.positions[at(mesh.corners[at(c)])];
    const auto round = [&](double x) { return std::round(x / mesh.degree(f) * 1e8) / 1e8; };
    list.emplace_back(round(sum.x), round(sum.y), round(sum.z),
                      surface.attributes.of(LabelKind::group).of_face[at(f)]);
  }
  std::sort(list.begin(), list.end());
  return list;
}

TEST_P(Attributes, GroupsAreThoseOfTheControlFacesWhateverTheEngine) {
  const Scheme& scheme = shipped(GetParam());
  for (unsigned seed = 1; seed < 12; ++seed) {
    Repeating control = repeating(random_mesh(scheme, seed), seed);
    control.attributes.texture = {};
    for (int levels = 0; levels <= 3; ++levels) {
      SurfaceOptions options{.levels = levels};
      options.attributes = &control.attributes;
      const auto quick = refine_surface(scheme, control.mesh, control.points, options);
      options.engine = SurfaceOptions::Engine::plain;
      const auto plain = refine_surface(scheme, control.mesh, control.points, options);
      ASSERT_EQ(quick.ok(), plain.ok());
      if (!plain) break;
      EXPECT_EQ(middles(*quick), middles(*plain)) << GetParam() << ", seed " << seed;
      if (scheme.split->is_dual() || scheme.split->boundary_rests()) continue;
      std::map<Index, double> count;
      for (const Index f : plain->attributes.of(LabelKind::group).of_face) ++count[f];
      for (Index f = 0; f < control.mesh.face_count(); ++f) {
        const double first = scheme.split->births.faces && !scheme.split->births.thirds
                                 ? control.mesh.degree(f)
                                 : scheme.split->dilation.growth();
        const double expected =
            levels == 0 ? 1 : first * std::pow(scheme.split->dilation.growth(), levels - 1);
        EXPECT_EQ(count[f], expected) << GetParam() << ", level " << levels;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Attributes,
                         ::testing::Values("loop", "catmull-clark", "butterfly", "sqrt3",
                                           "doo-sabin", "four-eight", "midedge", "loop-ternary",
                                           "kobbelt-quad"),
                         [](const auto& one) { return test_name(one.param); });

/// Two squares with a seam between them, u and v being x and y on either side.
Repeating two_squares() {
  Repeating result = repeating(must_build(6, {{0, 1, 2, 3}, {1, 4, 5, 2}}), 1);
  result.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  TextureCoordinates& texture = result.attributes.texture;
  texture = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 0}, {6, 0}, {6, 1}, {5, 1}},
             {0, 1, 2, 3, 4, 5, 6, 7},
             NumberType::float64};
  return result;
}

TEST(Texture, StaysOnEachSideOfASeam) {
  const Repeating control = two_squares();
  for (const auto& [name, rule] : texture_rules()) {
    SurfaceOptions options{.levels = 2};
    options.attributes = &control.attributes;
    options.attribute_rules.texture = rule;
    const RefinedSurface fine =
        refine_surface(shipped("catmull-clark"), control.mesh, control.points, options).value();
    const TextureCoordinates& texture = fine.attributes.texture;
    for (std::size_t c = 0; c < texture.of_corner.size(); ++c) {
      const bool right = fine.attributes.of(LabelKind::group).of_face[c / 4] == 1;
      const double u = texture.points[at(texture.of_corner[c])].u;
      EXPECT_GE(u, right ? 5 : 0) << name;
      EXPECT_LE(u, right ? 6 : 1) << name;
    }
  }
}

TEST(Texture, OfCornersThatStayFillsTheSquare) {
  const Repeating control = two_squares();
  SurfaceOptions options{.levels = 1};
  options.attributes = &control.attributes;
  options.attribute_rules.texture = TextureRule::corners_only;
  const RefinedSurface fine =
      refine_surface(shipped("catmull-clark"), control.mesh, control.points, options).value();
  for (const TexturePoint corner : control.attributes.texture.points)
    EXPECT_EQ(std::count(fine.attributes.texture.points.begin(),
                         fine.attributes.texture.points.end(), corner),
              1);
}

TEST(Texture, WithSeamsIsRefusedBySchemesThatCannotCut) {
  const Repeating control = two_squares();
  const auto said = [&](const Scheme& scheme, TextureRule rule) {
    const Status status =
        check_takes_texture(scheme, control.mesh, control.attributes.texture, rule);
    return status ? "" : status.error().text();
  };
  EXPECT_NE(said(shipped("doo-sabin"), TextureRule::none).find("lie across old edges"),
            std::string::npos);
  EXPECT_NE(said(shipped("four-eight"), TextureRule::all).find("--attributes none"),
            std::string::npos);
  const Scheme bare = parse_scheme(
                          "name = \"bare\"\nsplit = \"quad-dyadic\"\n[face]\ncorner = \"1/n\"\n"
                          "[edge]\nend = \"1/2\"\n[vertex]\nself = \"1\"\n",
                          "bare.toml")
                          .value();
  EXPECT_NE(said(bare, TextureRule::corners_plus1).find("--uv all"), std::string::npos);
  EXPECT_EQ(said(bare, TextureRule::all), "");
  EXPECT_EQ(said(shipped("catmull-clark"), TextureRule::none), "");
}

TEST(Texture, OfSomeFacesAloneStaysTheirs) {
  Repeating control = two_squares();
  for (std::size_t c = 4; c < 8; ++c) control.attributes.texture.of_corner[c] = kNone;
  SurfaceOptions options{.levels = 2};
  options.attributes = &control.attributes;
  const RefinedSurface fine =
      refine_surface(shipped("catmull-clark"), control.mesh, control.points, options).value();
  ASSERT_TRUE(attributes_fit(fine.attributes, fine.polygons));
  for (std::size_t c = 0; c < fine.polygons.corners.size(); ++c)
    EXPECT_EQ(fine.attributes.texture.of_corner[c] == kNone,
              fine.attributes.of(LabelKind::group).of_face[c / 4] == 1);
}

TEST(Texture, AndNumbersOfHolesGoWithTheirFaces) {
  const Repeating control = two_squares();
  SurfaceOptions options{.levels = 1};
  options.attributes = &control.attributes;
  options.sharpness.holes = {true, false};
  const RefinedSurface fine =
      refine_surface(shipped("catmull-clark"), control.mesh, control.points, options).value();
  ASSERT_TRUE(attributes_fit(fine.attributes, fine.polygons));
  EXPECT_EQ(fine.polygons.face_count(), 4);
  for (const Index group : fine.attributes.of(LabelKind::group).of_face) EXPECT_EQ(group, 1);
}

}  // namespace
}  // namespace limn::test
