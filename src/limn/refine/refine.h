#pragma once
/// Refinement of meshes: scheme × mesh → finer mesh.

#include <cstdint>
#include <functional>

#include "limn/refine/refine_values.h"

namespace limn {

/// What refining will come to, from counts alone. Cost O(levels).
struct RefineEstimate {
  double vertices = 0, faces = 0;  ///< of the result
  double peak_bytes = 0;           ///< at most, while the last step is being made
};
[[nodiscard]] RefineEstimate estimate_refinement(const Split& split, const Mesh& mesh, int levels,
                                                 std::size_t bytes_per_value);

/// Memory that this machine can give us now, in bytes; infinity where it cannot be told.
[[nodiscard]] double available_memory();

/// Whether `levels` steps can be taken: triangles for a scheme that needs them, fewer than
/// 2^31 half-edges, and the estimated memory within `memory_limit` bytes. The error names the
/// estimate.
[[nodiscard]] Status check_refinable(const Scheme& scheme, const Mesh& mesh, int levels,
                                     std::size_t bytes_per_value, double memory_limit);

/// Called after each step with the number of steps made so far.
using RefineProgress = std::function<void(int done, int levels, const Mesh& mesh)>;

template <class Value>
struct Refined {
  Mesh mesh;
  std::vector<Value> values;
};

/// `levels` ≥ 0 steps from the control mesh. Fails as `check_refinable` and
/// `RuleTables::prepare` do. `Number` is the type of the weights.
template <class Value, class Number = double>
[[nodiscard]] Result<Refined<Value>> refine(const Scheme& scheme, Mesh mesh,
                                            std::vector<Value> values, int levels,
                                            const RefineProgress& progress = {}) {
  const Status refinable = check_refinable(scheme, mesh, levels, sizeof(Value), available_memory());
  if (!refinable) return refinable.error();
  RuleTables<Number> tables(scheme);
  Refined<Value> result{std::move(mesh), std::move(values)};
  for (int step = 0; step < levels; ++step) {
    SplitResult split = scheme.split->apply(result.mesh, step);
    if (Status status = tables.prepare(result.mesh, split.births); !status) return status.error();
    result.values = refine_values(scheme, result.mesh, split.births, tables, result.values);
    result.mesh = std::move(split.mesh);
    if (progress) progress(step + 1, levels, result.mesh);
  }
  return result;
}

extern template Result<Refined<Point3>> refine<Point3, double>(const Scheme&, Mesh,
                                                               std::vector<Point3>, int,
                                                               const RefineProgress&);

}  // namespace limn
