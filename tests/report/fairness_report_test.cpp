#include "limn/report/fairness_report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "limn/fairness/laplacian.h"
#include "limn/limit/limit_points.h"
#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"
#include "limn/report/spectrum_report.h"
#include "support/shipped.h"
#include "support/smooth_surface.h"

namespace limn::test {
namespace {

constexpr Index kAround = 12;
constexpr Index kAcross = 8;

/// Dented: on a symmetric torus, curvatures do not jump where others would.
std::vector<Point3> torus_points() {
  std::vector<Point3> points;
  for (Index j = 0; j < kAcross; ++j)
    for (Index i = 0; i < kAround; ++i) {
      const double dent = .08 * std::sin(5 * i + 3 * j * j);
      const Eigen::Vector3d p = Tube{2 + dent, 1 - dent, {1, 1.3, .8}}.at(
          2 * std::numbers::pi * i / kAround, 2 * std::numbers::pi * j / kAcross + dent);
      points.push_back({p.x(), p.y(), p.z()});
    }
  return points;
}

study::FairnessRecord fairness_of(const std::string& scheme, int levels = 0) {
  const Mesh mesh = mesh::torus(shipped(scheme).split->lattice, kAround, kAcross);
  study::FairnessOptions options;
  options.levels = levels;
  return study::approx_fairness(scheme, shipped(scheme), mesh, torus_points(), options).value();
}

/// The uniform B-spline of degree d at t, supported on (0, d + 1), or its derivative: by the
/// recursions alone.
double b_spline(int d, int derivative, double t) {
  if (derivative > 0)
    return d == 0 ? 0 : b_spline(d - 1, derivative - 1, t) - b_spline(d - 1, derivative - 1, t - 1);
  if (d == 0) return t >= 0 && t < 1 ? 1 : 0;
  return (t * b_spline(d - 1, 0, t) + (d + 1 - t) * b_spline(d - 1, 0, t - 1)) / d;
}

/// The tensor-product B-spline surface of the torus's points.
struct SplineTorus {
  int degree = 3;
  std::vector<Point3> points = torus_points();

  Derivatives operator()(double u, double v) const {
    Derivatives s;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; a + b < 4; ++b) {
        Eigen::Vector3d sum(0, 0, 0);
        for (int i = static_cast<int>(u) - degree; i <= static_cast<int>(u); ++i)
          for (int j = static_cast<int>(v) - degree; j <= static_cast<int>(v); ++j) {
            const Point3& p = points[static_cast<std::size_t>((j + kAcross) % kAcross * kAround +
                                                              (i + kAround) % kAround)];
            sum += b_spline(degree, static_cast<int>(a), u - i) *
                   b_spline(degree, static_cast<int>(b), v - j) * Eigen::Vector3d(p.x, p.y, p.z);
          }
        s.d[a][b] = sum;
      }
    return s;
  }
};

TEST(Fairness, OfCatmullClarkOnATorusIsThatOfBicubicSplines) {
  const Densities exact = integrals(SplineTorus{3}, {0, kAround}, {0, kAcross}, 240);
  const study::FairnessRecord record = fairness_of("catmull-clark");
  EXPECT_GE(record.last().vertices, 50000);
  EXPECT_LE(record.last().vertices, 200000);
  EXPECT_NEAR(record.last().energies.area, exact.area, 1e-4 * exact.area);
  EXPECT_NEAR(record.last().energies.thin_plate, exact.thin_plate, 5e-4 * exact.thin_plate);
  EXPECT_NEAR(record.thin_plate.limit, exact.thin_plate, 3e-4 * exact.thin_plate);
  EXPECT_NEAR(record.area.limit, exact.area, 1e-6 * exact.area);
  // third derivatives jump between the patches
  EXPECT_EQ(record.curvature_variation.converges, Truth::yes);
  EXPECT_NEAR(record.curvature_variation.limit, exact.variation, .01 * exact.variation);
}

TEST(Fairness, OfDooSabinOnATorusIsThatOfBiquadraticSplines) {
  const Densities exact = integrals(SplineTorus{2}, {0, kAround}, {0, kAcross}, 240);
  const study::FairnessRecord record = fairness_of("doo-sabin");
  EXPECT_NEAR(record.area.limit, exact.area, 1e-4 * exact.area);
  EXPECT_EQ(record.thin_plate.converges, Truth::yes);
  EXPECT_NEAR(record.thin_plate.limit, exact.thin_plate, .01 * exact.thin_plate);
  // curvature jumps, so that its derivative is not square-integrable
  EXPECT_EQ(record.curvature_variation.converges, Truth::no);
}

TEST(Fairness, FindsHighPassLessFairThanLoopOnATorus) {
  const study::FairnessRecord loop = fairness_of("loop");
  const study::FairnessRecord high = fairness_of("laplacian-loop");
  EXPECT_LT(loop.last().energies.thin_plate, high.last().energies.thin_plate);
  EXPECT_LT(loop.last().laplacian_energy, high.last().laplacian_energy);
  EXPECT_EQ(loop.thin_plate.converges, Truth::yes);
  EXPECT_EQ(loop.curvature_variation.converges, Truth::yes);
  EXPECT_EQ(high.thin_plate.converges, Truth::no);
  EXPECT_EQ(high.curvature_variation.converges, Truth::no);
  const nlohmann::ordered_json json = report::fairness_json("torus", {high, loop});
  EXPECT_EQ(json.at("fairest").at("thin_plate"), "loop");
  EXPECT_EQ(json.at("fairest").at("laplacian_energy"), "loop");
  EXPECT_EQ(json.at("schemes")[0].at("trends").at("thin_plate").at("converges"), "no");
  EXPECT_TRUE(json.at("schemes")[0].at("trends").at("thin_plate").at("limit").is_null());
  const std::string text = report::fairness_text("torus", {high, loop});
  EXPECT_NE(text.find("*"), std::string::npos);
  EXPECT_NE(text.find("grows"), std::string::npos);
}

TEST(Fairness, IsMeasuredOnTheLimitAtEachLevel) {
  const Scheme& scheme = shipped("sqrt3");  // whose boundary moves in every second step
  const Mesh mesh = mesh::star(Lattice::triangle, 7, 2);
  std::vector<Point3> points;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    points.push_back({std::cos(2. * v), std::sin(3. * v), std::cos(v * v)});
  study::FairnessOptions options;
  options.levels = 3;
  const study::FairnessRecord record =
      study::approx_fairness("it", scheme, mesh, points, options).value();
  EXPECT_EQ(record.scheme, "it");
  ASSERT_EQ(record.levels.size(), 3U);
  for (const study::FairnessLevel& level : record.levels) {
    const refine::Refined<Point3> fine = refine::refine(scheme, mesh, points, level.level).value();
    LimitOptions made;
    made.steps_made = level.level;
    const std::vector<Point3> limit =
        approx_limit_points(scheme, fine.mesh, fine.values, made)->positions;
    EXPECT_EQ(level.vertices, fine.mesh.vertex_count());
    const double thin_plate = approx_energies(fine.mesh, limit)->thin_plate;
    const double laplacian = fairness::laplacian_energy(fine.mesh, limit);
    EXPECT_NEAR(level.energies.thin_plate, thin_plate, 1e-10 * thin_plate);
    EXPECT_NEAR(level.laplacian_energy, laplacian, 1e-10 * laplacian);
    EXPECT_NEAR(level.scaled_laplacian, level.laplacian_energy * std::pow(3, level.level), 1e-9);
  }
}

TEST(Fairness, ComparesTheLaplacianOfOneSplitOnly) {
  const std::vector<study::FairnessRecord> records{fairness_of("loop", 2), fairness_of("sqrt3", 2)};
  const nlohmann::ordered_json json = report::fairness_json("torus", records);
  EXPECT_FALSE(json.at("fairest").contains("laplacian_energy"));
  EXPECT_TRUE(json.at("fairest").contains("thin_plate"));
  EXPECT_NE(report::fairness_text("torus", records).find("does not compare"), std::string::npos);
  EXPECT_TRUE(report::fairness_json("torus", {records[0]}).at("fairest").empty());
}

TEST(Fairness, OfAPlaneIsZeroAndNoNoiseGrows) {
  const Mesh mesh = mesh::star(Lattice::triangle, 6, 3);
  std::vector<Point3> points;
  for (Index v = 0; v < mesh.vertex_count(); ++v)  // flat, whatever the mesh makes of it
    points.push_back({std::cos(v) * v, std::sin(v) * v, .3 * std::cos(v) * v});
  const study::FairnessRecord record =
      study::approx_fairness("loop", shipped("loop"), mesh, points).value();
  EXPECT_EQ(record.thin_plate.converges, Truth::yes);
  EXPECT_NEAR(record.thin_plate.limit, 0, 1e-12);
  EXPECT_EQ(record.curvature_variation.converges, Truth::yes);
}

std::vector<study::FairnessRecord> loop_and_optimal(const Mesh& mesh,
                                                    const std::vector<Point3>& points) {
  std::vector<study::FairnessRecord> records;
  for (const char* name : {"loop", "butterfly", "optimal"})
    records.push_back(study::approx_fairness(name, shipped(name), mesh, points, {4, {}}).value());
  return records;
}

// … so none is the fairest: what is left is rounding.
TEST(Fairness, OfPlanesIsATie) {
  const Mesh mesh = mesh::star(Lattice::triangle, 7, 3);
  for (const double scale : {1e-100, 1e-3, 1.0, 1e5, 1e100}) {
    SCOPED_TRACE(scale);
    std::vector<Point3> points;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double x = std::cos(v) * v, y = std::sin(v) * v;
      points.push_back(scale * Point3{x + 3, y, .3 * x - .7 * y});
    }
    const auto records = loop_and_optimal(mesh, points);
    const auto json = report::fairness_json("plane", records);
    for (const char* flat : {"thin_plate", "curvature_variation"})
      EXPECT_FALSE(json.at("fairest").contains(flat)) << json.at("fairest").dump();
    for (const study::FairnessRecord& record : records) {
      EXPECT_EQ(record.thin_plate.limit, 0) << record.scheme;
      EXPECT_EQ(record.curvature_variation.limit, 0) << record.scheme;
    }
  }
}

// What rounding may be is not so much that it hides what there is.
TEST(Fairness, OfBentSurfacesIsNoTie) {
  const Mesh mesh = mesh::torus(Lattice::triangle, kAround, kAcross);
  const auto records = loop_and_optimal(mesh, torus_points());
  for (const study::FairnessRecord& record : records) {
    const SurfaceEnergies& e = record.last().energies;
    EXPECT_LT(e.rounding.thin_plate, 1e-8 * e.thin_plate) << record.scheme;
    EXPECT_LT(e.rounding.curvature_variation, 1e-6 * e.curvature_variation) << record.scheme;
    EXPECT_LT(record.last().laplacian_rounding, 1e-8 * record.last().laplacian_energy);
  }
  EXPECT_EQ(report::fairness_json("torus", records).at("fairest").size(), 3);
}

TEST(Fairness, OfOnePointDoesNotGrow) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 4, 5);
  for (const Point3 at :
       {Point3{}, Point3{1, 2, 3}, Point3{.1, .7, -.3}, Point3{1e-90, 3e-90, 0}}) {
    const auto records = loop_and_optimal(mesh, std::vector<Point3>(20, at));
    for (const study::FairnessRecord& record : records)
      for (const fairness::Trend& trend :
           {record.scaled_laplacian, record.area, record.thin_plate, record.curvature_variation})
        EXPECT_EQ(trend.converges, Truth::yes) << record.scheme;
    EXPECT_TRUE(report::fairness_json("point", records).at("fairest").empty());
    for (const study::FairnessRecord& record : records)
      for (const study::FairnessLevel& level : record.levels) {
        EXPECT_EQ(level.laplacian_energy, 0) << record.scheme;
        EXPECT_EQ(level.scaled_laplacian, 0);
        EXPECT_EQ(level.energies.area, 0);
        EXPECT_EQ(level.energies.thin_plate, 0);
        EXPECT_EQ(level.energies.curvature_variation, 0);
      }
  }
}

// A part without any size adds nothing to the rest.
TEST(Fairness, OfPartsThatAreOnePointIsThatOfTheRest) {
  const Mesh mesh = mesh::torus(Lattice::triangle, kAround, kAcross);
  Polygons both = mesh.polygons(torus_points());
  const Index count = both.vertex_count();
  const auto corners = static_cast<Index>(both.corners.size());
  for (Index v = 0; v < count; ++v) both.positions.push_back({.1, .7, -.3});
  for (Index i = 0; i < corners; ++i) {
    both.corners.push_back(both.corners[static_cast<std::size_t>(i)] + count);
    if (i % 3 == 2) both.face_begin.push_back(static_cast<Index>(both.corners.size()));
  }
  const study::FairnessRecord alone =
      study::approx_fairness("loop", shipped("loop"), mesh, torus_points(), {4, {}}).value();
  const study::FairnessRecord record =
      study::approx_fairness("loop", shipped("loop"), Mesh::build(both).value(), both.positions,
                             {4, {}})
          .value();
  const SurfaceEnergies &a = alone.last().energies, &b = record.last().energies;
  EXPECT_NEAR(b.thin_plate, a.thin_plate, 1e-9 * a.thin_plate);
  EXPECT_NEAR(b.curvature_variation, a.curvature_variation, 1e-9 * a.curvature_variation);
  EXPECT_EQ(record.thin_plate.converges, alone.thin_plate.converges);
  EXPECT_EQ(record.curvature_variation.converges, alone.curvature_variation.converges);
}

TEST(Fairness, RefusesWhatCannotBeRefined) {
  const Mesh quads = mesh::torus(Lattice::quad, kAround, kAcross);
  const auto refused = study::approx_fairness("loop", shipped("loop"), quads, torus_points());
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text().find("triang"), std::string::npos);
  std::vector<Point3> points = torus_points();
  points[3].z = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(study::approx_fairness("loop", shipped("loop"),
                                      mesh::torus(Lattice::triangle, kAround, kAcross), points)
                   .ok());
}

TEST(SpectrumReport, HasBothEnds) {
  const Mesh mesh = mesh::torus(Lattice::quad, 4, 4);
  const report::SpectrumEnds ends = report::approx_spectrum_ends(mesh, 2).value();
  EXPECT_NEAR(ends.smallest[0], 0, 1e-14);
  EXPECT_NEAR(ends.smallest[1], .5, 1e-14);
  EXPECT_NEAR(ends.largest[1], 2, 1e-14);
  EXPECT_EQ(report::spectrum_json(ends).at("largest").size(), 2U);
  EXPECT_NE(report::spectrum_text("m", ends).find("0.50000000"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
