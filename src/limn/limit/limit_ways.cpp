#include "limn/limit/limit_ways.h"

#include <algorithm>
#include <utility>

#include "limn/mesh/index.h"
#include "limn/scheme/seen_from.h"

namespace limn::limit {
namespace {

using mesh::at;

/// How far a scheme's rules read from their anchor, in edges, at most.
int reach_of(const Scheme& scheme) {
  std::ptrdiff_t reach = 1;
  for (const std::optional<Rule>& rule : scheme.rules) {
    if (!rule) continue;
    for (const RuleCase& one : *rule)
      for (const Weight& weight : one.weights) {
        const auto moves = [](const Moves& walk) {
          return std::count(walk.begin(), walk.end(), Move::vertex);
        };
        reach = std::max(reach, moves(weight.walk.before) + moves(weight.walk.after) +
                                    (weight.walk.reads_face ? 1 : 0));
      }
  }
  return static_cast<int>(reach);
}

/// Whether the limit at a vertex depends on the rules that make its neighbours: because a rule
/// crosses edges but round its own vertex, or is seen from one.
bool goes_far(const Scheme& scheme) {
  if (scheme::has_rules_seen_from(scheme)) return true;
  for (const std::optional<Rule>& rule : scheme.rules) {
    if (!rule) continue;
    for (const RuleCase& one : *rule)
      for (const Weight& weight : one.weights)
        if (!weight.walk.repeated &&
            std::count(weight.walk.before.begin(), weight.walk.before.end(), Move::face) > 0)
          return true;
  }
  return false;
}

bool fades(double sharpness) { return sharpness > 0 && sharpness < kInfinitelySharp; }

/// All vertices within so many rings of faces of those taken, too.
void widen(const Mesh& mesh, int rings, std::vector<bool>& taken) {
  std::vector<Index> near;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (taken[at(v)]) near.push_back(v);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Index> next;
    for (const Index v : near) {
      const Index first = mesh.halfedge_of_vertex(v);
      for (Index h = first; h != kNone;) {
        for (Index g = mesh.next(h); g != h; g = mesh.next(g)) {
          if (taken[at(mesh.origin(g))]) continue;
          taken[at(mesh.origin(g))] = true;
          next.push_back(mesh.origin(g));
        }
        h = mesh.rotate(h);
        if (h == first) break;
      }
    }
    near = std::move(next);
  }
}

/// What sharpness makes of the vertices, each by itself.
struct Vertices {
  std::vector<refine::CreaseStep::Rule> kinds;
  std::vector<bool> fading;   // the vertex or an edge of it
  std::vector<bool> resting;  // darts and corners
};

Vertices vertices_of(const Mesh& mesh, const Sharpness& sharpness, std::vector<bool>& sharp) {
  const std::size_t count = at(mesh.vertex_count());
  Vertices found{{}, std::vector<bool>(count, false), std::vector<bool>(count, false)};
  std::vector<Index> edges(count, 0);
  sharp.resize(at(mesh.edge_count()));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const double sharpness_here = sharpness_of_edge(mesh, sharpness, e);
    sharp[at(e)] = sharpness_here > 0;
    if (!sharp[at(e)]) continue;
    const Index h = mesh.halfedge_of_edge(e);
    for (const Index v : {mesh.origin(h), mesh.target(h)}) {
      ++edges[at(v)];
      if (fades(sharpness_here)) found.fading[at(v)] = true;
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    using Kind = refine::CreaseStep::Rule;
    const double own = sharpness.vertices.empty() ? 0 : sharpness.vertices[v];
    const Kind kind = refine::CreaseStep::rule_of(own, edges[v]);
    found.kinds.push_back(kind);
    if (fades(own)) found.fading[v] = true;
    found.resting[v] = kind == Kind::dart || kind == Kind::corner;
  }
  return found;
}

}  // namespace

int rings_of_limit(const Scheme& scheme) { return 3 * reach_of(scheme) + 2; }

std::vector<Index> LimitWays::those(LimitWay way) const {
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < ways.size(); ++v)
    if (ways[v] == way) vertices.push_back(static_cast<Index>(v));
  return vertices;
}

LimitWays limit_ways(const Scheme& scheme, const Mesh& mesh, const Sharpness& sharpness,
                     const std::vector<Index>& vertices) {
  LimitWays result;
  auto [kinds, fading, resting] = vertices_of(mesh, sharpness, result.sharp);
  std::vector<bool> near = fading;
  if (goes_far(scheme)) {
    for (std::size_t v = 0; v < near.size(); ++v) near[v] = near[v] || resting[v];
    // what a part cuts at its rim is farther from its centres
    const int rings = rings_of_limit(scheme) - 1;
    widen(mesh, rings, near);
    widen(mesh, rings, fading);
  }
  std::vector<bool> wanted(kinds.size(), vertices.empty());
  for (const Index v : vertices) wanted[at(v)] = true;
  result.kinds = std::move(kinds);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    LimitWay way = LimitWay::on_cut;
    if (resting[at(v)]) way = LimitWay::resting;
    if (resting[at(v)] ? fading[at(v)] : near[at(v)]) way = LimitWay::later;
    if (mesh.is_isolated(v)) way = LimitWay::on_cut;
    result.ways.push_back(wanted[at(v)] ? way : LimitWay::none);
  }
  return result;
}

}  // namespace limn::limit
