// Creases, corners, boundaries and holes against OpenSubdiv, on random meshes with random tags.
//
// OpenSubdiv keeps sharpness as floats, which is exact for infinite and for integer sharpness. Its
// weights are those of doubles all the same.

#include <algorithm>
#include <cmath>
#include <random>

#include "limn/fast/fast_refiner.h"
#include "limn/limit/crease_limit.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "peer_test.h"
#include "stated.h"

namespace limn::peers {
namespace {

constexpr int kLevels = 4;
constexpr Index kLargeMesh = 60;  // faces; one level less

/// How sharp what is sharp shall be.
enum class Kind { infinite, whole, fractional };

float random_sharpness(Kind kind, std::mt19937& random) {
  std::uniform_int_distribution<int> integer(1, 4);
  std::uniform_real_distribution<float> real(0.05F, 4.5F);
  if (kind == Kind::infinite) return 10;
  return kind == Kind::whole ? static_cast<float>(integer(random)) : real(random);
}

/// Tags of some of the edges, vertices and faces of a mesh.
PeerTags random_tags(const Mesh& mesh, Kind kind, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  PeerTags tags;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (unit(random) > share) continue;
    const Index h = mesh.halfedge_of_edge(e);
    tags.edges.push_back({mesh.origin(h), mesh.target(h)});
    tags.edge_sharpness.push_back(random_sharpness(kind, random));
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (unit(random) > share / 3) continue;
    tags.corners.push_back(v);
    tags.corner_sharpness.push_back(random_sharpness(kind, random));
  }
  return tags;
}

Sharpness sharpness_of(const Mesh& mesh, const PeerTags& tags) {
  Sharpness result;
  result.edges.assign(static_cast<std::size_t>(mesh.edge_count()), 0);
  result.vertices.assign(static_cast<std::size_t>(mesh.vertex_count()), 0);
  std::size_t next = 0;  // tags stand in the order of edges
  for (Index e = 0; e < mesh.edge_count() && next < tags.edges.size(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (tags.edges[next] != std::array{mesh.origin(h), mesh.target(h)}) continue;
    result.edges[static_cast<std::size_t>(e)] = static_cast<double>(tags.edge_sharpness[next++]);
  }
  EXPECT_EQ(next, tags.edges.size());
  for (std::size_t i = 0; i < tags.corners.size(); ++i)
    result.vertices[static_cast<std::size_t>(tags.corners[i])] =
        static_cast<double>(tags.corner_sharpness[i]);
  if (!tags.holes.empty()) result.holes.assign(static_cast<std::size_t>(mesh.face_count()), false);
  for (const Index f : tags.holes) result.holes[static_cast<std::size_t>(f)] = true;
  if (tags.chaikin) result.method = CreaseMethod::chaikin;
  apply_boundary_mode(mesh, boundary_mode_of(tags), result);
  return result;
}

/// With all vertices, and the faces that are no holes, as the peer has them.
Polygons refined_with(const Scheme& scheme, const Polygons& control, const PeerTags& tags,
                      int levels) {
  const Mesh mesh = Mesh::build(control).value();
  const auto fine =
      refine::refine(scheme, mesh, control.positions, levels, {}, sharpness_of(mesh, tags)).value();
  return without(fine.mesh.polygons(fine.values), fine.sharpness.holes);
}

/// The same by the quick engine; empty where it takes no such sharpness.
Polygons quickly_refined_with(const Scheme& scheme, const Polygons& control, const PeerTags& tags,
                              int levels) {
  const Mesh mesh = Mesh::build(control).value();
  const Sharpness sharpness = sharpness_of(mesh, tags);
  if (why_no_fast_sharpness(scheme, mesh, sharpness)) return {};
  const FastRefiner refiner = FastRefiner::make(scheme, mesh, levels, sharpness).value();
  std::vector<Point3> fine(static_cast<std::size_t>(refiner.vertex_count()));
  refiner.evaluate<double>(numbers_of(control.positions), numbers_of(fine));
  std::vector<Index> face_of(static_cast<std::size_t>(refiner.face_count()));
  refiner.write_parents(face_of);
  std::vector<bool> holes;
  for (const Index f : face_of)
    holes.push_back(sharpness.has_holes() && sharpness.holes[static_cast<std::size_t>(f)]);
  return without(refined_polygons(refiner, std::move(fine)), holes);
}

std::string difference_with(Method method, const Polygons& control, const PeerTags& tags, int level,
                            double tolerance) {
  const Scheme scheme = find_scheme(method == Method::loop ? "loop" : "catmull-clark").value();
  const std::unique_ptr<Peer> peer = opensubdiv_peer(method, control, tags);
  peer->refine(level);
  const Polygons quick = quickly_refined_with(scheme, control, tags, level);
  const std::string plain =
      difference(refined_with(scheme, control, tags, level), peer->polygons(), tolerance);
  if (!plain.empty() || quick.face_count() == 0) return plain;
  return difference(quick, peer->polygons(), tolerance);
}

std::vector<ControlMesh> meshes_for(Method method) {
  std::vector<ControlMesh> all = method == Method::loop ? closed_triangles() : closed_polygons();
  for (ControlMesh& mesh : method == Method::loop ? open_triangles() : open_polygons())
    all.push_back(std::move(mesh));
  std::erase_if(all, [](const ControlMesh& mesh) { return mesh.polygons.face_count() > 200; });
  return all;
}

class Sharp : public ::testing::TestWithParam<Method> {
 protected:
  void compare(Kind kind, double tolerance,
               const std::function<void(const Mesh&, PeerTags&, unsigned)>& change = {}) const {
    unsigned seed = 7;
    for (const ControlMesh& control : meshes_for(GetParam())) {
      const Mesh mesh = Mesh::build(control.polygons).value();
      for (const double share : {0.1, 0.5}) {
        PeerTags tags = random_tags(mesh, kind, share, ++seed);
        if (change) change(mesh, tags, seed);
        const int levels = mesh.face_count() > kLargeMesh ? kLevels - 1 : kLevels;
        for (int level = 1; level <= levels; ++level)
          EXPECT_EQ(difference_with(GetParam(), control.polygons, tags, level, tolerance), "")
              << control.name << ", share " << share << ", level " << level;
      }
    }
  }
};

TEST_P(Sharp, InfiniteCreasesAndCorners) { compare(Kind::infinite, 1e-12); }
TEST_P(Sharp, IntegerSharpness) { compare(Kind::whole, 1e-12); }
TEST_P(Sharp, FractionalSharpness) { compare(Kind::fractional, 1e-6); }
TEST_P(Sharp, Chaikin) {
  compare(Kind::fractional, 1e-6,
          [](const Mesh&, PeerTags& tags, unsigned) { tags.chaikin = true; });
}
TEST_P(Sharp, SharpCornersOfTheBoundary) {
  compare(Kind::whole, 1e-12, [](const Mesh&, PeerTags& tags, unsigned) { tags.boundary = 2; });
}
TEST_P(Sharp, NoBoundary) {
  compare(Kind::infinite, 1e-12, [](const Mesh&, PeerTags& tags, unsigned) { tags.boundary = 0; });
}
TEST_P(Sharp, Holes) {
  compare(Kind::whole, 1e-12, [](const Mesh& mesh, PeerTags& tags, unsigned seed) {
    std::mt19937 random(seed);
    for (Index f = 1; f < mesh.face_count(); ++f)
      if (random() % 4 == 0) tags.holes.push_back(f);
  });
}

/// Tags without the edges that end inside, one after the other until there are no darts.
PeerTags without_darts(const Mesh& mesh, PeerTags tags) {
  for (std::size_t before = 0; before != tags.edges.size();) {
    before = tags.edges.size();
    std::vector<int> count(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const auto& ends : tags.edges)
      for (const Index v : ends) ++count[static_cast<std::size_t>(v)];
    std::erase_if(tags.edges, [&](const std::array<Index, 2>& ends) {
      return std::any_of(ends.begin(), ends.end(), [&](Index v) {
        return !mesh.is_boundary_vertex(v) && count[static_cast<std::size_t>(v)] == 1;
      });
    });
  }
  tags.edge_sharpness.assign(tags.edges.size(), 10);
  return tags;
}

// At darts OpenSubdiv takes the limit of a smooth vertex, which is not where the points go.
TEST_P(Sharp, LimitsOfInfiniteCreasesAndCorners) {
  unsigned seed = 30;
  for (const ControlMesh& control : meshes_for(GetParam())) {
    const Mesh mesh = Mesh::build(control.polygons).value();
    const PeerTags tags = without_darts(mesh, random_tags(mesh, Kind::infinite, 0.4, ++seed));
    const auto peer = opensubdiv_peer(GetParam(), control.polygons, tags);
    peer->want_limit();
    peer->refine(2);
    ASSERT_TRUE(peer->move_to_limit(0));
    const Scheme scheme =
        find_scheme(GetParam() == Method::loop ? "loop" : "catmull-clark").value();
    const auto fine =
        refine::refine(scheme, mesh, control.polygons.positions, 2, {}, sharpness_of(mesh, tags))
            .value();
    const LimitPoints limit =
        limit::approx_limit_points(scheme, fine.mesh, fine.values, fine.sharpness).value();
    EXPECT_EQ(difference(fine.mesh.polygons(limit.positions), peer->polygons(), 1e-11), "")
        << control.name;
  }
}

// After so many levels nothing is sharp in OpenSubdiv's mesh, so that its limits are those of a
// smooth one; ours are found three levels earlier, while much still fades.
TEST_P(Sharp, LimitsOfWhatFades) {
  constexpr int sharp_levels = 2, levels = 5;
  unsigned seed = 50;
  int fading = 0;
  for (const ControlMesh& control : meshes_for(GetParam())) {
    const Mesh mesh = Mesh::build(control.polygons).value();
    if (mesh.face_count() > kLargeMesh / 2) continue;
    for (const bool chaikin : {false, true}) {
      PeerTags tags = random_tags(mesh, Kind::fractional, 0.4, ++seed);
      tags.chaikin = chaikin;
      const auto peer = opensubdiv_peer(GetParam(), control.polygons, tags);
      peer->want_limit();
      peer->refine(levels);
      ASSERT_TRUE(peer->move_to_limit(0));
      const Polygons theirs = peer->polygons();
      const Scheme scheme =
          find_scheme(GetParam() == Method::loop ? "loop" : "catmull-clark").value();
      const auto fine = refine::refine(scheme, mesh, control.polygons.positions, sharp_levels, {},
                                       sharpness_of(mesh, tags))
                            .value();
      fading += fine.sharpness.fades() ? 1 : 0;
      const limit::SharpLimitPoints limit =
          limit::approx_limit_points(scheme, fine.mesh, fine.values, fine.sharpness).value();
      // each of ours is one of theirs: the child of its child
      double most = 0;
      for (const Point3& ours : limit.positions) {
        double nearest = HUGE_VAL;
        for (const Point3& p : theirs.positions)
          nearest = std::min(nearest, dot(p - ours, p - ours));
        most = std::max(most, nearest);
      }
      EXPECT_LT(std::sqrt(most), 1e-5) << control.name << (chaikin ? ", chaikin" : "");
    }
  }
  EXPECT_GT(fading, 5);
}

// --- smooth triangles --------------------------------------------------------------------------

Scheme smooth_catmull_clark() {
  Scheme scheme = find_scheme("catmull-clark").value();
  EXPECT_TRUE(use_smooth_triangles(scheme));
  return scheme;
}

/// Triangles, quads and larger faces, closed and open.
std::vector<ControlMesh> mixed_meshes() {
  std::vector<ControlMesh> all = closed_polygons();
  for (std::vector<ControlMesh> more : {open_polygons(), closed_triangles(), open_triangles()})
    for (ControlMesh& mesh : more) all.push_back(std::move(mesh));
  std::erase_if(all, [](const ControlMesh& mesh) { return mesh.polygons.face_count() > 200; });
  return all;
}

TEST(SmoothTriangles, AreThoseOfOpenSubdiv) {
  const Scheme smooth = smooth_catmull_clark();
  const Scheme plain = find_scheme("catmull-clark").value();
  int changed = 0;
  unsigned seed = 90;
  for (const ControlMesh& control : mixed_meshes()) {
    const Mesh mesh = Mesh::build(control.polygons).value();
    for (const double share : {0.0, 0.3}) {
      PeerTags tags = random_tags(mesh, Kind::whole, share, ++seed);
      tags.smooth_triangles = true;
      for (int level = 1; level <= 3; ++level) {
        const auto peer = opensubdiv_peer(Method::catmull_clark, control.polygons, tags);
        peer->refine(level);
        EXPECT_EQ(difference(refined_with(smooth, control.polygons, tags, level), peer->polygons(),
                             1e-12),
                  "")
            << control.name << ", share " << share << ", level " << level;
        if (level == 1 &&
            !difference(refined_with(plain, control.polygons, tags, level), peer->polygons(), 1e-12)
                 .empty())
          ++changed;
      }
    }
  }
  EXPECT_GT(changed, 4);
}

TEST(SmoothTriangles, HaveTheLimitsOfOpenSubdiv) {
  const Scheme smooth = smooth_catmull_clark();
  for (const ControlMesh& control : mixed_meshes()) {
    const Mesh mesh = Mesh::build(control.polygons).value();
    PeerTags tags;
    tags.smooth_triangles = true;
    const auto peer = opensubdiv_peer(Method::catmull_clark, control.polygons, tags);
    peer->want_limit();
    peer->refine(1);
    ASSERT_TRUE(peer->move_to_limit(0));
    const auto fine = refine::refine(smooth, mesh, control.polygons.positions, 1).value();
    const LimitPoints limit = approx_limit_points(smooth, fine.mesh, fine.values).value();
    EXPECT_EQ(difference(fine.mesh.polygons(limit.positions), peer->polygons(), 1e-12), "")
        << control.name;
    // and those of the control points are the same, found without that step
    const LimitPoints early = approx_limit_points(smooth, mesh, control.polygons.positions).value();
    for (std::size_t v = 0; v < early.positions.size(); ++v)
      EXPECT_LT(std::sqrt(dot(early.positions[v] - limit.positions[v],
                              early.positions[v] - limit.positions[v])),
                1e-10)
          << control.name << ", vertex " << v;
  }
}

INSTANTIATE_TEST_SUITE_P(OpenSubdiv, Sharp, ::testing::Values(Method::loop, Method::catmull_clark),
                         [](const auto& one) {
                           return one.param == Method::loop ? "Loop" : "CatmullClark";
                         });

}  // namespace
}  // namespace limn::peers
