#include "limn/fairness/laplacian.h"

#include <gtest/gtest.h>

#include <set>

#include "sampled.h"

namespace limn::test {
namespace {

/// I − H A from the faces' edges alone.
Eigen::MatrixXd by_brute_force(const Mesh& mesh) {
  const Index n = mesh.vertex_count();
  Eigen::MatrixXd adjacency = Eigen::MatrixXd::Zero(n, n);
  for (const auto& face : faces_of(polygons_of(mesh)))
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % face.size()];
      adjacency(a, b) = adjacency(b, a) = 1;
    }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Index v = 0; v < n; ++v)
    if (const double valence = adjacency.row(v).sum(); valence > 0) {
      result.row(v) = -adjacency.row(v) / valence;
      result(v, v) = 1;
    }
  return result;
}

std::vector<Mesh> deck() {
  std::vector<Mesh> meshes{tetrahedron(),
                           cube(),
                           icosahedron(),
                           mesh::star(Lattice::triangle, 7, 2),
                           mesh::star(Lattice::quad, 3, 2),
                           mesh::torus(Lattice::quad, 4, 5)};
  meshes.push_back(must_build(5, {{0, 1, 2}}));  // two isolated vertices
  return meshes;
}

TEST(Laplacian, IsTheMatrixOfTheGraph) {
  for (const Mesh& mesh : deck()) {
    const Eigen::MatrixXd expected = by_brute_force(mesh);
    EXPECT_EQ((Eigen::MatrixXd(fairness::laplacian_matrix(mesh)) - expected).norm(), 0);
    const Eigen::VectorXd random = Eigen::VectorXd::Random(mesh.vertex_count());
    const std::vector<double> values(random.begin(), random.end());
    const std::vector<double> moved = fairness::laplacian(mesh, values);
    const std::vector<double> smooth = fairness::low_pass(mesh, values);
    const Eigen::VectorXd product = expected * random;
    for (std::size_t v = 0; v < values.size(); ++v) {
      EXPECT_NEAR(moved[v], product[static_cast<Index>(v)], 1e-14);
      EXPECT_NEAR(smooth[v], values[v] - moved[v] / 2, 1e-14);
    }
  }
}

TEST(Laplacian, HasASymmetricForm) {
  for (const Mesh& mesh : deck()) {
    const Eigen::MatrixXd expected = by_brute_force(mesh);
    Eigen::VectorXd roots = Eigen::VectorXd::Ones(mesh.vertex_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (!mesh.is_isolated(v)) roots[v] = std::sqrt(mesh.valence(v));
    const Eigen::MatrixXd symmetric = fairness::symmetric_laplacian_matrix(mesh);
    EXPECT_NEAR((symmetric - symmetric.transpose()).norm(), 0, 1e-15);
    EXPECT_NEAR(
        (symmetric - roots.asDiagonal() * expected * roots.cwiseInverse().asDiagonal()).norm(), 0,
        1e-13);
  }
}

TEST(Laplacian, LowPassKeepsConstantsAndRemovesTheHighestFrequency) {
  const Mesh mesh = mesh::torus(Lattice::quad, 6, 4);  // bipartite
  const std::vector<double> constant(24, 3.0);
  std::vector<double> alternating;
  for (int v = 0; v < 24; ++v) alternating.push_back((v % 6 + v / 6) % 2 == 0 ? 1 : -1);
  for (const double value : fairness::low_pass(mesh, constant)) EXPECT_NEAR(value, 3, 1e-15);
  for (const double value : fairness::low_pass(mesh, alternating)) EXPECT_NEAR(value, 0, 1e-15);
}

TEST(LaplacianEnergy, IsTheSumOverWhatIsNotBoundary) {
  const Mesh mesh = mesh::star(Lattice::triangle, 6, 1);  // one vertex inside
  std::vector<Point3> points(7);
  points[0] = {1, 2, 2};
  points[1] = {6, 0, 0};
  EXPECT_NEAR(fairness::laplacian_energy(mesh, points), 0 + 4 + 4, 1e-14);
  // L of linear functions vanishes inside a regular mesh, though not on its boundary
  const Mesh large = mesh::star(Lattice::triangle, 6, 3);
  std::vector<Point3> flat;
  for (Index v = 0; v < large.vertex_count(); ++v) flat.push_back({});
  EXPECT_EQ(fairness::laplacian_energy(large, flat), 0);
  EXPECT_EQ(
      fairness::laplacian_energy(must_build(4, {{0, 1, 2}}), std::vector<Point3>(4, {1, 1, 1})), 0);
}

TEST(LaplacianEnergy, FallsAsTheSquareOfTheMeshWidth) {
  const auto energy = [](Index n) {
    const Sampled torus = sampled_tube({2, 1}, Lattice::triangle, n);
    return fairness::laplacian_energy(torus.mesh, torus.points);
  };
  EXPECT_NEAR(energy(32) / energy(64), 4, .05);
}

}  // namespace
}  // namespace limn::test
