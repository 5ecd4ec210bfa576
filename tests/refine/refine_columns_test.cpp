#include "limn/refine/refine_columns.h"

#include <gtest/gtest.h>

#include "limn/mesh/lattice.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

// torus_birth_place says by itself where new vertices lie on the plane.
TEST(LinearStep, PutsNewVerticesWhereTheyLieOnTheLattice) {
  constexpr Index n = 6;
  for (const Split& split : splits()) {
    const Mesh mesh = mesh::torus(split.lattice, n, n);
    const SplitResult fine = split.apply(mesh, 0);
    refine::Column places;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      places.push_back({12.0 * (v % n), 12.0 * (v / n), 0});  // NOLINT(bugprone-integer-division)
    const refine::Column values = refine::linear_step(split, mesh, fine.births, places);
    ASSERT_EQ(values.size(), static_cast<std::size_t>(fine.mesh.vertex_count()));
    Index compared = 0;
    for (Index v = 0; v < fine.mesh.vertex_count(); ++v) {
      const mesh::Twelfths place = mesh::torus_birth_place(mesh, n, n, fine.births, v);
      // across the cut of the torus
      if (std::max(place[0], place[1]) > 12 * (n - 1) || std::min(place[0], place[1]) < 0) continue;
      const Point3 value = values[static_cast<std::size_t>(v)];
      ++compared;
      EXPECT_NEAR(value.x, place[0], 1e-12) << split.name;
      EXPECT_NEAR(value.y, place[1], 1e-12) << split.name;
    }
    EXPECT_GT(compared, n * n / 2) << split.name;
  }
}

TEST(RefineColumns, GivesWhatRefineGivesOfEachColumn) {
  for (const char* name : {"loop", "catmull-clark", "sqrt3", "doo-sabin", "loop-ternary"}) {
    const Scheme& scheme = shipped(name);
    for (unsigned seed = 1; seed < 8; ++seed) {
      RandomMesh random(seed);
      const Mesh mesh =
          scheme.split->lattice == Lattice::triangle ? random.triangles() : random.polygons();
      std::mt19937 numbers(seed);
      refine::Columns columns;
      for (int k = 0; k < 2; ++k) {
        refine::Column column(static_cast<std::size_t>(mesh.vertex_count()));
        for (double& x : numbers_of(column)) x = numbers() * 1e-9;
        columns.smooth.push_back(column);
      }
      Sharpness sharpness;
      if (!scheme.split->is_dual() && !scheme.split->births.thirds)
        sharpness.vertices.assign(static_cast<std::size_t>(mesh.vertex_count()), 10);
      const auto all =
          refine::refine_columns(scheme, mesh, columns, sharpness, 2, {.parents = true});
      for (std::size_t k = 0; k < 2; ++k) {
        const auto one = refine::refine(scheme, mesh, columns.smooth[k], 2, {}, sharpness);
        ASSERT_EQ(all.ok(), one.ok()) << name << ", seed " << seed;
        if (!one) continue;
        EXPECT_EQ(all->columns.smooth[k], one->values) << name << ", seed " << seed;
        EXPECT_EQ(all->face_of.size(), static_cast<std::size_t>(one->mesh.face_count()));
      }
    }
  }
}

}  // namespace
}  // namespace limn::test
