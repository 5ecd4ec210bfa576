// Repeated evaluation: OpenSubdiv's tables and level-by-level sums against the plain engine.

#include "repeated_peer.h"

#include "limn/base/parallel.h"
#include "peer_test.h"

namespace limn::peers {
namespace {

using Make = std::unique_ptr<RepeatedPeer> (*)(Method, const Polygons&, int, Precision,
                                               const PeerTags&);

/// The faces are those of `opensubdiv_peer`, whose vertices have the same numbers.
std::string difference_after(const Scheme& scheme, Method method, const Polygons& control,
                             int levels, Make make) {
  const std::unique_ptr<Peer> peer = opensubdiv_peer(method, control);
  peer->refine(levels);
  Polygons theirs = peer->polygons();
  const std::unique_ptr<RepeatedPeer> repeated =
      make(method, control, levels, Precision::double_float, {});
  repeated->evaluate();
  repeated->evaluate();
  EXPECT_EQ(repeated->vertex_count(), theirs.positions.size());
  theirs.positions = repeated->points();
  return difference(refined(scheme, control, levels), theirs);
}

void expect_same(const char* name, Method method, const std::vector<ControlMesh>& meshes,
                 Make make) {
  const Scheme scheme = find_scheme(name).value();
  for (const ControlMesh& mesh : meshes)
    for (const int levels : {1, 3})
      EXPECT_EQ(difference_after(scheme, method, mesh.polygons, levels, make), "")
          << mesh.name << ", level " << levels;
}

TEST(PeersRepeated, StencilsOfLoop) {
  expect_same("loop", Method::loop, open_triangles(), opensubdiv_stencils);
}
TEST(PeersRepeated, StencilsOfCatmullClark) {
  expect_same("catmull-clark", Method::catmull_clark, open_polygons(), opensubdiv_stencils);
}
TEST(PeersRepeated, PrimvarsOfLoop) {
  expect_same("loop", Method::loop, open_triangles(), opensubdiv_primvars);
}
TEST(PeersRepeated, PrimvarsOfCatmullClark) {
  expect_same("catmull-clark", Method::catmull_clark, open_polygons(), opensubdiv_primvars);
}

TEST(PeersRepeated, ManyThreadsAndOneGiveTheSame) {
  const Polygons control = random_sphere(4, 100, 9, 3);  // more stencils than a chunk has
  const auto points = [&](int threads) {
    set_thread_limit(threads);
    const auto peer = opensubdiv_stencils(Method::loop, control, 2);
    peer->evaluate();
    set_thread_limit(0);
    return peer->points();
  };
  EXPECT_EQ(points(1), points(2));
}

TEST(PeersRepeated, OtherMethodsAreNotThere) {
  const Polygons control = random_sphere(1, 0, 6, 1);
  EXPECT_EQ(opensubdiv_stencils(Method::sqrt3, control, 1), nullptr);
  EXPECT_EQ(opensubdiv_primvars(Method::doo_sabin, control, 1), nullptr);
}

}  // namespace
}  // namespace limn::peers
