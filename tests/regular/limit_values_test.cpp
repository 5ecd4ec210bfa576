// Limit stencils and inner products against the literature, against eigenvectors of the spatial
// subdivision matrix, and against sums by hand.

#include "limn/regular/limit_values.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>

#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "regular/wave_oracle.h"
#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

using Values = std::map<LatticeVector, double>;

/// The weights by twice the offset: the centre's, the edge neighbours' and on quads the diagonals'.
Laurent stencil(Lattice lattice, const Rational& centre, const Rational& edge,
                const Rational& diagonal = 0) {
  Laurent s = {{{0, 0}, centre}};
  for (const Exponents k : {Exponents{2, 0}, {0, 2}, {2, 2}, {2, -2}}) {
    const bool far = lattice == Lattice::quad && k[0] * k[1] != 0;
    const Rational& w = far ? diagonal : edge;
    if (w != 0 && !(lattice == Lattice::triangle && k[1] < 0)) s[k] = s[{-k[0], -k[1]}] = w;
  }
  return s;
}

TEST(LimitStencil, IsThatOfTheLiterature) {
  const auto of = [](const char* name) {
    return regular::limit_stencil(shipped_mask(name)).value();
  };
  EXPECT_EQ(of("loop"), stencil(Lattice::triangle, Rational(1, 2), Rational(1, 12)));  // (11)
  // Kobbelt 2000: 3α/(1 + 3α) = 1/2 on the ring
  EXPECT_EQ(of("sqrt3"), stencil(Lattice::triangle, Rational(1, 2), Rational(1, 12)));
  EXPECT_EQ(of("catmull-clark"),
            stencil(Lattice::quad, Rational(16, 36), Rational(4, 36), Rational(1, 36)));
  EXPECT_EQ(of("doo-sabin"),
            stencil(Lattice::quad, Rational(36, 64), Rational(6, 64), Rational(1, 64)));
  for (const char* name :
       {"butterfly", "butterfly-modified", "interpolating-loop", "laplacian-butterfly"})
    EXPECT_EQ(of(name), (Laurent{{{0, 0}, Rational(1)}})) << name;
  EXPECT_EQ(regular::limit_stencil(ternary_box_spline()).value(), of("loop"));
  EXPECT_EQ(regular::limit_stencil(quincunx()).value(), (Laurent{{{0, 0}, Rational(1)}}));
}

/// φ(k) = Σ a(l) φ(Mk − l), exactly, and Σ φ = 1: of primal masks.
void expect_fixed(const std::string& name, const Mask& mask) {
  const Result<Laurent> limit = regular::limit_stencil(mask);
  ASSERT_TRUE(limit.ok()) << name << ": " << limit.error().text();
  EXPECT_EQ(total(*limit), 1) << name;
  Laurent refined;
  for (const auto& [l, a] : mask.coefficients) {
    for (const auto& [k, value] : *limit) {
      LatticeVector at{};
      if (divides(mask.dilation, {(k[0] + l[0]) / 2, (k[1] + l[1]) / 2}, at))
        refined[{2 * at[0], 2 * at[1]}] += a * value;
    }
  }
  for (const auto& [k, value] : refined) {
    const auto found = limit->find(k);
    EXPECT_EQ(found == limit->end() ? Rational(0) : found->second, value) << name;
  }
  const Values approx = regular::approx_limit_stencil(mask).value();
  for (const auto& [k, value] : approx) {
    const auto found = limit->find({2 * k[0], 2 * k[1]});
    EXPECT_NEAR(found == limit->end() ? 0 : to_double(found->second), value, 1e-13) << name;
  }
  for (const auto& [k, value] : *limit)
    EXPECT_EQ(approx.count({k[0] / 2, k[1] / 2}), 1U) << name << k[0] << k[1];
}

TEST(LimitStencil, IsFixedByTheMask) {
  for (const std::string& name : lattice_names())
    if (!is_dual(shipped_mask(name))) expect_fixed(name, shipped_mask(name));
  expect_fixed("ternary", ternary_box_spline());
  for (const unsigned seed : {1U, 20U})
    for (const Mask& mask : random_masks(seed)) expect_fixed("random", mask);
}

/// Where in the lattice the vertices of a split's star lie at the regular valence.
std::vector<LatticeVector> star_places(const Split& split, int rings) {
  const bool triangles = split.lattice == Lattice::triangle;
  const bool cropped = split.name == "quad-sqrt2";  // a square's corners are in the ring beyond
  const std::vector<LatticeVector> spokes =
      triangles ? std::vector<LatticeVector>{{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}
                : std::vector<LatticeVector>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<LatticeVector> places = {{0, 0}};
  for (int r = 1; r <= rings; ++r) {
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      const LatticeVector d = spokes[s], e = spokes[(s + 1) % spokes.size()];
      for (int i = 0; i < (triangles ? r : 2 * r); ++i) {
        int a = triangles ? r - i : std::min(r, 2 * r - i), b = std::min(i, r);
        if (cropped && a == b) a = b = r - 1;
        if (a == 0 && b == 0) continue;
        places.push_back({a * d[0] + b * e[0], a * d[1] + b * e[1]});
      }
    }
  }
  return places;
}

TEST(LimitStencil, IsTheLeftEigenvectorOfTheSpatialMatrix) {
  for (const std::string& name : lattice_names()) {
    const Scheme& scheme = shipped(name);
    const Lattice lattice = scheme.split->lattice;
    if (is_dual(shipped_mask(name)) || !scheme.rule(RuleKind::vertex)) continue;
    const int n = lattice == Lattice::triangle ? 6 : 4;
    const int rings = refine::invariant_rings(scheme, n).value();
    const Eigen::MatrixXd matrix =
        dense(refine::subdivision_matrix<double>(scheme, n, rings).value());
    const Eigen::MatrixXd shifted =
        matrix.transpose() - Eigen::MatrixXd::Identity(matrix.rows(), matrix.rows());
    Eigen::FullPivLU<Eigen::MatrixXd> lu(shifted);
    lu.setThreshold(1e-10);
    const Eigen::MatrixXd kernel = lu.kernel();
    ASSERT_EQ(kernel.cols(), 1) << name;
    const Eigen::VectorXd left = kernel.col(0) / kernel.sum();
    const Values limit = regular::approx_limit_stencil(shipped_mask(name)).value();
    const std::vector<LatticeVector> places = star_places(*scheme.split, rings);
    ASSERT_EQ(static_cast<Eigen::Index>(places.size()), left.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto found = limit.find(places[i]);
      EXPECT_NEAR(left(static_cast<Eigen::Index>(i)), found == limit.end() ? 0 : found->second,
                  1e-12)
          << name << i;
    }
  }
}

TEST(InnerProducts, AreSymmetricSumToOneAndArePositiveDefinite) {
  for (const std::string& name : lattice_names()) {
    const Values products = regular::approx_inner_products(shipped_mask(name)).value();
    double sum = 0, others = 0;
    for (const auto& [j, value] : products) {
      sum += value;
      EXPECT_NEAR(products.at({-j[0], -j[1]}), value, 1e-14) << name;
      if (j != LatticeVector{0, 0}) others = std::max(others, std::abs(value));
    }
    EXPECT_NEAR(sum, 1, 1e-13) << name;
    EXPECT_GT(products.at({0, 0}), others) << name;  // Cauchy-Schwarz
  }
}

TEST(InnerProducts, OfDooSabinAreTheQuinticBSplines) {
  const std::map<int, double> b = {{0, 66 / 120.}, {1, 26 / 120.}, {2, 1 / 120.}};
  const Values products = regular::approx_inner_products(shipped_mask("doo-sabin")).value();
  for (const auto& [j, value] : products) {
    const auto x = b.find(std::abs(j[0])), y = b.find(std::abs(j[1]));
    EXPECT_NEAR(value, x == b.end() || y == b.end() ? 0 : x->second * y->second, 1e-14);
  }
}

/// Loop's φ at the points of Z²/2^levels, by lattice coordinates times 2^levels.
Values loop_samples(int levels) {
  Values values = {{{0, 0}, 1.}};
  for (int step = 0; step < levels; ++step) {
    Values finer;
    for (const auto& [j, value] : values)
      for (const auto& [k, a] : shipped_mask("loop").coefficients)
        finer[{2 * j[0] + k[0] / 2, 2 * j[1] + k[1] / 2}] += to_double(a) * value;
    values = finer;
  }
  Values limit;
  for (const auto& [j, value] : values) {
    limit[j] += value / 2;
    for (const LatticeVector d : {LatticeVector{1, 0}, {0, 1}, {1, 1}}) {
      limit[{j[0] + d[0], j[1] + d[1]}] += value / 12;
      limit[{j[0] - d[0], j[1] - d[1]}] += value / 12;
    }
  }
  return limit;
}

TEST(InnerProducts, OfLoopAreTheIntegrals) {
  const int scale = 16;
  const Values phi = loop_samples(4);
  const Values products = regular::approx_inner_products(shipped_mask("loop")).value();
  for (const auto& [j, value] : products) {
    double sum = 0;
    for (const auto& [x, at] : phi) {
      const auto other = phi.find({x[0] - scale * j[0], x[1] - scale * j[1]});
      if (other != phi.end()) sum += at * other->second;
    }
    EXPECT_NEAR(sum / (scale * scale), value, 2e-7) << j[0] << ", " << j[1];
  }
}

TEST(Autocorrelation, RefinesWithTheSquareOfTheSymbol) {
  for (const char* name : {"loop", "doo-sabin", "sqrt3"}) {
    const Mask squared = regular::autocorrelation(shipped_mask(name));
    EXPECT_EQ(total(squared.coefficients), squared.dilation.growth()) << name;
    EXPECT_FALSE(is_dual(squared)) << name;
    const ArtifactAnalysis analysis = analysis_of(squared);
    for (const Frequency& f : some_frequencies(10)) {
      std::vector<double> squares = all(shipped_analysis(name).after_steps(f, 1));
      for (double& value : squares) value *= value;
      EXPECT_LT(distance(all(analysis.after_steps(f, 1)), squares), 1e-14) << name;
    }
  }
}

/// Nothing that needs a limit is had of this mask, and all say why.
void expect_no_limit(const std::string& what, const Mask& mask) {
  const Result<Values> stencil = regular::approx_limit_stencil(mask);
  EXPECT_FALSE(stencil.ok()) << what;
  if (!stencil) EXPECT_GT(stencil.error().message.size(), 15U) << what;
  const Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(mask);
  ASSERT_TRUE(analysis.ok()) << what;
  EXPECT_FALSE(analysis->limit_status().ok()) << what;
  EXPECT_FALSE(sampling_density(*analysis, 1, ArtifactMeasure::mean_energy).ok()) << what;
  EXPECT_EQ(analysis->after_steps({.1, .2}, 2).artifacts.size(),
            static_cast<std::size_t>(mask.dilation.growth() - 1));
}

Mask laplacian(const char* assignment) {
  Scheme scheme = shipped("laplacian-loop");
  const Status set = set_parameter(scheme, assignment);
  EXPECT_TRUE(set.ok()) << set.error().text();
  return regular_mask(scheme).value();
}

TEST(LimitStencil, FailsWhereThereIsNone) {
  expect_no_limit("cup eigenvalue 5/4", laplacian("a=1"));
  expect_no_limit("cup eigenvalue 1", laplacian("a=3/4"));
  expect_no_limit("cup eigenvalue just above 1", laplacian("a=7501/10000"));
  EXPECT_FALSE(regular::limit_stencil(laplacian("a=3/4")).ok());
  EXPECT_TRUE(regular::approx_limit_stencil(laplacian("a=1/2")).ok());  // 3/4: it converges

  // new points from afar: the mask's own vertices keep their values, and others are free
  const std::map<int, Rational> far = {{0, 1}, {3, Rational(1, 2)}, {-3, Rational(1, 2)}};
  Mask torn{Lattice::quad, {{{{2, 0}, {0, 2}}}}, {}};
  for (const auto& [i, a] : far)
    for (const auto& [j, b] : far) torn.coefficients[{2 * i, 2 * j}] = a * b;
  EXPECT_FALSE(regular::limit_stencil(torn).ok());
  expect_no_limit("torn", torn);
}

TEST(LimitStencil, FailsWhereOnlyUnsymmetricDataDiverge) {
  // the four-point scheme with ends 11/10 and outer -6/10: on data that are odd in one coordinate
  // the transition matrix has the eigenvalue 6/5, on even data none but 1 above .78
  const std::map<int, Rational> weights = {{0, 1},
                                           {1, Rational(11, 10)},
                                           {-1, Rational(11, 10)},
                                           {3, Rational(-6, 10)},
                                           {-3, Rational(-6, 10)}};
  Mask odd{Lattice::quad, {{{{2, 0}, {0, 2}}}}, {}};
  for (const auto& [i, a] : weights)
    for (const auto& [j, b] : weights) odd.coefficients[{2 * i, 2 * j}] = a * b;
  // v(1), v(2) of odd v, by T v(i) = Σ a(2i − j) v(j)
  const Eigen::Matrix2d block{{1.1 + .6, 1}, {-.6, 0}};
  EXPECT_NEAR((block * Eigen::Vector2d(2, -1) - 1.2 * Eigen::Vector2d(2, -1)).norm(), 0, 1e-14);
  expect_no_limit("odd data grow", odd);
}

TEST(LimitStencil, OfPiecewiseConstantsIsThere) {
  // φ is the indicator of a cell: it jumps, but not at the control points
  Mask cells{Lattice::quad, {{{{2, 0}, {0, 2}}}}, {}};
  for (const Exponents k : {Exponents{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) cells.coefficients[k] = 1;
  EXPECT_EQ(regular::limit_stencil(cells).value(), (Laurent{{{0, 0}, Rational(1)}}));
  const ArtifactAnalysis analysis = analysis_of(cells);
  ASSERT_TRUE(analysis.energy_status().ok()) << analysis.energy_status().error().text();
  for (const Frequency& f : some_frequencies(20)) {
    const double x = M_PI * f[0], y = M_PI * f[1];
    const double amplitude = std::sin(x) / x * std::sin(y) / y;
    EXPECT_NEAR(analysis.energy(f), 1 - amplitude * amplitude, 1e-14);
  }
}

}  // namespace
}  // namespace limn::test
