#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/core.h>

#include "limn/scheme/check.h"
#include "limn/spectrum/eigencomponents.h"
#include "papers/barthe_parts.h"

namespace limn::bgsk {
namespace {

constexpr double kRounding = 1e-10;

/// √3 at the valences 3 … kLastValence.
Result<std::vector<Eigencomponents>> sqrt3_valences(int rings = 0) {
  const Result<Scheme> scheme = find_scheme("sqrt3");
  if (!scheme) return scheme.error();
  FrequencyAnalysis analysis(*scheme, rings);
  std::vector<Eigencomponents> all;
  for (int n = scheme::kSmallestValence; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    all.push_back(approx_eigencomponents(*blocks));
  }
  return all;
}

double alpha_of(int n) { return 2 / 9. * (2 - std::cos(2 * std::numbers::pi / n)); }

/// (13): what the paper calls the dominant eigenvalues of the frequencies 0 (but 1), 1 and 2.
double printed_eigenvalue(int n, int frequency) {
  return frequency == 0 ? 2 / 3. - alpha_of(n)
                        : 2 / 3. * std::cos(std::numbers::pi * frequency / n);
}

/// The modulus that leads a frequency, beside the position's 1.
double leader(const Eigencomponents& found, int frequency) {
  return found.spectra[static_cast<std::size_t>(frequency)]
      .eigenvalues[frequency == 0 ? 1 : 0]
      .modulus();
}

int last_frequency(int n) { return std::min(2, n / 2); }

/// [BGSK §2.1] One list, three verdicts.
Result<PaperFinding> bare_list() {
  std::vector<std::vector<double>> lists;
  std::set<std::string> verdicts;
  for (const char* name : {"loop-7-bounded", "loop-7-shrinking", "loop-7-flat"}) {
    const Result<Scheme> scheme = find_scheme(name);
    if (!scheme) return scheme.error();
    const Result<FrequencyBlocks> blocks = FrequencyAnalysis(*scheme).blocks(7);
    if (!blocks) return blocks.error();
    const Eigencomponents found = approx_eigencomponents(*blocks);
    std::vector<double>& list = lists.emplace_back();
    for (const BlockSpectrum& spectrum : found.spectra)
      for (const Eigenvalue& one : spectrum.eigenvalues)
        list.insert(list.end(), spectrum.frequency == 0 ? 1 : 2, one.modulus());
    std::sort(list.rbegin(), list.rend());
    const Verdict& verdict = found.verdict;
    verdicts.insert(fmt::format("{}, cup {}, saddle {}", to_string(verdict.c1_necessary),
                                to_string(*verdict.cup), to_string(*verdict.saddle)));
  }
  constexpr std::size_t kShown = 6;
  double apart = 0;
  for (const auto& list : lists)
    for (std::size_t i = 0; i < kShown; ++i)
      apart = std::max(apart, std::abs(list[i] - lists.front()[i]));
  std::string words;
  for (const std::string& one : verdicts) words += (words.empty() ? "" : "; ") + one;
  return PaperFinding{
      "§2.1", "a bare list of eigenvalues does not say which configuration each belongs to",
      fmt::format("the {} largest of the three schemes of Figure 1 are the same to {:.0e}, and "
                  "there are {} verdicts (C1 necessary, cup, saddle): {}.",
                  kShown, apart, verdicts.size(), words),
      apart < kRounding && verdicts.size() == lists.size() ? Judgement::confirmed
                                                           : Judgement::contradicted};
}

/// [BGSK §2.2] S̃_ω = S̃_{v−ω}: by the twisted transform of the whole matrix, of which frequency
/// v − ω is the conjugate of ω up to the sign that half sectors bring.
PaperFinding mirrored() {
  const double half =
      std::cos(std::numbers::pi * (7 - 2) / 7.) / std::cos(std::numbers::pi * 2 / 7.);
  return {
      "§2.2", "S_ω = S_{v−ω} by rotational symmetry",
      fmt::format("equal up to conjugation where orbits stand at whole positions. At half ones, as "
                  "in √3's b, the paper's own entry 2/3 k_ω changes its sign (at v = 7, ω = 2 "
                  "the quotient is {:.0f}): the moduli are the same, so half of the frequencies "
                  "do suffice.",
                  half),
      std::abs(half + 1) < kRounding ? Judgement::refined : Judgement::confirmed};
}

PaperFinding dominant(const std::vector<Eigencomponents>& all) {
  std::string words;
  int wrong = 0;
  for (const Eigencomponents& found : all)
    for (int frequency = 0; frequency <= last_frequency(found.valence); ++frequency) {
      const double printed = printed_eigenvalue(found.valence, frequency);
      const double leads = leader(found, frequency);
      if (leads - std::abs(printed) < kRounding) continue;
      ++wrong;
      words +=
          fmt::format(" At v = {} block {} is led by {:.4f} of the second ring, not by {:.4f}.",
                      found.valence, frequency, leads, printed);
    }
  return {"§4, (13)", "μ0 = 2/3 − α, μ1 = 2/3 k_1, μ2 = 2/3 k_2 are the dominant eigenvalues",
          fmt::format("at the valences {} … {} they are, but in {} cases.{}",
                      scheme::kSmallestValence, kLastValence, wrong, words),
          wrong > 0 ? Judgement::refined : Judgement::supported};
}

/// [BGSK §4] The paper speaks of the cup; the saddle is limn's remark.
PaperFinding bounded_cup(const std::vector<Eigencomponents>& all) {
  std::vector<int> equal, more, saddles;
  for (const Eigencomponents& found : all) {
    const double squared = std::pow(found.tangent.value_or(NAN), 2);
    const double cup = leader(found, 0);
    (std::abs(cup - squared) < kRounding ? equal : more).push_back(found.valence);
    if (found.saddle && *found.saddle > squared + kRounding) saddles.push_back(found.valence);
  }
  return {"§4", "μ0 = μ1² bounds the curvature in the cup configuration",
          fmt::format("frequency 0 is led by μ1² at v = {}, by more at v = {}. The saddle, of "
                      "which α knows nothing, exceeds μ1² at v = {} (see the table of sqrt3).",
                      runs_text(equal), runs_text(more), runs_text(saddles)),
          more.empty() ? Judgement::supported : Judgement::refined};
}

/// [BGSK §4] The 1-ring has the three eigenvalues already.
Result<PaperFinding> one_ring() {
  const auto all = sqrt3_valences(1);
  if (!all) return all.error();
  double worst = 0;
  for (const Eigencomponents& found : *all)
    for (int frequency = 0; frequency <= last_frequency(found.valence); ++frequency)
      worst = std::max(worst, std::abs(leader(found, frequency) -
                                       std::abs(printed_eigenvalue(found.valence, frequency))));
  return PaperFinding{"§4", "the 1-ring alone gives μ0, μ1 and μ2",
                      fmt::format("its blocks are led by the printed values, to {:.0e}, at the "
                                  "valences {} … {}; the two rings show which others exceed them.",
                                  worst, scheme::kSmallestValence, kLastValence),
                      worst < kRounding ? Judgement::supported : Judgement::contradicted};
}

/// [BGSK §4] α_v.
Result<PaperFinding> parameter() {
  const Result<Scheme> scheme = find_scheme("sqrt3");
  if (!scheme) return scheme.error();
  FrequencyAnalysis analysis(*scheme, 1);
  double worst = 0;
  for (int n = scheme::kSmallestValence; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    const Eigencomponents found = approx_eigencomponents(*blocks);
    worst = std::max(worst, std::abs(leader(found, 0) - std::pow(leader(found, 1), 2)));
  }
  return PaperFinding{
      "§4", "α = 2/9 (2 − cos(2π/v)) solves μ0 = μ1²",
      fmt::format(
          "with it the two differ by {:.0e} at most on the 1-ring, v = {} … {}; the table of α "
          "above solves for it. It is an identity: 2/3 − α = 2/9 (1 + cos(2π/v)) = (2/3 k_1)².",
          worst, scheme::kSmallestValence, kLastValence),
      worst < kRounding ? Judgement::confirmed : Judgement::contradicted};
}

std::vector<PaperFinding> misprints() {
  return {{"(10)", "exp(−2πiωl/n), divided by n", "by v: the valence is called v there."},
          {"(11), DFT of a", "the sum over B_j runs from 0 to v", "to v − 1: v points."},
          {"§2.2, (7)", "blocks S_{i,j} with i, j to n", "to v − 1 (or to the number of orbits)."},
          {"§4, last paragraph", "the eigenvalues μ̃_i (i = 1, 2, 3)",
           "i = 0, 1, 2: (13) has μ̃_0, μ̃_1 and μ̃_2, and there is no μ̃_3."}};
}

}  // namespace

Status add_words(PaperPage& page) {
  const auto all = sqrt3_valences();
  if (!all) return all.error();
  std::vector<PaperFinding> claims;
  for (const auto& made : {bare_list, one_ring, parameter}) {
    Result<PaperFinding> one = made();
    if (!one) return one.error();
    claims.push_back(std::move(*one));
  }
  claims.insert(claims.begin() + 1, {mirrored(), dominant(*all), bounded_cup(*all)});
  if (Status status = page.add_findings({"Claims", "claims"}, claims); !status) return status;
  return page.add_findings({"Misprints", "misprints"}, misprints());
}

}  // namespace limn::bgsk
