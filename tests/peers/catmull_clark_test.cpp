// Catmull and Clark's scheme against CGAL, OpenSubdiv and OpenMesh, from any polygons.
//
// OpenMesh 9.0 moves a boundary vertex to the mean of itself and the middles of its two boundary
// edges, (1/6 2/3 1/6): the limit point of the cubic B-spline, not its refinement (1/8 3/4 1/8)
// that Catmull-Clark means, CGAL and OpenSubdiv have, and so has limn. With that one rule changed
// limn agrees with OpenMesh on open meshes too, so all the rest of them is compared.

#include "peer_test.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 3;

const Scheme& catmull_clark() {
  static const Scheme scheme = find_scheme("catmull-clark").value();
  return scheme;
}

std::unique_ptr<Peer> cgal(const Polygons& control) {
  return cgal_peer(Method::catmull_clark, control);
}

std::unique_ptr<Peer> opensubdiv(const Polygons& control) {
  return opensubdiv_peer(Method::catmull_clark, control);
}

std::unique_ptr<Peer> openmesh(const Polygons& control) {
  return openmesh_peer(Method::catmull_clark, control);
}

TEST(PeersCatmullClark, CgalOnClosedMeshes) {
  expect_agreement(catmull_clark(), closed_polygons(), kLevels, cgal);
}
TEST(PeersCatmullClark, CgalOnOpenMeshes) {
  expect_agreement(catmull_clark(), open_polygons(), kLevels, cgal);
}
TEST(PeersCatmullClark, CgalOnTheBracket) {
  expect_agreement(catmull_clark(), example("bracket-quads.obj"), 2, cgal);
}

TEST(PeersCatmullClark, OpenSubdivOnClosedMeshes) {
  expect_agreement(catmull_clark(), closed_polygons(), kLevels, opensubdiv);
}
TEST(PeersCatmullClark, OpenSubdivOnOpenMeshes) {
  expect_agreement(catmull_clark(), open_polygons(), kLevels, opensubdiv);
}
TEST(PeersCatmullClark, OpenSubdivOnTheBracket) {
  expect_agreement(catmull_clark(), example("bracket-quads.obj"), 2, opensubdiv);
}

TEST(PeersCatmullClark, OpenMeshOnClosedMeshes) {
  expect_agreement(catmull_clark(), closed_polygons(), kLevels, openmesh);
}

TEST(PeersCatmullClark, OpenMeshOnOpenMeshesButForItsBoundaryVertices) {
  const Scheme theirs =
      edited_scheme("catmull-clark",
                    {"boundary vertex rule",
                     {{"self = \"3/4\"", "self = \"2/3\""}, {"next = \"1/8\"", "next = \"1/6\""}},
                     ""});
  expect_agreement(theirs, open_polygons(), kLevels, openmesh);
}

TEST(PeersCatmullClark, AChangedWeightIsNoticed) {
  const std::vector<Edit> edits{
      {"edge rule",
       {{"end  = \"1/4\"", "end  = \"1/4 + 1/10^9\""},
        {"face = \"1/4\"", "face = \"1/4 - 1/10^9\""},
        {"[smooth-triangles]\nedge-side = [ { when = \"n == 3\", end = \"3/100\", face = "
         "\"47/100\" }, { end = \"1/4\", face = \"1/4\" } ]\n",
         ""}},  // it says of quads what the edge rule says
       ""},
      {"vertex rule",
       {{"face = \"1/n^2\"", "face = \"(1 + 1/10^9)/n^2\""},
        {"ring = \"1/n^2\"", "ring = \"(1 - 1/10^9)/n^2\""}},
       ""},
      {"boundary vertex rule",
       {{"self = \"3/4\"", "self = \"3/4 + 2/10^9\""},
        {"next = \"1/8\"", "next = \"1/8 - 1/10^9\""}},
       ""},
  };
  expect_notice("catmull-clark", edits, open_polygons(), 2, cgal);
}

}  // namespace
}  // namespace limn::peers
