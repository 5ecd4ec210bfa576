// Laws of the components at random frequencies.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "limn/regular/regular_mask.h"
#include "regular/wave_oracle.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

const std::set<std::string> kInterpolating = {
    "butterfly",    "butterfly-modified",  "butterfly-ternary",  "interpolating-loop",
    "kobbelt-quad", "laplacian-butterfly", "sqrt3-interpolating"};

Frequency any_frequency() {
  const auto coordinate = [] { return *rc::gen::inRange(-100000, 100001) * 0.8123e-5; };
  const double x = coordinate();
  return {x, coordinate()};
}

Frequency plus(Lattice lattice, Frequency f, int p, int q) {
  const Frequency shift = frequency_along(lattice, p, q);
  return {f[0] + shift[0], f[1] + shift[1]};
}

Frequency turned(Frequency f, double degrees) {
  const double angle = degrees * M_PI / 180, c = std::cos(angle), s = std::sin(angle);
  return {c * f[0] - s * f[1], s * f[0] + c * f[1]};
}

std::vector<double> sorted_sizes(const std::vector<double>& values) {
  std::vector<double> sorted;
  for (const double v : values) sorted.push_back(std::abs(v));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

RC_GTEST_PROP(ArtifactLaws, InterpolatingSchemesHaveComponentsOfSumOne, ()) {
  const Frequency f = any_frequency();
  for (const std::string& name : kInterpolating) {
    const Components limit = shipped_analysis(name).in_limit(f);
    RC_ASSERT(std::abs(limit.signal + limit.sum() - 1) < 1e-13);
    RC_ASSERT(distance(all(limit), all(shipped_analysis(name).after_steps(f, 1))) < 1e-13);
  }
}

TEST(ArtifactLaws, ApproximatingSchemesHaveNot) {
  for (const std::string& name : lattice_names()) {
    double largest = 0;
    for (const Frequency& f : some_frequencies(20)) {
      const Components limit = shipped_analysis(name).in_limit(f);
      largest = std::max(largest, std::abs(limit.signal + limit.sum() - 1));
    }
    EXPECT_EQ(largest < 1e-12, kInterpolating.count(name) == 1) << name << " " << largest;
  }
}

RC_GTEST_PROP(ArtifactLaws, ExtrusionsAlongAnEdgeHaveOneArtifact, ()) {
  const double size = any_frequency()[0];
  for (int j = 0; j < 3; ++j) {
    // Y1, Y2, Y3 are perpendicular to u1, u2, u3, which point at 0°, 120°, 240°
    const Frequency f = turned({0, size}, 120 * j);
    for (const char* name : {"loop", "butterfly", "interpolating-loop"}) {
      const Components limit = shipped_analysis(name).in_limit(f);
      for (std::size_t k = 0; k < 3; ++k)
        if (static_cast<int>(k) != j) RC_ASSERT(std::abs(limit.artifacts[k]) < 1e-14);
    }
  }
}

TEST(ArtifactLaws, TheLaplacianButterflyMakesTheOthersOfExtrusionsToo) {
  const Components limit = shipped_analysis("laplacian-butterfly").in_limit({0, .3});
  EXPECT_GT(std::abs(limit.artifacts[1]), 1e-3);
  EXPECT_NEAR(limit.artifacts[1], limit.artifacts[2], 1e-14);  // mirror images
}

RC_GTEST_PROP(ArtifactLaws, AFrequencyIsKnownUpToTheDualLattice, ()) {
  const Frequency f = any_frequency();
  const int p = *rc::gen::inRange(-3, 4), q = *rc::gen::inRange(-3, 4);
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const auto& [top, bottom] = analysis.mask().dilation.rows;
    const Lattice lattice = analysis.mask().lattice;
    const bool dual = is_dual(analysis.mask());
    const std::vector<double> here = all(analysis.in_limit(f));
    // the same control wave: the same waves, named otherwise
    const std::vector<double> there = all(analysis.in_limit(plus(lattice, f, p, q)));
    RC_ASSERT(distance(sorted_sizes(here), sorted_sizes(there)) < 1e-12);
    // and by Mᵀ (p, q) the same names
    const Frequency g = plus(lattice, f, top[0] * p + bottom[0] * q, top[1] * p + bottom[1] * q);
    RC_ASSERT(distance(here, all(analysis.in_limit(g)), dual) < 1e-12);
    // -f has the artifacts -(f + κ), which are in the order of the classes of -κ
    const std::vector<double> opposite = all(analysis.in_limit({-f[0], -f[1]}));
    RC_ASSERT(distance(sorted_sizes(here), sorted_sizes(opposite)) < 1e-13);
    RC_ASSERT(std::abs(here[0] - opposite[0]) < 1e-13);
  }
}

RC_GTEST_PROP(ArtifactLaws, AnArtifactIsTheSignalOfItsOwnFrequency, ()) {
  const Frequency f = any_frequency();
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const std::vector<Frequency> waves = all_frequencies(analysis, f);
    const std::vector<double> limit = all(analysis.in_limit(f));
    const std::vector<double> steps = all(analysis.after_steps(f, 3));
    double energy = 0;
    for (std::size_t c = 0; c < waves.size(); ++c) {
      RC_ASSERT(std::abs(analysis.in_limit(waves[c]).signal - limit[c]) < 1e-13);
      RC_ASSERT(std::abs(analysis.after_steps(waves[c], 3).signal - steps[c]) < 1e-13);
      // the energy of all waves together does not depend on which is called the signal
      const double signal = analysis.amplitude(waves[c]);
      const double total = analysis.energy(waves[c]) + signal * signal;
      if (c == 0) energy = total;
      RC_ASSERT(std::abs(total - energy) < 1e-13);
    }
  }
}

RC_GTEST_PROP(ArtifactLaws, TurningByASectorPermutesTheArtifacts, ()) {
  const Frequency f = any_frequency();
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const bool triangles = analysis.mask().lattice == Lattice::triangle;
    const Components here = analysis.in_limit(f);
    for (const Frequency& g : {turned(f, triangles ? 60 : 90), Frequency{f[0], -f[1]}}) {
      const Components there = analysis.in_limit(g);
      RC_ASSERT(std::abs(here.signal - there.signal) < 1e-13);
      RC_ASSERT(distance(sorted_sizes(here.artifacts), sorted_sizes(there.artifacts)) < 1e-13);
      RC_ASSERT(std::abs(analysis.energy(f) - analysis.energy(g)) < 1e-13);
      RC_ASSERT(std::abs(analysis.amplitude(f) - analysis.amplitude(g)) < 1e-13);
    }
    if (analysis.artifact_count() == 3 && triangles) {
      // by 60° u1 → -u3 → u2 → -u1, and Y1 → Y3 → Y2 → Y1 with it
      const std::vector<double> a = here.artifacts;
      const std::vector<double> b = analysis.in_limit(turned(f, 60)).artifacts;
      RC_ASSERT(distance(b, {a[1], a[2], a[0]}) < 1e-13);
      // and the mirror that keeps u1 changes u2 for u3
      const std::vector<double> c = analysis.in_limit({f[0], -f[1]}).artifacts;
      RC_ASSERT(distance(c, {a[0], a[2], a[1]}) < 1e-13);
    }
  }
}

RC_GTEST_PROP(ArtifactLaws, StagesArePowersAndLoopIsTwoOfThem, ()) {
  const Frequency f = any_frequency();
  const int stages = *rc::gen::inRange(0, 6);
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    if (is_dual(analysis.mask())) continue;
    std::vector<double> power = all(analysis.after_stages(f, 1));
    for (double& value : power) value = std::pow(value, stages);
    RC_ASSERT(distance(all(analysis.after_stages(f, stages)), power) < 1e-13);
  }
  const ArtifactAnalysis& loop = shipped_analysis("loop");
  RC_ASSERT(distance(all(loop.after_stages(f, 2)), all(loop.after_steps(f, 1))) < 1e-14);
  const ArtifactAnalysis& quads = shipped_analysis("catmull-clark");
  RC_ASSERT(distance(all(quads.after_stages(f, 4)), all(quads.after_steps(f, 1))) < 1e-14);
}

RC_GTEST_PROP(ArtifactLaws, QuadStagesAreProductsOfCosines, ()) {
  const Frequency f = any_frequency();
  // per direction (1 + cos θ)/2 = cos²(θ/2) makes two stages
  const auto half = [](double g) { return std::cos(M_PI * g / 2); };
  const ArtifactAnalysis& quads = shipped_analysis("catmull-clark");
  const auto stage = [&](Frequency g) { return half(g[0]) * half(g[1]); };
  std::vector<double> expected;
  for (const Frequency& g : all_frequencies(quads, f)) expected.push_back(std::pow(stage(g), 4));
  RC_ASSERT(distance(all(quads.after_steps(f, 1)), expected) < 1e-14);
  const ArtifactAnalysis& dual = shipped_analysis("doo-sabin");
  expected.clear();
  for (const Frequency& g : all_frequencies(dual, f)) expected.push_back(std::pow(stage(g), 3));
  RC_ASSERT(distance(all(dual.after_steps(f, 1)), expected) < 1e-14);
}

TEST(ArtifactLaws, AConstantHasNoArtifacts) {
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    std::vector<double> one(static_cast<std::size_t>(analysis.artifact_count()) + 1, 0);
    one[0] = 1;
    EXPECT_LT(distance(all(analysis.in_limit({0, 0})), one), 1e-14) << name;
    EXPECT_LT(distance(all(analysis.after_steps({0, 0}, 1)), one), 1e-14) << name;
    EXPECT_LT(distance(all(analysis.after_steps({0, 0}, 5)), one), 1e-14) << name;
    EXPECT_NEAR(analysis.amplitude({0, 0}), 1, 1e-14) << name;
    EXPECT_NEAR(analysis.energy({0, 0}), 0, 1e-14) << name;
    EXPECT_NEAR(StepsEnergy(analysis, 3)({0, 0}), 0, 1e-14) << name;
    for (const auto& [p, q] : {std::pair{1, 0}, {0, 1}, {2, -1}})
      EXPECT_NEAR(analysis.amplitude(frequency_along(analysis.mask().lattice, p, q)), 0, 1e-14);
  }
}

TEST(ArtifactLaws, OneStepsEnergyIsThatOfItsArtifacts) {
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    for (const Frequency& f : some_frequencies(5)) {
      double energy = 0;
      const Components step = analysis.after_steps(f, 1);
      for (const double a : step.artifacts) energy += a * a;
      EXPECT_NEAR(StepsEnergy(analysis, 1)(f), energy, 1e-14) << name;
      EXPECT_NEAR(step.mean_energy(), std::sqrt(energy / analysis.artifact_count()), 1e-14);
    }
  }
}

}  // namespace
}  // namespace limn::test
