#include "limn/limit/characteristic_map.h"

#include <cmath>

#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "limn/refine/star_step.h"

namespace limn {
namespace {

/// Vertices within so many rings of faces round the centre: vertex 0, or face 0 of a dual split.
std::vector<bool> within(const Mesh& mesh, bool dual, int rings) {
  std::vector<bool> near(static_cast<std::size_t>(mesh.vertex_count()), false);
  std::vector<Index> front;
  const auto reach = [&](Index v) {
    if (near[v]) return;
    near[v] = true;
    front.push_back(v);
  };
  if (dual)
    for (Index h = mesh.face_begin(0); h < mesh.face_begin(1); ++h) reach(mesh.origin(h));
  else
    reach(0);
  for (int ring = dual ? 1 : 0; ring < rings; ++ring) {
    const std::vector<Index> last = std::move(front);
    front.clear();
    for (const Index v : last) {
      const Index first = mesh.halfedge_of_vertex(v);
      for (Index h = first; h != kNone;) {
        for (Index g = mesh.next(h); g != h; g = mesh.next(g)) reach(mesh.origin(g));
        h = mesh.rotate(h);
        if (h == first) break;
      }
    }
  }
  return near;
}

/// Cycles that cut an edge in two, or half as many that cut it in three; a cycle is two steps where
/// these turn the star.
int steps_made(const Split& split, int steps) {
  const int cycles = arity(split.dilation) == 2 ? steps : steps / 2;
  return split.dilation.turns() ? 2 * cycles : cycles;
}

/// The faces all of whose vertices are kept, and those vertices' limit points.
Result<StarSurface> kept_part(const Mesh& mesh, const std::vector<bool>& kept,
                              const std::vector<Index>& vertices, const LimitPoints& limit) {
  std::vector<Index> name(kept.size(), kNone);
  for (std::size_t i = 0; i < vertices.size(); ++i) name[vertices[i]] = static_cast<Index>(i);
  Polygons polygons;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    bool whole = true;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      whole = whole && kept[mesh.origin(h)];
    if (!whole) continue;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      polygons.corners.push_back(name[mesh.origin(h)]);
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  polygons.positions.resize(vertices.size());
  Result<Mesh> part = Mesh::build(polygons);
  if (!part) return part.error();
  StarSurface surface{std::move(*part), {}, {}};
  for (const Index v : vertices) {
    surface.positions.push_back(limit.positions[v]);
    surface.normals.push_back(limit.normals[v]);
  }
  return surface;
}

}  // namespace

Result<StarSurface> approx_star_surface(const Scheme& scheme, int n, int rings,
                                        const std::vector<Point3>& values, int steps) {
  const Split& split = *scheme.split;
  const bool dual = split.is_dual();
  const int step_count = steps_made(split, steps);
  refine::Refined<Point3> fine{refine::split_star(split, n, rings), values};
  refine::RuleTables<double> tables(scheme, refine::Boundary::left_out);
  for (int step = 0; step < step_count; ++step) {
    Result<refine::Refined<Point3>> next =
        refine::refine_once(scheme, fine.mesh, fine.values, step, tables);
    if (!next) return next.error();
    fine = std::move(*next);
  }
  const double growth = std::pow(split.dilation.growth(), step_count / 2.0);
  const std::vector<bool> kept = within(fine.mesh, dual, static_cast<int>(std::lround(growth)));
  LimitOptions options;
  options.steps_made = step_count;
  options.boundary = false;
  for (Index v = 0; v < fine.mesh.vertex_count(); ++v)
    if (kept[v]) options.vertices.push_back(v);
  const Result<LimitPoints> limit = approx_limit_points(scheme, fine.mesh, fine.values, options);
  if (!limit) return limit.error();
  return kept_part(fine.mesh, kept, options.vertices, *limit);
}

}  // namespace limn
