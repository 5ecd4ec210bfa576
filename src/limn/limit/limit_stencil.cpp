#include "limn/limit/limit_stencil.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "limn/limit/sector_matrix.h"
#include "limn/mesh/lattice.h"
#include "limn/scheme/lattice_schemes.h"

namespace limn {
namespace {

Error no_limit(const std::string& where, const std::string& reason) {
  return {fmt::format("no limit points at {}: {}", where, reason)};
}

/// The outermost ring whose vertices have weights.
int reach(const FrequencyBlocks& blocks, const Eigen::RowVectorXcd& left) {
  const Eigen::Index shift = left.size() - static_cast<Eigen::Index>(blocks.orbits.size());
  int ring = 1;
  for (Eigen::Index i = shift; i < left.size(); ++i)
    if (std::abs(left(i)) > 1e-13)
      ring = std::max(ring, blocks.orbits[static_cast<std::size_t>(i - shift)].ring);
  return ring;
}

/// Vertices of a star of the blocks' valence, up to a ring.
std::size_t star_vertices(const FrequencyBlocks& blocks, int ring) {
  std::size_t count = blocks.has_center ? 1 : 0;
  for (const Orbit& orbit : blocks.orbits)
    if (orbit.ring <= ring) count += static_cast<std::size_t>(blocks.valence);
  return count;
}

/// Twice the area that ring 1 sweeps round its centre in coordinates (u, v).
double swept_area(const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                  const mesh::Sectors& sectors) {
  const Index end = mesh::sector_star_size(sectors, 1);
  double area = 0;
  for (Index i = 1; i + (sectors.open ? 1 : 0) < end; ++i) {
    const Index j = i + 1 < end ? i + 1 : 1;
    area += (u(i) - u(0)) * (v(j) - v(0)) - (v(i) - v(0)) * (u(j) - u(0));
  }
  return area;
}

std::vector<double> padded(const Eigen::VectorXd& weights, Index size) {
  std::vector<double> list(weights.begin(), weights.end());
  list.resize(static_cast<std::size_t>(size), 0.0);
  return list;
}

/// What is rounding becomes 0, so that an interpolating scheme leaves its points where they are.
void clean(LimitStencil& stencil) {
  for (std::vector<double>* weights :
       {&stencil.position, &stencil.first_tangent, &stencil.second_tangent})
    for (double& weight : *weights)
      if (std::abs(weight) < 1e-14) weight = 0;
  const double sum = std::accumulate(stencil.position.begin(), stencil.position.end(), 0.0);
  for (double& weight : stencil.position) weight /= sum;
}

}  // namespace

Result<LimitStencil> approx_limit_stencil(FrequencyAnalysis& analysis, int n) {
  const Result<FrequencyBlocks> found = analysis.blocks(n);
  if (!found) return found.error();
  const FrequencyBlocks& blocks = *found;
  const Eigencomponents components = approx_eigencomponents(blocks);
  const std::string where = fmt::format("valence {}", n);
  if (components.verdict.convergent == Truth::no)
    return no_limit(where, components.verdict.reasons.front());
  const Eigen::RowVectorXcd position =
      approx_eigenvectors(blocks, components.spectra[0].eigenvalues.front()).left.row(0);
  LimitStencil stencil;
  stencil.rings = reach(blocks, position);
  stencil.position = spatial_functionals(blocks, 0, position)[0];
  stencil.has_plane = n > 2;
  const Eigenvalue& leader = components.spectra[1].eigenvalues.front();
  if (components.tangent && leader.multiplicity == 1 && *components.tangent > 0) {
    const Eigen::RowVectorXcd tangent = approx_eigenvectors(blocks, leader).left.row(0);
    stencil.rings = std::max(stencil.rings, reach(blocks, tangent));
    auto weights = spatial_functionals(blocks, 1, tangent);
    for (double& weight : weights[1]) weight = -weight;
    stencil.first_tangent = std::move(weights[0]);
    stencil.second_tangent = std::move(weights[1]);
  }
  const std::size_t size = star_vertices(blocks, stencil.rings);
  for (std::vector<double>* weights :
       {&stencil.position, &stencil.first_tangent, &stencil.second_tangent})
    if (!weights->empty()) weights->resize(size);
  clean(stencil);
  return stencil;
}

Result<LimitStencil> approx_sector_limit_stencil(const Scheme& scheme,
                                                 const mesh::Sectors& sectors) {
  const Result<limit::SectorMatrix> matrix = limit::sector_matrix(scheme, sectors);
  if (!matrix) return matrix.error();
  const auto values = limit::eigenvalues_beside_one(*matrix);
  const auto position = values ? limit::sector_vectors(*matrix, 1) : std::nullopt;
  if (!position)
    return no_limit(limit::place_text(sectors),
                    "the subdivision matrix has no simple dominant eigenvalue 1");
  const auto tangents = limit::leading_pair(*matrix, *values);
  const Eigen::Index part =
      std::max(position->left.rows(), tangents ? tangents->left.rows() : Eigen::Index{0});
  LimitStencil stencil;
  stencil.rings = 1;
  while (mesh::sector_star_size(sectors, stencil.rings) < part) ++stencil.rings;
  const Index size = mesh::sector_star_size(sectors, stencil.rings);
  stencil.position = padded(position->left.col(0) / position->left.col(0).sum(), size);
  clean(stencil);
  if (!tangents) return stencil;
  const double area = swept_area(tangents->right.col(0), tangents->right.col(1), sectors);
  if (std::abs(area) < 1e-9) return stencil;
  stencil.first_tangent = padded(tangents->left.col(0), size);
  stencil.second_tangent = padded((area > 0 ? 1 : -1) * tangents->left.col(1), size);
  clean(stencil);
  return stencil;
}

Result<LimitStencil> approx_boundary_limit_stencil(const Scheme& scheme, int faces) {
  if (Status status = scheme::check_one_lattice(scheme); !status) return status.error();
  if (faces > limit::kMostStarVertices)
    return limit::too_large(fmt::format("a boundary vertex of {} faces", faces));
  const auto count = static_cast<std::size_t>(faces);
  return approx_sector_limit_stencil(scheme,
                                     {std::vector<Lattice>(count, scheme.split->lattice), true});
}

}  // namespace limn
