// Limits, normals and eigenvalues where triangles meet quads: against finer levels, against where
// refinement goes, and against powers.

#include <gtest/gtest.h>

#include <cmath>

#include "limit/wavy_points.h"
#include "limn/limit/limit_points.h"
#include "limn/limit/sector_spectrum.h"
#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

constexpr Lattice kT = Lattice::triangle, kQ = Lattice::quad;

const Scheme& scheme() { return shipped("quad-triangle"); }

/// In the plane, counterclockwise, with its sectors alike in angle, and bent a little.
std::vector<Point3> bent_star(const mesh::Sectors& sectors, Index rings) {
  std::vector<Point3> points{{0, 0, 0}};
  const auto count = static_cast<Index>(sectors.lattices.size());
  const double whole = sectors.open ? M_PI : 2 * M_PI;
  for (Index r = 1; r <= rings; ++r) {
    for (Index s = 0; s < count; ++s) {
      const bool quads = sectors.lattices[static_cast<std::size_t>(s)] == kQ;
      const Index length_here = quads ? 2 * r : r;
      for (Index k = 0; k < length_here; ++k) {
        const double angle = whole * (s + static_cast<double>(k) / length_here) / count;
        points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
      }
    }
    if (sectors.open) points.push_back({r * std::cos(whole), r * std::sin(whole), 0});
  }
  for (Point3& p : points) p.z = 0.1 * p.x * p.x + 0.05 * p.x * p.y;
  return points;
}

const std::vector<std::vector<Lattice>> kKinds{
    {kT, kT, kT, kQ, kQ}, {kT, kT, kQ, kT, kQ},    {kT, kQ, kQ}, {kT, kQ, kT, kQ}, {kT, kT, kQ},
    {kQ, kQ, kQ, kT},     {kT, kT, kT, kT, kQ, kQ}};

TEST(SectorMatrix, IsThatOfLoopsAndCatmullAndClarksStarsWhereFacesAreAlike) {
  for (const auto& [end, name, lattice] :
       {std::tuple{"-on-triangles", "loop", kT}, {"-on-quads", "catmull-clark", kQ}}) {
    const int n = lattice == kT ? 6 : 4;
    const mesh::Sectors sectors{std::vector<Lattice>(static_cast<std::size_t>(n), lattice), false};
    const limit::SectorMatrix mixed = limit::sector_matrix(scheme(), sectors).value();
    const auto of = [&](const std::string& of_name) {
      return dense(refine::subdivision_matrix<double>(shipped(of_name), n, mixed.rings).value());
    };
    EXPECT_EQ(mixed.rings, 2);
    EXPECT_LT((mixed.entries - of(name)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((mixed.entries - of("quad-triangle" + std::string(end))).cwiseAbs().maxCoeff(),
              1e-14);
  }
}

TEST(SectorSpectrum, BeginsAtASeamWithOneAndTwoHalves) {
  const limit::SectorSpectrum seam =
      limit::approx_sector_spectrum(scheme(), {{kT, kT, kT, kQ, kQ}, false}).value();
  EXPECT_NEAR(std::abs(seam.eigenvalues[0] - 1.0), 0, 1e-12);
  EXPECT_NEAR(std::abs(seam.eigenvalues[1] - .5), 0, 1e-12);
  EXPECT_NEAR(std::abs(seam.eigenvalues[2] - .5), 0, 1e-12);
  EXPECT_LT(std::abs(seam.eigenvalues[3]), .3);
  EXPECT_EQ(seam.convergent, Truth::yes);
  EXPECT_EQ(seam.c1_necessary, Truth::yes);
  ASSERT_TRUE(seam.tangent);
  EXPECT_NEAR(seam.tangent->at(0), seam.tangent->at(1), 1e-12);
}

/// It does not matter which face is the first.
TEST(SectorSpectrum, IsTheSameFromAnyFaceOn) {
  const auto moduli = [](const std::vector<Lattice>& kinds) {
    std::vector<double> list;
    const limit::SectorSpectrum spectrum =
        limit::approx_sector_spectrum(scheme(), {kinds, false}).value();
    for (const auto& value : spectrum.eigenvalues) list.push_back(std::abs(value));
    return list;
  };
  std::vector<Lattice> kinds{kT, kT, kQ, kT, kQ};
  const std::vector<double> first = moduli(kinds);
  for (int turn = 1; turn < 5; ++turn) {
    std::rotate(kinds.begin(), kinds.begin() + 1, kinds.end());
    const std::vector<double> other = moduli(kinds);
    ASSERT_EQ(first.size(), other.size());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(first[i], other[i], 1e-9) << turn << ' ' << i;
  }
}

/// Refined data shrink as the eigenvalues say: the ring round a vertex, less its limit.
TEST(SectorSpectrum, IsTheRateAtWhichRefinedStarsShrink) {
  for (const std::vector<Lattice>& kinds : kKinds) {
    const mesh::Sectors sectors{kinds, false};
    const limit::SectorSpectrum spectrum = limit::approx_sector_spectrum(scheme(), sectors).value();
    ASSERT_TRUE(spectrum.tangent) << limit::place_text(sectors);
    const Mesh star = mesh::sector_star(sectors, 2);
    std::vector<double> areas;  // of ring 1 after each level
    for (int level = 6; level <= 7; ++level) {
      const auto fine = refine::refine(scheme(), star, bent_star(sectors, 2), level).value();
      const Index first = fine.mesh.halfedge_of_vertex(0);
      std::vector<Point3> ring;
      Index h = first;
      do {
        ring.push_back(fine.values[static_cast<std::size_t>(fine.mesh.target(h))]);
        h = fine.mesh.rotate(h);
      } while (h != first);
      double area = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point3 a = ring[i] - fine.values[0], b = ring[(i + 1) % ring.size()] - fine.values[0];
        area += a.x * b.y - a.y * b.x;
      }
      areas.push_back(area);
    }
    EXPECT_GT(areas[0], 0);
    // the area shrinks with the product of the pair
    EXPECT_NEAR(areas[1] / areas[0], spectrum.tangent->at(0) * spectrum.tangent->at(1), 2e-3)
        << limit::place_text(sectors);
  }
}

TEST(SectorSpectrum, IsRefusedWhereSuchFacesCannotBe) {
  const auto fault = [](const std::string& name, const std::vector<Lattice>& kinds) {
    const auto found = limit::approx_sector_spectrum(shipped(name), {kinds, false});
    return found ? std::string() : found.error().message;
  };
  EXPECT_NE(fault("loop", {kT, kT, kQ}).find("triangles alone"), std::string::npos);
  EXPECT_NE(fault("sqrt3", {kT, kT, kT}).find("keeps no faces"), std::string::npos);
  EXPECT_NE(fault("doo-sabin", {kQ, kQ, kQ}).find("keeps no faces"), std::string::npos);
  EXPECT_EQ(fault("loop", {kT, kT, kT, kT, kT}), "");
  EXPECT_EQ(fault("catmull-clark", {kQ, kQ, kQ}), "");
}

/// Old vertices keep their numbers.
TEST(MixedLimit, IsThatOfFinerLevels) {
  int compared = 0, open = 0, seams = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = RandomMesh(seed).mixed();
    std::vector<Point3> before;
    for (int level = 0; level <= 2; ++level) {
      const auto fine = refine::refine(scheme(), mesh, points_of(mesh), level).value();
      LimitOptions options;
      options.steps_made = level;
      const auto limit = approx_limit_points(scheme(), fine.mesh, fine.values, options);
      ASSERT_TRUE(limit.ok()) << limit.error().text();
      for (std::size_t v = 0; v < before.size(); ++v, ++compared)
        EXPECT_LT(length(limit->positions[v] - before[v]), 1e-11) << level;
      before = limit->positions;
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) open += mesh.is_boundary_vertex(v) ? 1 : 0;
    seams += mesh.uniform_degree() == 0 ? 1 : 0;
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(open, 0);
  EXPECT_GT(seams, 5);
}

TEST(MixedLimit, IsWhereRefinementGoes) {
  constexpr int kLevels = 6;
  for (const std::vector<Lattice>& kinds : kKinds)
    for (const bool open : {false, true}) {
      const mesh::Sectors sectors{kinds, open};
      const Mesh mesh = mesh::sector_star(sectors, 2);
      const auto limit = approx_limit_points(scheme(), mesh, points_of(mesh)).value();
      const auto fine = refine::refine(scheme(), mesh, points_of(mesh), kLevels).value();
      for (std::size_t v = 0; v < limit.positions.size(); ++v)
        EXPECT_LT(length(fine.values[v] - limit.positions[v]), 2 * std::pow(.6, kLevels))
            << limit::place_text(sectors) << ' ' << v;
    }
}

/// The sum of the faces' normals, some levels on.
TEST(MixedLimit, HasTheNormalsOfFinerFaces) {
  constexpr int kLevels = 7;
  for (const std::vector<Lattice>& kinds : kKinds)
    for (const bool open : {false, true}) {
      const mesh::Sectors sectors{kinds, open};
      const Mesh mesh = mesh::sector_star(sectors, 2);
      const std::vector<Point3> points = bent_star(sectors, 2);
      const auto limit = approx_limit_points(scheme(), mesh, points).value();
      const auto fine = refine::refine(scheme(), mesh, points, kLevels).value();
      Point3 sum;
      Index h = fine.mesh.halfedge_of_vertex(0);
      for (std::size_t i = 0; i < kinds.size(); ++i, h = fine.mesh.rotate(h)) {
        const Index before = fine.mesh.origin(fine.mesh.prev(h));
        sum =
            sum + cross(fine.values[static_cast<std::size_t>(fine.mesh.target(h))] - fine.values[0],
                        fine.values[static_cast<std::size_t>(before)] - fine.values[0]);
      }
      const Point3 expected = (1 / length(sum)) * sum;
      EXPECT_NEAR(length(limit.normals[0]), 1, 1e-12) << limit::place_text(sectors);
      EXPECT_LT(length(limit.normals[0] - expected), .05) << limit::place_text(sectors);
    }
}

/// Vertices of one kind of faces alone have the limits of that lattice's own scheme.
TEST(MixedLimit, IsThatOfOneLatticeAwayFromSeams) {
  const Mesh triangles = mesh::torus(kT, 5, 4), quads = mesh::torus(kQ, 5, 4);
  for (const auto& [mesh, name] : {std::pair{triangles, "loop"}, {quads, "catmull-clark"}}) {
    const auto one = approx_limit_points(scheme(), mesh, points_of(mesh)).value();
    const auto other = approx_limit_points(shipped(name), mesh, points_of(mesh)).value();
    for (std::size_t v = 0; v < one.positions.size(); ++v) {
      EXPECT_LT(length(one.positions[v] - other.positions[v]), 1e-12);
      EXPECT_LT(length(one.normals[v] - other.normals[v]), 1e-9);
    }
  }
}

}  // namespace
}  // namespace limn::test
