// Kobbelt's √3 scheme against CGAL and OpenMesh. All three refine the boundary alike: not at all in
// the first step, each edge cut in three in the second, and so on. Both libraries count the steps
// from the beginning of a call, so a comparison is one call.

#include "peer_test.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 5;

const Scheme& sqrt3() {
  static const Scheme scheme = find_scheme("sqrt3").value();
  return scheme;
}

std::unique_ptr<Peer> cgal(const Polygons& control) { return cgal_peer(Method::sqrt3, control); }

std::unique_ptr<Peer> openmesh(const Polygons& control) {
  return openmesh_peer(Method::sqrt3, control);
}

TEST(PeersSqrt3, CgalOnClosedMeshes) {
  expect_agreement(sqrt3(), closed_triangles(), kLevels, cgal);
}
TEST(PeersSqrt3, CgalOnOpenMeshes) { expect_agreement(sqrt3(), open_triangles(), kLevels, cgal); }
TEST(PeersSqrt3, CgalOnTheBracket) { expect_agreement(sqrt3(), example("bracket.obj"), 2, cgal); }

TEST(PeersSqrt3, OpenMeshOnClosedMeshes) {
  expect_agreement(sqrt3(), closed_triangles(), kLevels, openmesh);
}
TEST(PeersSqrt3, OpenMeshOnOpenMeshes) {
  expect_agreement(sqrt3(), open_triangles(), kLevels, openmesh);
}
TEST(PeersSqrt3, OpenMeshOnTheBracket) {
  expect_agreement(sqrt3(), example("bracket.obj"), 2, openmesh);
}

TEST(PeersSqrt3, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"vertex rule", {{"(4 - 2*cos(2*pi/n))/9", "(4 - 2*cos(2*pi/n))/9 + 1/10^9"}}, ""},
      {"boundary vertex rule", {{"19/27", "19/27 + 2/10^9"}, {"4/27", "4/27 - 1/10^9"}}, ""},
      {"boundary edge rule",
       {{"near   = \"16/27\"", "near   = \"16/27 + 1/10^9\""},
        {"far    = \"10/27\"", "far    = \"10/27 - 1/10^9\""}},
       ""},
      {"boundary edge's outer weight",
       {{"far    = \"10/27\"", "far    = \"10/27 + 1/10^9\""},
        {"beyond = \"1/27\"", "beyond = \"1/27 - 1/10^9\""}},
       ""},
  };
  expect_notice("sqrt3", edits, open_triangles(), 2, cgal);
}

}  // namespace
}  // namespace limn::peers
