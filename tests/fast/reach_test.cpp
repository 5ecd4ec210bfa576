// How far the quick engine finds rules to look.

#include <gtest/gtest.h>

#include "limn/fast/families/grid_family.h"
#include "limn/fast/sites/reach.h"
#include "limn/mesh/lattice.h"
#include "support/shipped.h"

namespace limn::fast {
namespace {

using test::shipped;

/// On meshes whose faces have up to two sides that meet on the boundary, or none there.
Reach reach_of(const Scheme& scheme, int step = 0, bool boundary = true) {
  BoundarySides sides{};
  sides[0] = true;
  sides[1] = sides[3] = boundary;
  return find_reach(scheme, *grid_cycle(*scheme.split), step, sides).value();
}

/// By hand, in steps of which two are an edge: Loop's stencils need the neighbours of an edge's or
/// vertex's own faces only, the butterfly's also the vertices beyond, so that edges at a control
/// vertex see round it. Catmull–Clark's need the faces of an edge or a vertex.
TEST(FastReach, IsThatOfTheRules) {
  for (const char* name : {"loop", "catmull-clark"}) {
    const Reach near = reach_of(shipped(name));
    EXPECT_EQ(near.star_zone.size, 0);
    EXPECT_EQ(near.strip_depth, 0);
    EXPECT_EQ(near.fan_zone.size, 0);
    EXPECT_EQ(near.corner_zone.size, 0);
    EXPECT_EQ(near.star_rings, 2);
    EXPECT_EQ(near.fan_rings, 2);
    EXPECT_EQ(near.smallest_side, 2);
  }
  const Reach butterfly = reach_of(shipped("butterfly"));
  EXPECT_EQ(butterfly.star_zone.size, 1);
  EXPECT_EQ(butterfly.strip_depth, 1);
  EXPECT_EQ(butterfly.star_rings, 4);
  EXPECT_EQ(butterfly.smallest_side, 4);
}

/// By hand: vertices look at the neighbours that their faces have, faces at their corners, so only
/// control vertices are not regular; at the boundary, the ends of edges look round the corner.
TEST(FastReach, IsThatOfTwoStepsWithCentres) {
  for (const int step : {0, 1}) {
    const bool thirds = step == 1;
    const Reach inner = reach_of(shipped("sqrt3"), step, false);
    EXPECT_EQ(inner.star_zone.size, 0);
    EXPECT_EQ(inner.star_rings, thirds ? 2 : 3);
    EXPECT_EQ(inner.smallest_side, 3);
    const Reach outer = reach_of(shipped("sqrt3"), step);
    EXPECT_EQ(outer.strip_depth, thirds ? 1 : 0);
    EXPECT_EQ(outer.fan_zone.size, thirds ? 1 : 0);
    EXPECT_EQ(outer.corner_zone.size, thirds ? 1 : 0);
    EXPECT_EQ(outer.smallest_side, 3);
  }
}

}  // namespace
}  // namespace limn::fast
