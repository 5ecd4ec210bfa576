#include "limn/refine/fast/plain_steps.h"

#include <algorithm>

#include "limn/base/huge_array.h"
#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

/// Those of a first step.
Births births(const Split& split, const Mesh& mesh) {
  Births births;
  if (split.births.vertices) births.from_vertices = mesh.vertex_count();
  if (split.births.edges) births.from_edges = mesh.edge_count();
  if (split.births.faces) births.from_faces = mesh.face_count();
  if (!split.births.corners) return births;
  births.from_corners = mesh.halfedge_count();
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) births.isolated.push_back(v);
  return births;
}

/// The most that rows may take: half as much again as a butterfly's do, and something on top for
/// small meshes.
std::size_t row_limit(Index vertices) { return 48 * (static_cast<std::size_t>(vertices) + 1024); }

}  // namespace

Index halfedge_between(const Mesh& mesh, Index from, Index to) {
  const Index first = mesh.halfedge_of_vertex(to);
  Index h = first;
  do {
    if (mesh.origin(mesh.prev(h)) == from) return mesh.prev(h);
    h = mesh.rotate(h);
  } while (h != kNone && h != first);
  return kNone;
}

Index first_part(const Mesh& coarse, const SplitResult& split, Index h) {
  const Index middle = split.births.from_vertices + coarse.edge(h);
  return halfedge_between(split.mesh, coarse.origin(h), middle);
}

Result<PlainSteps> PlainSteps::make(const Scheme& scheme, const Mesh& control, int count) {
  PlainSteps steps(scheme, control);
  for (int step = 0; step < count; ++step) {
    const Mesh& mesh = steps.mesh(static_cast<std::size_t>(step));
    // nobody looks at the mesh that a single step makes
    SplitResult split =
        count > 1 ? scheme.split->apply(mesh, step) : SplitResult{{}, births(*scheme.split, mesh)};
    if (Status status = steps.tables_.prepare(mesh, split.births); !status) return status.error();
    steps.splits_.push_back(std::move(split));
    ++steps.count_;
  }
  return steps;
}

void PlainSteps::write_down(std::vector<Index> order) {
  std::vector<Index> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    places[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
  order_ = std::move(order);
  std::vector<PlainRows> rows;
  for (std::size_t step = 0; step < splits_.size(); ++step) {
    StepStencils<double> stencils(*scheme_, mesh(step), splits_[step].births, tables_);
    stencils.prepare_all();
    std::vector<Index> places_here;
    if (step + 1 == splits_.size()) places_here.swap(places);
    std::optional<PlainRows> made =
        PlainRows::record(stencils, std::move(places_here), row_limit(stencils.count()));
    if (!made) return;
    rows.push_back(std::move(*made));
  }
  rows_ = std::move(rows);
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
  HugeArray<Real> old(numbers + 1);
  std::copy(control, control + numbers, old.data());
  old[numbers] = 0;
  for (std::size_t step = 0; step + 1 < rows_.size(); ++step) {
    const std::size_t after = 3 * static_cast<std::size_t>(rows_[step].vertex_count());
    HugeArray<Real> fresh(after + 1);
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
    points = refine_values(*scheme_, mesh(step), splits_[step].births, tables_, points);
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
