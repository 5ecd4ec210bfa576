#include "limn/limit/sector_matrix.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/limit/partial_rules.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"
#include "limn/spectrum/null_space.h"

namespace limn::limit {
namespace {

constexpr int kMostRings = 7;  // one more than may control a surface
constexpr double kTie = 1e-6;  // rounding splits a defective pair of eigenvalues by about 1e-8

/// The forms at the images of the vertices. At the rim, which stands for nothing, rules may be
/// missing. Fails where one is that an image depends on.
Result<std::vector<refine::LinearForm<double>>> refined_forms(const Scheme& scheme,
                                                              const refine::SectorStep& step,
                                                              refine::Boundary boundary) {
  PartialRules rules(scheme, boundary);
  refine::RuleTables<double>& tables = rules.tables();
  std::vector<refine::LinearForm<double>> forms =
      refine::unit_forms<double>(step.coarse.vertex_count());
  const Mesh* mesh = &step.coarse;
  for (const SplitResult& fine : step.fine) {
    if (Status status = tables.prepare(*mesh, fine.births); !status) return status.error();
    forms = refine::refine_values(scheme, *mesh, fine.births, tables, forms);
    mesh = &fine.mesh;
  }
  if (rules.complete()) return forms;
  for (Index i = 0; i < step.size; ++i)
    for (const auto& [vertex, weight] : forms[static_cast<std::size_t>(step.images[i])].terms)
      if (std::isnan(weight)) return rules.missing();
  return forms;
}

/// That the rings are not too large for a dense matrix.
Status check_size(const mesh::Sectors& sectors, int rings) {
  if (mesh::sector_star_size(sectors, rings) <= kMostStarVertices) return Done{};
  return too_large(place_text(sectors));
}

/// Up to each ring, how far the images look: the last vertex that they weigh.
std::vector<Index> farthest_seen(const mesh::Sectors& sectors, const refine::SectorStep& step,
                                 const std::vector<refine::LinearForm<double>>& forms) {
  std::vector<Index> farthest(kMostRings + 1, 0);
  Index v = 0;
  for (int r = 0; r <= kMostRings; ++r)
    for (; v < mesh::sector_star_size(sectors, r); ++v)
      for (const auto& [vertex, weight] : forms[static_cast<std::size_t>(step.images[v])].terms)
        if (weight != 0) farthest[r] = std::max(farthest[r], vertex);
  return farthest;
}

}  // namespace

Error too_large(const std::string& place) {
  return {fmt::format("{} is too large for limit points", place),
          fmt::format("up to {} vertices round it are analysed", kMostStarVertices)};
}

std::string place_text(const mesh::Sectors& sectors) {
  const auto alike =
      std::adjacent_find(sectors.lattices.begin(), sectors.lattices.end(), std::not_equal_to<>());
  const std::string vertex = sectors.open ? "a boundary vertex" : "a vertex";
  if (alike == sectors.lattices.end())
    return fmt::format("{} of {} faces", vertex, sectors.lattices.size());
  std::vector<int> corners;
  corners.reserve(sectors.lattices.size());
  for (const Lattice lattice : sectors.lattices)
    corners.push_back(lattice == Lattice::triangle ? 3 : 4);
  return fmt::format("{} of the faces {}", vertex, fmt::join(corners, ", "));
}

Result<SectorMatrix> sector_matrix(const Scheme& scheme, const mesh::Sectors& sectors) {
  if (Status status = check_size(sectors, 1); !status) return status.error();
  const refine::SectorStep step = refine::sector_step(*scheme.split, sectors, kMostRings);
  const Result<std::vector<refine::LinearForm<double>>> forms = refined_forms(
      scheme, step, sectors.open ? refine::Boundary::refined : refine::Boundary::left_out);
  if (!forms) return forms.error();
  const std::vector<Index> farthest = farthest_seen(sectors, step, *forms);
  SectorMatrix matrix{sectors, 1, {}, {}};
  for (int r = 1; r <= kMostRings; ++r)
    if (farthest[r] >= mesh::sector_star_size(sectors, r - 1)) matrix.rings = r;
  if (matrix.rings == kMostRings)
    return Error{fmt::format("scheme '{}' reaches farther than {} rings at {}", scheme.name,
                             kMostRings - 1, place_text(sectors)),
                 {},
                 scheme.file,
                 0,
                 0};
  if (Status status = check_size(sectors, matrix.rings); !status) return status.error();
  const Eigen::Index size = mesh::sector_star_size(sectors, matrix.rings);
  matrix.entries = Eigen::MatrixXd::Zero(size, size);
  for (Index i = 0; i < size; ++i)
    for (const auto& [vertex, weight] : (*forms)[static_cast<std::size_t>(step.images[i])].terms)
      if (vertex < size) matrix.entries(i, vertex) = weight;
  Index reached = 0;
  for (int r = 0; r <= matrix.rings; ++r) {
    reached = std::max(reached, farthest[r]);
    const Index end = mesh::sector_star_size(sectors, r);
    if (reached < end) matrix.invariant.push_back(end);
  }
  return matrix;
}

std::optional<SectorVectors> sector_vectors(const SectorMatrix& matrix, double lambda) {
  SectorVectors found;
  for (const Eigen::Index part : matrix.invariant) {
    const Eigen::MatrixXd shifted =
        matrix.entries.topLeftCorner(part, part) - lambda * Eigen::MatrixXd::Identity(part, part);
    const Eigen::MatrixXd left = spectrum::null_space<Eigen::MatrixXd>(shifted.transpose());
    if (left.cols() <= found.left.cols()) continue;
    found = {left, spectrum::null_space(shifted)};
  }
  if (found.left.cols() == 0 || found.right.cols() != found.left.cols()) return std::nullopt;
  const Eigen::MatrixXd products = found.left.transpose() * found.right;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(products);
  if (std::abs(lu.determinant()) < kTie) return std::nullopt;
  found.left = found.left * lu.inverse().transpose();
  return found;
}

std::vector<std::complex<double>> eigenvalues_of(const SectorMatrix& matrix) {
  const Eigen::VectorXcd values = matrix.entries.eigenvalues();
  std::vector<std::complex<double>> list(values.begin(), values.end());
  std::sort(list.begin(), list.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  return list;
}

std::optional<std::vector<std::complex<double>>> eigenvalues_beside_one(
    const SectorMatrix& matrix) {
  std::vector<std::complex<double>> list = eigenvalues_of(matrix);
  if (std::abs(list.front() - 1.0) > 1e-9 || std::abs(list[1]) > 1 - 1e-9) return std::nullopt;
  list.erase(list.begin());
  return list;
}

std::optional<SectorVectors> leading_pair(const SectorMatrix& matrix,
                                          const std::vector<std::complex<double>>& values) {
  SectorVectors pair;
  for (std::size_t i = 0; i < values.size() && pair.left.cols() < 2;) {
    const std::complex<double> value = values[i];
    if (std::abs(value.imag()) > 1e-9 || std::abs(value) < 1e-9) return std::nullopt;
    const auto vectors = sector_vectors(matrix, value.real());
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

}  // namespace limn::limit
