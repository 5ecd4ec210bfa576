#include <gtest/gtest.h>

#include <limits>

#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

Mesh control_mesh(const Scheme& scheme) {
  // an open disc: boundaries must be counted too
  return scheme.split->is_dual() ? mesh::face_star(5, 3) : mesh::star(scheme.split->lattice, 5, 3);
}

TEST(RefineEstimate, BoundsTheCountsAndIsNearThem) {
  for (const std::string name : {"loop", "catmull-clark", "doo-sabin", "sqrt3", "four-eight",
                                 "loop-ternary", "quad-triangle", "midedge"}) {
    const Scheme scheme = find_scheme(name).value();
    const Mesh mesh = control_mesh(scheme);
    for (int levels = 0; levels <= 4; ++levels) {
      const refine::RefineEstimate estimate =
          refine::estimate_refinement(*scheme.split, mesh, levels, sizeof(Point3));
      const auto fine = refine::refine(
          scheme, mesh, std::vector<Point3>(static_cast<std::size_t>(mesh.vertex_count())), levels);
      ASSERT_TRUE(fine.ok()) << fine.error().text();
      const double vertices = fine->mesh.vertex_count();
      EXPECT_GE(estimate.vertices, vertices) << name << levels;
      EXPECT_LE(estimate.vertices, 2.5 * vertices) << name << levels;
      EXPECT_GE(estimate.faces, fine->mesh.face_count()) << name << levels;
    }
  }
}

TEST(RefineEstimate, IsExactForClosedMeshesOfADyadicSplit) {
  const Scheme scheme = find_scheme("loop").value();
  const Mesh mesh = mesh::torus(Lattice::triangle, 5, 4);
  const refine::RefineEstimate estimate =
      refine::estimate_refinement(*scheme.split, mesh, 3, sizeof(Point3));
  EXPECT_EQ(estimate.vertices, 20 * 64);
  EXPECT_EQ(estimate.faces, 40 * 64);
}

TEST(CheckRefinable, NamesTheEstimateWhereMemoryIsShort) {
  const Scheme scheme = find_scheme("loop").value();
  const Mesh mesh = mesh::torus(Lattice::triangle, 5, 4);
  EXPECT_TRUE(refine::check_refinable(scheme, mesh, 3, sizeof(Point3), kNoLimit).ok());
  const Status status = refine::check_refinable(scheme, mesh, 8, sizeof(Point3), 1e6);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("1.31e+06 vertices"), std::string::npos)
      << status.error().message;
  EXPECT_NE(status.error().message.find("iB"), std::string::npos);
}

TEST(CheckRefinable, NamesWhatTheSplitDoesNotTake) {
  const auto message = [](const Scheme& scheme, const Mesh& mesh) {
    const Status status = refine::check_refinable(scheme, mesh, 1, sizeof(Point3), kNoLimit);
    return status ? std::string() : status.error().message;
  };
  Scheme quads = find_scheme("catmull-clark").value();
  quads.split = find_split("quad-ternary");
  EXPECT_EQ(message(quads, mesh::torus(Lattice::quad, 5, 4)), "");
  EXPECT_NE(message(quads, mesh::torus(Lattice::triangle, 5, 4)).find("refines quads"),
            std::string::npos);
  const Scheme triangles = find_scheme("loop-ternary").value();
  EXPECT_NE(message(triangles, mesh::torus(Lattice::quad, 5, 4)).find("refines triangles"),
            std::string::npos);
}

TEST(CheckRefinable, RefusesMoreHalfedgesThanAnIndexHolds) {
  const Scheme scheme = find_scheme("catmull-clark").value();
  const Mesh mesh = mesh::torus(Lattice::quad, 5, 4);
  EXPECT_TRUE(refine::check_refinable(scheme, mesh, 12, sizeof(Point3), kNoLimit).ok());
  const Status status = refine::check_refinable(scheme, mesh, 13, sizeof(Point3), kNoLimit);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("half-edges"), std::string::npos);
}

TEST(CheckRefinable, ATriangleSchemeNamesThePolygonAndTheRemedy) {
  const Scheme scheme = find_scheme("loop").value();
  const Status status = refine::check_refinable(scheme, mesh::torus(Lattice::quad, 3, 3), 1,
                                                sizeof(Point3), kNoLimit);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("face 0 has 4 corners"), std::string::npos);
  EXPECT_NE(status.error().hint.find("--triangulate"), std::string::npos);
}

}  // namespace
}  // namespace limn
