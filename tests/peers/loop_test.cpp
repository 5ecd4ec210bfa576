// Loop's scheme against CGAL, OpenMesh and OpenSubdiv: three codes by three groups.
//
// OpenMesh's CompositeLoopT is left out.

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

TEST(PeersLoop, OpenMeshOnClosedMeshes) {
  expect_agreement(loop(), closed_triangles(), kLevels, openmesh);
}
TEST(PeersLoop, OpenMeshOnOpenMeshes) {
  expect_agreement(loop(), open_triangles(), kLevels, openmesh);
}

TEST(PeersLoop, OpenSubdivOnClosedMeshes) {
  expect_agreement(loop(), closed_triangles(), kLevels, opensubdiv);
}
TEST(PeersLoop, OpenSubdivOnOpenMeshes) {
  expect_agreement(loop(), open_triangles(), kLevels, opensubdiv);
}

}  // namespace
}  // namespace limn::peers
