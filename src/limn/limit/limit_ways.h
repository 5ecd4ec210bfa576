#pragma once
/// How the limit of each vertex of a mesh with sharpness is found. Private to crease_limit.

#include <cstdint>
#include <vector>

#include "limn/limit/limit_points.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/refine/crease_step.h"

namespace limn::limit {

enum class LimitWay : std::uint8_t {
  none,     ///< it is not asked for
  on_cut,   ///< amid the surface or on a crease: of the mesh that is cut along its sharp edges
  resting,  ///< dart or corner: the neighbourhood is refined until it rests
  later,    ///< something fades here, or near: its neighbourhood is refined until it has faded
};

/// By vertices, but `sharp`, by edges.
struct LimitWays {
  std::vector<LimitWay> ways;
  std::vector<refine::CreaseStep::Rule> kinds;  ///< of the first step
  std::vector<bool> sharp;                      ///< whether the edge is, at all

  [[nodiscard]] std::vector<Index> those(LimitWay way) const;  ///< ascending
};

/// In how many rings of faces round a vertex all is that its limit depends on, some steps later.
[[nodiscard]] int rings_of_limit(const Scheme& scheme);

/// Of `vertices`, each once, or of all where it is empty. Cost O(size of the mesh).
[[nodiscard]] LimitWays limit_ways(const Scheme& scheme, const Mesh& mesh,
                                   const Sharpness& sharpness, const std::vector<Index>& vertices);

}  // namespace limn::limit
