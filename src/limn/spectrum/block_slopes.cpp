#include "limn/spectrum/block_slopes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "limn/scheme/scope.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn::spectrum {
namespace {

constexpr double kElsewhere = 0.0618;  // to another place, of no meaning

/// Scopes in which the variables are jets.
class JetScopes {
 public:
  JetScopes(const Scheme& scheme, const std::vector<std::string>& variables,
            const std::vector<double>& values)
      : scheme_(scheme), variables_(variables), values_(values) {}

  [[nodiscard]] scheme::Scope<number::Jet> at(std::optional<long long> n,
                                              std::optional<long long> k) const {
    scheme::Scope<number::Jet> scope(scheme_, n, k);
    for (std::size_t j = 0; j < variables_.size(); ++j)
      scope.give(variables_[j], number::Jet::variable(values_[j], j, variables_.size()));
    return scope;
  }
  /// A weight that is one number: of the centre at valence n, or of a regular rule.
  [[nodiscard]] Result<number::Jet> single(const NamedWeight& name, int n) const {
    const std::optional<long long> valence = !name.regular ? std::optional<long long>(n)
                                             : *name.regular > 0
                                                 ? std::optional<long long>(*name.regular)
                                                 : std::nullopt;
    scheme::Scope<number::Jet> scope =
        at(valence, name.k ? std::optional<long long>(*name.k) : std::nullopt);
    return shared(name, scope(name.weight->value));
  }
  /// The n weights of a repeated role.
  [[nodiscard]] Result<std::vector<number::Jet>> repeated(const NamedWeight& name, int n) const {
    std::vector<number::Jet> jets;
    for (int k = 0; k < n; ++k) {
      scheme::Scope<number::Jet> scope = at(n, k);
      Result<number::Jet> jet = shared(name, scope(name.weight->value));
      if (!jet) return jet.error();
      jets.push_back(*std::move(jet));
    }
    return jets;
  }

 private:
  static Result<number::Jet> shared(const NamedWeight& name, Result<number::Jet> jet) {
    if (!jet) return jet;
    return number::Jet(to_double(name.share)) * *jet;
  }

  const Scheme& scheme_;
  const std::vector<std::string>& variables_;
  const std::vector<double>& values_;
};

/// A jet of complex numbers.
struct ComplexJet {
  std::complex<double> value;
  std::vector<std::complex<double>> slopes;

  void add(const number::Jet& jet, std::complex<double> factor) {
    value += jet.value * factor;
    for (std::size_t j = 0; j < slopes.size(); ++j) slopes[j] += jet.slope(j) * factor;
  }
};

std::complex<double> turn(double sectors, int omega, int n) {
  return std::polar(1.0, 2 * std::numbers::pi * std::fmod(sectors * omega, n) / n);
}

/// All that a pattern's blocks are made of, at one valence.
class Entries {
 public:
  Entries(const SectorPattern& pattern, int n, std::size_t variables)
      : pattern_(pattern), n_(n), variables_(variables) {}

  Status evaluate(const JetScopes& scopes) {
    for (const NamedWeight& name : pattern_.names) {
      single_.emplace_back();
      repeated_.emplace_back();
      if (name.repeated) {
        Result<std::vector<number::Jet>> jets = scopes.repeated(name, n_);
        if (!jets) return jets.error();
        repeated_.back() = *std::move(jets);
      } else {
        Result<number::Jet> jet = scopes.single(name, n_);
        if (!jet) return jet.error();
        single_.back() = *std::move(jet);
      }
    }
    return Done{};
  }

  void put_block(int omega, BlockSlopes& into) const {
    const bool with_center = pattern_.has_center && omega == 0;
    const int shift = with_center ? 1 : 0;
    const auto size = static_cast<Eigen::Index>(pattern_.orbits.size()) + shift;
    const auto at = static_cast<std::size_t>(omega);
    Eigen::MatrixXcd& block = into.blocks.blocks[at];
    block = Eigen::MatrixXcd::Zero(size, size);
    into.slopes[at].assign(variables_, block);
    for (const SectorTerm& term : pattern_.terms) {
      if (!with_center && (term.row == kCenter || term.column == kCenter)) continue;
      const ComplexJet entry = value_of(term, omega);
      block(term.row + shift, term.column + shift) += entry.value;
      for (std::size_t j = 0; j < variables_; ++j)
        into.slopes[at][j](term.row + shift, term.column + shift) += entry.slopes[j];
    }
  }

 private:
  [[nodiscard]] ComplexJet value_of(const SectorTerm& term, int omega) const {
    ComplexJet sum{0.0, std::vector<std::complex<double>>(variables_)};
    if (term.every_sector && omega != 0) return sum;
    number::Jet factor(term.coefficient);
    for (const int name : term.names) factor = factor * single_[static_cast<std::size_t>(name)];
    const std::complex<double> first =
        term.every_sector ? std::complex<double>(n_) : turn(term.angle, omega, n_);
    if (term.repeated < 0) {
      sum.add(factor, first);
      return sum;
    }
    const std::vector<number::Jet>& jets = repeated_[static_cast<std::size_t>(term.repeated)];
    for (int k = 0; k < n_; ++k)
      sum.add(factor * jets[static_cast<std::size_t>(k)],
              first * (term.every_sector ? 1.0 : turn(term.slope * k, omega, n_)));
    return sum;
  }

  const SectorPattern& pattern_;
  int n_;
  std::size_t variables_;
  std::vector<number::Jet> single_;                 // by name; of repeated ones 0
  std::vector<std::vector<number::Jet>> repeated_;  // by name; of others empty
};

bool is_zero(const number::Jet& jet) {
  return jet.value == 0 &&
         std::all_of(jet.slopes.begin(), jet.slopes.end(), [](double s) { return s == 0; });
}

}  // namespace

SlopeAnalysis::SlopeAnalysis(const Scheme& scheme, std::vector<std::string> variables)
    : scheme_(&scheme), variables_(std::move(variables)) {}
SlopeAnalysis::~SlopeAnalysis() = default;
SlopeAnalysis::SlopeAnalysis(SlopeAnalysis&&) noexcept = default;

Result<const SectorPattern*> SlopeAnalysis::pattern_at(int n, const std::vector<double>& values) {
  const Result<CenterCases> cases = center_cases(*scheme_, n);
  if (!cases) return cases.error();
  std::unique_ptr<SectorPattern>& pattern = patterns_[*cases];
  if (pattern) return pattern.get();
  std::vector<double> elsewhere = values;
  for (double& value : elsewhere) value += kElsewhere;
  // a weight that is 0 wherever it is looked at is none: the fewer there are, the fewer the rings
  const RegularNames named = [&](const NamedWeight& name) {
    const Result<number::Jet> here = JetScopes(*scheme_, variables_, values).single(name, n);
    const Result<number::Jet> there = JetScopes(*scheme_, variables_, elsewhere).single(name, n);
    return !here || !is_zero(*here) || !there || !is_zero(*there);
  };
  const Result<int> rings = control_rings(*scheme_, *cases, named);
  if (!rings) return rings.error();
  Result<SectorPattern> made = sector_pattern(*scheme_, *cases, *rings, named);
  if (!made) return made.error();
  pattern = std::make_unique<SectorPattern>(*std::move(made));
  return pattern.get();
}

Result<BlockSlopes> SlopeAnalysis::blocks(int n, const std::vector<double>& values,
                                          const std::vector<int>& frequencies) {
  const Result<const SectorPattern*> pattern = pattern_at(n, values);
  if (!pattern) return pattern.error();
  Entries entries(**pattern, n, variables_.size());
  if (Status status = entries.evaluate(JetScopes(*scheme_, variables_, values)); !status)
    return status.error();
  const auto count = static_cast<std::size_t>(n / 2 + 1);
  BlockSlopes result{{n, (*pattern)->rings, (*pattern)->has_center, (*pattern)->orbits, {}}, {}};
  result.blocks.blocks.resize(count);
  result.slopes.resize(count);
  for (const int omega : frequencies) entries.put_block(omega, result);
  return result;
}

Result<number::Jet> eigenvalue_jet(const BlockSlopes& slopes, const Eigenvalue& eigenvalue) {
  const Eigenvectors vectors = approx_eigenvectors(slopes.blocks, eigenvalue);
  if (vectors.right.cols() != 1 || eigenvalue.jordan != 1 || eigenvalue.multiplicity != 1)
    return Error{fmt::format("the eigenvalue {:.9g} of frequency {} is not simple",
                             eigenvalue.value.real(), eigenvalue.frequency)};
  number::Jet jet(eigenvalue.value.real());
  for (const Eigen::MatrixXcd& slope :
       slopes.slopes[static_cast<std::size_t>(eigenvalue.frequency)])
    jet.slopes.push_back((vectors.left * slope * vectors.right)(0, 0).real());
  return jet;
}

}  // namespace limn::spectrum
