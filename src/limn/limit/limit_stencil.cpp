#include "limn/limit/limit_stencil.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "limn/limit/partial_rules.h"
#include "limn/mesh/lattice.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"
#include "limn/spectrum/null_space.h"

namespace limn {
namespace {

constexpr int kMostRings = 7;        // of a fan, and one more than may control it
constexpr Index kLargestFan = 1000;  // vertices of a dense matrix, which takes some seconds
constexpr double kTie = 1e-6;  // rounding splits a defective pair of eigenvalues by about 1e-8

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

/// The subdivision matrix of a fan, on as many rings as control the surface there.
struct FanMatrix {
  Eigen::MatrixXd entries;
  std::vector<Eigen::Index> invariant;  ///< sizes of leading parts that are closed, ascending
};

/// The forms at the images of the fan's vertices. At its rim, which stands for nothing, rules may
/// be missing. Fails where one is that an image depends on.
Result<std::vector<LinearForm<double>>> refined_forms(const Scheme& scheme, const FanStep& step) {
  PartialRules rules(scheme, Boundary::refined);
  RuleTables<double>& tables = rules.tables();
  std::vector<LinearForm<double>> forms = unit_forms<double>(step.coarse.vertex_count());
  const Mesh* mesh = &step.coarse;
  for (const SplitResult& fine : step.fine) {
    if (Status status = tables.prepare(*mesh, fine.births); !status) return status.error();
    forms = refine_values(scheme, *mesh, fine.births, tables, forms);
    mesh = &fine.mesh;
  }
  if (rules.complete()) return forms;
  for (Index i = 0; i < step.size; ++i)
    for (const auto& [vertex, weight] : forms[static_cast<std::size_t>(step.images[i])].terms)
      if (std::isnan(weight)) return rules.missing();
  return forms;
}

/// That the rings of a fan are not too large for a dense matrix.
Status check_size(Lattice lattice, int faces, int rings) {
  if (faces <= kLargestFan && fan_size(lattice, faces, rings) <= kLargestFan) return Done{};
  return Error{fmt::format("a boundary vertex of {} faces is too large for limit points", faces),
               fmt::format("up to {} vertices round it are analysed", kLargestFan)};
}

Result<FanMatrix> fan_matrix(const Scheme& scheme, int faces) {
  const Lattice lattice = scheme.split->lattice;
  if (Status status = check_size(lattice, faces, 1); !status) return status.error();
  const FanStep step = fan_step(*scheme.split, faces, kMostRings);
  const Result<std::vector<LinearForm<double>>> forms = refined_forms(scheme, step);
  if (!forms) return forms.error();
  std::vector<Index> farthest(kMostRings + 1, 0);  // vertex that a ring's images weigh
  int rings = 1;
  Index v = 0;
  for (int r = 0; r <= kMostRings; ++r) {
    for (; v < (r == 0 ? 1 : fan_size(lattice, faces, r)); ++v)
      for (const auto& [vertex, weight] : (*forms)[step.images[v]].terms)
        if (weight != 0) farthest[r] = std::max(farthest[r], vertex);
    if (r > 0 && farthest[r] >= fan_size(lattice, faces, r - 1)) rings = r;
  }
  if (rings == kMostRings)
    return Error{fmt::format("scheme '{}' reaches farther than {} rings at the boundary",
                             scheme.name, kMostRings - 1),
                 {},
                 scheme.file,
                 0,
                 0};
  if (Status status = check_size(lattice, faces, rings); !status) return status.error();
  const Eigen::Index size = fan_size(lattice, faces, rings);
  FanMatrix matrix{Eigen::MatrixXd::Zero(size, size), {}};
  for (Index i = 0; i < size; ++i)
    for (const auto& [vertex, weight] : (*forms)[step.images[i]].terms)
      if (vertex < size) matrix.entries(i, vertex) = weight;
  Index reached = 0;
  for (int r = 0; r <= rings; ++r) {
    reached = std::max(reached, farthest[r]);
    const Index end = r == 0 ? 1 : fan_size(lattice, faces, r);
    if (reached < end) matrix.invariant.push_back(end);
  }
  return matrix;
}

/// Left and right eigenvectors of a real eigenvalue of the fan's matrix: biorthonormal columns,
/// on the smallest invariant part that has all of them.
struct FanVectors {
  Eigen::MatrixXd left, right;
};

/// Nothing where λ is defective.
std::optional<FanVectors> fan_vectors(const FanMatrix& matrix, double lambda) {
  FanVectors found;
  for (const Eigen::Index part : matrix.invariant) {
    const Eigen::MatrixXd shifted =
        matrix.entries.topLeftCorner(part, part) - lambda * Eigen::MatrixXd::Identity(part, part);
    const Eigen::MatrixXd left = null_space<Eigen::MatrixXd>(shifted.transpose());
    if (left.cols() <= found.left.cols()) continue;
    found = {left, null_space(shifted)};
  }
  if (found.left.cols() == 0 || found.right.cols() != found.left.cols()) return std::nullopt;
  const Eigen::MatrixXd products = found.left.transpose() * found.right;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(products);
  if (std::abs(lu.determinant()) < kTie) return std::nullopt;
  found.left = found.left * lu.inverse().transpose();
  return found;
}

/// The eigenvalues other than the first 1, largest modulus first; nothing where 1 does not lead.
std::optional<std::vector<std::complex<double>>> others(const FanMatrix& matrix) {
  const Eigen::VectorXcd values = matrix.entries.eigenvalues();
  std::vector<std::complex<double>> list(values.begin(), values.end());
  std::sort(list.begin(), list.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  if (std::abs(list.front() - 1.0) > 1e-9 || std::abs(list[1]) > 1 - 1e-9) return std::nullopt;
  list.erase(list.begin());
  return list;
}

/// Twice the area that ring 1 of the fan sweeps round its centre in coordinates (u, v).
double swept_area(const Eigen::VectorXd& u, const Eigen::VectorXd& v, Index ring_end) {
  double area = 0;
  for (Index i = 1; i + 1 < ring_end; ++i)
    area += (u(i) - u(0)) * (v(i + 1) - v(0)) - (v(i) - v(0)) * (u(i + 1) - u(0));
  return area;
}

std::vector<double> padded(const Eigen::VectorXd& weights, Index size) {
  std::vector<double> list(weights.begin(), weights.end());
  list.resize(static_cast<std::size_t>(size), 0.0);
  return list;
}

/// The two eigenvectors that lead all others, or none.
std::optional<FanVectors> leading_pair(const FanMatrix& matrix,
                                       const std::vector<std::complex<double>>& values) {
  FanVectors pair;
  for (std::size_t i = 0; i < values.size() && pair.left.cols() < 2;) {
    const std::complex<double> value = values[i];
    if (std::abs(value.imag()) > 1e-9 || std::abs(value) < 1e-9) return std::nullopt;
    const auto vectors = fan_vectors(matrix, value.real());
    if (!vectors || pair.left.cols() + vectors->left.cols() > 2) return std::nullopt;
    const Eigen::Index columns = pair.left.cols() + vectors->left.cols();
    pair.left.conservativeResizeLike(
        Eigen::MatrixXd::Zero(std::max(pair.left.rows(), vectors->left.rows()), columns));
    pair.right.conservativeResizeLike(Eigen::MatrixXd::Zero(pair.left.rows(), columns));
    pair.left.topRightCorner(vectors->left.rows(), vectors->left.cols()) = vectors->left;
    pair.right.topRightCorner(vectors->right.rows(), vectors->right.cols()) = vectors->right;
    i += static_cast<std::size_t>(vectors->left.cols());
    if (i < values.size() && std::abs(std::abs(values[i]) - std::abs(value)) < kTie &&
        pair.left.cols() == 2)
      return std::nullopt;  // a third ties with them
  }
  return pair;
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

Result<LimitStencil> approx_boundary_limit_stencil(const Scheme& scheme, int faces) {
  const Result<FanMatrix> matrix = fan_matrix(scheme, faces);
  if (!matrix) return matrix.error();
  const std::string where = fmt::format("a boundary vertex of {} faces", faces);
  const auto values = others(*matrix);
  const auto position = values ? fan_vectors(*matrix, 1) : std::nullopt;
  if (!position)
    return no_limit(where, "the subdivision matrix has no simple dominant eigenvalue 1");
  const auto tangents = leading_pair(*matrix, *values);
  const Eigen::Index part =
      std::max(position->left.rows(), tangents ? tangents->left.rows() : Eigen::Index{0});
  LimitStencil stencil;
  const Lattice lattice = scheme.split->lattice;
  stencil.rings = 1;
  while (fan_size(lattice, faces, stencil.rings) < part) ++stencil.rings;
  const Index size = fan_size(lattice, faces, stencil.rings);
  stencil.position = padded(position->left.col(0) / position->left.col(0).sum(), size);
  clean(stencil);
  if (!tangents) return stencil;
  const double area =
      swept_area(tangents->right.col(0), tangents->right.col(1), fan_size(lattice, faces, 1));
  if (std::abs(area) < 1e-9) return stencil;
  stencil.first_tangent = padded(tangents->left.col(0), size);
  stencil.second_tangent = padded((area > 0 ? 1 : -1) * tangents->left.col(1), size);
  clean(stencil);
  return stencil;
}

}  // namespace limn
