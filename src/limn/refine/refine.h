#pragma once
/// Refinement of meshes: scheme × mesh → finer mesh.

#include <functional>

#include "limn/base/memory.h"
#include "limn/refine/crease_stencils.h"
#include "limn/refine/refine_estimate.h"
#include "limn/refine/refine_values.h"

namespace limn {

/// Called after each step with the number of steps made so far.
using RefineProgress = std::function<void(int done, int levels, const Mesh& mesh)>;

template <class Value>
struct Refined {
  Mesh mesh;
  std::vector<Value> values;
  Sharpness sharpness = {};  ///< what is left of it
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

/// The same of a mesh with sharpness. Precondition: check_takes_sharpness(scheme, sharpness).
template <class Value, class Number>
[[nodiscard]] Result<Refined<Value>> refine_once(const Scheme& scheme, const Mesh& mesh,
                                                 const std::vector<Value>& values,
                                                 const Sharpness& sharpness, int step,
                                                 RuleTables<Number>& tables) {
  if (!sharpness.any()) {
    SplitResult split = scheme.split->apply(mesh, step);
    if (Status status = tables.prepare(mesh, split.births); !status) return status.error();
    std::vector<Value> fine = refine_values(scheme, mesh, split.births, tables, values);
    Sharpness left;
    if (sharpness.has_holes())
      left = inherit(mesh, {{}, {}, sharpness.holes, {}}, child_sharpness(mesh, {}), split);
    return Refined<Value>{std::move(split.mesh), std::move(fine), std::move(left)};
  }
  Result<CreaseStep> creases = CreaseStep::make(*scheme.split, mesh, sharpness, step);
  if (!creases) return creases.error();
  if (Status status = prepare_tables(tables, *creases); !status) return status.error();
  std::vector<Value> fine = refine_values(CreaseStencils<Number>(scheme, *creases, tables), values);
  return Refined<Value>{std::move(creases->fine().mesh), std::move(fine),
                        std::move(creases->fine_sharpness())};
}

/// `levels` ≥ 0 steps from the control mesh. Fails as `check_refinable` and
/// `RuleTables::prepare` do, and, of a mesh with sharpness, as `check_takes_sharpness`. `Number` is
/// the type of the weights.
template <class Value, class Number = double>
[[nodiscard]] Result<Refined<Value>> refine(const Scheme& scheme, Mesh mesh,
                                            std::vector<Value> values, int levels,
                                            const RefineProgress& progress = {},
                                            Sharpness sharpness = {}) {
  if (Status takes = check_takes_sharpness(scheme, sharpness); !takes) return takes.error();
  const Status refinable = check_refinable(scheme, mesh, levels, sizeof(Value), available_memory());
  if (!refinable) return refinable.error();
  RuleTables<Number> tables(scheme);
  Refined<Value> result{std::move(mesh), std::move(values), std::move(sharpness)};
  for (int step = 0; step < levels; ++step) {
    Result<Refined<Value>> next =
        refine_once(scheme, result.mesh, result.values, result.sharpness, step, tables);
    if (!next) return next.error();
    result = std::move(*next);
    if (progress) progress(step + 1, levels, result.mesh);
  }
  return result;
}

extern template Result<Refined<Point3>> refine<Point3, double>(const Scheme&, Mesh,
                                                               std::vector<Point3>, int,
                                                               const RefineProgress&, Sharpness);

}  // namespace limn
