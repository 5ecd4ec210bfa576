// Loop's scheme against CGAL, OpenMesh (LoopT) and OpenSubdiv.

#include "peer_test.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 3;

const Scheme& loop() {
  static const Scheme scheme = find_scheme("loop").value();
  return scheme;
}

std::unique_ptr<Peer> cgal(const Polygons& control) { return cgal_peer(Method::loop, control); }

std::unique_ptr<Peer> openmesh(const Polygons& control) {
  return openmesh_peer(Method::loop, control);
}

std::unique_ptr<Peer> opensubdiv(const Polygons& control) {
  return opensubdiv_peer(Method::loop, control);
}

TEST(PeersLoop, CgalOnClosedMeshes) { expect_agreement(loop(), closed_triangles(), kLevels, cgal); }
TEST(PeersLoop, CgalOnOpenMeshes) { expect_agreement(loop(), open_triangles(), kLevels, cgal); }
TEST(PeersLoop, CgalOnTheBracket) { expect_agreement(loop(), example("bracket.obj"), 2, cgal); }

TEST(PeersLoop, OpenMeshOnClosedMeshes) {
  expect_agreement(loop(), closed_triangles(), kLevels, openmesh);
}
TEST(PeersLoop, OpenMeshOnOpenMeshes) {
  expect_agreement(loop(), open_triangles(), kLevels, openmesh);
}
TEST(PeersLoop, OpenMeshOnTheBracket) {
  expect_agreement(loop(), example("bracket.obj"), 2, openmesh);
}

TEST(PeersLoop, OpenSubdivOnClosedMeshes) {
  expect_agreement(loop(), closed_triangles(), kLevels, opensubdiv);
}
TEST(PeersLoop, OpenSubdivOnOpenMeshes) {
  expect_agreement(loop(), open_triangles(), kLevels, opensubdiv);
}
TEST(PeersLoop, OpenSubdivOnTheBracket) {
  expect_agreement(loop(), example("bracket.obj"), 2, opensubdiv);
}

TEST(PeersLoop, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"vertex rule", {{"5/8 - lambda^2", "5/8 - lambda^2 + 1/10^9"}}, ""},
      {"edge rule",
       {{"end  = \"3/8\"", "end  = \"3/8 + 1/10^9\""},
        {"wing = \"1/8\"", "wing = \"1/8 - 1/10^9\""}},
       ""},
      {"boundary vertex rule",
       {{"self = \"3/4\"", "self = \"3/4 + 2/10^9\""},
        {"next = \"1/8\"", "next = \"1/8 - 1/10^9\""}},
       ""},
  };
  expect_notice("loop", edits, open_triangles(), 2, cgal);
}

}  // namespace
}  // namespace limn::peers
