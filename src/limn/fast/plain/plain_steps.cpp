#include "limn/fast/plain/plain_steps.h"

#include <algorithm>

#include "limn/base/huge_array.h"
#include "limn/fast/sites/dependence.h"
#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

/// The most that rows may take: half as much again as a butterfly's do, and something on top for
/// small meshes.
std::size_t row_limit(Index vertices) { return 48 * (static_cast<std::size_t>(vertices) + 1024); }

}  // namespace

Result<PlainSteps> PlainSteps::make(const Scheme& scheme, const Mesh& control, int count,
                                    Sharpness sharpness) {
  PlainSteps steps(scheme, control);
  sharpness.holes.clear();
  steps.splits_.reserve(static_cast<std::size_t>(count));  // what is sharp refers to these
  for (int step = 0; step < count; ++step)
    if (Status status = steps.add_step(count == 1, sharpness); !status) return status.error();
  return steps;
}

Status PlainSteps::add_step(bool alone, Sharpness& sharpness) {
  const Split& split = *scheme_->split;
  const Mesh& old = mesh(static_cast<std::size_t>(count_));
  std::unique_ptr<refine::CreaseStep> creases;
  SplitResult made;
  if (sharpness.any()) {
    Result<refine::CreaseStep> step = refine::CreaseStep::make(split, old, sharpness, count_);
    if (!step) return step.error();
    if (Status status = refine::prepare_tables(tables_, *step); !status) return status;
    creases = std::make_unique<refine::CreaseStep>(std::move(*step));
    sharpness = creases->fine_sharpness();
    made = alone ? SplitResult{{}, creases->fine().births} : creases->fine();
  } else {
    // nobody looks at the mesh that a single step makes
    made = alone ? SplitResult{{}, first_births(split, old)} : split.apply(old, count_);
    if (Status status = tables_.prepare(old, made.births); !status) return status;
  }
  splits_.push_back(std::move(made));
  creases_.push_back(std::move(creases));
  ++count_;
  return Done{};
}

std::optional<PlainRows> PlainSteps::rows_of(std::size_t step, std::vector<Index> places) const {
  if (creases_[step]) {
    const refine::CreaseStencils<double> stencils(*scheme_, *creases_[step], tables_);
    return PlainRows::record(stencils, std::move(places), row_limit(stencils.count()));
  }
  refine::StepStencils<double> stencils(*scheme_, mesh(step), splits_[step].births, tables_);
  stencils.prepare_all();
  return PlainRows::record(stencils, std::move(places), row_limit(stencils.count()));
}

void PlainSteps::write_down(std::vector<Index> order) {
  std::vector<Index> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    places[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
  order_ = std::move(order);
  std::vector<PlainRows> rows;
  for (std::size_t step = 0; step < splits_.size(); ++step) {
    std::vector<Index> places_here;
    if (step + 1 == splits_.size()) places_here.swap(places);
    std::optional<PlainRows> made = rows_of(step, std::move(places_here));
    if (!made) return;
    rows.push_back(std::move(*made));
  }
  rows_ = std::move(rows);
  creases_.clear();
  splits_ = std::vector<SplitResult>();
  order_ = std::vector<Index>();
}

template <class Real>
void PlainSteps::evaluate(const Real* control, Real* fine) const {
  if (count() == 0)
    std::copy(control, control + 3 * static_cast<std::size_t>(control_->vertex_count()), fine);
  else if (rows_.empty())
    evaluate_anew(control, fine);
  else
    evaluate_rows(control, fine);
}

template <class Real>
void PlainSteps::evaluate_rows(const Real* control, Real* fine) const {
  // a point is read with the number after it
  const std::size_t numbers = 3 * static_cast<std::size_t>(control_->vertex_count());
  base::HugeArray<Real> old(numbers + 1);
  std::copy(control, control + numbers, old.data());
  old[numbers] = 0;
  for (std::size_t step = 0; step + 1 < rows_.size(); ++step) {
    const std::size_t after = 3 * static_cast<std::size_t>(rows_[step].vertex_count());
    base::HugeArray<Real> fresh(after + 1);
    rows_[step].evaluate(old.data(), fresh.data());
    fresh[after] = 0;
    old = std::move(fresh);
  }
  rows_.back().evaluate(old.data(), fine);
}

template <class Real>
void PlainSteps::evaluate_anew(const Real* control, Real* fine) const {
  const auto vertices = static_cast<std::size_t>(control_->vertex_count());
  std::vector<Point3> points(vertices);
  for (std::size_t v = 0; v < vertices; ++v, control += 3)
    points[v] = {double(control[0]), double(control[1]), double(control[2])};
  for (std::size_t step = 0; step < splits_.size(); ++step)
    points =
        creases_[step]
            ? refine::refine_values(
                  refine::CreaseStencils<double>(*scheme_, *creases_[step], tables_), points)
            : refine::refine_values(*scheme_, mesh(step), splits_[step].births, tables_, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& point = points[order_.empty() ? i : static_cast<std::size_t>(order_[i])];
    *fine++ = static_cast<Real>(point.x);
    *fine++ = static_cast<Real>(point.y);
    *fine++ = static_cast<Real>(point.z);
  }
}

std::size_t PlainSteps::bytes() const {
  std::size_t indices = order_.size();
  for (const SplitResult& split : splits_) {
    const Mesh& mesh = split.mesh;
    indices += 3 * static_cast<std::size_t>(mesh.halfedge_count()) +
               static_cast<std::size_t>(mesh.edge_count()) +
               static_cast<std::size_t>(mesh.vertex_count());
  }
  std::size_t bytes = indices * sizeof(Index);
  for (const PlainRows& rows : rows_) bytes += rows.bytes();
  return bytes;
}

template void PlainSteps::evaluate<float>(const float*, float*) const;
template void PlainSteps::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
