#pragma once
/// The Laplacian of a mesh, L = I − H A, with A the adjacency matrix and H the diagonal of
/// 1/valence: each vertex minus the mean of its neighbours [KS §3.1].
///
/// It is that of the graph, at the boundary too: there the mean has neighbours inside and on the
/// boundary, so that L p is small only with the mesh width, and `laplacian_energy` leaves boundary
/// vertices out. The row of an isolated vertex, which has no neighbours, is zero.

#include <vector>

#include <Eigen/SparseCore>

#include "limn/base/parallel.h"
#include "limn/mesh/mesh.h"

namespace limn::fairness {

/// visit(w) for every neighbour w of v, counterclockwise.
template <class Visit>
void visit_neighbours(const Mesh& mesh, Index v, Visit&& visit) {
  const Index first = mesh.halfedge_of_vertex(v);
  for (Index h = first; h != kNone;) {
    visit(mesh.target(h));
    const Index last = h;
    h = mesh.rotate(h);
    if (h == kNone) visit(mesh.origin(mesh.prev(last)));
    if (h == first) break;
  }
}

/// L values, one per vertex: of numbers, of points, of anything with a sum and multiples. Cost
/// O(vertices + edges), in parallel; the same bits on any number of threads.
template <class Value>
[[nodiscard]] std::vector<Value> laplacian(const Mesh& mesh, const std::vector<Value>& values) {
  std::vector<Value> result(values.size());
  base::parallel_for_each(mesh.vertex_count(), [&](Index v) {
    Value sum{};
    int n = 0;
    visit_neighbours(mesh, v, [&](Index w) {
      sum = sum + values[static_cast<std::size_t>(w)];
      ++n;
    });
    if (n > 0)
      result[static_cast<std::size_t>(v)] = values[static_cast<std::size_t>(v)] + (-1.0 / n) * sum;
  });
  return result;
}

/// (I − L/2) values: the low-pass filter that KS take for a pseudo-inverse of L, because it has
/// L's eigenvectors, 1 where L has 0, and 0 where L has 2 [KS §3.2].
template <class Value>
[[nodiscard]] std::vector<Value> low_pass(const Mesh& mesh, const std::vector<Value>& values) {
  std::vector<Value> result = laplacian(mesh, values);
  base::parallel_for_each(mesh.vertex_count(), [&](Index v) {
    Value& value = result[static_cast<std::size_t>(v)];
    value = values[static_cast<std::size_t>(v)] + (-0.5) * value;
  });
  return result;
}

/// Σ |L p|² over the vertices that are not on the boundary, in squares of the unit of length. On
/// finer and finer samples of a smooth surface it falls as the square of the mesh width, that is as
/// 1/vertices.
/// Models of any size have that of their shape times the square of their size, as far as it can be
/// represented.
[[nodiscard]] double laplacian_energy(const Mesh& mesh, const std::vector<Point3>& positions);

/// What rounding of the positions may change that energy by.
[[nodiscard]] double laplacian_rounding(const Mesh& mesh, const std::vector<Point3>& positions,
                                        double energy);

/// L as a matrix; in general not symmetric.
[[nodiscard]] Eigen::SparseMatrix<double> laplacian_matrix(const Mesh& mesh);

/// D^{1/2} L D^{-1/2} = I − H^{1/2} A H^{1/2} with D = H⁻¹: symmetric, with the eigenvalues of L.
[[nodiscard]] Eigen::SparseMatrix<double> symmetric_laplacian_matrix(const Mesh& mesh);

}  // namespace limn::fairness
