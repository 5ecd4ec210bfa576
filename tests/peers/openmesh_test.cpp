// Schemes that of the other libraries OpenMesh alone has: Labsik and Greiner's interpolating √3,
// and mid-edge.

#include "peer_test.h"

namespace limn::peers {
namespace {

const Scheme& interpolating_sqrt3() {
  static const Scheme scheme = find_scheme("sqrt3-interpolating").value();
  return scheme;
}

const Scheme& midedge() {
  static const Scheme scheme = find_scheme("midedge").value();
  return scheme;
}

std::unique_ptr<Peer> labsik_greiner(const Polygons& control) {
  return openmesh_peer(Method::interpolating_sqrt3, control);
}

std::unique_ptr<Peer> midpoint(const Polygons& control) {
  return openmesh_peer(Method::midedge, control);
}

// Closed meshes: at boundaries OpenMesh has face rules of its own making.
TEST(PeersInterpolatingSqrt3, OpenMeshOnClosedMeshes) {
  expect_agreement(interpolating_sqrt3(), closed_triangles(), 4, labsik_greiner);
}

TEST(PeersInterpolatingSqrt3, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"face rule",
       {{"corner = \"32/81\"", "corner = \"32/81 + 1/10^9\""},
        {"beyond = \"-1/81\"", "beyond = \"-1/81 - 1/10^9\""}},
       ""},
      {"rule at valence 3",
       {{"2/3*cos(pi*(2*k + 1)/3)", "(2/3 + 1/10^9)*cos(pi*(2*k + 1)/3)"}},
       ""},
      {"rule at other valences", {{"2*lambda*cos", "(2 + 1/10^9)*lambda*cos"}}, ""},
  };
  expect_notice("sqrt3-interpolating", edits, closed_triangles(), 2, labsik_greiner);
}

// Closed meshes: OpenMesh lets open ones fall apart where an edge has both ends on the boundary.
TEST(PeersMidEdge, OpenMeshOnClosedMeshes) {
  expect_agreement(midedge(), closed_polygons(), 4, midpoint);
}

TEST(PeersMidEdge, AChangedWeightIsNoticed) {
  const Edit edit{
      "edge rule", {{"end = \"1/2\"", "end = \"1/2 - 2/10^9\"\nwing = \"1/10^9\""}}, ""};
  expect_notice("midedge", {edit}, closed_polygons(), 2, midpoint);
}

}  // namespace
}  // namespace limn::peers
