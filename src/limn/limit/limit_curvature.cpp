#include "limn/limit/limit_curvature.h"

#include <cmath>
#include <numeric>

#include "limn/limit/limit_points.h"
#include "limn/refine/star_step.h"

namespace limn {
namespace {

constexpr int kWider = 3;  // rings round those that control the surface: they hold ring 1's limits

/// Values at the vertices of the star, and the functional that measures how much of them there is.
struct Function {
  std::vector<double> values, weights;
};

/// The real eigenvectors of an eigenvalue.
std::vector<Function> functions(const FrequencyBlocks& blocks, const Eigenvalue& eigenvalue) {
  const Eigenvectors vectors = approx_eigenvectors(blocks, eigenvalue);
  const int omega = eigenvalue.frequency;
  std::vector<Function> list;
  for (Eigen::Index i = 0; i < vectors.left.rows(); ++i) {
    auto weights = spatial_functionals(blocks, omega, vectors.left.row(i));
    auto values = spatial_vectors(blocks, omega, vectors.right.col(i));
    for (double& weight : weights[1]) weight = -weight;
    for (double& value : values[1]) value = -value;
    list.push_back({std::move(values[0]), std::move(weights[0])});
    if (omega > 0 && 2 * omega != blocks.valence)
      list.push_back({std::move(values[1]), std::move(weights[1])});
  }
  return list;
}

/// The eigenvalues that make curvature: those that are tangent². Nothing where one of them has a
/// frequency that no quadratic has: curvature then hangs on the direction.
std::optional<std::vector<Eigenvalue>> quadratic(const Eigencomponents& components) {
  if (components.verdict.curvature_necessary != Truth::yes) return std::nullopt;
  const double square = *components.tangent * *components.tangent;
  std::vector<Eigenvalue> list;
  for (const BlockSpectrum& spectrum : components.spectra) {
    for (std::size_t i = 0; i < spectrum.eigenvalues.size(); ++i) {
      const Eigenvalue& one = spectrum.eigenvalues[i];
      if (std::abs(std::abs(one.value) - square) > kEqualBelow) continue;
      const int folded = components.valence == 3 ? 1 : 2;  // the saddles' frequency
      if ((one.frequency != 0 && one.frequency != folded) ||
          std::abs(one.value - square) > kEqualBelow)
        return std::nullopt;
      if (list.empty() || list.back().frequency != one.frequency) list.push_back(one);
    }
  }
  return list;
}

/// Limits at ring 1 of three functions.
Result<std::vector<Point3>> ring_limits(const Scheme& scheme, const FrequencyBlocks& blocks,
                                        const Function& x, const Function& y, const Function& z) {
  const Split& split = *scheme.split;
  std::vector<Point3> values;
  for (std::size_t v = 0; v < x.values.size(); ++v)
    values.push_back({x.values[v], y.values[v], z.values[v]});
  LimitOptions options;
  options.boundary = false;
  const Index first = blocks.has_center ? 1 : 0;
  const Index last = split_star_size(split, blocks.valence, 1);
  options.vertices.resize(static_cast<std::size_t>(last - first));
  std::iota(options.vertices.begin(), options.vertices.end(), first);
  Result<LimitPoints> limit =
      approx_limit_points(scheme, split_star(split, blocks.valence, blocks.rings), values, options);
  if (!limit) return limit.error();
  return std::vector<Point3>(limit->positions.begin() + first, limit->positions.begin() + last);
}

}  // namespace

Result<std::optional<CurvatureStencil>> approx_curvature_stencil(const Scheme& scheme,
                                                                 FrequencyAnalysis& analysis,
                                                                 int n) {
  const Result<FrequencyBlocks> near = analysis.blocks(n);
  if (!near) return near.error();
  const Eigencomponents components = approx_eigencomponents(*near);
  const auto eigenvalues = quadratic(components);
  if (!eigenvalues) return std::optional<CurvatureStencil>{};
  const Result<FrequencyBlocks> wide = FrequencyAnalysis(scheme, near->rings + kWider).blocks(n);
  if (!wide) return wide.error();
  const auto tangents = functions(*wide, components.spectra[1].eigenvalues.front());
  CurvatureStencil stencil;
  const std::size_t size = star_places(*near).size();
  stencil.rings = near->rings;
  stencil.cup = stencil.first_saddle = stencil.second_saddle = std::vector<double>(size, 0.0);
  for (const Eigenvalue& eigenvalue : *eigenvalues)
    for (const Function& function : functions(*wide, eigenvalue)) {
      const auto at = ring_limits(scheme, *wide, tangents[0], tangents[1], function);
      if (!at) return at.error();
      Eigen::MatrixXd quadratics(static_cast<Eigen::Index>(at->size()), 3);
      Eigen::VectorXd heights(quadratics.rows());
      for (Eigen::Index i = 0; i < heights.size(); ++i) {
        const Point3& p = (*at)[static_cast<std::size_t>(i)];
        quadratics.row(i) << p.x * p.x + p.y * p.y, p.x * p.x - p.y * p.y, 2 * p.x * p.y;
        heights(i) = p.z;
      }
      const Eigen::Vector3d fit = quadratics.colPivHouseholderQr().solve(heights);
      for (std::size_t v = 0; v < size; ++v) {
        stencil.cup[v] += fit(0) * function.weights[v];
        stencil.first_saddle[v] += fit(1) * function.weights[v];
        stencil.second_saddle[v] += fit(2) * function.weights[v];
      }
    }
  return std::optional(std::move(stencil));
}

}  // namespace limn
