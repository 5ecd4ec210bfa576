#include "limn/search/demands.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/scheme/scope.h"
#include "limn/tune/solve.h"

namespace limn::search {
namespace {

/// An answer, why it is not yes, and by how much it is missed.
struct Answer {
  Truth truth = Truth::yes;
  std::string reason = {};
  double miss = 0;
};

Answer missed(double miss, std::string reason, Truth truth = Truth::no) {
  return {truth, std::move(reason), miss};
}

/// Of an amount by which something is missed: from 0 to 1, so that one large miss does not hide
/// others.
double bounded_miss(double amount) { return amount > 0 ? amount / (1 + amount) : 0; }

// ----------------------------------------------------------------------------- at a valence

/// The largest modulus of all eigenvalues but 1 and the pair that leads frequency 1.
double largest_other(const Eigencomponents& found) {
  double largest = 0;
  for (const BlockSpectrum& block : found.spectra) {
    const std::size_t skip = block.frequency <= 1 ? 1 : 0;
    if (skip < block.eigenvalues.size())
      largest = std::max(largest, std::abs(block.eigenvalues[skip].value));
  }
  return largest;
}

/// How far a verdict is missed, in moduli of eigenvalues.
double verdict_miss(Relation relation, const Eigencomponents& found) {
  const double other = largest_other(found);
  if (relation == Relation::convergent) return bounded_miss(other - 1);
  if (!found.tangent || !(*found.tangent > 0)) return 1;
  const double bound = relation == Relation::c1 ? *found.tangent : *found.tangent * *found.tangent;
  return bounded_miss(other - bound);
}

/// What the eigenvalues say.
Answer verdict_at(Relation relation, const Eigencomponents& found) {
  const Verdict& verdict = found.verdict;
  const Truth truth = relation == Relation::convergent ? verdict.convergent
                      : relation == Relation::c1       ? verdict.c1_necessary
                                                       : verdict.curvature_necessary;
  if (truth == Truth::yes) return {};
  return missed(verdict_miss(relation, found),
                fmt::format("valence {}: {}", found.valence,
                            verdict.reasons.empty() ? "undecided" : verdict.reasons.front()),
                truth);
}

Result<double> side_value(const Scheme& scheme, const Expression& side,
                          const Eigencomponents& found) {
  const std::optional<double> values[] = {found.position, found.cup, found.tangent, found.saddle};
  scheme::Scope<double> scope(scheme, found.valence, std::nullopt);
  for (std::size_t i = 0; i < kComponents.size(); ++i) {
    const auto& names = side.names();
    const std::string name(kComponents[i].name);
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (!values[i]) return Error{fmt::format("there is no {} at valence {}", name, found.valence)};
    scope.give(name, *values[i]);
  }
  return scope(Formula{side, {}});
}

Answer relation_at(const Requirement& requirement, const Scheme& scheme,
                   const Eigencomponents& found) {
  for (const std::size_t i : requirement.used)
    if (!kComponents[i].exists_at(found.valence)) return {};  // nothing is asked here
  const Result<double> left = side_value(scheme, *requirement.left, found);
  const Result<double> right = side_value(scheme, *requirement.right, found);
  if (!left || !right) return missed(1, (left ? right : left).error().message);
  const double above = *left - *right;
  const bool equation = requirement.relation == Relation::equal;
  const bool holds = equation ? std::abs(above) <= kUndecidedResidual
                     : requirement.relation == Relation::at_least ? above >= -kEqualBelow
                                                                  : above > kEqualBelow;
  if (holds) return {};
  return missed(bounded_miss(std::max(std::abs(above), kEqualBelow)),
                fmt::format("valence {}: '{}' is missed by {:.3g}", found.valence, requirement.text,
                            std::abs(above)));
}

/// At all valences together.
Answer at_vertices(const Requirement& requirement, SchemeReading& reading) {
  Answer all;
  for (const int n : reading.valences()) {
    const Result<Eigencomponents>& found = reading.components(n);
    const Answer one = !found             ? missed(1, found.error().message)
                       : requirement.left ? relation_at(requirement, reading.scheme(), *found)
                                          : verdict_at(requirement.relation, *found);
    all.truth = all.truth && one.truth;
    all.miss += one.miss;
    if (all.reason.empty()) all.reason = one.reason;
  }
  // the lattice costs more, so it is asked last
  if (requirement.relation != Relation::bounded_curvature || all.truth != Truth::yes) return all;
  const RegularPart& lattice = reading.regular_part();
  if (lattice.bounded == Truth::yes) return all;
  return missed(1, lattice.reason, lattice.bounded);
}

// ---------------------------------------------------------------------------------- proofs

Truth truth_of(certify::Answer answer) {
  return answer == certify::Answer::proved    ? Truth::yes
         : answer == certify::Answer::refuted ? Truth::no
                                              : Truth::undecided;
}

Truth truth_of(certify::CurvatureAnswer answer) {
  using C = certify::CurvatureAnswer;
  return answer == C::bounded || answer == C::flat ? Truth::yes
         : answer == C::unbounded                  ? Truth::no
                                                   : Truth::undecided;
}

/// C1 or bounded curvature, on the lattice and at each valence.
Answer proved(Relation relation, SchemeReading& reading) {
  const Result<certify::Certificate>& certificate = reading.certificate();
  if (!certificate) return missed(1, certificate.error().message, Truth::undecided);
  Answer all{truth_of(certificate->regular.c1), certificate->regular.reason, 0};
  for (const certify::ValenceClaim& claim : certificate->valences) {
    const bool curvature = relation == Relation::bounded_curvature;
    const Truth c1 = truth_of(claim.c1);
    const Truth one = curvature ? c1 && truth_of(claim.curvature.answer) : c1;
    if (one != Truth::yes && all.truth == Truth::yes)
      all.reason = fmt::format("valence {}: {}", claim.valence,
                               c1 == Truth::yes ? claim.curvature.reason : claim.reason);
    all.truth = all.truth && one;
    if (one != Truth::yes) all.miss += 1;
  }
  if (all.truth == Truth::yes) return {};
  all.miss = std::max(all.miss, 1.0);
  all.reason = "not proved: " + all.reason;
  return all;
}

// -------------------------------------------------------------------------------------------

Answer bounds(const Demand& demand, SchemeReading& reading) {
  const Result<double> value = (*demand.value)(reading);
  if (!value) return missed(1, value.error().message);
  const double below = demand.at_least ? *demand.at_least - *value : 0;
  const double above = demand.at_most ? *value - *demand.at_most : 0;
  const double miss = std::max(below, above);
  if (miss <= 0) return {};
  return missed(bounded_miss(miss), fmt::format("'{}': {:.6g}", demand.text, *value));
}

Answer answer_of(const Demand& demand, SchemeReading& reading, Proofs which) {
  if (which == Proofs::now) return proved(demand.at_vertices->relation, reading);
  return demand.at_vertices ? at_vertices(*demand.at_vertices, reading) : bounds(demand, reading);
}

}  // namespace

void check_demands(const Study& study, SchemeReading& reading, Proofs which, Outcome& outcome) {
  for (std::size_t i = 0; i < study.demands.size(); ++i) {
    const Demand& demand = study.demands[i];
    if (which == Proofs::now && !demand.certified) continue;
    const Answer answer = answer_of(demand, reading, which);
    // what the eigenvalues allow is not yet proved
    const bool open = which == Proofs::later && demand.certified && answer.truth == Truth::yes;
    if (!open) outcome.demands[i] = answer.truth;
    if (answer.truth == Truth::yes) continue;
    outcome.violation += std::max(answer.miss, kEqualBelow);
    if (outcome.reason.empty()) outcome.reason = answer.reason;
  }
}

}  // namespace limn::search
