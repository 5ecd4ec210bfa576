#include "limn/fairness/spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <Eigen/Eigenvalues>

#include "limn/fairness/lanczos.h"
#include "limn/fairness/laplacian.h"

namespace limn::fairness {
namespace {

constexpr Index kDense = 300;  // up to so many vertices the dense solver is as quick

double weight(const Mesh& mesh, Index v) { return mesh.is_isolated(v) ? 1 : mesh.valence(v); }

/// Modes of L from orthonormal ones of the symmetric form: divided by the roots of the valences.
void to_modes(const Mesh& mesh, Eigen::MatrixXd& vectors) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) vectors.row(v) /= std::sqrt(weight(mesh, v));
}

/// The `count` at one end of all modes.
LaplacianModes end_of(const LaplacianModes& all, SpectrumEnd end, Index count) {
  const auto total = static_cast<Index>(all.eigenvalues.size());
  const Index first = end == SpectrumEnd::smallest ? 0 : total - count;
  return {{all.eigenvalues.begin() + first, all.eigenvalues.begin() + first + count},
          all.modes.middleCols(first, count)};
}

}  // namespace

Result<LaplacianModes> approx_all_modes(const Mesh& mesh) {
  if (mesh.vertex_count() > kMostDenseVertices)
    return Error{fmt::format("all modes of {} vertices are too many", mesh.vertex_count()),
                 fmt::format("up to {} they can be found; ask for some of the smallest or largest",
                             kMostDenseVertices)};
  const Eigen::MatrixXd matrix = symmetric_laplacian_matrix(mesh);
  if (matrix.rows() == 0) return LaplacianModes{};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const Eigen::VectorXd& values = solver.eigenvalues();
  LaplacianModes all{{values.begin(), values.end()}, solver.eigenvectors()};
  to_modes(mesh, all.modes);
  return all;
}

bool spectra_available() { return lanczos_available(); }

Result<LaplacianModes> approx_modes(const Mesh& mesh, SpectrumEnd end, int count) {
  const Index vertices = mesh.vertex_count();
  count = std::min(count, vertices);
  // Lanczos' method is for few of many
  const bool few = vertices > kDense && count <= vertices / 8;
  if (!few || (!spectra_available() && vertices <= kMostDenseVertices)) {
    const Result<LaplacianModes> all = approx_all_modes(mesh);
    if (!all) return all.error();
    return end_of(*all, end, count);
  }
  Eigen::SparseMatrix<double> matrix = symmetric_laplacian_matrix(mesh);
  if (end == SpectrumEnd::largest) {
    Eigen::SparseMatrix<double> two(vertices, vertices);
    two.setIdentity();
    matrix = 2.0 * two - matrix;
  }
  Result<LeastEigenpairs> pairs = approx_least_eigenpairs(matrix, count);
  if (!pairs) return pairs.error();
  LaplacianModes result{std::move(pairs->values), std::move(pairs->vectors)};
  if (end == SpectrumEnd::largest) {
    for (double& value : result.eigenvalues) value = 2 - value;
    std::reverse(result.eigenvalues.begin(), result.eigenvalues.end());
    result.modes = result.modes.rowwise().reverse().eval();
  }
  to_modes(mesh, result.modes);
  return result;
}

std::vector<double> approx_amplitudes(const Mesh& mesh, const LaplacianModes& modes,
                                      const std::vector<Point3>& points) {
  Eigen::MatrixX3d weighted(mesh.vertex_count(), 3);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& p = points[static_cast<std::size_t>(v)];
    weighted.row(v) = weight(mesh, v) * Eigen::RowVector3d(p.x, p.y, p.z);
  }
  const Eigen::VectorXd lengths = (modes.modes.transpose() * weighted).rowwise().norm();
  return {lengths.begin(), lengths.end()};
}

}  // namespace limn::fairness
