#include "limn/fairness/laplacian.h"

#include <cmath>
#include <limits>

#include "limn/fairness/energy.h"
#include "limn/fairness/rounding.h"
#include "limn/mesh/unit_normal.h"

namespace limn::fairness {
namespace {

/// Entry (v, w) of the matrix is −weight(valence(v), valence(w)) for neighbours.
template <class Weight>
Eigen::SparseMatrix<double> matrix_of(const Mesh& mesh, Weight weight) {
  const Index count = mesh.vertex_count();
  std::vector<Index> valence(static_cast<std::size_t>(count));
  base::parallel_for_each(count, [&](Index v) {
    valence[static_cast<std::size_t>(v)] = mesh.is_isolated(v) ? 0 : mesh.valence(v);
  });
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index v = 0; v < count; ++v) {
    if (mesh.is_isolated(v)) continue;
    entries.emplace_back(v, v, 1.0);
    visit_neighbours(mesh, v, [&](Index w) {
      entries.emplace_back(
          v, w,
          -weight(valence[static_cast<std::size_t>(v)], valence[static_cast<std::size_t>(w)]));
    });
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double energy_of(const Mesh& mesh, const std::vector<Point3>& positions) {
  const std::vector<Point3> moved = laplacian(mesh, positions);
  // one slot a chunk, so that the sum depends on no thread
  std::vector<double> sums(static_cast<std::size_t>(mesh.vertex_count() / base::kDefaultGrain + 1));
  base::parallel_for(Index{0}, mesh.vertex_count(), [&](Index first, Index last) {
    double sum = 0;
    for (Index v = first; v < last; ++v)
      if (!mesh.is_boundary_vertex(v))
        sum += dot(moved[static_cast<std::size_t>(v)], moved[static_cast<std::size_t>(v)]);
    sums[static_cast<std::size_t>(first / base::kDefaultGrain)] = sum;
  });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

constexpr int kSafe = 64;  // squares of numbers of such exponents are far from the ends

}  // namespace

double laplacian_energy(const Mesh& mesh, const std::vector<Point3>& positions) {
  const int exponent = mesh::largest_exponent(numbers_of(positions));
  if (exponent == mesh::kNoExponent || std::abs(exponent) <= kSafe)
    return energy_of(mesh, positions);
  return std::ldexp(energy_of(mesh, mesh::scaled(positions, -exponent)), 2 * exponent);
}

double laplacian_rounding(const Mesh& mesh, const std::vector<Point3>& positions, double energy) {
  const int exponent = mesh::largest_exponent(numbers_of(positions));
  if (exponent == mesh::kNoExponent) return 0;
  // a vertex and the mean of its neighbours, in three coordinates
  const double error =
      std::ldexp(2 * kPositionUnits * std::numeric_limits<double>::epsilon(), exponent);
  return rounding_of_squares(energy, 3.0 * mesh.vertex_count() * error * error);
}

Eigen::SparseMatrix<double> laplacian_matrix(const Mesh& mesh) {
  return matrix_of(mesh, [](Index own, Index) { return 1.0 / own; });
}

Eigen::SparseMatrix<double> symmetric_laplacian_matrix(const Mesh& mesh) {
  return matrix_of(mesh, [](Index own, Index other) {
    return 1 / std::sqrt(static_cast<double>(own) * static_cast<double>(other));
  });
}

}  // namespace limn::fairness
