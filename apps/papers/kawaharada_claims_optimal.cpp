#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "papers/kawaharada_evidence.h"

namespace limn::ks {
namespace {

constexpr int kSteps = 60;  // of b from 1/3 to 2/3

PaperFinding at_a_quarter(const Findings& found) {
  const Eigencomponents& at = found.quarter.at(6);
  const Truth c1 = found.quarter.regularity.smoothness[1].verdict;
  return {
      "§4.1", "with b = 1/4 the scheme is not C1",
      fmt::format("at a regular vertex the cup eigenvalue is {:.4f}, the tangent's {:.4f}; C1: {}",
                  *at.cup, *at.tangent, to_string(c1)),
      c1 == Truth::no    ? Judgement::confirmed
      : c1 == Truth::yes ? Judgement::contradicted
                         : Judgement::undecided};
}

PaperFinding butterfly_smooth(const Findings& found) {
  const HolderBracket& eighth = found.eighth.regularity.holder;
  const HolderBracket& sixteenths = found.sixteenths.regularity.holder;
  return {
      "§4.1", "C1 for b = 1/8 and 3/16, at regular vertices",
      fmt::format("proved: the Hölder exponent is in {} at b = 1/8, in {} at b = 3/16, in {} at "
                  "b = 0: C1, and rougher than the butterfly",
                  bracket_text(eighth), bracket_text(sixteenths),
                  bracket_text(found.butterfly.regularity.holder)),
      eighth.lower > 1 && sixteenths.lower > 1 ? Judgement::confirmed : Judgement::undecided};
}

/// [KS §4.1] 0 ≤ b < 1/4.
PaperFinding butterfly_range(const Findings& found) {
  const ValenceRange& range = found.b_of_butterfly.front();
  std::string words;
  for (const RangePart& part : range.parts)
    words += fmt::format(
        "at regular vertices C1 is not ruled out for {:.6f} {} b < {:.6f}, and "
        "proved at b = 0, 1/8, 3/16",
        part.low.value, part.low.of_search ? "≤" : "<", part.high.value);
  const bool same = range.parts.size() == 1 && range.parts.front().low.value <= 0 &&
                    std::abs(range.parts.front().high.value - 1 / 4.) < 1e-6;
  return {"§4.1", "maybe C1 for all 0 ≤ b < 1/4", words,
          same ? Judgement::supported : Judgement::contradicted};
}

/// μ1/μ2 of the 1-ring, in which the paper's eigenvalues are all there are.
Result<double> ratio_at(Scheme scheme, int step, int n) {
  const std::string b = fmt::format("b={}/{}", kSteps + step, 3 * kSteps);
  if (Status status = set_parameter(scheme, b); !status) return status.error();
  const Result<FrequencyBlocks> blocks = FrequencyAnalysis(scheme, 1).blocks(n);
  if (!blocks) return blocks.error();
  const Eigencomponents found = approx_eigencomponents(*blocks);
  return *found.tangent / *found.saddle;
}

/// [KS §5.2] Where the ratio is greatest among b ≥ 2c, c ≥ 0, which is 1/3 ≤ b ≤ 1/2.
Result<PaperFinding> best_choice() {
  const Result<Scheme> scheme = find_scheme("loop-type");
  if (!scheme) return scheme.error();
  std::string words;
  bool at_third = true;
  for (const int n : {5, 6, 8, 12}) {
    double best = 0;
    int where = 0;
    for (int step = 0; step <= kSteps / 2; ++step) {
      const Result<double> ratio = ratio_at(*scheme, step, n);
      if (!ratio) return ratio.error();
      if (*ratio > best) {
        best = *ratio;
        where = step;
      }
    }
    at_third = at_third && where == 0;
    words += fmt::format("{}{:.4f} at k = {}, b = {:.4f}", words.empty() ? "" : ", ", best, n,
                         (kSteps + where) / (3. * kSteps));
  }
  return PaperFinding{
      "§5.2", "b = 1/3, c = 1/6 maximises μ1/μ2 among c > 0, b ≥ 2c",
      "on the 1-ring, which has the paper's eigenvalues alone, the greatest μ1/μ2 are " + words +
          "; (b + 2c cos 2π/k)/(b + 2c cos 4π/k) rises with c/b at every k ≥ 5, as "
          "cos 2π/k > cos 4π/k",
      at_third ? Judgement::confirmed : Judgement::contradicted};
}

/// [KS §5.1] dominance when c > 0, b ≥ 2c.
PaperFinding type_range(const Findings& found) {
  double low = 0;
  int where = 0;
  for (const ValenceRange& range : found.b_of_type)
    for (const RangePart& part : range.parts)
      if (part.low.value > low) {
        low = part.low.value;
        where = range.valence;
      }
  const double equal = 1 / 3.;  // b = 2c with 2(b + c) = 1
  return {"§5.1", "if c > 0 and b − 2c ≥ 0, then b + 2c cos(2π/k) is the dominant pair",
          fmt::format("the whole neighbourhood has the eigenvalue c too, in the second ring. "
                      "With the cup at μ1² the condition is b > {:.6f} for all k, at k = {} the "
                      "strictest, which is b > 2c: b = 2c itself is a tie ({})",
                      low, where, found.b_of_type.front().parts.front().low.reason),
          std::abs(low - equal) < 1e-6 ? Judgement::refined
          : low < equal                ? Judgement::supported
                                       : Judgement::contradicted};
}

/// [KS §5.1] Even and odd k.
Result<std::vector<PaperFinding>> polygons(const Members& m) {
  std::vector<PaperFinding> claims;
  for (const int first : {6, 5}) {
    double distance = 0, axes = 1;
    std::string words;
    for (int k = first; k <= kLastValence; k += 2) {
      const Result<DifferenceFit> fit = difference_fit(m, k);
      if (!fit) return fit.error();
      distance = std::max(distance, fit->distance);
      axes = std::max(axes, fit->axes);
      words += fmt::format("{}{:.2f} at k = {}", words.empty() ? "" : ", ", fit->axes, k);
    }
    const bool affine = distance < 1e-6, regular = affine && axes < 1 + 1e-6;
    const bool even = first % 2 == 0;
    claims.push_back(
        {"§5.1",
         even ? "difference vectors tend to a regular k-gon or its expansion where k is even"
              : "difference vectors tend to a regular k-gon where k is odd",
         fmt::format(
             "from random vectors {} (to {:.0e}), with half-axes in the ratios {}; see Figure 36",
             affine ? "to an affine image of it" : "to no affine image of it", distance, words),
         even ? (affine ? Judgement::supported : Judgement::contradicted)
              : (regular ? Judgement::supported : Judgement::contradicted)});
  }
  return claims;
}

/// [KS §5.2] Judged at vertices of these valences, which the paper's cube does not have.
PaperFinding from_five_on(const Findings& found, const Members& m) {
  std::string words;
  int fairer = 0, depends = 0, count = 0;
  for (const auto& [k, records] : found.by_valence) {
    const FairnessTally tally = fairness_tally(records, m.optimal_low, m.optimal);
    words += fmt::format("{}{} of {} at k = {}", words.empty() ? "" : ", ", tally.smaller,
                         tally.smaller + tally.larger, k);
    if (k < 5) continue;
    ++count;
    fairer += tally.fairer() == Judgement::confirmed ? 1 : 0;
    depends += tally.fairer() == Judgement::depends ? 1 : 0;
  }
  return {"§5.2", "where k ≥ 5 the low pass is fairer than the optimal scheme (by the cube)",
          "the cube has the valences 3 and 6 alone; by a raised vertex of valence k (the table "
          "above) the low pass has the smaller energy, of those that do not grow for both "
          "schemes, in " +
              words,
          fairer == count         ? Judgement::supported
          : fairer + depends == 0 ? Judgement::contradicted
                                  : Judgement::depends};
}

std::string optimal_at_three(const Findings& found) {
  const Eigencomponents& at = found.optimal.at(3);
  int count = 0;
  int jordan = 1;
  for (const BlockSpectrum& spectrum : at.spectra)
    for (const Eigenvalue& eigenvalue : spectrum.eigenvalues)
      if (std::abs(eigenvalue.value - *at.tangent) < 1e-6) {
        count += spectrum.frequency == 0 ? 1 : 2;  // frequency 2 is the conjugate of 1
        jordan = std::max(jordan, eigenvalue.jordan);
      }
  return fmt::format(
      "left open at k = 3; at the other k necessary conditions alone are tested. At k = 3 |b + 2c "
      "− kβ| < |b + 2c "
      "cos(2π/k)| holds, but the "
      "tangent's {:.4f} is also c, an eigenvalue of the outer ring: {} eigenvalues are equal, with "
      "a "
      "Jordan block of size {}, which the standard theorem leaves out. What C1 needs of the "
      "eigenvalues there: {} (optimal), {} (high pass), {} (low pass). At the "
      "other k up to {} C1 is not ruled out. At regular vertices the Hölder exponents "
      "are "
      "in {}, {} and {}: C1, and none is C2, as Loop is",
      *at.tangent, count, jordan, to_string(at.verdict.c1_necessary),
      to_string(found.optimal_high.at(3).verdict.c1_necessary),
      to_string(found.optimal_low.at(3).verdict.c1_necessary), kLastValence,
      bracket_text(found.optimal.regularity.holder),
      bracket_text(found.optimal_high.regularity.holder),
      bracket_text(found.optimal_low.regularity.holder));
}

/// The condition leaves k = 3 open where the eigenvalues do.
Judgement optimal_c1(const Findings& found) {
  bool open = false;
  for (const Eigencomponents& at : found.optimal.valences) {
    if (fails_c1(at)) return Judgement::contradicted;
    open = open || at.verdict.c1_necessary == Truth::undecided;
  }
  return open ? Judgement::refined : Judgement::supported;
}

std::string optimal_at_four(const Findings& found) {
  const Eigencomponents& at = found.optimal.at(4);
  return fmt::format(
      "good by some of the energies above, which are smaller than Loop's. If bounded curvature is "
      "meant, which the paper does not say, it is contradicted at k = 4: an outer eigenvalue 1/6 = "
      "{:.4f} leads frequency 0 and exceeds μ1² = {:.4f}. Since curvature is unbounded on the "
      "regular lattice, it is so at every k: {}",
      *at.cup, *at.tangent * *at.tangent, valences_text(found.optimal, unbounds_curvature));
}

}  // namespace

std::vector<PaperFinding> butterfly_claims(const Findings& found, const Members& m) {
  std::vector<PaperFinding> claims{at_a_quarter(found), butterfly_smooth(found),
                                   butterfly_range(found)};
  for (const auto& [b, member] : {std::pair{"1/8", &m.eighth}, {"3/16", &m.sixteenths}}) {
    const FairnessTally tally = fairness_tally(found.raised, *member, m.butterfly);
    claims.push_back(
        {"§4.2", fmt::format("the basis function for b = {} is fairer than the butterfly's", b),
         tally.words, tally.fairer()});
  }
  const FairnessTally eighth = fairness_tally(found.cube, m.eighth, m.butterfly);
  const FairnessTally sixteenths = fairness_tally(found.cube, m.sixteenths, m.butterfly);
  claims.push_back(
      {"§4.2", "on the cube no concrete gain in fairness can be seen",
       fmt::format("no gain in {} and {} of 3 energies. {}; {}", 3 - eighth.smaller,
                   3 - sixteenths.smaller, eighth.words, sixteenths.words),
       eighth.no_gain() == sixteenths.no_gain() ? eighth.no_gain() : Judgement::depends});
  return claims;
}

Result<std::vector<PaperFinding>> optimal_claims(const Findings& found, const Members& m) {
  const Result<PaperFinding> best = best_choice();
  if (!best) return best.error();
  const Result<std::vector<PaperFinding>> limits = polygons(m);
  if (!limits) return limits.error();
  std::vector<PaperFinding> claims{type_range(found)};
  claims.insert(claims.end(), limits->begin(), limits->end());
  claims.push_back(*best);
  for (const auto& [whose, member] :
       {std::pair{"the basis function of the optimal scheme is fairer than Loop's", &m.optimal},
        {"that of its low pass is fairer than Loop's", &m.optimal_low}}) {
    const FairnessTally tally = fairness_tally(found.raised, *member, m.loop);
    claims.push_back({"§5.2", whose, tally.words, tally.fairer()});
  }
  claims.push_back(from_five_on(found, m));
  claims.push_back({"§5.2",
                    "optimal schemes are C1 if and only if |b + 2c − kβ| < |b + 2c cos(2π/k)|",
                    optimal_at_three(found), optimal_c1(found)});
  claims.push_back(
      {"§5.2", "optimal schemes generate good surfaces", optimal_at_four(found),
       unbounds_curvature(found.optimal.at(4)) ? Judgement::depends : Judgement::undecided});
  return claims;
}

std::vector<PaperFinding> misprints() {
  return {
      {"§3.3", "p^{j+1} = S_k^H p^0", "p^{j+1} = S_k^H p^j"},
      {"§3.3", "the submatrix of D_k^H is denoted D_k^H",
       "the first is the whole matrix, with its accent (D́_k^H = ΔSΔ⁻¹), which is lost, maybe "
       "only from the text that limn was written from"},
      {"§3.3", "0 < a < kβ − 2/8 + 2/8 cos(2π/k) from |5/8 − kβ + a| < μ1",
       "the condition gives −μ1 − μ1² < a on the left; 0 < a is what makes it a high pass"},
      {"§3.3, note", "since 0 ≤ a ≤ 1, if k = 3, a > 0",
       "0 ≤ á ≤ 1; á = 0 gives a = 0: a > 0 where á > 0"},
      {"§3.2, note", "L⁻¹ has a local stencil; L⁻¹ does not have one",
       "the first is L̂⁻¹ = I − L/2, the second the pseudo inverse L̃⁻¹: their marks are lost, maybe "
       "only from the text that limn was written from"},
      {"§3.1", "lim L^j p is the high frequency part",
       "its direction: L^j p itself grows or vanishes with the largest eigenvalue"},
      {"§5.1", "Λ = diag(…, b + 2c cos(2(3)π/k), b + 2c cos(2(3)π/k), …)",
       "2(2)π/k the first time"},
      {"§5.1", "Re(2 w_2⁻¹ (w_2 d)) = Re(w_2⁻¹ w_2) d, Re(w_2) = Re(w_2⁻¹)",
       "but for the factors 2 and 1/k, which change no direction"},
      {"§5.1", "F = diag(0, (b + 2c cos(2π/k))^∞, …)",
       "that power is 0: the limit is of differences scaled by it"},
  };
}

}  // namespace limn::ks
