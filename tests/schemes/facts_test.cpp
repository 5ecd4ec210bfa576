// Every shipped file against the literature: its rules, its facts, its mask, and the numbers of
// the papers that follow from eigenvalues alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/frequency.h"
#include "support/scheme_oracle.h"
#include "support/shipped.h"

#include "limn/mesh/lattice.h"
#include "limn/number/exact.h"
#include "limn/refine/refine_values.h"

namespace limn::test {
namespace {

class Shipped : public ::testing::TestWithParam<std::string> {};

TEST_P(Shipped, RefinesAsTheLiteratureSays) {
  EXPECT_EQ(failed_reference(shipped(GetParam())), std::nullopt);
}

TEST_P(Shipped, HasTheMaskThatItStates) {
  EXPECT_EQ(failed_mask(shipped(GetParam())), std::nullopt);
}

TEST_P(Shipped, HasFactsAndTheyHold) { EXPECT_EQ(failed_facts(shipped(GetParam())), std::nullopt); }

INSTANTIATE_TEST_SUITE_P(All, Shipped, ::testing::ValuesIn(shipped_schemes()),
                         [](const auto& chosen) { return test_name(chosen.param); });

// --- numbers of the papers ------------------------------------------------------------------

constexpr double kPi = std::numbers::pi;
constexpr int kRings = 3;

Eigen::MatrixXcd block(const std::string& scheme, int n, int omega) {
  return frequency_block(shipped(scheme), n, kRings, omega);
}

/// The largest real part of frequency ω; beside 1 where ω = 0.
double leading(const Scheme& scheme, int n, int omega) {
  return eigenvalues(frequency_block(scheme, n, kRings, omega))[omega == 0 ? 1 : 0].real();
}
double leading(const std::string& scheme, int n, int omega) {
  return leading(shipped(scheme), n, omega);
}

Scheme with(const std::string& name, const std::string& assignment) {
  Scheme scheme = shipped(name);
  const Status status = set_parameter(scheme, assignment);
  EXPECT_TRUE(status.ok()) << assignment;
  return scheme;
}

/// Eigenvalues are compared to half a unit of the last digit that the papers print.
void expect_printed(double value, double printed, int digits) {
  EXPECT_NEAR(value, printed, 0.5001 * std::pow(10, -digits));
}

TEST(PlainButterfly, IsNotSmoothAtValenceThreeNorFromEightOn) {
  // four digits of these were known before this code was written
  EXPECT_NEAR(leading("butterfly", 3, 1), 0.25, 1e-6);
  EXPECT_NEAR(leading("butterfly", 3, 0), 0.25, 1e-4);  // a tie
  expect_printed(leading("butterfly", 7, 1), .4819, 4);
  expect_printed(leading("butterfly", 7, 2), .4061, 4);
  expect_printed(leading("butterfly", 8, 1), .4624, 4);
  expect_printed(leading("butterfly", 8, 2), .4690, 4);  // the wrong frequency leads
}

TEST(Loop, HasTheEigenvaluesOfItsClosedForms) {
  // 3/8 + cos(2π/7)/4, its square, 3/8 + cos(4π/7)/4
  expect_printed(leading("loop", 7, 1), .530872, 6);
  expect_printed(leading("loop", 7, 0), .281826, 6);
  expect_printed(leading("loop", 7, 2), .319370, 6);
  for (int n = 3; n <= 12; ++n) {
    for (int omega = 0; omega <= n / 2; ++omega) {  // outer rings, in every frequency
      EXPECT_LT(eigenvalue_defect(block("loop", n, omega), 1 / 8.), 1e-12);
      EXPECT_LT(eigenvalue_defect(block("loop", n, omega), 1 / 16.), 1e-12);
    }
  }
  // n = 3: the tangent's square is less than the outer rings' 1/8
  EXPECT_NEAR(leading("loop", 3, 1), 1 / 4., 1e-9);
  EXPECT_NEAR(leading("loop", 3, 0), 1 / 8., 1e-6);
}

TEST(LoopWarren, HasItsWeights) {
  const Scheme& scheme = shipped("loop-warren");
  for (int n = 3; n <= 12; ++n) {
    const auto matrix = refine::subdivision_matrix<number::Exact>(scheme, n, 1).value();
    const Rational beta = n == 3 ? Rational(3, 16) : Rational(3, 8 * n);
    EXPECT_EQ(matrix(0, 0).rational(), 1 - n * beta);
    for (int k = 1; k <= n; ++k) EXPECT_EQ(matrix(0, k).rational(), beta);
  }
}

// The published decimals against what they were tuned for: cup and saddle at the tangent's square,
// and the tangent at 1/2.
TEST(LoopTuned, MeetsItsAimsToSomeDigits) {
  for (int n = 3; n <= 12; ++n) {
    const std::string where = "valence " + std::to_string(n);
    const double regularity = leading("loop-tuned-regularity", n, 1);
    EXPECT_NEAR(leading("loop-tuned-regularity", n, 0), regularity * regularity, 2.3e-3) << where;
    const double continuity = leading("loop-tuned-continuity", n, 1);
    EXPECT_NEAR(leading("loop-tuned-continuity", n, 0), continuity * continuity, 1e-3) << where;
    if (n == 3) continue;  // no frequency 2, and no tangent of 1/2
    EXPECT_NEAR(regularity, 1 / 2., 1.2e-3) << where;
    EXPECT_NEAR(leading("loop-tuned-continuity", n, 2), continuity * continuity, 2e-3) << where;
    const double excess = leading("loop-tuned-regularity", n, 2) - regularity * regularity;
    if (n < 10)
      EXPECT_LT(std::abs(excess), 5e-4) << where;
    else
      EXPECT_GT(excess, 0.04) << where;
  }
}

TEST(Sqrt3, HasEigenvaluesThatThePaperIsSilentOn) {
  const double outer = (1 + std::sqrt(7)) / 18;
  expect_printed(outer, .20254, 5);
  for (int n = 3; n <= 12; ++n) EXPECT_LT(eigenvalue_defect(block("sqrt3", n, 0), outer), 1e-12);
  // n = 3: more than the tangent's square, 1/9, in spite of alpha
  EXPECT_NEAR(leading("sqrt3", 3, 1), 1 / 3., 1e-9);
  EXPECT_NEAR(leading("sqrt3", 3, 0), outer, 1e-9);
  // n = 4: ±1/√54 lead frequency 2, whose µ2 = (2/3)cos(π/2) is 0
  EXPECT_NEAR(std::abs(eigenvalues(block("sqrt3", 4, 2)).front()), 1 / std::sqrt(54), 1e-9);
  EXPECT_LT(eigenvalue_defect(block("sqrt3", 4, 2), 0), 1e-12);
}

TEST(CatmullClark, HasTheTangentsOfTheTable) {
  for (const auto& [n, tangent] : {std::pair{3, .410097}, {5, .549988}, {6, .579682}, {8, .611117}})
    expect_printed(leading("catmull-clark", n, 1), tangent, 6);
}

/// What a step does to values round a boundary vertex of so many faces that are linear in each of
/// its sectors, sin (across the boundary) or cos (along it) of s·π/faces at spoke s: how far the
/// new points on its spokes are from half of them.
double not_halved(const std::string& name, Index faces, bool across) {
  const Scheme& scheme = shipped(name);
  const Lattice lattice = scheme.split->lattice;
  const auto spoke = [&](Index s) {
    const double angle = kPi * s / faces;
    return across ? std::sin(angle) : std::cos(angle);
  };
  std::vector<double> values{0};
  for (Index ring = 1; ring <= 2; ++ring)
    for (Index s = 0; s <= faces; ++s) {
      const Index points = s == faces ? 1 : lattice == Lattice::triangle ? ring : 2 * ring;
      for (Index i = 0; i < points; ++i) {
        const Index x = lattice == Lattice::triangle ? ring - i : std::min(ring, 2 * ring - i);
        values.push_back(x * spoke(s) + std::min(i, ring) * spoke(s + 1));
      }
    }
  const Mesh mesh = mesh::fan(lattice, faces, 2);
  EXPECT_EQ(values.size(), static_cast<std::size_t>(mesh.vertex_count()));
  const Births births = scheme.split->apply(mesh, 0).births;
  refine::RuleTables<double> tables(scheme);
  EXPECT_TRUE(tables.prepare(mesh, births).ok());
  const std::vector<double> fine = refine::refine_values(scheme, mesh, births, tables, values);
  double worst = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), v = mesh.origin(h), w = mesh.target(h);
    if (v != 0 && w != 0) continue;
    const double half = values[static_cast<std::size_t>(v + w)] / 2;
    worst =
        std::max(worst, std::abs(fine[static_cast<std::size_t>(births.from_vertices + e)] - half));
  }
  return worst;
}

// [Biermann, Levin, Zorin 2000]: the two eigenvalues beside 1 are 1/2 at every boundary vertex.
TEST(PiecewiseSmooth, HalvesItsTangentsAtEveryBoundaryVertex) {
  for (Index faces = 1; faces <= 9; ++faces)
    for (const char* name : {"loop-piecewise-smooth", "catmull-clark-piecewise-smooth"})
      for (const bool across : {false, true})
        EXPECT_LT(not_halved(name, faces, across), 1e-14) << name << ", faces: " << faces;
  // with the plain rules that is so of one number of faces each
  EXPECT_LT(not_halved("loop", 3, true), 1e-14);
  EXPECT_GT(not_halved("loop", 4, true), 0.04);
  EXPECT_LT(not_halved("catmull-clark", 2, true), 1e-14);
  EXPECT_GT(not_halved("catmull-clark", 3, true), 0.1);
}

TEST(LaplacianButterfly, LosesItsTangentAtAQuarter) {
  // [KS §4]: the third eigenvalue at a regular vertex
  expect_printed(leading(with("laplacian-butterfly", "b=1/8"), 6, 0), .4254, 4);
  expect_printed(leading(with("laplacian-butterfly", "b=3/16"), 6, 0), .4659, 4);
  const Eigen::MatrixXcd tie = frequency_block(with("laplacian-butterfly", "b=1/4"), 6, kRings, 0);
  EXPECT_LT(eigenvalue_defect(tie, 1 / 2.), 1e-12);
  for (const char* b : {"b=1/8", "b=3/16", "b=1/4"})
    EXPECT_NEAR(leading(with("laplacian-butterfly", b), 6, 1), 1 / 2., 1e-6);
}

TEST(LaplacianLoop, AddsToTheCupAlone) {
  for (const auto& [text, a] : {std::pair{"a=1/8", 1 / 8.}, {"a=-1/10", -1 / 10.}}) {
    const Scheme scheme = with("laplacian-loop", text);
    for (int n = 3; n <= 12; ++n) {
      const double tangent = 3 / 8. + std::cos(2 * kPi / n) / 4;
      const Eigen::MatrixXcd cup = frequency_block(scheme, n, kRings, 0);
      EXPECT_LT(eigenvalue_defect(cup, tangent * tangent + a), 1e-12);
      for (int omega = 1; omega <= n / 2; ++omega)
        EXPECT_LT(
            (frequency_block(scheme, n, 1, omega) - frequency_block(shipped("loop"), n, 1, omega))
                .norm(),
            1e-13);
    }
  }
}

TEST(LaplacianLoop, LowPassIsHighPassWithAnotherParameter) {
  for (const char* blend : {"0", "1/3", "1"}) {
    const Scheme low = with("laplacian-loop-low", std::string("a=") + blend);
    const Scheme high = with("laplacian-loop", std::string("a=") + blend + "*(n*beta - 1/2)");
    for (int n = 3; n <= 12; ++n) {
      const auto one = refine::subdivision_matrix<double>(low, n, 2).value();
      const auto other = refine::subdivision_matrix<double>(high, n, 2).value();
      EXPECT_LT((dense(one) - dense(other)).norm(), 1e-14) << blend << " at " << n;
    }
  }
}

TEST(Optimal, HasFiveEigenvaluesOneSixthAtValenceThree) {
  const Eigen::MatrixXcd cup = block("optimal", 3, 0), tangent = block("optimal", 3, 1);
  // frequencies 1 and 2 are conjugate
  EXPECT_EQ(multiplicity(cup, 1 / 6.) + 2 * multiplicity(tangent, 1 / 6.), 5);
  // frequency 1 has one eigenvector for two of them: a Jordan block
  const Eigen::MatrixXcd shifted =
      tangent - Eigen::MatrixXcd::Identity(tangent.rows(), tangent.cols()) / 6;
  const Eigen::VectorXd singular = singular_values(shifted);
  EXPECT_LT(singular[singular.size() - 1], 1e-12);
  EXPECT_GT(singular[singular.size() - 2], 1e-3);
  // n = 4: 1/6 is more than the tangent's square
  EXPECT_NEAR(leading("optimal", 4, 1), 1 / 3., 1e-9);
  EXPECT_NEAR(leading("optimal", 4, 0), 1 / 6., 1e-4);
}

}  // namespace
}  // namespace limn::test
