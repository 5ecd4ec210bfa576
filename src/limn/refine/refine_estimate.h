#pragma once
/// What refining a mesh will come to, and whether it can be done, before it is done.

#include <cstddef>
#include <string>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"

namespace limn::refine {

/// What refining will come to, from counts alone. Cost O(levels).
struct RefineEstimate {
  double vertices = 0;    ///< of the result
  double faces = 0;       ///< of the result
  double peak_bytes = 0;  ///< at most, while the last step is being made
};
/// The estimate for the plain engine, `levels` ≥ 0 steps, values of so many bytes at each vertex.
[[nodiscard]] RefineEstimate estimate_refinement(const Split& split, const Mesh& mesh, int levels,
                                                 std::size_t bytes_per_value);

/// In words: "5 levels make about 3e+06 vertices and 6e+06 faces, in about 0.2 GiB of memory".
[[nodiscard]] std::string text_of(const RefineEstimate& estimate, int levels);

/// That the memory of an estimate for so many levels is within `memory_limit` bytes; the error
/// names it.
[[nodiscard]] Status check_memory(const RefineEstimate& estimate, int levels, double memory_limit);

/// Whether `levels` steps can be taken: triangles for a scheme that needs them, fewer than
/// 2^31 half-edges, and the estimated memory within `memory_limit` bytes. The error names the
/// estimate.
[[nodiscard]] Status check_refinable(const Scheme& scheme, const Mesh& mesh, int levels,
                                     std::size_t bytes_per_value, double memory_limit);

}  // namespace limn::refine
