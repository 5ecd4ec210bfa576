#include "limn/extraordinary/frequency_blocks.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <fmt/core.h>

#include "limn/extraordinary/sector_pattern.h"
#include "limn/scheme/check.h"

namespace limn {
namespace {

const double kTwoPi = 2 * std::acos(-1.0);

/// The named weights at one valence: one number each, or n of a repeated role.
using Weights = std::vector<std::vector<double>>;

Result<Weights> evaluated(const Scheme& scheme, const SectorPattern& pattern, int n) {
  Weights weights;
  Scope<double> plain(scheme, n, std::nullopt);
  for (const NamedWeight& name : pattern.names) {
    std::vector<double>& values = weights.emplace_back();
    for (int k = 0; k < (name.repeated ? n : 1); ++k) {
      Result<double> value = name.repeated ? Scope<double>(scheme, n, k)(name.weight->value)
                                           : plain(name.weight->value);
      if (!value) return value.error();
      values.push_back(name.share * *value);
    }
  }
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

/// The term's part of the block of frequency ω at valence n.
std::complex<double> part(const SectorTerm& term, const Weights& weights, int n, int omega) {
  const auto phase = [&](double sectors) { return std::polar(1.0, kTwoPi * omega * sectors / n); };
  double factor = term.coefficient;
  for (const int name : term.names) factor *= weights[static_cast<std::size_t>(name)].front();
  if (term.every_sector) return omega == 0 ? factor * n : 0.0;
  if (term.repeated < 0) return factor * phase(term.angle);
  std::complex<double> sum = 0;
  const std::vector<double>& values = weights[static_cast<std::size_t>(term.repeated)];
  for (int k = 0; k < n; ++k)
    sum += values[static_cast<std::size_t>(k)] * phase(term.angle + term.slope * k);
  return factor * sum;
}

}  // namespace

struct FrequencyAnalysis::Pattern : SectorPattern {};

FrequencyAnalysis::FrequencyAnalysis(const Scheme& scheme, int rings)
    : scheme_(&scheme), rings_(rings) {}
FrequencyAnalysis::~FrequencyAnalysis() = default;
FrequencyAnalysis::FrequencyAnalysis(FrequencyAnalysis&&) noexcept = default;
FrequencyAnalysis& FrequencyAnalysis::operator=(FrequencyAnalysis&&) noexcept = default;

Result<const FrequencyAnalysis::Pattern*> FrequencyAnalysis::pattern_at(int n) {
  Result<CenterCases> cases = center_cases(*scheme_, n);
  if (!cases) return cases.error();
  std::unique_ptr<Pattern>& pattern = patterns_[*cases];
  if (pattern) return pattern.get();
  const Result<int> rings = rings_ > 0 ? rings_ : control_rings(*scheme_, *cases);
  if (!rings) return rings.error();
  Result<SectorPattern> made = sector_pattern(*scheme_, *cases, *rings);
  if (!made) return made.error();
  pattern = std::make_unique<Pattern>(Pattern{std::move(*made)});
  return pattern.get();
}

Result<FrequencyBlocks> FrequencyAnalysis::blocks(int n) {
  if (n < kSmallestValence)
    return Error{fmt::format("valence {} is below {}", n, kSmallestValence), {}, {}, 0, 0};
  const Result<const Pattern*> pattern = pattern_at(n);
  if (!pattern) return pattern.error();
  const SectorPattern& p = **pattern;
  const Result<Weights> weights = evaluated(*scheme_, p, n);
  if (!weights) return weights.error();
  FrequencyBlocks result{n, p.rings, p.has_center, p.orbits, {}};
  for (int omega = 0; omega <= n / 2; ++omega) {
    const bool with_center = p.has_center && omega == 0;
    const auto size = static_cast<Eigen::Index>(p.orbits.size() + (with_center ? 1 : 0));
    Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(size, size);
    for (const SectorTerm& term : p.terms) {
      if (!with_center && (term.row == kCenter || term.column == kCenter)) continue;
      const int shift = with_center ? 1 : 0;  // the centre, -1, comes first
      block(term.row + shift, term.column + shift) += part(term, *weights, n, omega);
    }
    result.blocks.push_back(std::move(block));
  }
  if (Status status = check_sums(*scheme_, result); !status) return status.error();
  return result;
}

}  // namespace limn
