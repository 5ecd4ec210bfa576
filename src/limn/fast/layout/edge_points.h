#pragma once
/// Numbers for the points on control edges that are cut into n each, as the layouts of triangles
/// and quads have them.

#include <cstdint>

#include "limn/mesh/mesh.h"

namespace limn::fast {

/// A half-edge by its edge: twice that, and 1 more where the half-edge leads.
using EdgeCode = Index;

/// Whether h stands for its edge, the lower half-edge of the two (mesh.h): the points of the edge
/// are numbered along it.
[[nodiscard]] inline bool leads(const Mesh& mesh, Index h) {
  // on the boundary the twin is the largest number of all
  return static_cast<std::uint32_t>(h) < static_cast<std::uint32_t>(mesh.twin(h));
}

[[nodiscard]] inline EdgeCode edge_code(const Mesh& mesh, Index h) {
  return 2 * mesh.edge(h) + (leads(mesh, h) ? 1 : 0);
}

class EdgePoints {
 public:
  /// The points follow the control vertices: n - 1 for each edge. `control` must outlive this.
  EdgePoints(const Mesh& control, Index n)
      : mesh_(&control), n_(n), edges_at_(control.vertex_count()) {}

  [[nodiscard]] const Mesh& control() const { return *mesh_; }
  [[nodiscard]] Index n() const { return n_; }

  /// The first inner point of an edge.
  [[nodiscard]] Index edge_begin(Index e) const { return edges_at_ + e * (n_ - 1); }

  /// The t-th point along a half-edge, 0 < t < n.
  [[nodiscard]] Index point_along(EdgeCode code, Index t) const {
    return edge_begin(code >> 1) + ((code & 1) != 0 ? t : n_ - t) - 1;
  }
  [[nodiscard]] Index edge_point(Index h, Index t) const {
    return point_along(edge_code(*mesh_, h), t);
  }

 protected:
  [[nodiscard]] Index edges_end() const { return edge_begin(mesh_->edge_count()); }

 private:
  const Mesh* mesh_;
  Index n_, edges_at_;
};

/// The inner points of an edge along one of its half-edges.
class AlongEdge {
 public:
  AlongEdge(const EdgePoints& points, EdgeCode code)
      : origin_(points.point_along(code, 0)), step_(2 * (code & 1) - 1) {}
  /// Point t, 0 < t < n.
  [[nodiscard]] Index operator()(Index t) const { return origin_ + t * step_; }

 private:
  Index origin_, step_;
};

}  // namespace limn::fast
