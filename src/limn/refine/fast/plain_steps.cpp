#include "limn/refine/fast/plain_steps.h"

#include <algorithm>

#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

/// Those of a first step.
Births births(const Split& split, const Mesh& mesh) {
  Births births;
  if (split.births_vertices) births.from_vertices = mesh.vertex_count();
  if (split.births_edges) births.from_edges = mesh.edge_count();
  if (split.births_faces) births.from_faces = mesh.face_count();
  if (!split.births_corners) return births;
  births.from_corners = mesh.halfedge_count();
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) births.isolated.push_back(v);
  return births;
}

}  // namespace
Index first_part(const Mesh& coarse, const SplitResult& split, Index h) {
  const Index middle = split.births.from_vertices + coarse.edge(h);
  Index part = split.mesh.halfedge_of_vertex(coarse.origin(h));
  while (split.mesh.target(part) != middle) part = split.mesh.rotate(part);
  return part;
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
  }
  return steps;
}

template <class Real>
void PlainSteps::evaluate(const Real* control, Real* fine) const {
  const auto vertices = static_cast<std::size_t>(control_->vertex_count());
  if (count() == 0) {
    std::copy(control, control + 3 * vertices, fine);
    return;
  }
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
  return indices * sizeof(Index);
}

template void PlainSteps::evaluate<float>(const float*, float*) const;
template void PlainSteps::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
