// Limit points of dual schemes by the quick engine, beside those that the plain way finds on the
// same refined mesh.

#include "limn/base/parallel.h"
#include "limn/extraordinary/fast_limit.h"
#include "limn/extraordinary/limit_points.h"
#include "mesh/random_mesh.h"
#include "refine/fast_check.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Scheme parsed(const std::string& rules) {
  return parse_scheme("split = \"quad-dual\"\nsource = \"a test\"\n" + rules, "test.toml").value();
}

/// Of the face alone, with weights of its own for few and for many corners.
const Scheme& near_rules() {
  static const Scheme scheme = parsed(R"toml(
[[corner]]
when = "n < 5"
round = "((k == 0)*n/4 + 5/8 + cos(2*pi*k/n)/3 + cos(4*pi*k/n)/11)/n + (k == 0)/8"

[[corner]]
round = "((k == 0)*n/2 + 1/2 + cos(2*pi*k/n)/9)/n"
)toml");
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
    const auto plain = refine(scheme, control, points, levels).value();
    EXPECT_FALSE(approx_limit_points(scheme, plain.mesh, plain.values, options).ok());
    return Outcome::refused;
  }
  if (!*found) return Outcome::none;
  const Result<Mesh> fine = Mesh::build(
      refined_polygons(refiner, as_points(evaluate<double>(refiner, points))));
  if (!fine) return Outcome::same;  // two edges between the same vertices
  const std::vector<Point3> values = as_points(evaluate<double>(refiner, points));
  const LimitPoints expected = approx_limit_points(scheme, *fine, values, options).value();
  std::vector<Real> positions(3 * values.size(), Real(7e7)), normals = positions;
  FastRefiner::Scratch<Real> scratch;
  refiner.evaluate_limit<Real>(**found, as_numbers<Real>(points), positions, normals, scratch);
  const std::vector<Point3> p = as_points(positions), n = as_points(normals);
  for (std::size_t v = 0; v < p.size(); ++v) {
    EXPECT_LT(distance(p[v], expected.positions[v]), exact ? 1e-12 : 1e-5) << v;
    EXPECT_LT(distance(n[v], expected.normals[v]), exact ? 1e-9 : 1e-2) << v;
  }
  return Outcome::same;
}

std::vector<Mesh> bodies() {
  return {tetrahedron(), cube(), icosahedron(), torus(Lattice::quad, 3, 4),
          torus(Lattice::triangle, 3, 4)};
}

std::vector<Mesh> open_meshes() {
  std::vector<Mesh> meshes{must_build(6, {{0, 1, 2, 3}, {1, 0, 4, 5}}),
                           must_build(8, {{0, 1, 2, 3, 4}, {1, 0, 5, 6}}), band(5, 1), band(4, 2),
                           tree(Lattice::quad, 2)};
  for (const Index n : {3, 4, 5, 9}) {
    meshes.push_back(star(Lattice::triangle, n, 2));
    meshes.push_back(star(Lattice::quad, n, 1));
    meshes.push_back(fan(Lattice::quad, n - 2, 2));
    meshes.push_back(face_star(n, 2));
  }
  return meshes;
}

TEST(FastDualLimit, IsThePlainOneAtEveryLevel) {
  for (const Scheme* scheme : {&shipped("doo-sabin"), &near_rules()})
    for (const std::vector<Mesh>& meshes : {bodies(), open_meshes()})
      for (const Mesh& mesh : meshes)
        for (int levels = 0; levels <= 3; ++levels) {
          SCOPED_TRACE(levels);
          EXPECT_EQ(expect_same_limit<double>(*scheme, mesh, levels), Outcome::same);
        }
}

TEST(FastDualLimit, IsThePlainOneOnRandomMeshes) {
  const Scheme& scheme = shipped("doo-sabin");
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const auto levels = static_cast<int>(seed % 4);
    const Mesh mesh = RandomMesh(seed).polygons();
    EXPECT_EQ(expect_same_limit<double>(scheme, mesh, levels), Outcome::same);
    EXPECT_EQ(expect_same_limit<float>(scheme, mesh, levels), Outcome::same);
  }
}

}  // namespace
}  // namespace limn::test
