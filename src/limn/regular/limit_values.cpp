#include "limn/regular/limit_values.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>

#include <fmt/core.h>
#include <Eigen/Eigenvalues>

#include "limn/regular/symbol.h"

namespace limn::regular {
namespace {

constexpr std::size_t kMostExactValues = 80;  // a few seconds of rational elimination
// of dense eigenvalues and a factorisation; measured on random matrices of that size: 1417 values
// take 15 s of one processor and 80 MB, 800 take 2 s and 30 MB; a value more costs with the third
// power
constexpr std::size_t kMostApproxValues = 1450;

Error no_limit(const std::string& why) { return {"the limit values are not determined: " + why}; }

}  // namespace

std::vector<LatticeMatrix> symmetries(const Mask& mask) {
  std::vector<LatticeMatrix> kept;
  for (const LatticeMatrix& s : isometries(mask.lattice)) {
    const bool invariant =
        std::all_of(mask.coefficients.begin(), mask.coefficients.end(), [&](const auto& entry) {
          const auto image = mask.coefficients.find(s.apply(entry.first));
          return image != mask.coefficients.end() && image->second == entry.second;
        });
    if (invariant) kept.push_back(s);
  }
  const auto conjugate_kept = [&](const LatticeMatrix& s) {
    // M S e_j = S' M e_j for some kept S'
    return std::any_of(kept.begin(), kept.end(), [&](const LatticeMatrix& other) {
      const LatticeMatrix& m = mask.dilation;
      return m.apply(s.apply({1, 0})) == other.apply(m.apply({1, 0})) &&
             m.apply(s.apply({0, 1})) == other.apply(m.apply({0, 1}));
    });
  };
  if (std::all_of(kept.begin(), kept.end(), conjugate_kept)) return kept;
  return {LatticeMatrix{{{{1, 0}, {0, 1}}}}};
}

namespace {

/// The points (doubled coordinates) where φ may differ from 0, one of each orbit under its
/// symmetries, and how many there are in each.
struct Points {
  std::map<LatticeVector, std::size_t> orbit_of;
  std::vector<LatticeVector> representative;
  std::vector<int> size;
};

Points points_of(const Mask& mask) {
  // |x| ≤ reach/(sqrt|det M| - 1) on the support of φ
  int farthest = 0;
  for (const auto& [k, value] : mask.coefficients)
    farthest = std::max(farthest, squared_length(mask.lattice, k));
  const double radius = std::sqrt(farthest) / (std::sqrt(mask.dilation.growth()) - 1) + 1e-9;
  const int parity = mask.coefficients.begin()->first[0] % 2 == 0 ? 0 : 1;
  const int bound = static_cast<int>(std::ceil(radius * 1.16)) + 2;  // coordinates ≤ length·2/√3
  const std::vector<LatticeMatrix> group = symmetries(mask);
  Points points;
  for (int x = -bound; x <= bound; ++x)
    for (int y = -bound; y <= bound; ++y) {
      const LatticeVector k{x, y};
      if (std::abs(x % 2) != parity || std::abs(y % 2) != parity) continue;
      if (std::sqrt(squared_length(mask.lattice, k)) > radius || points.orbit_of.count(k) > 0)
        continue;
      const std::size_t orbit = points.representative.size();
      points.representative.push_back(k);
      int size = 0;
      for (const LatticeMatrix& s : group)
        size += points.orbit_of.emplace(s.apply(k), orbit).second ? 1 : 0;
      points.size.push_back(size);
    }
  return points;
}

using Rows = std::vector<std::vector<Rational>>;

/// Row i of T, where value(orbit i) = Σ T_ij value(orbit j), by j; without zeros.
std::map<std::size_t, Rational> transition_row(const Mask& mask, const Points& points,
                                               std::size_t i) {
  std::map<std::size_t, Rational> row;
  const LatticeVector image = mask.dilation.apply(points.representative[i]);
  for (const auto& [k, value] : mask.coefficients) {
    const auto to = points.orbit_of.find({image[0] - k[0], image[1] - k[1]});
    if (to != points.orbit_of.end()) row[to->second] += value;
  }
  return row;
}

Rows transition_matrix(const Mask& mask, const Points& points) {
  const std::size_t n = points.representative.size();
  Rows rows(n, std::vector<Rational>(n, Rational(0)));
  for (std::size_t i = 0; i < n; ++i)
    for (const auto& [j, value] : transition_row(mask, points, i)) rows[i][j] = value;
  return rows;
}

Error too_many(std::size_t n, std::size_t most, const char* how) {
  return no_limit(
      fmt::format("the mask is too wide: {} different ones, {} at most {}", n, most, how));
}

/// The only solution of the rows (coefficients, then right side); nothing where there is none or
/// where there are several.
std::optional<std::vector<Rational>> solve(Rows rows) {
  const std::size_t n = rows.front().size() - 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < rows.size() && rows[pivot][c] == 0) ++pivot;
    if (pivot == rows.size()) return std::nullopt;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= n; ++k)
        if (rows[c][k] != 0) rows[r][k] -= factor * rows[c][k];
    }
  }
  for (std::size_t r = n; r < rows.size(); ++r)
    if (rows[r][n] != 0) return std::nullopt;
  std::vector<Rational> solution;
  for (std::size_t c = 0; c < n; ++c) solution.push_back(rows[c][n] / rows[c][c]);
  return solution;
}

const char* const kSeveral = "the mask fixes none, or more than one set of them";

/// Whether data that sum to 0, symmetric or not, grow under the transition matrix: iterated
/// from a fixed irregular start, the growth averaged over the last steps. (1, …, 1) is its left
/// eigenvector of eigenvalue 1, so that this is the largest of the other eigenvalues.
bool other_data_grow(const Mask& mask, const Points& points) {
  constexpr int kSteps = 384;
  constexpr int kLast = 128;
  std::map<LatticeVector, std::size_t> number;
  for (const auto& [k, orbit] : points.orbit_of) number.emplace(k, number.size());
  std::vector<std::vector<std::pair<std::size_t, double>>> rows(number.size());
  for (const auto& [point, row] : number) {
    const LatticeVector image = mask.dilation.apply(point);
    for (const auto& [k, value] : mask.coefficients)
      if (const auto to = number.find({image[0] - k[0], image[1] - k[1]}); to != number.end())
        rows[row].emplace_back(to->second, to_double(value));
  }
  std::vector<double> values(rows.size());
  std::uint32_t state = 1;
  for (double& value : values) value = (state = state * 1664525U + 1013904223U) / 4294967296.0;
  double growth = 0;
  std::vector<double> next(values.size());
  for (int step = 0; step < kSteps; ++step) {
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double size = 0;
    for (double& value : values) size = std::max(size, std::abs(value -= mean));
    if (size < 1e-200) return false;
    if (step >= kSteps - kLast) growth += std::log(size) / kLast;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      next[i] = 0;
      for (const auto& [j, weight] : rows[i]) next[i] += weight * values[j] / size;
    }
    values.swap(next);
  }
  return growth > 1e-7;
}

Status check_convergence(const Mask& mask, const Points& points) {
  if (!other_data_grow(mask, points)) return Done{};
  return no_limit("the scheme does not converge (an eigenvalue beside 1 is greater than 1)");
}

Result<std::vector<Rational>> exact_values(const Mask& mask, const Points& points) {
  const std::size_t n = points.representative.size();
  if (n > kMostExactValues) return too_many(n, kMostExactValues, "can be found exactly");
  if (Status status = check_convergence(mask, points); !status) return status.error();
  Rows rows = transition_matrix(mask, points);
  rows.emplace_back(n, Rational(0));
  for (std::size_t i = 0; i < n; ++i) {
    rows[i][i] -= 1;
    rows[i].emplace_back(0);
    rows[n][i] = points.size[i];
  }
  rows[n].emplace_back(1);
  std::optional<std::vector<Rational>> solution = solve(std::move(rows));
  if (!solution) return no_limit(kSeveral);
  return *std::move(solution);
}

Result<Eigen::VectorXd> approx_values(const Mask& mask, const Points& points) {
  const auto n = static_cast<Eigen::Index>(points.representative.size());
  if (points.representative.size() > kMostApproxValues)
    return too_many(points.representative.size(), kMostApproxValues, "are sought");
  if (Status status = check_convergence(mask, points); !status) return status.error();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (const auto& [j, value] : transition_row(mask, points, static_cast<std::size_t>(i)))
      system(i, static_cast<Eigen::Index>(j)) = to_double(value);
  int not_less_than_1 = 0;
  for (const std::complex<double> value : system.topRows(n).eigenvalues())
    not_less_than_1 += std::abs(value) > 1 - 1e-9 ? 1 : 0;
  if (not_less_than_1 > 1)
    return no_limit("the scheme does not converge (an eigenvalue beside 1 is not less than 1)");
  for (Eigen::Index i = 0; i < n; ++i) {
    system(i, i) -= 1;
    system(n, i) = points.size[static_cast<std::size_t>(i)];
  }
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  right(n) = 1;
  const Eigen::VectorXd values = system.colPivHouseholderQr().solve(right);
  if (!((system * values - right).lpNorm<Eigen::Infinity>() < 1e-9)) return no_limit(kSeveral);
  return values;
}

/// φ at the lattice points from φ at the points of a dual mask's own lattice: one more refinement.
template <class Value>
std::map<LatticeVector, Value> at_lattice_points(const Mask& mask,
                                                 const std::map<LatticeVector, Value>& values) {
  if (mask.coefficients.begin()->first[0] % 2 == 0) return values;
  std::map<LatticeVector, Value> result;
  for (const auto& [k, weight] : mask.coefficients)
    for (const auto& [point, value] : values)
      if (const auto i = mask.dilation.divide({point[0] + k[0], point[1] + k[1]}))
        if ((*i)[0] % 2 == 0 && (*i)[1] % 2 == 0) result[*i] += static_cast<Value>(weight) * value;
  return result;
}

Result<std::map<LatticeVector, double>> approx_lattice_values(const Mask& mask) {
  const Points points = points_of(mask);
  const Result<Eigen::VectorXd> values = approx_values(mask, points);
  if (!values) return values.error();
  std::map<LatticeVector, double> doubled;
  for (const auto& [k, orbit] : points.orbit_of)
    doubled[k] = (*values)(static_cast<Eigen::Index>(orbit));
  std::map<LatticeVector, double> result;
  for (const auto& [k, value] : at_lattice_points(mask, doubled))
    if (std::abs(value) > 1e-15) result[{k[0] / 2, k[1] / 2}] = value;
  return result;
}

}  // namespace

Result<Laurent> limit_stencil(const Mask& mask) {
  const Points points = points_of(mask);
  const Result<std::vector<Rational>> values = exact_values(mask, points);
  if (!values) return values.error();
  Laurent doubled;
  for (const auto& [k, orbit] : points.orbit_of)
    if ((*values)[orbit] != 0) doubled[k] = (*values)[orbit];
  return at_lattice_points(mask, doubled);
}

Result<std::map<LatticeVector, double>> approx_limit_stencil(const Mask& mask) {
  return approx_lattice_values(mask);
}

Result<std::map<LatticeVector, double>> approx_inner_products(const Mask& mask) {
  return approx_lattice_values(autocorrelation(mask));
}

Mask autocorrelation(const Mask& mask) {
  return {mask.lattice, mask.dilation,
          scaled(product(mask.coefficients, reflected(mask.coefficients)),
                 Rational(1, mask.dilation.growth()))};
}

}  // namespace limn::regular
