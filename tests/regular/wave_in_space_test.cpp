// The analysis in frequency against waves on real meshes, refined by limn's engine: the components
// that it predicts are there, and nothing else.

#include <gtest/gtest.h>

#include <cmath>

#include "regular/torus_wave.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

const std::vector<std::string> kSchemes = {
    "loop",          "butterfly",      "interpolating-loop", "sqrt3",        "doo-sabin",
    "catmull-clark", "laplacian-loop", "four-eight",         "loop-ternary", "butterfly-ternary",
    "midedge"};

void expect_components(const TorusWave& torus, const std::vector<Frequency>& waves,
                       const std::vector<double>& predicted, const std::string& what) {
  ASSERT_EQ(waves.size(), predicted.size());
  for (std::size_t c = 0; c < waves.size(); ++c)
    EXPECT_LT(std::abs(torus.component(waves[c]) - predicted[c]), 1e-12)
        << what << " component " << c;
}

TEST(WaveInSpace, PlacesAreThoseOfTheBirths) {
  for (const std::string& name : kSchemes) {
    const Scheme& scheme = shipped(name);
    TorusWave torus_wave(scheme, 5, {0, 0});
    torus_wave.refine_once();
    const Mesh mesh = mesh::torus(scheme.split->lattice, 5, 5);
    const Births births = scheme.split->apply(mesh, 0).births;
    for (Index v = 0; v < static_cast<Index>(torus_wave.values().size()); ++v) {
      const mesh::Twelfths at = mesh::torus_birth_place(mesh, 5, 5, births, v);
      const Place expected = plane(scheme.split->lattice, {at[0] / 12., at[1] / 12.});
      const Place found = torus_wave.place(static_cast<std::size_t>(v));
      for (const Frequency& g : closed_frequencies(scheme.split->lattice, 5))  // tell it mod 5
        EXPECT_LT(std::abs(wave(g, found) - wave(g, expected)), 1e-12) << name << v;
    }
  }
}

TEST(WaveInSpace, AfterOneStepIsTheComponentsAndNothingElse) {
  for (const std::string& name : kSchemes) {
    const Scheme& scheme = shipped(name);
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    for (const Frequency& f : closed_frequencies(scheme.split->lattice, 5)) {
      TorusWave torus(scheme, 5, f);
      torus.refine_once();
      const std::vector<double> predicted = all(analysis.after_steps(f, 1));
      expect_components(torus, all_frequencies(analysis, f), predicted, name);
      double energy = 0;
      for (const double a : predicted) energy += a * a;
      EXPECT_NEAR(torus.power(), energy, 1e-12) << name;
    }
  }
}

TEST(WaveInSpace, AfterMoreStepsKeepsTheComponentsAndTheEnergyOfAllOthers) {
  for (const std::string& name : kSchemes) {
    const Scheme& scheme = shipped(name);
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    for (const Frequency& f : closed_frequencies(scheme.split->lattice, 4)) {
      TorusWave torus(scheme, 4, f);
      for (int steps = 1; steps <= 3; ++steps) {
        torus.refine_once();
        const Components predicted = analysis.after_steps(f, steps);
        expect_components(torus, all_frequencies(analysis, f), all(predicted), name);
        const double others = StepsEnergy(analysis, steps)(f);
        EXPECT_NEAR(torus.power(), others + predicted.signal * predicted.signal, 1e-12) << name;
        EXPECT_NEAR(StepsEnergy(analysis, steps).percent(f),
                    100 * std::sqrt(std::max(0., others)) / std::abs(predicted.signal), 1e-9);
      }
    }
  }
}

/// Largest distance of the values at the first refined vertices, after `levels` steps, from what
/// in_limit predicts there.
double distance_from_limit(const Scheme& scheme, const ArtifactAnalysis& analysis, Frequency f,
                           int levels) {
  TorusWave torus(scheme, 3, f);
  torus.refine_once();
  const std::size_t first = torus.values().size();
  std::vector<Place> places;
  for (std::size_t v = 0; v < first; ++v) places.push_back(torus.place(v));
  for (int step = 1; step < levels; ++step) torus.refine_once();
  const std::vector<double> limit = all(analysis.in_limit(f));
  const std::vector<Frequency> waves = all_frequencies(analysis, f);
  double largest = 0;
  for (std::size_t v = 0; v < first; v += scheme.split->is_dual() ? 7 : 1) {
    Complex expected = 0;
    for (std::size_t c = 0; c < waves.size(); ++c) expected += limit[c] * wave(waves[c], places[v]);
    const Complex found = scheme.split->is_dual() ? torus.value_near(places[v]) : torus.values()[v];
    largest = std::max(largest, std::abs(found - expected));
  }
  return largest;
}

TEST(WaveInSpace, ConvergesToTheLimitAtTheRateOfTheCupEigenvalue) {
  struct Rate {
    std::string scheme;
    double ratio;
    int levels;
  };
  for (const auto& [name, ratio, levels] : {Rate{"loop", 1 / 4., 6},
                                            {"catmull-clark", 1 / 4., 6},
                                            {"sqrt3", 1 / 3., 8},
                                            {"optimal", 1 / 4., 6},
                                            {"laplacian-loop", 3 / 8., 6}}) {
    const Scheme& scheme = shipped(name);
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const Frequency f =
        frequency_along(scheme.split->lattice, 1 / 3., name == "sqrt3" ? 0 : 1 / 3.);
    const double before = distance_from_limit(scheme, analysis, f, levels - 1);
    const double after = distance_from_limit(scheme, analysis, f, levels);
    EXPECT_GT(before, 1e-8) << name;
    EXPECT_LT(after, 0.03) << name;
    EXPECT_NEAR(after / before, ratio, 0.02) << name;
  }
}

TEST(WaveInSpace, StaysAtTheLimitWhereTheSchemeInterpolates) {
  // and for Doo-Sabin's quadratic spline the mean of the four vertices round a knot is its value
  for (const char* name : {"butterfly", "interpolating-loop", "laplacian-butterfly", "doo-sabin"}) {
    const Scheme& scheme = shipped(name);
    const Frequency f = frequency_along(scheme.split->lattice, 1 / 3., 1 / 3.);
    EXPECT_LT(distance_from_limit(scheme, shipped_analysis(name), f, 3), 1e-13) << name;
  }
}

TEST(WaveInSpace, EveryHarmonicOfALevelIsTheAmplitudeUpToTheFinerLevels) {
  for (const char* name : {"loop", "butterfly", "catmull-clark", "doo-sabin"}) {
    const Scheme& scheme = shipped(name);
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const Lattice lattice = scheme.split->lattice;
    const Frequency f = frequency_along(lattice, 1 / 4., 1 / 2.);
    TorusWave torus(scheme, 4, f);
    for (int level = 1; level <= 4; ++level) {
      torus.refine_once();
      const double scale = std::pow(2, level);
      for (const auto& [p, q] : {std::pair{0, 0}, {1, 0}, {0, 1}, {-2, 1}, {3, 0}, {5, -2}}) {
        const Frequency shift = frequency_along(lattice, p, q);
        const Frequency g = {f[0] + shift[0], f[1] + shift[1]};
        const double finer = analysis.amplitude({g[0] / scale, g[1] / scale});
        const Complex found = torus.component(g);
        EXPECT_LT(std::abs(found * finer - analysis.amplitude(g)), 1e-12) << name << level;
      }
    }
  }
}

}  // namespace
}  // namespace limn::test
