#include "limn/spectrum/frequency_blocks.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "limn/scheme/scope.h"
#include "limn/spectrum/least_valence.h"
#include "limn/spectrum/ring_transform.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// The named weights at one valence: one number each, or n of a repeated role.
using Weights = std::vector<std::vector<double>>;

Result<Weights> evaluated(const Scheme& scheme, const spectrum::SectorPattern& pattern, int n) {
  Weights weights(pattern.names.size());
  std::vector<double> shares;
  shares.reserve(pattern.names.size());
  for (const spectrum::NamedWeight& name : pattern.names) shares.push_back(to_double(name.share));
  // each scope evaluates a let that several weights use once
  const auto evaluate = [&](scheme::Scope<double> scope, bool repeated) -> Status {
    for (std::size_t i = 0; i < pattern.names.size(); ++i) {
      const spectrum::NamedWeight& name = pattern.names[i];
      if (name.repeated != repeated) continue;
      const Result<double> value = scope(name.weight->value);
      if (!value) return value.error();
      weights[i].push_back(shares[i] * *value);
    }
    return Done{};
  };
  if (Status status = evaluate({scheme, n, std::nullopt}, false); !status) return status.error();
  const bool any = std::any_of(pattern.names.begin(), pattern.names.end(),
                               [](const spectrum::NamedWeight& name) { return name.repeated; });
  for (int k = 0; any && k < n; ++k)
    if (Status status = evaluate({scheme, n, k}, true); !status) return status.error();
  return weights;
}

/// A row of the block of frequency 0 sums to 1: constants are reproduced.
Status check_sums(const Scheme& scheme, const FrequencyBlocks& blocks) {
  const Eigen::VectorXcd sums = blocks.blocks.front().rowwise().sum();
  for (Eigen::Index i = 0; i < sums.size(); ++i)
    if (!(std::abs(sums(i) - 1.0) < 1e-9))
      return Error{
          fmt::format("scheme '{}' has weights that sum to about {:.9g}, not 1, at valence {}",
                      scheme.name, sums(i).real(), blocks.valence),
          {},
          scheme.file,
          0,
          0};
  return Done{};
}

/// A pattern's terms at one valence, frequency after frequency.
class TermsAt {
 public:
  TermsAt(const spectrum::SectorPattern& pattern, const Weights& weights, int n)
      : pattern_(pattern), n_(n) {
    for (const spectrum::SectorTerm& term : pattern.terms) {
      double factor = term.coefficient;
      for (const int name : term.names) factor *= weights[static_cast<std::size_t>(name)].front();
      factors_.push_back(factor);
      steps_.push_back(phase(term.angle));
    }
    phases_.resize(pattern.terms.size());
    sums_.resize(weights.size());
    for (std::size_t name = 0; name < weights.size(); ++name) {
      const std::vector<double>& values = weights[name];
      totals_.push_back(std::accumulate(values.begin(), values.end(), 0.0));
      transforms_.push_back(pattern.names[name].repeated ? spectrum::ring_transform(values)
                                                         : std::vector<std::complex<double>>());
    }
  }

  /// The block of frequency ω; called for ascending ω.
  Eigen::MatrixXcd block(int omega) {
    turn_phases(omega);
    const bool with_center = pattern_.has_center && omega == 0;
    const int shift = with_center ? 1 : 0;  // the centre, -1, comes first
    const auto size = static_cast<Eigen::Index>(pattern_.orbits.size()) + shift;
    Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(size, size);
    for (std::size_t name = 0; name < sums_.size(); ++name)
      if (pattern_.names[name].repeated)
        sums_[name] = transforms_[name][static_cast<std::size_t>(omega)];
    for (std::size_t i = 0; i < pattern_.terms.size(); ++i) {
      const spectrum::SectorTerm& term = pattern_.terms[i];
      if (!with_center && (term.row == spectrum::kCenter || term.column == spectrum::kCenter))
        continue;
      block(term.row + shift, term.column + shift) += factors_[i] * along(term, omega, phases_[i]);
    }
    return block;
  }

 private:
  [[nodiscard]] std::complex<double> phase(double sectors) const {
    return std::polar(1.0, kTwoPi * sectors / n_);
  }

  /// Phases of ω, whichever frequency they had, by the same roundings.
  void turn_phases(int omega) {
    constexpr int kResync = 16;  // so that errors of the recurrence for e^{iωx} do not add up
    const int synchronous = omega - omega % kResync;
    if (at_ < synchronous) {
      for (std::size_t i = 0; i < phases_.size(); ++i)
        phases_[i] = phase(pattern_.terms[i].angle * synchronous);
      at_ = synchronous;
    }
    for (; at_ < omega; ++at_)
      for (std::size_t i = 0; i < phases_.size(); ++i) phases_[i] *= steps_[i];
  }

  /// What the positions of a term sum to, without its factor.
  [[nodiscard]] std::complex<double> along(const spectrum::SectorTerm& term, int omega,
                                           std::complex<double> first) const {
    if (term.every_sector && omega != 0) return 0.0;
    if (term.repeated < 0) return term.every_sector ? n_ : first;
    const auto name = static_cast<std::size_t>(term.repeated);
    if (term.every_sector) return n_ * totals_[name];
    if (term.slope == 0) return first * totals_[name];
    return first * (term.slope > 0 ? sums_[name] : std::conj(sums_[name]));
  }

  const spectrum::SectorPattern& pattern_;
  int n_;
  int at_ = -1;  // the frequency of phases_
  std::vector<std::complex<double>> steps_, phases_;
  /// Of each repeated name's weights, at all ω and at the present one.
  std::vector<std::vector<std::complex<double>>> transforms_;
  std::vector<std::complex<double>> sums_;
  std::vector<double> factors_;
  std::vector<double> totals_;  // of each name's weights
};

}  // namespace

FrequencyAnalysis::FrequencyAnalysis(const Scheme& scheme, int rings)
    : scheme_(&scheme), rings_(rings) {}
FrequencyAnalysis::~FrequencyAnalysis() = default;
FrequencyAnalysis::FrequencyAnalysis(FrequencyAnalysis&&) noexcept = default;
FrequencyAnalysis& FrequencyAnalysis::operator=(FrequencyAnalysis&&) noexcept = default;

Result<const spectrum::SectorPattern*> FrequencyAnalysis::pattern_at(int n) {
  Result<spectrum::CenterCases> cases = spectrum::center_cases(*scheme_, n);
  if (!cases) return cases.error();
  std::unique_ptr<spectrum::SectorPattern>& pattern = patterns_[*cases];
  if (pattern) return pattern.get();
  const Result<int> rings = rings_ > 0 ? rings_ : spectrum::control_rings(*scheme_, *cases);
  if (!rings) return rings.error();
  Result<spectrum::SectorPattern> made = spectrum::sector_pattern(*scheme_, *cases, *rings);
  if (!made) return made.error();
  pattern = std::make_unique<spectrum::SectorPattern>(std::move(*made));
  return pattern.get();
}

Result<FrequencyBlocks> FrequencyAnalysis::blocks(int n, int frequencies) {
  std::vector<int> first(static_cast<std::size_t>(std::min(frequencies, std::max(n, 0) / 2 + 1)));
  std::iota(first.begin(), first.end(), 0);
  Result<FrequencyBlocks> result = blocks(n, first);
  if (result) result->blocks.resize(first.size());
  return result;
}

Result<FrequencyBlocks> FrequencyAnalysis::blocks(int n, const std::vector<int>& frequencies) {
  if (const int least = spectrum::least_valence(*scheme_->split); n < least)
    return Error{fmt::format("valence {} is below {}: {}", n, least,
                             scheme_->split->is_dual()
                                 ? "under a dual split it is the number of a face's corners"
                                 : "an interior vertex has two faces or more")};
  const Result<const spectrum::SectorPattern*> pattern = pattern_at(n);
  if (!pattern) return pattern.error();
  const spectrum::SectorPattern& p = **pattern;
  const Result<Weights> weights = evaluated(*scheme_, p, n);
  if (!weights) return weights.error();
  FrequencyBlocks result{n, p.rings, p.has_center, p.orbits, {}};
  TermsAt terms(p, *weights, n);
  result.blocks.resize(static_cast<std::size_t>(n / 2 + 1));
  result.blocks.front() = terms.block(0);
  for (const int omega : frequencies)
    if (omega > 0) result.blocks[static_cast<std::size_t>(omega)] = terms.block(omega);
  if (Status status = check_sums(*scheme_, result); !status) return status.error();
  return result;
}

}  // namespace limn
