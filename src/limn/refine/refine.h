#pragma once
/// Refinement of meshes: scheme × mesh → finer mesh.

#include <cstdint>
#include <functional>

#include "limn/base/memory.h"
#include "limn/refine/refine_values.h"

namespace limn {

/// What refining will come to, from counts alone. Cost O(levels).
struct RefineEstimate {
  double vertices = 0, faces = 0;  ///< of the result
  double peak_bytes = 0;           ///< at most, while the last step is being made
};
[[nodiscard]] RefineEstimate estimate_refinement(const Split& split, const Mesh& mesh, int levels,
                                                 std::size_t bytes_per_value);

/// In words: "5 levels make about 3e+06 vertices and 6e+06 faces, in about 0.2 GiB of memory".
[[nodiscard]] std::string text_of(const RefineEstimate& estimate, int levels);

/// That an estimate for so many levels is within `memory_limit` bytes; the error names it.
[[nodiscard]] Status check_memory(const RefineEstimate& estimate, int levels, double memory_limit);

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

/// One step, its number `step`. Fails as `tables.prepare` does.
template <class Value, class Number>
[[nodiscard]] Result<Refined<Value>> refine_once(const Scheme& scheme, const Mesh& mesh,
                                                 const std::vector<Value>& values, int step,
                                                 RuleTables<Number>& tables) {
  SplitResult split = scheme.split->apply(mesh, step);
  if (Status status = tables.prepare(mesh, split.births); !status) return status.error();
  std::vector<Value> fine = refine_values(scheme, mesh, split.births, tables, values);
  return Refined<Value>{std::move(split.mesh), std::move(fine)};
}

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
    Result<Refined<Value>> next = refine_once(scheme, result.mesh, result.values, step, tables);
    if (!next) return next.error();
    result = std::move(*next);
    if (progress) progress(step + 1, levels, result.mesh);
  }
  return result;
}

extern template Result<Refined<Point3>> refine<Point3, double>(const Scheme&, Mesh,
                                                               std::vector<Point3>, int,
                                                               const RefineProgress&);

}  // namespace limn
