// Limit points of dual schemes by the quick engine, beside those that the plain way finds on the
// same refined mesh.

#include "fast/fast_limit_check.h"
#include "mesh/random_mesh.h"
#include "refine/dual_rules.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// Of the face alone, with weights of its own for few and for many corners.
const Scheme& near_rules() {
  static const Scheme scheme = rules_on("quad-dual", R"toml(
[[corner]]
when = "n < 5"
round = "((k == 0)*n/4 + 5/8 + cos(2*pi*k/n)/3 + cos(4*pi*k/n)/11)/n + (k == 0)/8"

[[corner]]
round = "((k == 0)*n/2 + 1/2 + cos(2*pi*k/n)/9)/n"
)toml");
  return scheme;
}

const Scheme& wide_rules() {
  static const Scheme scheme = rules_on("quad-dual", kWider);
  return scheme;
}
const Scheme& far_rules() {
  static const Scheme scheme = rules_on("quad-dual", kFar);
  return scheme;
}

enum class Outcome { none, same, refused };

template <class Real>
Outcome expect_same_limit(const Scheme& scheme, const Mesh& control, int levels) {
  const bool exact = sizeof(Real) == 8;
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const std::vector<Point3> points = random_points(control.vertex_count(), 4);
  LimitOptions options;
  options.steps_made = levels;
  const auto found = approx_fast_limit(scheme, refiner);
  if (!found) {
    const auto plain = refine::refine(scheme, control, points, levels).value();
    EXPECT_FALSE(approx_limit_points(scheme, plain.mesh, plain.values, options).ok());
    return Outcome::refused;
  }
  if (!*found) return Outcome::none;
  const std::vector<Point3> values = as_points(evaluate<double>(refiner, points));
  const Mesh fine = Mesh::build(refined_polygons(refiner, values)).value();
  const LimitPoints expected = approx_limit_points(scheme, fine, values, options).value();
  expect_limit<Real>(refiner, **found, points, expected, exact ? 1e-12 : 1e-5, exact ? 1e-9 : 1e-2);
  return Outcome::same;
}

/// Meshes that do not grow, and at level 0 those with an inner vertex of valence 2.
bool is_left_out(const Mesh& mesh, int levels) {
  if (boundary_edges(mesh) == mesh.edge_count()) return true;
  bool thin = false;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    thin = thin || (mesh.valence(v) == 2 && !mesh.is_boundary_vertex(v));
  return thin && levels == 0;
}

/// Over so many sides.
Mesh pyramid(Index sides) {
  Faces faces(1);
  for (Index i = 0; i < sides; ++i) {
    faces.front().insert(faces.front().begin(), i);
    faces.push_back({i, (i + 1) % sides, sides});
  }
  return must_build(sides + 1, faces);
}

std::vector<Mesh> bodies() {
  return {tetrahedron(),
          cube(),
          icosahedron(),
          pyramid(7),
          mesh::torus(Lattice::quad, 3, 4),
          mesh::torus(Lattice::triangle, 3, 4)};
}

std::vector<Mesh> open_meshes() {
  std::vector<Mesh> meshes{must_build(6, {{0, 1, 2, 3}, {1, 0, 4, 5}}),
                           must_build(8, {{0, 1, 2, 3, 4}, {1, 0, 5, 6}}), band(5, 1), band(4, 2),
                           mesh::tree(Lattice::quad, 2)};
  for (const Index n : {3, 4, 7}) {
    meshes.push_back(mesh::star(Lattice::triangle, n, 2));
    meshes.push_back(mesh::star(Lattice::quad, n, 1));
    meshes.push_back(mesh::fan(Lattice::quad, n - 2, 2));
    meshes.push_back(mesh::face_star(n, 2));
  }
  return meshes;
}

void expect_same_everywhere(const Scheme& scheme, int levels) {
  SCOPED_TRACE(levels);
  for (const std::vector<Mesh>& meshes : {bodies(), open_meshes()})
    for (const Mesh& mesh : meshes)
      EXPECT_EQ(expect_same_limit<double>(scheme, mesh, levels), Outcome::same);
}

TEST(FastDualLimit, IsThePlainOneAtEveryLevel) {
  for (int levels = 0; levels <= 3; ++levels) expect_same_everywhere(shipped("doo-sabin"), levels);
}

TEST(FastDualLimit, IsThePlainOneForOtherRulesOfTheFaceAlone) {
  expect_same_everywhere(near_rules(), 2);
}

TEST(FastDualLimit, IsThePlainOneOnRandomMeshes) {
  const Scheme& scheme = shipped("doo-sabin");
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const auto levels = static_cast<int>(seed % 4);
    const Mesh mesh = RandomMesh(seed).polygons();
    const Outcome expected = is_left_out(mesh, levels) ? Outcome::none : Outcome::same;
    EXPECT_EQ(expect_same_limit<double>(scheme, mesh, levels), expected);
    EXPECT_EQ(expect_same_limit<float>(scheme, mesh, levels), expected);
  }
}

/// A step later all vertices have limits.
TEST(FastDualLimit, IsThereAfterAStepWhereVerticesHaveTwoFaces) {
  for (const Index sides : {3, 5})
    for (int levels = 0; levels <= 3; ++levels)
      EXPECT_EQ(expect_same_limit<double>(shipped("doo-sabin"), pillow(sides), levels),
                levels > 0 ? Outcome::same : Outcome::none);
}

/// Once patches are as large as the zones.
TEST(FastDualLimit, IsThereForRulesThatLookBeyondTheFace) {
  for (const auto& [scheme, first] : {std::pair{&wide_rules(), 3}, std::pair{&far_rules(), 4}})
    for (const Mesh& mesh : bodies()) {
      const bool regular = mesh.uniform_degree() == 4 && mesh.max_valence() == 4;
      for (int levels = first - 1; levels <= first; ++levels) {
        SCOPED_TRACE(levels);
        EXPECT_EQ(expect_same_limit<double>(*scheme, mesh, levels),
                  regular || levels == first ? Outcome::same : Outcome::none);
      }
    }
}

/// Such rules have no limit points at the boundary, by any engine.
TEST(FastDualLimit, IsNotThereAtTheBoundaryForRulesThatLookBeyondTheFace) {
  const Mesh mesh = band(4, 2);
  EXPECT_EQ(expect_same_limit<double>(wide_rules(), mesh, 4), Outcome::none);
  const auto fine =
      refine::refine(wide_rules(), mesh, random_points(mesh.vertex_count(), 1), 1).value();
  EXPECT_FALSE(approx_limit_points(wide_rules(), fine.mesh, fine.values).ok());
}

TEST(FastDualLimit, IsTheSameBitsOnOneThreadAndMany) {
  expect_same_limit_bits(shipped("doo-sabin"), mesh::star(Lattice::triangle, 7, 9), 4);
}

}  // namespace
}  // namespace limn::test
