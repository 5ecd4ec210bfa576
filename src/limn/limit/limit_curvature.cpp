#include "limn/limit/limit_curvature.h"

#include <cmath>
#include <numeric>

#include "limn/limit/limit_points.h"
#include "limn/refine/star_step.h"

namespace limn::limit {
namespace {

// rings round those that control the surface: they hold ring 1's limits
constexpr int kWider = 3;

/// How many rings of limits tell a quadratic's shape: the corners of a square, a dual split's first
/// ring, lie on its diagonals, where u² − v² is 0; a cropped star's on the axes, where 2uv is.
int fitted_rings(const Split& split) {
  return split.is_dual() ? 2 : refine::least_star_rings(split);
}

constexpr int kQuadraticFrequencies = 3;  // 0, 1 and 2

/// Values at the vertices of the star, and the functional that measures how much of them there is.
struct Function {
  std::vector<double> values, weights;
};

/// The real eigenvectors of an eigenvalue. Of Re((a + bi)(c + si)) = ac - bs the functionals give a
/// and, turned, -b; so the functions are c and s.
std::vector<Function> functions(const Scheme& scheme, const FrequencyBlocks& blocks,
                                const Eigenvalue& eigenvalue) {
  const Eigenvectors vectors = approx_eigenvectors(blocks, eigenvalue);
  const int omega = eigenvalue.frequency;
  std::vector<Function> list;
  for (Eigen::Index i = 0; i < vectors.left.rows(); ++i) {
    auto weights = spatial_functionals(blocks, omega, vectors.left.row(i));
    auto values = spatial_vectors(blocks, omega, vectors.right.col(i));
    for (double& weight : weights[1]) weight = -weight;
    const bool half = omega > 0 && 2 * omega == blocks.valence;
    const bool complex = omega > 0 && (!half || scheme.split->dilation.turns());
    if (half && complex)  // half of a real function is in the conjugate vector
      for (std::vector<double>& part : weights)
        for (double& weight : part) weight *= 2;
    list.push_back({std::move(values[0]), std::move(weights[0])});
    if (complex) list.push_back({std::move(values[1]), std::move(weights[1])});
  }
  return list;
}

/// The eigenvalues that are tangent².
struct Quadratic {
  std::vector<Eigenvalue> shapes;  ///< of the cup and the saddles
  std::vector<Eigenvalue> jumps;   ///< of frequency 1
};

/// Nothing where one of them has a frequency of 3 or more, or the modulus alone. Where a step
/// `turns` the star, complex vectors of frequency n/2 have conjugates there, of the opposite value:
/// one of the two stands for both.
std::optional<Quadratic> quadratic(const Eigencomponents& components, bool turns) {
  const double square = *components.tangent * *components.tangent;
  const int saddles = components.valence == 3 ? 1 : 2;  // their frequency; 2 is folded to 1
  Quadratic found;
  for (const BlockSpectrum& spectrum : components.spectra) {
    for (const Eigenvalue& one : spectrum.eigenvalues) {
      if (std::abs(std::abs(one.value) - square) > kEqualBelow) continue;
      if (turns && 2 * one.frequency == components.valence && one.value.real() < 0) continue;
      if (one.frequency > 2 || std::abs(one.value - square) > kEqualBelow) return std::nullopt;
      const bool shape = one.frequency == 0 || one.frequency == saddles;
      std::vector<Eigenvalue>& list = shape ? found.shapes : found.jumps;
      if (list.empty() || list.back().frequency != one.frequency) list.push_back(one);
    }
  }
  return found;
}

/// Limits of three functions at the rings 1 … last.
Result<std::vector<Point3>> ring_limits(const Scheme& scheme, const FrequencyBlocks& blocks,
                                        int last_ring, const Function& x, const Function& y,
                                        const Function& z) {
  const Split& split = *scheme.split;
  std::vector<Point3> values;
  for (std::size_t v = 0; v < x.values.size(); ++v)
    values.push_back({x.values[v], y.values[v], z.values[v]});
  LimitOptions options;
  options.boundary = false;
  const Index first = blocks.has_center ? 1 : 0;
  const Index last = refine::split_star_size(split, blocks.valence, last_ring);
  options.vertices.resize(static_cast<std::size_t>(last - first));
  std::iota(options.vertices.begin(), options.vertices.end(), first);
  Result<LimitPoints> limit = approx_limit_points(
      scheme, refine::split_star(split, blocks.valence, blocks.rings), values, options);
  if (!limit) return limit.error();
  return std::vector<Point3>(limit->positions.begin() + first, limit->positions.begin() + last);
}

/// What each of the shapes has of the cup and the saddles, by its limits, and how much of it there
/// is.
Status add_shapes(const Scheme& scheme, const FrequencyBlocks& wide,
                  const Eigencomponents& components, const std::vector<Eigenvalue>& shapes,
                  CurvatureStencil& stencil) {
  const int rings = fitted_rings(*scheme.split);
  const auto tangents = functions(scheme, wide, components.spectra[1].eigenvalues.front());
  for (const Eigenvalue& eigenvalue : shapes)
    for (const Function& function : functions(scheme, wide, eigenvalue)) {
      const auto at = ring_limits(scheme, wide, rings, tangents[0], tangents[1], function);
      if (!at) return at.error();
      Eigen::MatrixXd quadratics(static_cast<Eigen::Index>(at->size()), 3);
      Eigen::VectorXd heights(quadratics.rows());
      for (Eigen::Index i = 0; i < heights.size(); ++i) {
        const Point3& p = (*at)[static_cast<std::size_t>(i)];
        quadratics.row(i) << p.x * p.x + p.y * p.y, p.x * p.x - p.y * p.y, 2 * p.x * p.y;
        heights(i) = p.z;
      }
      const Eigen::Vector3d fit = quadratics.colPivHouseholderQr().solve(heights);
      for (std::size_t v = 0; v < stencil.cup.size(); ++v) {
        stencil.cup[v] += fit(0) * function.weights[v];
        stencil.first_saddle[v] += fit(1) * function.weights[v];
        stencil.second_saddle[v] += fit(2) * function.weights[v];
      }
    }
  return Done{};
}

}  // namespace

Result<VertexCurvature> approx_curvature_stencil(const Scheme& scheme, FrequencyAnalysis& analysis,
                                                 int n) {
  const Result<FrequencyBlocks> near = analysis.blocks(n);
  if (!near) return near.error();
  const Eigencomponents components = approx_eigencomponents(*near);
  if (components.verdict.curvature_necessary != Truth::yes)
    return VertexCurvature{{}, n == 2 ? NoCurvature::no_normal : NoCurvature::unbounded};
  const std::optional<Quadratic> eigenvalues =
      quadratic(components, scheme.split->dilation.turns());
  if (!eigenvalues) return VertexCurvature{{}, NoCurvature::direction};
  const Result<FrequencyBlocks> wide =
      FrequencyAnalysis(scheme, near->rings + kWider + fitted_rings(*scheme.split) - 1)
          .blocks(n, kQuadraticFrequencies);
  if (!wide) return wide.error();
  CurvatureStencil stencil;
  const std::size_t size = star_places(*near).size();
  stencil.rings = near->rings;
  stencil.cup = stencil.first_saddle = stencil.second_saddle = std::vector<double>(size, 0.0);
  for (const Eigenvalue& eigenvalue : eigenvalues->jumps)
    for (Function& function : functions(scheme, *near, eigenvalue))
      stencil.jumps.push_back(std::move(function.weights));
  if (Status status = add_shapes(scheme, *wide, components, eigenvalues->shapes, stencil); !status)
    return status.error();
  return VertexCurvature{std::move(stencil), NoCurvature::none};
}

}  // namespace limn::limit
