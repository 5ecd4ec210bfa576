#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/report/papers/kawaharada_evidence.h"

namespace limn::ks {
namespace {

constexpr int kSteps = 60;  // of b from 1/3 to 2/3

/// [KS §4.1] b = 1/4.
std::string at_a_quarter(const Findings& found) {
  const Eigencomponents& at = found.quarter.at(6);
  return fmt::format(
      "confirmed: at a regular vertex the cup eigenvalue is {:.4f}, the tangent's "
      "{:.4f}; C1: {}",
      *at.cup, *at.tangent, to_string(found.quarter.regularity.smoothness[1].verdict));
}

/// [KS §4.1] 0 ≤ b < 1/4.
std::string butterfly_range(const Findings& found) {
  const ValenceRange& range = found.b_of_butterfly.front();
  std::string words = "refined. ";
  for (const RangePart& part : range.parts)
    words += fmt::format("At regular vertices C1 is not ruled out for {:.6f} {} b < {:.6f}. ",
                         part.low.value, part.low.of_search ? "≤" : "<", part.high.value);
  return words + fmt::format(
                     "Proved: the Hölder exponent is in {} at b = 0, in {} at b = 1/8, in {} "
                     "at b = 3/16: C1, and rougher than the butterfly",
                     bracket_text(found.butterfly.regularity.holder),
                     bracket_text(found.eighth.regularity.holder),
                     bracket_text(found.sixteenths.regularity.holder));
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
Result<std::string> best_choice() {
  const Result<Scheme> scheme = find_scheme("loop-type");
  if (!scheme) return scheme.error();
  std::string words;
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
    words += fmt::format("{}{:.4f} at k = {}, b = {:.4f}", words.empty() ? "" : ", ", best, n,
                         (kSteps + where) / (3. * kSteps));
  }
  return "confirmed on the 1-ring, which has the paper's eigenvalues alone; the greatest μ1/μ2 "
         "are " +
         words;
}

/// [KS §5.1] dominance when c > 0, b ≥ 2c.
std::string type_range(const Findings& found) {
  double low = 0;
  int where = 0;
  for (const ValenceRange& range : found.b_of_type)
    for (const RangePart& part : range.parts)
      if (part.low.value > low) {
        low = part.low.value;
        where = range.valence;
      }
  return fmt::format(
      "refined. The whole neighbourhood has the eigenvalue c too, in the second ring. "
      "With the cup at μ1² the condition is b > {:.6f} for all k, at k = {} the "
      "strictest, which is b > 2c: b = 2c itself is a tie ({})",
      low, where, found.b_of_type.front().parts.front().low.reason);
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
      "refined, and left open at k = 3. There |b + 2c − kβ| < |b + 2c cos(2π/k)| holds, but the "
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

std::string optimal_at_four(const Findings& found) {
  const Eigencomponents& at = found.optimal.at(4);
  return fmt::format(
      "contradicted at k = 4: an outer eigenvalue 1/6 = {:.4f} leads frequency 0 and "
      "exceeds μ1² = {:.4f}: curvature is unbounded there. Since it is so on the regular lattice, "
      "it is so at every k: {}",
      *at.cup, *at.tangent * *at.tangent, valences_text(found.optimal, unbounds_curvature));
}

}  // namespace

std::vector<PaperFinding> butterfly_claims(const Findings& found, const Members& m) {
  return {
      {"§4.1", "with b = 1/4 the scheme is not C1", at_a_quarter(found)},
      {"§4.1", "C1 for b = 1/8 and 3/16; maybe for all 0 ≤ b < 1/4", butterfly_range(found)},
      {"§4.2", "the basis function for b = 1/8 is fairer than the butterfly's",
       fairness_words(found.raised, m.eighth, m.butterfly)},
      {"§4.2", "the basis function for b = 3/16 is fairer than the butterfly's",
       fairness_words(found.raised, m.sixteenths, m.butterfly)},
      {"§4.2", "on the cube no concrete gain in fairness can be seen",
       fairness_words(found.cube, m.eighth, m.butterfly)},
  };
}

Result<std::vector<PaperFinding>> optimal_claims(const Findings& found, const Members& m) {
  const Result<std::string> best = best_choice();
  if (!best) return best.error();
  return std::vector<PaperFinding>{
      {"§5.1", "if c > 0 and b − 2c ≥ 0, then b + 2c cos(2π/k) is the dominant pair",
       type_range(found)},
      {"§5.1", "difference vectors tend to a regular k-gon where k is odd",
       "contradicted: to an affine image of it; see Figure 36"},
      {"§5.2", "b = 1/3, c = 1/6 maximises μ1/μ2 among c > 0, b ≥ 2c", *best},
      {"§5.2", "the basis function of the optimal scheme is fairer than Loop's",
       fairness_words(found.raised, m.optimal, m.loop)},
      {"§5.2", "that of its low pass is fairer than Loop's",
       fairness_words(found.raised, m.optimal_low, m.loop)},
      {"§5.2", "where k ≥ 5 the low pass is fairer than the optimal scheme (by the cube)",
       fairness_words(found.cube, m.optimal_low, m.optimal)},
      {"§5.2", "optimal schemes are C1 if and only if |b + 2c − kβ| < |b + 2c cos(2π/k)|",
       optimal_at_three(found)},
      {"§5.2", "optimal schemes generate good surfaces", optimal_at_four(found)},
  };
}

}  // namespace limn::ks
