// The modified butterfly against OpenMesh.

#include "peer_test.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 3;

const Scheme& butterfly() {
  static const Scheme scheme = find_scheme("butterfly-modified").value();
  return scheme;
}

std::unique_ptr<Peer> openmesh(const Polygons& control) {
  return openmesh_peer(Method::modified_butterfly, control);
}

TEST(PeersButterfly, OpenMeshOnClosedMeshes) {
  expect_agreement(butterfly(), closed_triangles(), kLevels, openmesh);
}
TEST(PeersButterfly, OpenMeshOnOpenMeshes) {
  expect_agreement(butterfly(), open_triangles(), kLevels, openmesh);
}
TEST(PeersButterfly, OpenMeshOnTheBracket) {
  expect_agreement(butterfly(), example("bracket.obj"), 2, openmesh);
}

TEST(PeersButterfly, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"edge rule",
       {},
       "[edge]\nend = \"1/2\"\nwing = \"1/8 + 1/10^9\"\nouter = \"-1/16 - 1/2/10^9\"\n"},
      {"boundary edge rule",
       {},
       "[boundary.edge]\nend = \"9/16 + 1/10^9\"\nbeyond = \"-1/16 - 1/10^9\"\n"},
      {"rule at valence 3",
       {{"5/12*(k == 0)", "(5/12 + 2/10^9)*(k == 0)"}, {"- 1/12", "- (1/12 + 1/10^9)"}},
       ""},
      {"rule at valence 4",
       {{"3/8*(k == 0)", "(3/8 + 1/10^9)*(k == 0)"}, {"- 1/8*", "- (1/8 + 1/10^9)*"}},
       ""},
      {"rule at other valences", {{"cos(4*pi*k/n)/2", "cos(4*pi*k/n)/(2 + 1/10^9)"}}, ""},
  };
  expect_notice("butterfly-modified", edits, open_triangles(), 2, openmesh);
}

}  // namespace
}  // namespace limn::peers
