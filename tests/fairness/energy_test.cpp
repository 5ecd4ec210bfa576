#include "limn/fairness/energy.h"

#include "limn/fairness/laplacian.h"

#include <gtest/gtest.h>

#include <limits>

#include "limn/base/parallel.h"
#include "limn/fairness/second_form.h"
#include "sampled.h"

namespace limn::test {
namespace {

using std::numbers::pi;

SurfaceEnergies energies(const Sampled& surface) {
  return approx_energies(surface.mesh, surface.points).value();
}

/// The exponent p of errors like width^p, from meshes of width 1 and 1/2.
double order(double coarse, double fine, double exact) {
  return std::log2(std::abs(coarse - exact) / std::abs(fine - exact));
}

/// On two meshes, the second twice as fine: small errors that fall by four.
void expect_second_order(const Sampled& coarse, const Sampled& fine, const Densities& exact,
                         double tolerance) {
  const SurfaceEnergies a = energies(coarse);
  const SurfaceEnergies b = energies(fine);
  EXPECT_EQ(b.left_out, 0);
  EXPECT_NEAR(b.area, exact.area, tolerance * exact.area);
  EXPECT_NEAR(b.thin_plate, exact.thin_plate, tolerance * exact.thin_plate);
  EXPECT_NEAR(b.curvature_variation, exact.variation, tolerance * exact.variation + .03);
  EXPECT_NEAR(order(a.area, b.area, exact.area), 2, .1);
  EXPECT_NEAR(order(a.thin_plate, b.thin_plate, exact.thin_plate), 2, .25);
  if (exact.variation > 0)
    EXPECT_GT(order(a.curvature_variation, b.curvature_variation, exact.variation), 1.6);
}

TEST(SmoothSurface, IsMeasuredAsByHand) {
  // the torus: curvatures 1/r and cos v/(R + r cos v), of which the second varies along v alone
  const Densities torus = integrals(Tube{3, 1}, {0, 2 * pi}, {0, 2 * pi}, 200);
  EXPECT_NEAR(torus.area, 4 * pi * pi * 3, 1e-9);
  Densities by_hand;
  for (int i = 0; i < 2000; ++i) {
    const double v = 2 * pi * (i + .5) / 2000;
    const double width = 3 + std::cos(v);
    const double k = std::cos(v) / width;
    const double slope = (-std::sin(v) * width + std::cos(v) * std::sin(v)) / (width * width);
    const double area = 2 * pi * width * 2 * pi / 2000;
    by_hand.thin_plate += area * (1 + k * k);
    by_hand.variation += area * 3 * slope * slope;
  }
  EXPECT_NEAR(torus.thin_plate, by_hand.thin_plate, 1e-9);
  EXPECT_NEAR(torus.variation, by_hand.variation, 1e-9);
  // the sphere, as a tube of no large radius
  const Densities sphere = integrals(Tube{0, 2}, {0, 2 * pi}, {-pi / 2, pi / 2}, 400);
  EXPECT_NEAR(sphere.thin_plate, 8 * pi, 1e-4);
  EXPECT_NEAR(sphere.variation, 0, 1e-12);
}

TEST(SurfaceEnergies, OfATorusAreThoseOfTheSmoothOne) {
  const Tube torus{2, 1};
  const Densities exact = integrals(torus, {0, 2 * pi}, {0, 2 * pi}, 200);
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (const double shear : {0.0, 0.4})
      expect_second_order(sampled_tube(torus, lattice, 64, shear),
                          sampled_tube(torus, lattice, 128, shear), exact, .006);
}

TEST(SurfaceEnergies, OfAStretchedTorusAreThoseOfTheSmoothOne) {
  const Tube torus{3, 1, {1, 1.5, .7}};
  const Densities exact = integrals(torus, {0, 2 * pi}, {0, 2 * pi}, 400);
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    expect_second_order(sampled_tube(torus, lattice, 96), sampled_tube(torus, lattice, 192), exact,
                        .02);
}

TEST(SurfaceEnergies, OfSphereLikeMeshesAreThoseOfTheSphere) {
  const Densities exact{4 * pi, 8 * pi, 0};
  const auto expect_sphere = [&](const Sampled& start, int steps) {
    SCOPED_TRACE(start.mesh.vertex_count());
    expect_second_order(refined_on_sphere(start, steps), refined_on_sphere(start, steps + 1), exact,
                        .005);
    const double coarse = energies(refined_on_sphere(start, steps)).curvature_variation;
    const double fine = energies(refined_on_sphere(start, steps + 1)).curvature_variation;
    EXPECT_LT(fine, coarse / 3);
  };
  expect_sphere(tetrahedron_on_sphere(), 5);
  expect_sphere(octahedron_on_sphere(), 5);
  expect_sphere(icosahedron_on_sphere(), 4);
  expect_sphere(cube_on_sphere(), 5);
}

TEST(SurfaceEnergies, OfAnEllipsoidAreThoseOfTheSmoothOne) {
  const Eigen::Vector3d scale(1, 1.5, .8);
  const Densities exact = integrals(Tube{0, 1, scale}, {0, 2 * pi}, {-pi / 2, pi / 2}, 800);
  const auto stretched = [&](const Sampled& start, int steps) {
    Sampled sphere = refined_on_sphere(start, steps);
    for (Point3& p : sphere.points) p = point_of(vector_of(p).cwiseProduct(scale));
    return sphere;
  };
  for (const Sampled& start : {icosahedron_on_sphere(), octahedron_on_sphere(), cube_on_sphere()}) {
    SCOPED_TRACE(start.mesh.vertex_count());
    const int steps = start.mesh.vertex_count() > 8 ? 5 : 6;
    const SurfaceEnergies a = energies(stretched(start, steps - 1));
    const SurfaceEnergies b = energies(stretched(start, steps));
    EXPECT_NEAR(b.thin_plate, exact.thin_plate, .004 * exact.thin_plate);
    EXPECT_NEAR(order(a.thin_plate, b.thin_plate, exact.thin_plate), 2, .3);
    EXPECT_NEAR(b.curvature_variation, exact.variation, .01 * exact.variation);
    EXPECT_LT(std::abs(b.curvature_variation - exact.variation),
              std::abs(a.curvature_variation - exact.variation) / 2);
  }
}

/// A piece with a boundary: an open patch of the torus.
Sampled open_patch(Lattice lattice, Index n) {
  const Mesh closed = mesh::torus(lattice, n + 1, n + 1);
  Polygons polygons;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      polygons.positions.push_back(point_of(Tube{2, 1}.at(1.5 * i / n, .3 + 2.0 * j / n)));
  for (Index f = 0; f < closed.face_count(); ++f) {
    const Index cell = lattice == Lattice::quad ? f : f / 2;
    if (cell % (n + 1) == n || cell / (n + 1) == n) continue;
    for (Index h = closed.face_begin(f); h < closed.face_begin(f + 1); ++h)
      polygons.corners.push_back(closed.origin(h));
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return {Mesh::build(polygons).value(), polygons.positions};
}

TEST(SurfaceEnergies, ConvergeUpToTheBoundary) {
  const Densities exact = integrals(Tube{2, 1}, {0, 1.5}, {.3, 2.3}, 200);
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    const SurfaceEnergies a = energies(open_patch(lattice, 40));
    const SurfaceEnergies b = energies(open_patch(lattice, 80));
    EXPECT_EQ(b.left_out, 0);
    EXPECT_NEAR(b.thin_plate, exact.thin_plate, .002 * exact.thin_plate);
    EXPECT_GT(order(a.thin_plate, b.thin_plate, exact.thin_plate), 1.5);
    EXPECT_NEAR(b.curvature_variation, exact.variation, .06 * exact.variation);
    EXPECT_GT(order(a.curvature_variation, b.curvature_variation, exact.variation), .8);
  }
}

TEST(SurfaceEnergies, ScaleAndDoNotDependOnPlaceOrThreads) {
  const Sampled torus = sampled_tube({2, 1}, Lattice::triangle, 24);
  const SurfaceEnergies once = energies(torus);
  Sampled moved = torus;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (Point3& p : moved.points) p = point_of(3 * turn * vector_of(p) + Eigen::Vector3d(5, -7, 1));
  const SurfaceEnergies large = energies(moved);
  EXPECT_NEAR(large.area, 9 * once.area, 1e-9 * large.area);
  EXPECT_NEAR(large.thin_plate, once.thin_plate, 1e-9 * once.thin_plate);
  EXPECT_NEAR(large.curvature_variation, once.curvature_variation / 9,
              1e-9 * once.curvature_variation);
  set_thread_limit(1);
  const SurfaceEnergies alone = energies(torus);
  set_thread_limit(0);
  EXPECT_EQ(alone.thin_plate, once.thin_plate);
  EXPECT_EQ(alone.curvature_variation, once.curvature_variation);
}

// Scaled by powers of two everything is the same to the last bit, as far as it can be represented.
TEST(SurfaceEnergies, AreThoseOfTheShapeAtAnySize) {
  const Sampled torus = sampled_tube({2, 1}, Lattice::triangle, 16);
  const SurfaceEnergies once = energies(torus);
  const double laplacian = fairness::laplacian_energy(torus.mesh, torus.points);
  for (const int exponent : {-990, -500, -70, -3, 3, 70, 500, 990}) {
    SCOPED_TRACE(exponent);
    Sampled other = torus;
    for (Point3& p : other.points) p = std::ldexp(1.0, exponent) * p;
    const SurfaceEnergies found = energies(other);
    EXPECT_EQ(found.area, std::ldexp(once.area, 2 * exponent));
    EXPECT_EQ(found.thin_plate, once.thin_plate);
    EXPECT_EQ(found.curvature_variation, std::ldexp(once.curvature_variation, -2 * exponent));
    EXPECT_EQ(fairness::laplacian_energy(other.mesh, other.points),
              std::ldexp(laplacian, 2 * exponent));
    EXPECT_EQ(found.left_out, 0);
  }
}

TEST(SurfaceEnergies, OfPlanesAndCylindersVanish) {
  Sampled plane = open_patch(Lattice::triangle, 12);
  Sampled cylinder = plane;
  for (Index v = 0; v < plane.mesh.vertex_count(); ++v) {
    const double x = v % 13 + .1 * (v / 13);
    const double y = v / 13;
    plane.points[v] = point_of({x, y, 2 * x - y});
    cylinder.points[v] = point_of({std::cos(x / 10), std::sin(x / 10), y / 10});
  }
  EXPECT_NEAR(energies(plane).thin_plate, 0, 1e-20);
  EXPECT_NEAR(energies(plane).curvature_variation, 0, 1e-20);
  const SurfaceEnergies bent = energies(cylinder);
  EXPECT_NEAR(bent.thin_plate, bent.area, .01 * bent.area);
  EXPECT_NEAR(bent.curvature_variation, 0, .01);
}

TEST(SurfaceEnergies, ForgiveDegenerateFacesAndRefuseWhatIsNotFinite) {
  const Sampled torus = sampled_tube({2, 1}, Lattice::triangle, 16);
  Sampled bad = torus;
  bad.points.assign(bad.points.size(), {1, 2, 3});  // one point
  EXPECT_EQ(energies(bad).area, 0);
  EXPECT_EQ(energies(bad).left_out, bad.mesh.face_count());
  for (std::size_t v = 0; v < bad.points.size(); ++v) bad.points[v] = {double(v), double(v), 0};
  EXPECT_EQ(energies(bad).thin_plate, 0);  // one line
  bad = torus;
  bad.points[5] = bad.points[6];  // two faces without area
  EXPECT_TRUE(std::isfinite(energies(bad).curvature_variation));
  bad.points[7].y = std::numeric_limits<double>::quiet_NaN();
  const Result<SurfaceEnergies> refused = approx_energies(bad.mesh, bad.points);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("vertex 7"), std::string::npos);
  for (Point3& p : bad.points) p = 1e200 * Point3{p.x, 1, p.z};  // squares overflow
  (void)approx_energies(bad.mesh, bad.points);
}

TEST(SecondForms, KnowTheNormalAndTheSignOfCurvature) {
  const Sampled sphere = refined_on_sphere(icosahedron_on_sphere(), 3);
  const std::vector<fairness::SecondForm> forms =
      fairness::approx_second_forms(sphere.mesh, sphere.points);
  for (std::size_t v = 0; v < forms.size(); ++v) {
    const Eigen::Vector3d n = vector_of(sphere.points[v]);
    EXPECT_NEAR((forms[v].normal - n).norm(), 0, .002);
    const Eigen::Matrix3d expected = n * n.transpose() - Eigen::Matrix3d::Identity();
    EXPECT_NEAR((forms[v].tensor - expected).norm(), 0, .02);
  }
}

/// One vertex and its ring on the graph of a quadratic function over the plane that its faces take
/// for the tangent plane, and which the graph crosses at a slope.
TEST(SecondForms, AreExactOnAQuadraticGraph) {
  const Mesh mesh = mesh::star(Lattice::triangle, 7, 1);
  Eigen::MatrixXd rows(7, 5);  // of x, y, x²/2, xy, y²/2
  Eigen::MatrixXd ring(7, 3);
  for (int i = 0; i < 7; ++i) {
    const double angle = 2 * pi * i / 7;
    const double radius = 1 + .5 * std::sin(angle) - .4 * std::cos(2 * angle);
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    ring.row(i) << x, y, 0;
    rows.row(i) << x, y, x * x / 2, x * y, y * y / 2;
  }
  // Σ p_i × p_{i+1} is along z if and only if Σ z_i (p_{i-1} − p_{i+1}) vanishes
  Eigen::MatrixXd differences(2, 7);
  for (int i = 0; i < 7; ++i)
    differences.col(i) = (ring.row((i + 6) % 7) - ring.row((i + 1) % 7)).head<2>().transpose();
  const Eigen::MatrixXd conditions = differences * rows;
  Eigen::VectorXd c(5);
  c.tail<3>() << .9, -.5, 1.3;
  c.head<2>() = -conditions.leftCols<2>().inverse() * conditions.rightCols<3>() * c.tail<3>();
  ASSERT_GT(c.head<2>().norm(), .1);
  ring.col(2) = rows * c;
  std::vector<Point3> points{{0, 0, 0}};
  for (int i = 0; i < 7; ++i) points.push_back({ring(i, 0), ring(i, 1), ring(i, 2)});

  const fairness::SecondForm form = fairness::approx_second_forms(mesh, points)[0];
  ASSERT_TRUE(form.known);
  Derivatives graph{};
  for (auto& row : graph.d) row.fill({0, 0, 0});
  graph.d[1][0] = {1, 0, c[0]};
  graph.d[0][1] = {0, 1, c[1]};
  graph.d[2][0].z() = c[2];
  graph.d[1][1].z() = c[3];
  graph.d[0][2].z() = c[4];
  const Densities exact = densities(graph);
  EXPECT_NEAR(form.tensor.squaredNorm(), exact.thin_plate / exact.area, 1e-12);
  EXPECT_NEAR((form.normal - Eigen::Vector3d(-c[0], -c[1], 1).normalized()).norm(), 0, 1e-12);
  EXPECT_NEAR((form.tensor * form.normal).norm(), 0, 1e-12);
}

TEST(SurfaceEnergies, DoNotDependOnWhereAFaceBegins) {
  const Sampled torus = sampled_tube({2, 1}, Lattice::quad, 8);
  Polygons polygons = torus.mesh.polygons(torus.points);
  for (Index f = 0; f < polygons.face_count(); ++f)
    std::rotate(polygons.corners.begin() + polygons.face_begin[f],
                polygons.corners.begin() + polygons.face_begin[f] + f % 4,
                polygons.corners.begin() + polygons.face_begin[f + 1]);
  const SurfaceEnergies once = energies(torus);
  const SurfaceEnergies turned = energies({Mesh::build(polygons).value(), torus.points});
  EXPECT_NEAR(turned.area, once.area, 1e-12 * once.area);
  EXPECT_NEAR(turned.curvature_variation, once.curvature_variation,
              1e-9 * once.curvature_variation);
}

}  // namespace
}  // namespace limn::test
