#include "limn/regular/artifacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "limn/regular/limit_values.h"

namespace limn {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

double percent(double artifacts, double signal) {
  if (artifacts == 0) return 0;
  if (signal == 0) return std::numeric_limits<double>::infinity();
  return 100 * artifacts / std::abs(signal);
}

Symbol symbol_of(const std::map<LatticeVector, double>& values) {
  std::vector<Symbol::Term> all;
  all.reserve(values.size());
  for (const auto& [k, value] : values)
    all.push_back({{static_cast<double>(k[0]), static_cast<double>(k[1])}, value});
  return Symbol(all);
}

double square(double x) { return x * x; }

}  // namespace

double Components::sum() const { return std::accumulate(artifacts.begin(), artifacts.end(), 0.0); }

double Components::mean_energy() const {
  double squares = 0;
  for (const double artifact : artifacts) squares += square(artifact);
  return std::sqrt(squares / static_cast<double>(artifacts.size()));
}

double Components::percent_of_signal() const { return percent(mean_energy(), signal); }

Result<ArtifactAnalysis> ArtifactAnalysis::of(const Mask& mask) {
  if (!is_point_symmetric(mask.coefficients))
    return Error{
        "the mask is not the same from both sides of its centre: its artifacts have no "
        "real magnitudes",
        "a(-k) must be a(k)"};
  return ArtifactAnalysis(mask);
}

ArtifactAnalysis::ArtifactAnalysis(const Mask& mask)
    : mask_(mask),
      factors_(factor(mask)),
      aliases_(dual_cosets(mask.dilation)),
      symbol_(mask.coefficients, 1.0 / mask.dilation.growth()),
      stage_(smoothing_stage(mask.lattice, mask.dilation)) {
  const auto limit = regular::approx_limit_stencil(mask);
  if (limit)
    limit_ = symbol_of(*limit);
  else
    limit_status_ = limit.error();
  const auto inner = regular::approx_inner_products(mask);
  if (inner)
    inner_products_ = symbol_of(*inner);
  else
    energy_status_ = inner.error();
}

std::vector<Frequency> ArtifactAnalysis::artifact_frequencies(Frequency f) const {
  const auto& m = mask_.dilation.rows;
  const Phase t = control_phase(mask_.lattice, f);
  std::vector<Frequency> frequencies;
  for (std::size_t i = 1; i < aliases_.size(); ++i) {
    // the member κ + Mᵀ n with n near -M⁻ᵀ (t/2π + κ): M is a similarity, so rounding is off by 1
    // at most
    const Phase member{t[0] / kTwoPi + aliases_[i][0], t[1] / kTwoPi + aliases_[i][1]};
    const Phase way = mask_.dilation.refined_phase(member);
    Frequency nearest{};
    double least = std::numeric_limits<double>::infinity();
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b) {
        const double x = a - std::nearbyint(way[0]);
        const double y = b - std::nearbyint(way[1]);
        const Frequency g =
            frequency_of_phase(mask_.lattice, {kTwoPi * (member[0] + m[0][0] * x + m[1][0] * y),
                                               kTwoPi * (member[1] + m[0][1] * x + m[1][1] * y)});
        // the margin keeps ties, at f along an axis, from being decided by rounding
        if (const double length = std::hypot(g[0], g[1]); length < least - 1e-12) {
          least = length;
          nearest = g;
        }
      }
    frequencies.push_back(nearest);
  }
  return frequencies;
}

std::vector<Phase> ArtifactAnalysis::refined_phases(Frequency f) const {
  std::vector<Phase> phases{mask_.dilation.refined_phase(control_phase(mask_.lattice, f))};
  for (const Frequency& g : artifact_frequencies(f))
    phases.push_back(mask_.dilation.refined_phase(control_phase(mask_.lattice, g)));
  return phases;
}

template <class Magnitude>
Components ArtifactAnalysis::components(Frequency f, Magnitude magnitude) const {
  const std::vector<Phase> phases = refined_phases(f);
  Components result{magnitude(phases.front()), {}};
  for (std::size_t i = 1; i < phases.size(); ++i) result.artifacts.push_back(magnitude(phases[i]));
  return result;
}

Components ArtifactAnalysis::after_stages(Frequency f, int stages) const {
  return components(f, [&](Phase theta) { return std::pow(stage_(theta), stages); });
}

Components ArtifactAnalysis::after_steps(Frequency f, int steps) const {
  return components(f, [&](Phase theta) {
    double value = 1;
    for (int step = 0; step < steps; ++step) {
      value *= symbol_(theta);
      theta = mask_.dilation.refined_phase(theta);
    }
    return value;
  });
}

Components ArtifactAnalysis::in_limit(Frequency f) const {
  return components(f, [&](Phase theta) { return symbol_(theta) * limit_(theta); });
}

double ArtifactAnalysis::amplitude(Frequency g) const {
  Phase theta = control_phase(mask_.lattice, g);
  double value = 1;
  // m = 1 - O(θ²), so that what is left of the product differs from 1 by O(θ²)
  constexpr int kMostSteps = 5000;  // enough for the largest finite phase
  for (int step = 0; step < kMostSteps && value != 0; ++step) {
    if (std::max(std::abs(theta[0]), std::abs(theta[1])) < 1e-9) break;
    theta = mask_.dilation.refined_phase(theta);
    value *= symbol_(theta);
  }
  return value;
}

double ArtifactAnalysis::made_by_one_step(Phase t, const Symbol& energies) const {
  double sum = 0;
  for (std::size_t i = 1; i < aliases_.size(); ++i) {
    const Phase theta = mask_.dilation.refined_phase(
        {t[0] + kTwoPi * aliases_[i][0], t[1] + kTwoPi * aliases_[i][1]});
    if (const double square_of_symbol = square(symbol_(theta)); square_of_symbol > 0)
      sum += square_of_symbol * energies(theta);
  }
  return sum;
}

double ArtifactAnalysis::energy(Frequency f) const {
  // E(t) = Σ_artifacts |m|² B + |m(signal)|² E(θ), B the energy of all: no difference of close
  // numbers
  Phase t = control_phase(mask_.lattice, f);
  double sum = 0;
  double signal = 1;
  constexpr int kMostSteps = 200;
  // where steps turn the lattice, every second one may make nothing of a wave along a diagonal
  int negligible = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double term = signal * made_by_one_step(t, inner_products_);
    sum += term;
    t = mask_.dilation.refined_phase(t);
    signal *= square(symbol_(t));
    const bool near_constant = std::max(std::abs(t[0]), std::abs(t[1])) < 1;
    negligible = near_constant && term <= 1e-17 * sum ? negligible + 1 : 0;
    if (signal == 0 || negligible == 2) break;
  }
  return std::max(0.0, sum);
}

double ArtifactAnalysis::energy_percent(Frequency f) const {
  return limn::percent(std::sqrt(energy(f)), amplitude(f));
}

StepsEnergy::StepsEnergy(const ArtifactAnalysis& analysis, int steps) : analysis_(analysis) {
  // the transition operator of the autocorrelation, applied to the constant 1
  const LatticeMatrix& dilation = analysis.mask().dilation;
  std::map<LatticeVector, double> squared;
  for (const auto& [k, weight] : regular::autocorrelation(analysis.mask()).coefficients)
    squared[{k[0] / 2, k[1] / 2}] = to_double(weight);
  std::map<LatticeVector, double> sums{{{0, 0}, 1.0}};
  for (int step = 0; step < steps; ++step) {
    energies_.push_back(symbol_of(sums));
    std::map<LatticeVector, double> next;
    for (const auto& [k, weight] : squared)
      for (const auto& [j, value] : sums)
        if (const auto i = dilation.divide({k[0] + j[0], k[1] + j[1]})) next[*i] += weight * value;
    sums = std::move(next);
  }
}

double StepsEnergy::operator()(Frequency f) const {
  Phase t = control_phase(analysis_.mask().lattice, f);
  double sum = 0;
  double signal = 1;
  for (std::size_t left = energies_.size(); left-- > 0;) {
    sum += signal * analysis_.made_by_one_step(t, energies_[left]);
    t = analysis_.mask().dilation.refined_phase(t);
    signal *= square(analysis_.symbol()(t));
  }
  return sum;
}

double StepsEnergy::percent(Frequency f) const {
  const int steps = static_cast<int>(energies_.size());
  return limn::percent(std::sqrt((*this)(f)), analysis_.after_steps(f, steps).signal);
}

}  // namespace limn
