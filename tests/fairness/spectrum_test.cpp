#include "limn/fairness/spectrum.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "limn/fairness/laplacian.h"
#include "mesh/random_mesh.h"

namespace limn::test {
namespace {

using std::numbers::pi;

void expect_near(const std::vector<double>& values, const std::vector<double>& expected,
                 double tolerance) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], tolerance) << i;
}

/// The modes are eigenvectors, and orthonormal with valences as weights.
void expect_modes(const Mesh& mesh, const fairness::LaplacianModes& modes, double tolerance) {
  const Eigen::MatrixXd residual =
      fairness::laplacian_matrix(mesh) * modes.modes -
      modes.modes * Eigen::Map<const Eigen::VectorXd>(modes.eigenvalues.data(),
                                                      static_cast<Index>(modes.eigenvalues.size()))
                        .asDiagonal();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), tolerance);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v)) weights[v] = mesh.valence(v);
  const Eigen::MatrixXd gram = modes.modes.transpose() * weights.asDiagonal() * modes.modes;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).norm(), tolerance);
}

/// Eigenvalues of the Laplacian of a torus, sorted: one for each wave.
std::vector<double> torus_spectrum(Lattice lattice, Index nx, Index ny) {
  std::vector<double> values;
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const double a = 2 * pi * i / nx;
      const double b = 2 * pi * j / ny;
      values.push_back(lattice == Lattice::triangle
                           ? 1 - (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3
                           : 1 - (std::cos(a) + std::cos(b)) / 2);
    }
  std::sort(values.begin(), values.end());
  return values;
}

TEST(Spectrum, OfThePlatonicSolidsIsKnown) {
  const auto spectrum = [](const Mesh& mesh) {
    const fairness::LaplacianModes all = fairness::approx_all_modes(mesh).value();
    expect_modes(mesh, all, 1e-13);
    return all.eigenvalues;
  };
  const double root = 1 / std::sqrt(5.0);
  const double third = 1.0 / 3;
  expect_near(spectrum(tetrahedron()), {0, 4 * third, 4 * third, 4 * third}, 1e-14);
  expect_near(spectrum(cube()),
              {0, 2 * third, 2 * third, 2 * third, 4 * third, 4 * third, 4 * third, 2}, 1e-14);
  expect_near(spectrum(must_build(6, {{0, 2, 4},
                                      {2, 1, 4},
                                      {1, 3, 4},
                                      {3, 0, 4},
                                      {2, 0, 5},
                                      {1, 2, 5},
                                      {3, 1, 5},
                                      {0, 3, 5}})),
              {0, 1, 1, 1, 1.5, 1.5}, 1e-14);
  expect_near(
      spectrum(icosahedron()),
      {0, 1 - root, 1 - root, 1 - root, 1.2, 1.2, 1.2, 1.2, 1.2, 1 + root, 1 + root, 1 + root},
      1e-14);
}

TEST(Spectrum, OfToriIsThatOfWaves) {
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    const Mesh small = mesh::torus(lattice, 5, 7);
    expect_near(fairness::approx_all_modes(small)->eigenvalues, torus_spectrum(lattice, 5, 7),
                1e-13);
    // of the same size in both directions, so that most eigenvalues come several times
    const Mesh large = mesh::torus(lattice, 48, 48);
    const std::vector<double> waves = torus_spectrum(lattice, 48, 48);
    for (const int count : {1, 2, 5, 20}) {
      if (!fairness::spectra_available()) break;
      const fairness::LaplacianModes low =
          fairness::approx_modes(large, fairness::SpectrumEnd::smallest, count).value();
      expect_near(low.eigenvalues, {waves.begin(), waves.begin() + count}, 1e-10);
      expect_modes(large, low, 1e-7);
      const fairness::LaplacianModes high =
          fairness::approx_modes(large, fairness::SpectrumEnd::largest, count).value();
      expect_near(high.eigenvalues, {waves.end() - count, waves.end()}, 1e-10);
      expect_modes(large, high, 1e-7);
    }
  }
}

TEST(Spectrum, CountsComponentsAndBipartiteOnes) {
  Faces faces;
  Index first = 0;
  for (const Mesh& part : {mesh::torus(Lattice::quad, 20, 20), mesh::torus(Lattice::quad, 20, 14),
                           mesh::torus(Lattice::triangle, 12, 12)}) {
    for (auto face : faces_of(polygons_of(part))) {
      for (Index& corner : face) corner += first;
      faces.push_back(face);
    }
    first += part.vertex_count();
  }
  const Mesh mesh = must_build(first + 1, faces);  // and an isolated vertex
  if (!fairness::spectra_available()) GTEST_SKIP();
  const std::vector<double> low =
      fairness::approx_modes(mesh, fairness::SpectrumEnd::smallest, 6)->eigenvalues;
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(low[static_cast<std::size_t>(i)], 0, 1e-12);
  EXPECT_GT(low[4], 1e-3);
  const std::vector<double> high =
      fairness::approx_modes(mesh, fairness::SpectrumEnd::largest, 3)->eigenvalues;
  EXPECT_LT(high[0], 2 - 1e-3);
  EXPECT_NEAR(high[1], 2, 1e-12);
  EXPECT_NEAR(high[2], 2, 1e-12);
}

TEST(Spectrum, OfRandomMeshesIsThatOfTheDenseSolver) {
  if (!fairness::spectra_available()) GTEST_SKIP();
  const Mesh mesh = mesh::star(Lattice::triangle, 7, 10);  // 386 vertices, with a boundary
  const std::vector<double> all = fairness::approx_all_modes(mesh)->eigenvalues;
  EXPECT_GE(all.front(), -1e-14);
  EXPECT_LE(all.back(), 2);
  expect_near(fairness::approx_modes(mesh, fairness::SpectrumEnd::smallest, 40)->eigenvalues,
              {all.begin(), all.begin() + 40}, 1e-10);
  expect_near(fairness::approx_modes(mesh, fairness::SpectrumEnd::largest, 40)->eigenvalues,
              {all.end() - 40, all.end()}, 1e-10);
}

TEST(Amplitudes, SumToTheWholeAndFindASingleWave) {
  const Mesh mesh = mesh::star(Lattice::triangle, 5, 3);  // of several valences
  const fairness::LaplacianModes all = fairness::approx_all_modes(mesh).value();
  std::vector<Point3> points;
  double whole = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    points.push_back({std::sin(v), std::cos(3 * v), 1.0 * (v % 3)});
    whole += mesh.valence(v) * dot(points.back(), points.back());
  }
  double sum = 0;
  for (const double amplitude : fairness::approx_amplitudes(mesh, all, points))
    sum += amplitude * amplitude;
  EXPECT_NEAR(sum, whole, 1e-10 * whole);
  for (Index v = 0; v < mesh.vertex_count(); ++v) points[v] = {0, 2 * all.modes(v, 7), 0};
  const std::vector<double> one = fairness::approx_amplitudes(mesh, all, points);
  for (std::size_t j = 0; j < one.size(); ++j) EXPECT_NEAR(one[j], j == 7 ? 2 : 0, 1e-12);
}

TEST(Spectrum, TakesWhatThereIs) {
  EXPECT_EQ(
      fairness::approx_modes(cube(), fairness::SpectrumEnd::smallest, 100)->eigenvalues.size(), 8U);
  EXPECT_EQ(fairness::approx_modes(cube(), fairness::SpectrumEnd::largest, 3)->eigenvalues.size(),
            3U);
  EXPECT_TRUE(fairness::approx_all_modes(must_build(0, {}))->eigenvalues.empty());
  const Result<fairness::LaplacianModes> refused =
      fairness::approx_all_modes(mesh::torus(Lattice::quad, 50, 50));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("2500"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
