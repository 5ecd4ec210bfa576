#include "limn/refine/fast/plain_steps.h"

#include <algorithm>

#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

/// The half-edge of the refined mesh that starts as h does, on the same edge.
Index first_part(const Mesh& coarse, const SplitResult& split, Index h) {
  const Index middle = split.births.from_vertices + coarse.edge(h);
  Index part = split.mesh.halfedge_of_vertex(coarse.origin(h));
  while (split.mesh.target(part) != middle) part = split.mesh.rotate(part);
  return part;
}

}  // namespace

Result<PlainSteps> PlainSteps::make(const Scheme& scheme, const Mesh& control, int count) {
  PlainSteps steps(scheme, control);
  for (int step = 0; step < count; ++step) {
    const Mesh& mesh = steps.mesh(static_cast<std::size_t>(step));
    // nobody looks at the mesh that a single step makes
    SplitResult split = count > 1 ? scheme.split->apply(mesh, step) : SplitResult{};
    split.births.from_vertices = mesh.vertex_count();
    split.births.from_edges = mesh.edge_count();
    if (Status status = steps.tables_.prepare(mesh, split.births); !status) return status.error();
    steps.splits_.push_back(std::move(split));
  }
  if (count > 1) steps.number_vertices();
  return steps;
}

void PlainSteps::number_vertices() {
  const Mesh& fine = splits_.back().mesh;
  const TriangleLayout layout(*control_, Index{1} << count());
  const Index n = layout.n();
  order_.assign(static_cast<std::size_t>(layout.vertex_count()), kNone);
  for (Index v = 0; v < control_->vertex_count(); ++v) order_[v] = v;
  for (Index f = 0; f < control_->face_count(); ++f) {
    const Index side = control_->face_begin(f);
    Index row = side;  // the half-edge from (0, y) to (1, y)
    for (std::size_t step = 0; step < splits_.size(); ++step)
      row = first_part(mesh(step), splits_[step], row);
    for (Index y = 0; y < n; ++y) {
      Index h = row;
      for (Index x = 0; x + y < n; ++x) {
        order_[layout.point(side, x, y)] = fine.origin(h);
        order_[layout.point(side, x + 1, y)] = fine.target(h);
        // over the face that points down, into the next one that points up
        if (x + y + 1 < n) h = fine.next(fine.twin(fine.next(fine.twin(fine.next(h)))));
      }
      // the face that points down beside (0, y) has the next row's first edge opposite
      if (y + 1 < n) row = fine.twin(fine.prev(fine.twin(fine.next(row))));
    }
  }
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
