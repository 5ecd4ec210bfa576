// Components after one step against the mask applied by hand to an infinite wave, for every
// shipped scheme and for masks of splits that limn does not have.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "regular/wave_oracle.h"

namespace limn::test {
namespace {

/// after_steps(f, 1) is what the wave holds, at several points and frequencies.
void expect_what_the_wave_holds(const std::string& name, const Mask& mask, int frequencies) {
  const ArtifactAnalysis analysis = analysis_of(mask);
  EXPECT_EQ(analysis.artifact_count() + 1, static_cast<int>(class_members(mask.dilation).size()));
  for (const Frequency& f : some_frequencies(frequencies)) {
    const std::vector<Frequency> waves = all_frequencies(analysis, f);
    const std::vector<double> predicted = all(analysis.after_steps(f, 1));
    for (const int shift : {0, 3})
      EXPECT_LT(distance(predicted, fitted_amplitudes(mask, f, waves, shift)), 1e-12)
          << name << " at " << f[0] << ", " << f[1];
    for (int i = 0; i < 24; ++i) {  // points that the fit did not see
      const int odd = is_dual(mask) ? 1 : 0;
      const LatticeVector doubled = {2 * (i % 5 - 2) + odd, 2 * (i / 5 - 2) + odd};
      Complex sum = 0;
      for (std::size_t c = 0; c < waves.size(); ++c)
        sum += predicted[c] * wave(waves[c], refined_place(mask, doubled));
      EXPECT_LT(std::abs(sum - refined_wave(mask, f, doubled)), 1e-12) << name;
    }
  }
}

TEST(WaveByConvolution, OfEveryShippedSchemeAndOthers) {
  for (const auto& [name, mask] : many_masks()) expect_what_the_wave_holds(name, mask, 8);
}

TEST(WaveByConvolution, OfRandomMasksOfManySplits) {
  for (const unsigned seed : {1U, 20U, 40U})
    for (const Mask& mask : random_masks(seed)) expect_what_the_wave_holds("random", mask, 2);
}

TEST(WaveByConvolution, TwoAndThreeStepsAreTheSymbolOnEachFinerLattice) {
  for (const char* name : {"loop", "sqrt3", "doo-sabin", "catmull-clark", "laplacian-butterfly"}) {
    const Mask& mask = shipped_mask(name);
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const auto& [top, bottom] = mask.dilation.rows;
    const double det = top[0] * bottom[1] - top[1] * bottom[0];
    for (const Frequency& f : some_frequencies(5)) {
      std::vector<Frequency> waves = all_frequencies(analysis, f);
      std::vector<double> product = all(analysis.after_steps(f, 1));
      for (int steps = 2; steps <= 4; ++steps) {
        for (std::size_t c = 0; c < waves.size(); ++c) {
          // one lattice finer, in units of its own edges: phases M⁻ᵀ t
          Frequency& g = waves[c];
          const Place e1 = plane(mask.lattice, {1, 0}), e2 = plane(mask.lattice, {0, 1});
          const double a = g[0] * e1[0] + g[1] * e1[1], b = g[0] * e2[0] + g[1] * e2[1];
          g = frequency_along(mask.lattice, (bottom[1] * a - bottom[0] * b) / det,
                              (top[0] * b - top[1] * a) / det);
          product[c] *= fitted_amplitudes(mask, g, all_frequencies(analysis, g), 1)[0];
        }
        EXPECT_LT(distance(all(analysis.after_steps(f, steps)), product), 1e-12) << name << steps;
      }
    }
  }
}

/// How much farther from 0 than the nearest of its class an artifact of f is, at the worst;
/// infinite where one is not in the class of dual_cosets at its place.
double farther_than_the_nearest(const ArtifactAnalysis& analysis, Frequency f) {
  const Mask& mask = analysis.mask();
  const std::vector<LatticeVector> classes = dual_cosets(mask.dilation);
  const auto& [top, bottom] = mask.dilation.rows;
  const std::vector<Frequency> found = analysis.artifact_frequencies(f);
  double worst = found.size() + 1 == classes.size() ? 0 : 1e9;
  for (std::size_t j = 0; j < found.size(); ++j) {
    double least = 1e9, member = 1e9;
    for (int x = -8; x <= 8; ++x) {
      for (int y = -8; y <= 8; ++y) {  // κ + Mᵀ (x, y)
        const LatticeVector k = {classes[j + 1][0] + top[0] * x + bottom[0] * y,
                                 classes[j + 1][1] + top[1] * x + bottom[1] * y};
        const Frequency shift = frequency_along(mask.lattice, k[0], k[1]);
        const Frequency g = {f[0] + shift[0], f[1] + shift[1]};
        least = std::min(least, std::hypot(g[0], g[1]));
        member = std::min(member, std::hypot(g[0] - found[j][0], g[1] - found[j][1]));
      }
    }
    worst = std::max(worst, std::hypot(found[j][0], found[j][1]) - least);
    if (member > 1e-13) worst = 1e9;
  }
  return worst;
}

TEST(ArtifactFrequencies, AreTheNearestOfTheirClassesInTheOrderOfTheDualCosets) {
  for (const auto& [name, mask] : many_masks()) {
    if (name == "random") continue;
    const ArtifactAnalysis analysis = analysis_of(mask);
    for (const Frequency& f : some_frequencies(8))
      EXPECT_LT(farther_than_the_nearest(analysis, f), 1e-13) << name;
  }
}

TEST(ArtifactFrequencies, AreTheNearestFarFromZero) {
  for (const char* name : {"loop", "sqrt3", "catmull-clark", "doo-sabin"})
    for (const Frequency& f : some_frequencies(20))
      EXPECT_LT(farther_than_the_nearest(shipped_analysis(name), {6 * f[0], 6 * f[1]}), 1e-13)
          << name;
}

TEST(ArtifactFrequencies, AreTheNearestWhereThereAreManyClasses) {
  for (const Mask& mask : random_masks(5)) {
    const ArtifactAnalysis analysis = analysis_of(mask);
    for (const Frequency& f : some_frequencies(20))
      EXPECT_LT(farther_than_the_nearest(analysis, f), 1e-13)
          << "determinant " << mask.dilation.determinant();
  }
}

TEST(ArtifactAnalysisOf, RefusesAMaskThatIsNotPointSymmetric) {
  Mask mask = shipped_mask("loop");
  mask.coefficients.begin()->second += Rational(1, 100);
  const Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(mask);
  ASSERT_FALSE(analysis.ok());
  EXPECT_FALSE(analysis.error().message.empty());
}

}  // namespace
}  // namespace limn::test
