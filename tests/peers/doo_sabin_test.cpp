// Doo and Sabin's scheme against CGAL.

#include "peer_test.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 3;

const Scheme& doo_sabin() {
  static const Scheme scheme = find_scheme("doo-sabin").value();
  return scheme;
}

std::unique_ptr<Peer> cgal(const Polygons& control) {
  return cgal_peer(Method::doo_sabin, control);
}

TEST(PeersDooSabin, CgalOnClosedMeshes) {
  expect_agreement(doo_sabin(), closed_polygons(), kLevels, cgal);
}
TEST(PeersDooSabin, CgalOnOpenMeshes) {
  expect_agreement(doo_sabin(), open_polygons(), kLevels, cgal);
}
TEST(PeersDooSabin, CgalOnTheBracket) {
  expect_agreement(doo_sabin(), example("bracket-quads.obj"), 2, cgal);
}

TEST(PeersDooSabin, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"corner rule", {{"2*cos(2*pi*k/n)", "(2 + 1/10^9)*cos(2*pi*k/n)"}}, ""},
  };
  expect_notice("doo-sabin", edits, open_polygons(), 2, cgal);
}

}  // namespace
}  // namespace limn::peers
