#include "limn/certify/vertex/valence_proof.h"

#include <cmath>

#include <fmt/core.h>

#include "limn/certify/blocks/exact_spectrum.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn::certify {
namespace {

constexpr int kMostSquarings = 40;
constexpr double kNear = 1e-12;      // of a claimed number to what is enclosed
constexpr double kRealBelow = 1e-9;  // imaginary parts that may be rounding

/// What must be shown of the map of a frequency; nothing where none is known to decide.
std::optional<RingGoal> goal_of(int frequency, int n) {
  if (frequency == 1) return RingGoal::regular;
  if (frequency == 0) return RingGoal::one_sign;
  if (2 * frequency < n) return RingGoal::nowhere_zero;
  return std::nullopt;
}

class Search {
 public:
  Search(const Scheme& scheme, const RegularProof& regular, const CellSigns& signs, int n,
         const ProofLimits& limits)
      : scheme_(scheme), regular_(regular), signs_(signs), limits_(limits) {
    claim_.valence = n;
    claim_.bits = limits.bits;
  }

  Result<SearchedValence> run() {
    const number::BallPrecision precision(limits_.bits);
    const Result<FrequencyBlocks> blocks = FrequencyAnalysis(scheme_).blocks(claim_.valence);
    if (!blocks) return blocks.error();
    approx_ = approx_eigencomponents(*blocks);
    const Result<ValenceBalls> balls = ValenceBalls::make(scheme_, claim_.valence);
    if (!balls) return balls.error();
    if (Status found = find_leader(*balls); !found) {
      const std::string tie = exact_tie(scheme_, *balls, largest_);
      return SearchedValence{
          undecided(found.error().message + (tie.empty() ? "" : "; a tie: " + tie)), tie.empty()};
    }
    if (Status shown = find_map(*balls); !shown)
      return SearchedValence{undecided(shown.error().message), false};
    if (claim_.c1 != Answer::proved)
      claim_.curvature.reason = "not C1";
    else if (!limits_.curvature)
      claim_.curvature.reason = "was not asked for";
    else
      claim_.curvature = search_curvature(scheme_, *balls, leader_, regular_.curvature,
                                          Effective(*balls, regular_.cells, signs_));
    return SearchedValence{claim_, false};
  }

 private:
  /// What is claimed so far proves nothing.
  ValenceClaim undecided(const std::string& why) {
    ValenceClaim claim;
    claim.valence = claim_.valence;
    claim.bits = claim_.bits;
    claim.reason = why;
    claim.curvature.reason = "C1 is undecided";
    return claim;
  }

  Status find_leader(const ValenceBalls& balls) {
    for (const BlockSpectrum& spectrum : approx_.spectra) {
      const std::size_t skip = spectrum.frequency == 0 ? 1 : 0;
      if (spectrum.eigenvalues.size() <= skip) continue;
      const double modulus = spectrum.eigenvalues[skip].modulus();
      if (modulus > largest_ + kEqualBelow) {
        largest_ = modulus;
        claim_.frequency = spectrum.frequency;
      }
    }
    const number::BallMatrix block = balls.block(claim_.frequency);
    const std::optional<ApproxPair> near = approx_leader(block, kRealBelow);
    if (!near) return Error{why("the leading eigenvalue is not real")};
    const Result<EnclosedPair> pair = enclose_eigenpair(block, near->value, near->vector);
    if (!pair) return Error{why(pair.error().message)};
    leader_ = *pair;
    if (!leader_.value.is_positive()) return Error{why("the leading eigenvalue is not positive")};
    if (!number::is_less(leader_.value, number::Ball(1)))
      return Error{why("the scheme is not shown to converge")};
    claim_.squarings =
        squarings_of_others(balls, claim_.frequency, leader_, leader_.value, kMostSquarings);
    for (std::size_t i = 0; i < claim_.squarings.size(); ++i)
      if (claim_.squarings[i] < 0)
        return Error{
            why(fmt::format("frequency {} has eigenvalues that are not shown to be less "
                            "than {:.6g} of frequency {}",
                            i, leader_.value.approx(), claim_.frequency))};
    claim_.eigenvalue = leader_.value.approx();
    for (const number::Ball& entry : leader_.vector) claim_.eigenvector.push_back(entry.approx());
    return Done{};
  }

  /// `fault`, and what double precision says that it comes from.
  [[nodiscard]] std::string why(const std::string& fault) const {
    const std::vector<std::string>& reasons = approx_.verdict.reasons;
    for (const std::string& reason : reasons)
      if (reason.find("C1") != std::string::npos && reason.find("curvature") == std::string::npos)
        return fmt::format("{} (in double precision: {})", fault, reason);
    return fault;
  }

  Status find_map(const ValenceBalls& balls) {
    const std::optional<RingGoal> goal = goal_of(claim_.frequency, claim_.valence);
    if (!goal)
      return Error{
          fmt::format("{:.6g} of frequency {} = n/2 leads: no theorem that is used here "
                      "speaks of a map that has one coordinate and both signs",
                      claim_.eigenvalue, claim_.frequency)};
    EigenMap map(balls, regular_.cells, claim_.frequency, leader_);
    RingProof proof(regular_.cells, signs_, map.net, map.phase, *goal);
    Result<RingProof::Found> found = proof.search(limits_.most_parts, limits_.stop);
    if (!found) return found.error();
    if (found->answer == Answer::undecided) return Error{found->reason};
    claim_.inner = found->inner;
    claim_.ring = std::move(found->ring);
    claim_.fold = found->fold;
    const bool regular = *goal == RingGoal::regular && found->answer == Answer::proved;
    claim_.c1 = regular ? Answer::proved : Answer::refuted;
    claim_.reason = regular ? "the characteristic map is regular and winds once"
                    : claim_.fold
                        ? "the characteristic map folds: its Jacobian has both signs"
                        : fmt::format("{:.6g} of frequency {} leads, whose map winds {} times",
                                      claim_.eigenvalue, claim_.frequency, claim_.frequency);
    return Done{};
  }

  const Scheme& scheme_;
  const RegularProof& regular_;
  const CellSigns& signs_;
  const ProofLimits& limits_;
  ValenceClaim claim_;
  Eigencomponents approx_;
  EnclosedPair leader_;
  double largest_ = 0;  // modulus, of all but 1, in double precision
};

Status same_numbers(const EnclosedPair& leader, const ValenceClaim& claim) {
  const auto near = [](const number::Ball& ball, double value) {
    return std::abs(ball.approx() - value) <= kNear * std::max(1.0, std::abs(value));
  };
  if (!near(leader.value, claim.eigenvalue) || leader.vector.size() != claim.eigenvector.size())
    return Error{"the leading eigenvalue is another one"};
  for (std::size_t i = 0; i < leader.vector.size(); ++i)
    if (!near(leader.vector[i], claim.eigenvector[i]))
      return Error{"the eigenvector is another one"};
  return Done{};
}

Status check_map(const ValenceBalls& balls, const RegularProof& regular, const CellSigns& signs,
                 const EnclosedPair& leader, const ValenceClaim& claim) {
  const std::optional<RingGoal> goal = goal_of(claim.frequency, claim.valence);
  const bool proved = claim.c1 == Answer::proved;
  if (!goal || (proved && (*goal != RingGoal::regular || claim.fold)) ||
      (!proved && *goal == RingGoal::regular && !claim.fold) ||
      (claim.fold && (*goal != RingGoal::regular || !claim.ring.empty())))
    return Error{"what is shown does not prove what is claimed"};
  EigenMap map(balls, regular.cells, claim.frequency, leader);
  RingProof proof(regular.cells, signs, map.net, map.phase, *goal);
  return claim.fold ? proof.check_fold(*claim.fold, claim.inner)
                    : proof.check(claim.inner, claim.ring);
}

}  // namespace

Result<SearchedValence> search_valence(const Scheme& scheme, const RegularProof& regular,
                                       const CellSigns& signs, int n, const ProofLimits& limits) {
  return Search(scheme, regular, signs, n, limits).run();
}

Status check_valence(const Scheme& scheme, const RegularProof& regular, const CellSigns& signs,
                     const ValenceClaim& claim) {
  if (claim.valence < 3) return Error{"a valence below 3"};
  if (claim.c1 == Answer::undecided) {
    if (claim.curvature.answer != CurvatureAnswer::undecided ||
        !holds_what_it_needs(claim.curvature))
      return Error{"curvature is claimed where C1 is not"};
    return Done{};
  }
  const number::BallPrecision precision(claim.bits);
  const Result<ValenceBalls> balls = ValenceBalls::make(scheme, claim.valence);
  if (!balls) return balls.error();
  if (claim.frequency < 0 || claim.frequency > claim.valence / 2)
    return Error{"a frequency that the valence has not"};
  const number::BallMatrix block = balls->block(claim.frequency);
  if (claim.eigenvector.size() != block.rows()) return Error{"the eigenvector has another length"};
  const Result<EnclosedPair> leader = enclose_eigenpair(block, claim.eigenvalue, claim.eigenvector);
  if (!leader) return leader.error();
  if (!leader->value.is_positive()) return Error{"the leading eigenvalue is not positive"};
  if (!number::is_less(leader->value, number::Ball(1)))
    return Error{"the leading eigenvalue is not below 1"};
  if (Status same = same_numbers(*leader, claim); !same) return same;
  if (squarings_of_others(*balls, claim.frequency, *leader, leader->value, kMostSquarings) !=
          claim.squarings ||
      std::find(claim.squarings.begin(), claim.squarings.end(), -1) != claim.squarings.end())
    return Error{"other eigenvalues are not shown to be smaller by these squarings"};
  if (Status shown = check_map(*balls, regular, signs, *leader, claim); !shown) return shown;
  if (claim.c1 == Answer::proved)
    return check_curvature(scheme, *balls, *leader, regular.curvature,
                           Effective(*balls, regular.cells, signs), claim.curvature);
  if (claim.curvature.answer != CurvatureAnswer::undecided || !holds_what_it_needs(claim.curvature))
    return Error{"curvature is claimed where C1 is refuted"};
  return Done{};
}

}  // namespace limn::certify
