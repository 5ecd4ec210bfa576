// Limit positions and normals against OpenSubdiv's, boundaries included.

#include "limn/limit/limit_points.h"

#include "limn/refine/refine.h"
#include "peer_test.h"

namespace limn::peers {
namespace {

/// Our refined mesh with its points moved to the limit and, inside, by `offset` along the normals.
Polygons our_limit(const Scheme& scheme, const Polygons& control, int levels, double offset) {
  refine::Refined<Point3> refined =
      refine::refine(scheme, Mesh::build(control).value(), control.positions, levels).value();
  LimitOptions options;
  options.steps_made = levels;
  LimitPoints limit = approx_limit_points(scheme, refined.mesh, refined.values, options).value();
  for (std::size_t v = 0; v < limit.positions.size(); ++v)
    if (!refined.mesh.is_boundary_vertex(static_cast<Index>(v)))
      limit.positions[v] = limit.positions[v] + offset * limit.normals[v];
  return refined.mesh.polygons(std::move(limit.positions));
}

void expect_same_limit(const char* name, Method method, const std::vector<ControlMesh>& meshes,
                       double offset) {
  const Scheme scheme = find_scheme(name).value();
  for (const ControlMesh& control : meshes)
    for (const int levels : {1, 2}) {
      const auto peer = opensubdiv_peer(method, control.polygons);
      peer->want_limit();
      peer->refine(levels);
      ASSERT_TRUE(peer->move_to_limit(offset));
      EXPECT_EQ(
          difference(our_limit(scheme, control.polygons, levels, offset), peer->polygons(), 1e-11),
          "")
          << name << ' ' << control.name << ' ' << levels;
    }
}

TEST(PeersLimit, LoopPositions) {
  expect_same_limit("loop", Method::loop, closed_triangles(), 0);
  expect_same_limit("loop", Method::loop, open_triangles(), 0);
}
TEST(PeersLimit, LoopNormals) {
  expect_same_limit("loop", Method::loop, closed_triangles(), 0.1);
  expect_same_limit("loop", Method::loop, open_triangles(), 0.1);
}
TEST(PeersLimit, CatmullClarkPositions) {
  expect_same_limit("catmull-clark", Method::catmull_clark, closed_polygons(), 0);
  expect_same_limit("catmull-clark", Method::catmull_clark, open_polygons(), 0);
}
TEST(PeersLimit, CatmullClarkNormals) {
  expect_same_limit("catmull-clark", Method::catmull_clark, closed_polygons(), 0.1);
  expect_same_limit("catmull-clark", Method::catmull_clark, open_polygons(), 0.1);
}

}  // namespace
}  // namespace limn::peers
