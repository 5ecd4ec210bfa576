#pragma once
/// Refinement of meshes: scheme × mesh → finer mesh.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "limn/base/memory.h"
#include "limn/refine/crease_stencils.h"
#include "limn/refine/refine_estimate.h"
#include "limn/refine/refine_values.h"

namespace limn::refine {

/// Called after each step with the number of steps made so far.
using RefineProgress = std::function<void(int done, int levels, const Mesh& mesh)>;

template <class Value>
struct Refined {
  Mesh mesh;
  std::vector<Value> values;
  Sharpness sharpness = {};  ///< what is left of it
};

/// One step, its number `step`: calls use(fine, left, values_of) once, with the finer mesh and its
/// births, what is left of the sharpness, and a function from a value for each old vertex to those
/// of the new ones, which is to be called before `fine` is moved from. Without tables there are
/// none of these. Precondition: check_takes_sharpness(scheme, sharpness). Fails as
/// `tables->prepare` and CreaseStep::make do.
template <class Number, class Use>
[[nodiscard]] Status make_step(const Scheme& scheme, const Mesh& mesh, const Sharpness& sharpness,
                               int step, RuleTables<Number>* tables, Use&& use) {
  if (!sharpness.any()) {
    SplitResult fine = scheme.split->apply(mesh, step);
    if (tables != nullptr)
      if (Status status = tables->prepare(mesh, fine.births); !status) return status;
    Sharpness left;
    left.method = sharpness.method;
    if (sharpness.has_holes())
      left = inherit(mesh, {{}, {}, sharpness.holes, sharpness.method}, child_sharpness(mesh, {}),
                     fine);
    use(fine, left,
        [&](const auto& old) { return refine_values(scheme, mesh, fine.births, *tables, old); });
    return Done{};
  }
  Result<CreaseStep> creases = CreaseStep::make(*scheme.split, mesh, sharpness, step);
  if (!creases) return creases.error();
  std::optional<CreaseStencils<Number>> stencils;
  if (tables != nullptr) {
    if (Status status = prepare_tables(*tables, *creases); !status) return status;
    stencils.emplace(scheme, *creases, *tables);
  }
  use(creases->fine(), creases->fine_sharpness(),
      [&](const auto& old) { return refine_values(*stencils, old); });
  return Done{};
}

/// One step of values, its number `step`. Precondition and failures as make_step.
template <class Value, class Number>
[[nodiscard]] Result<Refined<Value>> refine_once(const Scheme& scheme, const Mesh& mesh,
                                                 const std::vector<Value>& values,
                                                 const Sharpness& sharpness, int step,
                                                 RuleTables<Number>& tables) {
  Refined<Value> result;
  const auto take = [&](SplitResult& fine, Sharpness& left, const auto& values_of) {
    result.values = values_of(values);
    result.mesh = std::move(fine.mesh);
    result.sharpness = std::move(left);
  };
  if (Status status = make_step(scheme, mesh, sharpness, step, &tables, take); !status)
    return status.error();
  return result;
}

/// The same of a mesh without sharpness.
template <class Value, class Number>
[[nodiscard]] Result<Refined<Value>> refine_once(const Scheme& scheme, const Mesh& mesh,
                                                 const std::vector<Value>& values, int step,
                                                 RuleTables<Number>& tables) {
  return refine_once(scheme, mesh, values, Sharpness{}, step, tables);
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
  const Status refinable =
      check_refinable(scheme, mesh, levels, sizeof(Value), base::available_memory());
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

}  // namespace limn::refine
