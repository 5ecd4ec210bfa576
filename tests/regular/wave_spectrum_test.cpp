// The whole spectrum of the limit surface against closed forms of box splines and sums over
// frequencies by brute force.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "limn/regular/regular_mask.h"
#include "regular/wave_oracle.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

double sinc(double cycles) {
  const double x = std::numbers::pi * cycles;
  return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x;
}

/// f·e1 and f·e2.
Place along_basis(Lattice lattice, Frequency f) {
  if (lattice == Lattice::quad) return f;
  return {f[0], -f[0] / 2 + f[1] * kSqrt3 / 2};
}

TEST(Amplitude, OfBoxSplinesIsAProductOfSincs) {
  std::vector<Frequency> frequencies = some_frequencies(30);
  for (const Frequency& f : some_frequencies(30, 3)) frequencies.push_back({7 * f[0], 7 * f[1]});
  const ArtifactAnalysis ternary = analysis_of(ternary_box_spline());
  for (const Frequency& f : frequencies) {
    const auto [a, b] = along_basis(Lattice::triangle, f);
    const double loop = std::pow(sinc(a) * sinc(b) * sinc(a + b), 2);
    EXPECT_NEAR(shipped_analysis("loop").amplitude(f), loop, 1e-14);
    EXPECT_NEAR(ternary.amplitude(f), loop, 1e-14);  // the same function
    EXPECT_NEAR(shipped_analysis("catmull-clark").amplitude(f),
                std::pow(sinc(f[0]) * sinc(f[1]), 4), 1e-14);
    EXPECT_NEAR(shipped_analysis("doo-sabin").amplitude(f), std::pow(sinc(f[0]) * sinc(f[1]), 3),
                1e-14);
  }
}

/// Σ_n sinc(a + n)^8 and sinc^6: the inner products of cubic and of quadratic B-splines.
double cubic_spectrum(double a) {
  const double t = 2 * std::numbers::pi * a;
  return (2416 + 2 * (1191 * std::cos(t) + 120 * std::cos(2 * t) + std::cos(3 * t))) / 5040;
}
double quadratic_spectrum(double a) {
  const double t = 2 * std::numbers::pi * a;
  return (66 + 2 * (26 * std::cos(t) + std::cos(2 * t))) / 120;
}

TEST(Energy, OfTensorBSplinesIsTheClosedForm) {
  for (const Frequency& f : some_frequencies(50)) {
    const double cubic = std::pow(sinc(f[0]) * sinc(f[1]), 8);
    const double quadratic = std::pow(sinc(f[0]) * sinc(f[1]), 6);
    EXPECT_NEAR(shipped_analysis("catmull-clark").energy(f),
                cubic_spectrum(f[0]) * cubic_spectrum(f[1]) - cubic, 3e-15);
    EXPECT_NEAR(shipped_analysis("doo-sabin").energy(f),
                quadratic_spectrum(f[0]) * quadratic_spectrum(f[1]) - quadratic, 3e-15);
  }
}

TEST(Energy, OfLinearInterpolationIsTheHatFunctions) {
  // ⟨φ, φ⟩ = 1/2 and 1/12 with each of the six neighbours, per area of a cell
  Mask hat{Lattice::triangle, {{{{2, 0}, {0, 2}}}}, {{{0, 0}, Rational(1)}}};
  for (const Exponents k : {Exponents{2, 0}, {0, 2}, {2, 2}})
    hat.coefficients[k] = hat.coefficients[{-k[0], -k[1]}] = Rational(1, 2);
  const ArtifactAnalysis analysis = analysis_of(hat);
  ASSERT_TRUE(analysis.energy_status().ok());
  for (const Frequency& f : some_frequencies(30)) {
    const auto [a, b] = along_basis(Lattice::triangle, f);
    const double amplitude = sinc(a) * sinc(b) * sinc(a + b), tau = 2 * std::numbers::pi;
    const double sum = .5 + (std::cos(tau * a) + std::cos(tau * b) + std::cos(tau * (a + b))) / 6;
    EXPECT_NEAR(analysis.energy(f), sum - amplitude * amplitude, 3e-15);
    EXPECT_NEAR(analysis.energy_percent(f),
                100 * std::sqrt(sum - amplitude * amplitude) / std::abs(amplitude), 1e-9);
  }
}

/// Σ |φ̂(f + κ)|² over κ ≠ 0 with both coordinates at most `radius`.
double energy_in_box(const ArtifactAnalysis& analysis, Frequency f, int radius) {
  double sum = 0;
  for (int p = -radius; p <= radius; ++p) {
    for (int q = -radius; q <= radius; ++q) {
      const Frequency shift = frequency_along(analysis.mask().lattice, p, q);
      const double amplitude = analysis.amplitude({f[0] + shift[0], f[1] + shift[1]});
      if (p != 0 || q != 0) sum += amplitude * amplitude;
    }
  }
  return sum;
}

/// Steps that make the lattice at least √3 times as fine.
int steps_for(const Mask& mask) { return mask.dilation.growth() == 2 ? 2 : 1; }

TEST(Energy, IsTheSumOverAllFrequencies) {
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    ASSERT_TRUE(analysis.energy_status().ok()) << name;
    for (const Frequency& f : some_frequencies(2, 11)) {
      const double all = analysis.energy(f);
      const double near = all - energy_in_box(analysis, f, 4);
      const double far = all - energy_in_box(analysis, f, 8);
      EXPECT_GT(near, -1e-14) << name;
      EXPECT_GT(far, -1e-14) << name;
      EXPECT_LT(far, 0.4 * near + 1e-14) << name;  // C¹: at least as fast as r⁻²
      EXPECT_LT(far, 1e-3 * all + 1e-6) << name;
    }
  }
}

TEST(Energy, AfterManyStepsTendsToThatOfTheLimit) {
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    for (const Frequency& f : some_frequencies(3, 5)) {
      const double limit = analysis.energy(f);
      const double scale = 1 + limit;
      // gaps close fourfold per doubling of the lattice: |det M|^-1 per step for the slowest
      const int steps = 3 * steps_for(analysis.mask());
      const double near = std::abs(StepsEnergy(analysis, steps)(f) - limit);
      const double far = std::abs(StepsEnergy(analysis, 2 * steps)(f) - limit);
      EXPECT_LT(far, 0.1 * near + 1e-12) << name;
      EXPECT_LT(far, 0.01 * scale) << name;
    }
  }
}

TEST(Amplitude, IsWhereTheStepsTend) {
  for (const std::string& name : lattice_names()) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    for (const Frequency& f : some_frequencies(5)) {
      std::vector<double> limit = {analysis.amplitude(f)};
      for (const Frequency& g : analysis.artifact_frequencies(f))
        limit.push_back(analysis.amplitude(g));
      EXPECT_LT(distance(all(analysis.after_steps(f, 40 * steps_for(analysis.mask()))), limit),
                1e-10)
          << name;
      const int steps = steps_for(analysis.mask());
      const double before = distance(all(analysis.after_steps(f, 8 * steps)), limit);
      const double after = distance(all(analysis.after_steps(f, 9 * steps)), limit);
      EXPECT_LT(after, before / 2 + 1e-14) << name;
    }
  }
}

TEST(Amplitude, FoldsIntoTheComponentsOfTheLimit) {
  // the limit's waves, sampled at the first refined lattice, are those of one class together
  for (const char* name : {"loop", "catmull-clark", "optimal"}) {
    const ArtifactAnalysis& analysis = shipped_analysis(name);
    const Lattice lattice = analysis.mask().lattice;
    for (const Frequency& f : some_frequencies(3)) {
      const std::vector<Frequency> waves = all_frequencies(analysis, f);
      const std::vector<double> limit = all(analysis.in_limit(f));
      for (std::size_t c = 0; c < waves.size(); ++c) {
        double sum = 0;
        for (int p = -40; p <= 40; p += 2) {
          for (int q = -40; q <= 40; q += 2) {
            const Frequency shift = frequency_along(lattice, p, q);
            sum += analysis.amplitude({waves[c][0] + shift[0], waves[c][1] + shift[1]});
          }
        }
        EXPECT_NEAR(sum, limit[c], 2e-4) << name << c;
      }
    }
  }
}

}  // namespace
}  // namespace limn::test
