#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/fairness/spectrum.h"
#include "limn/refine/subdivision_matrix.h"
#include "limn/scheme/scope.h"
#include "papers/kawaharada_evidence.h"

namespace limn::ks {
namespace {

constexpr double kRounding = 1e-12;

/// [KS §3.1]
Result<PaperFinding> eigenvalues_of_laplacian(const Studio& studio) {
  std::string words = "they lie in ";
  bool inside = true;
  for (const Control* control : {&studio.torus, &studio.cube}) {
    const Result<fairness::LaplacianModes> modes = fairness::approx_all_modes(control->mesh);
    if (!modes) return modes.error();
    const double least = modes->eigenvalues.front(), most = modes->eigenvalues.back();
    inside = inside && least > -kRounding && most < 2 + kRounding;
    words += fmt::format("[{:.4f}, {:.4f}] for the {}{}", std::abs(least), most, control->name,
                         control == &studio.torus ? ", in " : ". ");
  }
  return PaperFinding{
      "§3.1", "L = I − HA has real eigenvalues between 0 and 2",
      words +
          "The paper's proof, by a symmetric matrix similar to it and Gershgorin's circles, "
          "holds for every mesh; 2 is reached where there are no odd cycles, so by no mesh of "
          "triangles",
      inside ? Judgement::confirmed : Judgement::contradicted};
}

/// How far two members' subdivision matrices differ, at the valences of the evidence.
Result<double> largest_difference(const Member& one, const Member& other) {
  const Result<Scheme> a = one.load(), b = other.load();
  if (!a) return a.error();
  if (!b) return b.error();
  double largest = 0;
  for (int n = kFirstValence; n <= kLastValence; ++n) {
    const auto first = refine::subdivision_matrix<double>(*a, n, 2);
    const auto second = refine::subdivision_matrix<double>(*b, n, 2);
    if (!first) return first.error();
    if (!second) return second.error();
    for (std::size_t i = 0; i < first->entries.size(); ++i)
      largest = std::max(largest, std::abs(first->entries[i] - second->entries[i]));
  }
  return largest;
}

/// [KS §3.3] high pass with a = á(kβ − 1/2) against low pass with á.
Result<PaperFinding> equivalence() {
  double largest = 0;
  for (const std::string blend : {"1/4", "1/2", "1"}) {
    const Result<double> difference =
        largest_difference({"low", "laplacian-loop-low", {"a=" + blend}},
                           {"high", "laplacian-loop", {"a=" + blend + "*(n*beta - 1/2)"}});
    if (!difference) return difference.error();
    largest = std::max(largest, *difference);
  }
  return PaperFinding{
      "§3.3", "high pass with a = á(kβ − 1/2) is the low pass",
      fmt::format(
          "the subdivision matrices at k = {} … {}, á = 1/4, 1/2, 1 differ by {:.0e} at most; "
          "(1 − á)(1 − kβ) + á/2 = 1 − kβ + á(kβ − 1/2) for all",
          kFirstValence, kLastValence, largest),
      largest < kRounding ? Judgement::confirmed : Judgement::contradicted};
}

/// [KS §3.3, the note] The sign of á(kβ − 1/2), which the low pass's file states as what it is as a
/// high pass.
Result<PaperFinding> low_pass_at_three(const Members& members) {
  const Result<Scheme> low = members.low.load();
  if (!low) return low.error();
  std::string words;
  bool as_printed = true;
  for (const int n : {3, 4, 5, 6, 8, 12, 50, 1000}) {
    const Result<double> a =
        scheme::Scope<double>(*low, n, std::nullopt)(low->equivalences.front().with.front().second);
    if (!a) return a.error();
    as_printed = as_printed && (*a > 0) == (n == 3);
    words += fmt::format("{}{:+.4f} at k = {}", words.empty() ? "" : ", ", *a, n);
  }
  return PaperFinding{"§3.3", "at k = 3 the low pass is a high pass, at k ≥ 4 it is none",
                      "with á = 1 it has as a high pass a = " + words +
                          "; with á = 0 it is Loop, a = 0, at every k",
                      as_printed ? Judgement::confirmed : Judgement::contradicted};
}

PaperFinding high_pass_range(const Findings& found) {
  const auto ends = [&](int n) {
    const RangePart& part =
        found.a_of_high[static_cast<std::size_t>(n - kFirstValence)].parts.front();
    return fmt::format("{:.4f} < a < {:.4f} at k = {}", part.low.value, part.high.value, n);
  };
  double upper = 0, lower = -1;
  for (std::size_t i = 0; i < found.a_of_high.size(); ++i) {
    const RangePart& part = found.a_of_high[i].parts.front();
    const double tangent = found.tangents[i];
    upper = std::max(upper, std::abs(part.high.value - (tangent - tangent * tangent)));
    lower = std::max(lower, part.low.value);
  }
  return {"§3.3",
          "tangent plane continuous if and only if 0 < a < kβ − 2/8 + 2/8 cos(2π/k) for all k",
          fmt::format("{}, {}. The upper end is the paper's, to {:.0e}; the lower one, −μ1 − μ1², "
                      "is below 0 at every k: a need not be positive. These are necessary "
                      "conditions, of the vertex; see the table above",
                      ends(3), ends(6), upper),
          upper > 1e-9 ? Judgement::contradicted
          : lower < 0  ? Judgement::refined
                       : Judgement::supported};
}

/// [KS §3.2] 0 ≤ á ≤ 1.
PaperFinding low_pass_range(const Findings& found) {
  bool whole = true;
  for (const ValenceRange& range : found.a_of_low)
    whole = whole && range.parts.size() == 1 && range.parts.front().low.value <= 0 &&
            range.parts.front().high.value >= 1;
  return {"§3.2, §3.3", "0 ≤ á ≤ 1, and the low pass is C1 where |5/8 − kβ + á(kβ − 1/2)| < μ1",
          fmt::format("{} á in [0, 1] C1 is not ruled out at k = {} … {}; the condition itself "
                      "allows more (see the table of á)",
                      whole ? "for every" : "not for every", found.a_of_low.front().valence,
                      found.a_of_low.back().valence),
          whole ? Judgement::supported : Judgement::contradicted};
}

PaperFinding lost_smoothness(const Findings& found) {
  const std::string high_fails = valences_text(found.high, fails_c1);
  const std::string low_fails = valences_text(found.low, fails_c1);
  const bool proved =
      found.high.regularity.holder.lower > 1 && found.low.regularity.holder.lower > 1;
  const bool fails = high_fails != valences_text(found.loop, fails_c1) ||
                     low_fails != valences_text(found.loop, fails_c1);
  return {
      "§3.3", "where tangent plane continuous, the limit surface is C1",
      fmt::format(
          "C1 at regular vertices for the paper's parameters, proved: Hölder exponent in {} for "
          "its a, "
          "in {} for the low pass; of the valences {} … {} the necessary conditions fail at: {} "
          "(high pass), {} (low pass). But it "
          "is no longer C2, as Loop is ({}), and that nearly everywhere: at k = 6 the high pass "
          "has the cup eigenvalue {:.4f}, more than μ1² = {:.4f}, so that curvature is unbounded "
          "at "
          "every vertex of every level. The paper does not mention it",
          bracket_text(found.high.regularity.holder), bracket_text(found.low.regularity.holder),
          kFirstValence, kLastValence, high_fails, low_fails,
          bracket_text(found.loop.regularity.holder), *found.high.at(6).cup,
          std::pow(*found.high.at(6).tangent, 2)),
      !proved ? Judgement::undecided
      : fails ? Judgement::contradicted
              : Judgement::supported};
}

/// Volumes in the words of Figures 6 to 13.
Result<PaperFinding> outlines(Studio& studio) {
  std::string words;
  bool ordered = true;
  for (const Control* control : {&studio.torus, &studio.cube}) {
    std::vector<double> volumes;
    for (const Member* member : {&studio.members.low, &studio.members.loop, &studio.members.high}) {
      const auto surface = studio.surface(*control, *member);
      if (!surface) return surface.error();
      volumes.push_back(size_of(**surface).volume);
    }
    ordered = ordered && volumes[0] < volumes[1] && volumes[1] < volumes[2];
    words +=
        fmt::format("{}{}: {:.4f} (low pass), {:.4f} (Loop), {:.4f} (high pass)",
                    words.empty() ? "" : "; ", control->name, volumes[0], volumes[1], volumes[2]);
  }
  return PaperFinding{
      "§3.4", "high pass surfaces keep outlines more than Loop's; the low pass shrinks them",
      "by the enclosed volumes: " + words,
      ordered ? Judgement::confirmed : Judgement::contradicted};
}

const study::FairnessRecord& record_of(const std::vector<study::FairnessRecord>& records,
                                       const Member& member) {
  return *std::find_if(records.begin(), records.end(), [&](const study::FairnessRecord& one) {
    return one.scheme == member.words;
  });
}

}  // namespace

Judgement FairnessTally::fairer() const {
  if (smaller > 0) return larger == 0 ? Judgement::confirmed : Judgement::depends;
  return larger > 0 ? Judgement::contradicted : Judgement::undecided;
}

Judgement FairnessTally::no_gain() const {
  if (smaller == 0) return larger > 0 ? Judgement::confirmed : Judgement::undecided;
  return larger > 0 ? Judgement::depends : Judgement::contradicted;
}

FairnessTally fairness_tally(const std::vector<study::FairnessRecord>& records,
                             const Member& fairer, const Member& other) {
  const study::FairnessRecord& a = record_of(records, fairer);
  const study::FairnessRecord& b = record_of(records, other);
  FairnessTally tally;
  tally.words = fmt::format("{} against {}", fairer.words, other.words);
  bool first = true;
  const auto compare = [&](const char* name, const auto& value, const auto& rounding,
                           fairness::Trend study::FairnessRecord::*trend) {
    const double one = value(a.last()), two = value(b.last());
    const bool one_grows = (a.*trend).converges == Truth::no;
    const bool two_grows = (b.*trend).converges == Truth::no;
    const bool tie = std::abs(one - two) <= rounding(a.last()) + rounding(b.last());
    if (one_grows != two_grows)
      ++(one_grows ? tally.larger : tally.smaller);
    else if (!one_grows && !tie)
      ++(one < two ? tally.smaller : tally.larger);
    tally.words +=
        fmt::format("{} {} {:.4g}{} against {:.4g}{}", first ? ":" : ",", name, one,
                    one_grows ? " and growing" : "", two, two_grows ? " and growing" : "");
    first = false;
  };
  compare(
      "Σ|Lp|²·4^level", [](const study::FairnessLevel& level) { return level.scaled_laplacian; },
      [](const study::FairnessLevel& level) {
        const double scale =
            level.laplacian_energy > 0 ? level.scaled_laplacian / level.laplacian_energy : 1;
        return level.laplacian_rounding * scale;
      },
      &study::FairnessRecord::scaled_laplacian);
  compare(
      "thin plate", [](const study::FairnessLevel& level) { return level.energies.thin_plate; },
      [](const study::FairnessLevel& level) { return level.energies.rounding.thin_plate; },
      &study::FairnessRecord::thin_plate);
  compare(
      "curvature variation",
      [](const study::FairnessLevel& level) { return level.energies.curvature_variation; },
      [](const study::FairnessLevel& level) { return level.energies.rounding.curvature_variation; },
      &study::FairnessRecord::curvature_variation);
  return tally;
}

Result<std::vector<PaperFinding>> loop_claims(const Findings& found, Studio& studio) {
  const Members& m = studio.members;
  std::vector<PaperFinding> claims;
  for (Result<PaperFinding> one :
       {eigenvalues_of_laplacian(studio), equivalence(), low_pass_at_three(m), outlines(studio)}) {
    if (!one) return one.error();
    claims.push_back(std::move(*one));
  }
  claims.insert(claims.begin() + 1,
                {high_pass_range(found), low_pass_range(found), lost_smoothness(found)});
  const FairnessTally torus = fairness_tally(found.torus, m.loop, m.low);
  claims.push_back({"§3.4", "on the torus Loop's surface is fairer than that of the low pass",
                    torus.words, torus.fairer()});
  return claims;
}

Status add_claims(PaperPage& page, Studio& studio) {
  const Result<Findings> found = find_all(page, studio);
  if (!found) return found.error();
  Result<std::vector<PaperFinding>> claims = loop_claims(*found, studio);
  if (!claims) return claims.error();
  const std::vector<PaperFinding> butterfly = butterfly_claims(*found, studio.members);
  const Result<std::vector<PaperFinding>> optimal = optimal_claims(*found, studio.members);
  if (!optimal) return optimal.error();
  claims->insert(claims->end(), butterfly.begin(), butterfly.end());
  claims->insert(claims->end(), optimal->begin(), optimal->end());
  if (Status status = page.add_findings({"Claims", "claims"}, *claims); !status) return status;
  return page.add_findings({"Misprints", "misprints"}, misprints());
}

}  // namespace limn::ks
