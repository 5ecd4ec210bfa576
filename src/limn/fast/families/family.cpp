#include "limn/fast/families/family.h"

#include <cmath>
#include <map>

#include <fmt/core.h>

#include "limn/fast/families/grid_family.h"
#include "limn/fast/families/kite_family.h"
#include "limn/fast/sites/sharp_steps.h"

namespace limn::fast {
namespace {

/// Whether edges of different sharpness meet that both fade: then the parts of an edge may come to
/// be sharp in different ways.
bool unequal_meet(const Mesh& mesh, const std::vector<double>& edges) {
  std::vector<double> at_vertex(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Index h = mesh.halfedge_of_edge(static_cast<Index>(e));
    if (mesh.twin(h) == kNone || !(edges[e] > 0) || edges[e] >= kInfinitelySharp) continue;
    for (const Index v : {mesh.origin(h), mesh.target(h)}) {
      double& seen = at_vertex[static_cast<std::size_t>(v)];
      if (seen > 0 && seen != edges[e]) return true;
      seen = edges[e];
    }
  }
  return false;
}

/// Whether edges end in one step whose sharpness is then not the same.
bool unequal_end(const Mesh& mesh, const std::vector<double>& edges) {
  std::map<double, double> seen;  // by the step
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!(edges[e] > 0) || edges[e] >= kInfinitelySharp) continue;
    if (mesh.is_boundary_edge(static_cast<Index>(e))) continue;
    if (seen.try_emplace(std::ceil(edges[e]), edges[e]).first->second != edges[e]) return true;
  }
  return false;
}

/// Whether creases change the rules of points beside them.
bool sees_beside(const Scheme& scheme, const GridCycle& cycle) {
  BoundarySides sides{};
  sides[0] = sides[1] = true;
  const std::optional<Reach> reach = find_reach(scheme, cycle, 0, sides);
  return !reach || reach->strip_depth > 0;
}

}  // namespace

bool has_family(const Split& split) { return grid_cycle(split).has_value(); }

std::optional<std::string> why_no_family(const Scheme& scheme, const Mesh& control,
                                         const Sharpness& sharpness) {
  if (!sharpness.any()) return std::nullopt;
  const std::optional<GridCycle> cycle = grid_cycle(*scheme.split);
  if (!cycle || cycle->steps > 1 || cycle->offset)
    return fmt::format("its split, {}, does not cut sharp edges in every step", scheme.split->name);
  if (sharpness.method == CreaseMethod::chaikin && unequal_meet(control, sharpness.edges))
    return "by chaikin, edges of different sharpness that meet do not fade evenly";
  if (unequal_end(control, sharpness.edges) && sees_beside(scheme, *cycle))
    return "its rules look past creases, and these end in a step with different sharpness";
  return std::nullopt;
}

std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control, int levels,
                                    const Sharpness& sharpness) {
  const GridCycle cycle = *grid_cycle(*scheme.split);
  if (cycle.offset) return make_kite_family(scheme, cycle, control, levels);
  // by chaikin, too: see unequal_meet
  return make_grid_family(scheme, cycle, control, levels,
                          {sharpness.edges, sharpness.vertices, {}, CreaseMethod::uniform});
}

}  // namespace limn::fast
