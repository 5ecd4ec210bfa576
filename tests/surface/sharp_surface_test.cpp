// Surfaces of meshes with sharpness, holes and attributes: the quick engine's are the plain one's,
// its vertices and faces in another order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <set>

#include "limn/fast/fast_refiner.h"
#include "limn/surface/refine_surface.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

using Numbers = std::vector<double>;

double rounded(double x, double parts = 1e8) { return std::round(x * parts) / parts; }
void add(Numbers& list, const Point3& p, double parts = 1e8) {
  for (const double x : {p.x, p.y, p.z}) list.push_back(rounded(x, parts));
}

/// All that a surface says of its corners: the point, and what is asked for there.
std::multiset<Numbers> corners(const RefinedSurface& surface) {
  const Polygons& mesh = surface.polygons;
  const MeshAttributes& attributes = surface.attributes;
  const FaceLabels& groups = attributes.of(LabelKind::group);
  std::multiset<Numbers> all;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index c = mesh.face_begin[at(f)]; c < mesh.face_begin[at(f) + 1]; ++c) {
      Numbers one;
      const auto v = at(mesh.corners[at(c)]);
      add(one, mesh.positions[v]);
      if (!surface.limit.empty()) add(one, surface.limit[v]);
      // where the normal at a corner is that of the faces there, rounding of points grows to 1e-6
      if (!surface.normals.empty()) add(one, surface.normals[v], 1e4);
      for (const VertexNumbers& numbers : attributes.vertices)
        one.push_back(rounded(numbers.values[v]));
      if (!attributes.texture.empty()) {
        const Index point = attributes.texture.of_corner[at(c)];
        one.push_back(point == kNone ? -7 : rounded(attributes.texture.points[at(point)].u));
        one.push_back(point == kNone ? -7 : rounded(attributes.texture.points[at(point)].v));
      }
      if (!groups.empty()) one.push_back(groups.of_face[at(f)]);
      all.insert(std::move(one));
    }
  return all;
}

/// What is sharp, by positions.
std::map<std::set<Numbers>, double> sharp(const RefinedSurface& surface) {
  std::map<std::set<Numbers>, double> all;
  const auto place = [&](Index v) {
    Numbers point;
    add(point, surface.polygons.positions[at(v)]);
    return point;
  };
  for (const auto& crease : surface.sharp.creases)
    all[{place(crease.vertices.at(0)), place(crease.vertices.at(1))}] = crease.sharpness.at(0);
  for (const auto& corner : surface.sharp.corners) all[{place(corner.vertex)}] = corner.sharpness;
  return all;
}

struct Control {
  Mesh mesh;
  std::vector<Point3> points;
  Sharpness sharpness;
  MeshAttributes attributes;
};

/// A random mesh without the vertices of valence 2 that some schemes have no rule for; three of ten
/// edges are sharp in different ways, two of ten faces holes; seams wherever corners at a vertex
/// name different points; one of ten faces has no texture.
Control control_of(const Scheme& scheme, unsigned seed, bool fades) {
  Control control;
  for (unsigned more = 0;; more += 1000) {
    control.mesh = random_control(*scheme.split, seed + more);
    bool good = is_simple(control.mesh);
    for (Index v = 0; v < control.mesh.vertex_count(); ++v)
      good = good && (control.mesh.is_isolated(v) || control.mesh.is_boundary_vertex(v) ||
                      control.mesh.valence(v) >= 3);
    if (good) break;
  }
  const Mesh& mesh = control.mesh;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto value = [&] {
    if (!fades) return kInfinitelySharp;
    return std::vector<double>{0.5, 1, 1.5, 2}.at(random() % 4);
  };
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    control.points.push_back({unit(random), unit(random), unit(random)});
    control.sharpness.vertices.push_back(unit(random) < 0.1 ? value() : 0);
  }
  for (Index e = 0; e < mesh.edge_count(); ++e)
    control.sharpness.edges.push_back(unit(random) < 0.3 ? value() : 0);
  for (Index f = 0; f < mesh.face_count(); ++f)
    control.sharpness.holes.push_back(f > 0 && unit(random) < 0.2);
  MeshAttributes& attributes = control.attributes;
  for (const char* const name : {"a", "b", "c", "d"}) {
    attributes.vertices.push_back({name, NumberType::float64, {}});
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      attributes.vertices.back().values.push_back(unit(random));
  }
  for (Index i = 0; i < 2 * mesh.vertex_count(); ++i)
    attributes.texture.points.push_back({unit(random), unit(random)});
  FaceLabels& groups = attributes.of(LabelKind::group);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    groups.names.push_back(std::to_string(f));
    groups.of_face.push_back(f);
    const bool without = unit(random) < 0.1, second = unit(random) < 0.3;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
      const Index v = mesh.origin(h) + (second ? mesh.vertex_count() : 0);
      attributes.texture.of_corner.push_back(without ? kNone : v);
    }
  }
  return control;
}

class SharpSurface : public ::testing::TestWithParam<std::string> {
 protected:
  /// Returns whether the quick engine refined it.
  static bool compare(const Scheme& scheme, const Control& control, SurfaceOptions options) {
    options.sharpness = control.sharpness;
    const bool quick = is_quick(scheme, control.mesh, options);
    const auto fast = refine_surface(scheme, control.mesh, control.points, options);
    options.engine = SurfaceOptions::Engine::plain;
    const auto plain = refine_surface(scheme, control.mesh, control.points, options);
    EXPECT_EQ(fast.ok(), plain.ok());
    if (!fast || !plain) {
      if (fast.ok() == plain.ok()) EXPECT_EQ(fast.error().text(), plain.error().text());
      return false;
    }
    EXPECT_EQ(fast->polygons.positions.size(), plain->polygons.positions.size());
    const std::multiset<Numbers> a = corners(*fast), b = corners(*plain);
    std::vector<Numbers> first, second;  // what one has and the other has not
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(first));
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(second));
    EXPECT_EQ(first, second);
    EXPECT_EQ(sharp(*fast), sharp(*plain));
    return quick;
  }
};

TEST_P(SharpSurface, IsTheSameByBothEngines) {
  const Scheme scheme = shipped(GetParam());
  int quick = 0;
  for (unsigned seed = 1; seed < 13; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Control control = control_of(scheme, seed, seed % 2 == 0);
    SurfaceOptions options{.levels = static_cast<int>(seed % 4)};
    if (compare(scheme, control, options)) ++quick;
  }
  EXPECT_GT(quick, 8);
}

TEST_P(SharpSurface, CarriesItsAttributesByBothEngines) {
  const Scheme scheme = shipped(GetParam());
  const std::vector<TextureRule> rules{TextureRule::none,          TextureRule::corners_only,
                                       TextureRule::corners_plus1, TextureRule::corners_plus2,
                                       TextureRule::boundaries,    TextureRule::all};
  int quick = 0;
  for (unsigned seed = 1; seed < 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Control control = control_of(scheme, seed, seed % 2 == 0);
    SurfaceOptions options{.levels = static_cast<int>(seed % 4)};
    options.attributes = &control.attributes;
    options.attribute_rules.texture = rules[seed % rules.size()];
    if (compare(scheme, control, options)) ++quick;
  }
  EXPECT_GT(quick, 10);
}

/// Of rules with small neighbourhoods: of others the plain way takes long.
class SharpLimit : public SharpSurface {};

TEST_P(SharpLimit, IsTheSameByBothEngines) {
  const Scheme scheme = shipped(GetParam());
  for (unsigned seed = 1; seed < 9; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Control control = control_of(scheme, seed, seed % 2 == 0);
    SurfaceOptions options{.levels = seed % 2 == 0 ? 4 : 3, .limit = true};
    options.normals = seed % 4 < 2;
    options.partial = true;
    compare(scheme, control, options);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, SharpSurface,
                         ::testing::Values("loop", "catmull-clark", "butterfly-modified",
                                           "kobbelt-quad"),
                         [](const auto& one) { return test_name(one.param); });
INSTANTIATE_TEST_SUITE_P(Schemes, SharpLimit,
                         ::testing::Values("loop", "catmull-clark", "laplacian-loop"),
                         [](const auto& one) { return test_name(one.param); });

}  // namespace
}  // namespace limn::test
