#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/fairness/spectrum.h"
#include "limn/refine/subdivision_matrix.h"
#include "limn/report/papers/kawaharada_evidence.h"

namespace limn::ks {
namespace {

/// [KS §3.1]
Result<std::string> eigenvalues_of_laplacian(const Studio& studio) {
  std::string words = "confirmed: they lie in ";
  for (const Control* control : {&studio.torus, &studio.cube}) {
    const Result<LaplacianModes> modes = approx_all_modes(control->mesh);
    if (!modes) return modes.error();
    words += fmt::format("[{:.4f}, {:.4f}] for the {}{}", std::abs(modes->eigenvalues.front()),
                         modes->eigenvalues.back(), control->name,
                         control == &studio.torus ? ", in " : ". ");
  }
  return words + "2 is reached where there are no odd cycles, so by no mesh of triangles";
}

/// How far two members' subdivision matrices differ, at the valences of the evidence.
Result<double> largest_difference(const Member& one, const Member& other) {
  const Result<Scheme> a = one.load(), b = other.load();
  if (!a) return a.error();
  if (!b) return b.error();
  double largest = 0;
  for (int n = kFirstValence; n <= kLastValence; ++n) {
    const auto first = subdivision_matrix<double>(*a, n, 2);
    const auto second = subdivision_matrix<double>(*b, n, 2);
    if (!first) return first.error();
    if (!second) return second.error();
    for (std::size_t i = 0; i < first->entries.size(); ++i)
      largest = std::max(largest, std::abs(first->entries[i] - second->entries[i]));
  }
  return largest;
}

/// [KS §3.3] high pass with a = á(kβ − 1/2) against low pass with á.
Result<std::string> equivalence() {
  double largest = 0;
  for (const std::string blend : {"1/4", "1/2", "1"}) {
    const Result<double> difference =
        largest_difference({"low", "laplacian-loop-low", {"a=" + blend}},
                           {"high", "laplacian-loop", {"a=" + blend + "*(n*beta - 1/2)"}});
    if (!difference) return difference.error();
    largest = std::max(largest, *difference);
  }
  return fmt::format("confirmed: the subdivision matrices at k = {} … {} differ by {:.0e} at most",
                     kFirstValence, kLastValence, largest);
}

/// [KS §3.3, the note] The sign of á(kβ − 1/2), which the low pass's file states as what it is as a
/// high pass.
Result<std::string> low_pass_at_three(const Members& members) {
  const Result<Scheme> low = members.low.load();
  if (!low) return low.error();
  std::string words;
  for (const int n : {3, 4, 6, 12}) {
    const Result<double> a =
        Scope<double>(*low, n, std::nullopt)(low->equivalences.front().with.front().second);
    if (!a) return a.error();
    words += fmt::format("{}{:+.4f} at k = {}", words.empty() ? "" : ", ", *a, n);
  }
  return "confirmed: as a high pass it has a = " + words;
}

std::string high_pass_range(const Findings& found) {
  const auto ends = [&](int n) {
    const RangePart& part =
        found.a_of_high[static_cast<std::size_t>(n - kFirstValence)].parts.front();
    return fmt::format("{:.4f} < a < {:.4f} at k = {}", part.low.value, part.high.value, n);
  };
  return fmt::format(
      "refined: {}, {}. The upper end is the paper's; the lower one, −μ1 − μ1², is "
      "negative: low passes meet the condition, which is necessary, too. See the table above",
      ends(3), ends(6));
}

std::string lost_smoothness(const Findings& found) {
  return fmt::format(
      "refined. It is C1 at regular vertices: Hölder exponent in {} for the paper's a, in {} for "
      "the "
      "low pass. But it is no longer C2, as Loop is ({}), and that nearly everywhere: at k = 6 the "
      "high pass has the cup eigenvalue {:.4f}, more than μ1² = {:.4f}, so that curvature is "
      "unbounded at every vertex of every level. The paper does not mention it",
      bracket_text(found.high.regularity.holder), bracket_text(found.low.regularity.holder),
      bracket_text(found.loop.regularity.holder), *found.high.at(6).cup,
      std::pow(*found.high.at(6).tangent, 2));
}

/// Volumes in the words of Figures 6 to 13.
Result<std::string> outlines(Studio& studio) {
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
  return (ordered ? "confirmed, by the enclosed volumes. "
                  : "not confirmed by the enclosed volumes. ") +
         words;
}

const FairnessRecord& record_of(const std::vector<FairnessRecord>& records, const Member& member) {
  return *std::find_if(records.begin(), records.end(),
                       [&](const FairnessRecord& one) { return one.scheme == member.words; });
}

}  // namespace

std::string fairness_words(const std::vector<FairnessRecord>& records, const Member& fairer,
                           const Member& other) {
  const FairnessRecord& a = record_of(records, fairer);
  const FairnessRecord& b = record_of(records, other);
  std::string words;
  int smaller = 0;
  int larger = 0;
  const auto compare = [&](const char* name, const auto& value, const auto& rounding,
                           Trend FairnessRecord::*trend) {
    const double one = value(a.last()), two = value(b.last());
    const bool one_grows = (a.*trend).converges == Truth::no;
    const bool two_grows = (b.*trend).converges == Truth::no;
    const double tie = rounding(a.last()) + rounding(b.last());
    smaller += (two - one > tie && !one_grows) || (two_grows && !one_grows) ? 1 : 0;
    larger += (one - two > tie && !two_grows) || (one_grows && !two_grows) ? 1 : 0;
    words += fmt::format("{}{} {:.4g}{} against {:.4g}{}", words.empty() ? "" : ", ", name, one,
                         one_grows ? " and growing" : "", two, two_grows ? " and growing" : "");
  };
  compare(
      "Σ|Lp|²", [](const FairnessLevel& level) { return level.laplacian_energy; },
      [](const FairnessLevel& level) { return level.laplacian_rounding; },
      &FairnessRecord::scaled_laplacian);
  compare(
      "thin plate", [](const FairnessLevel& level) { return level.energies.thin_plate; },
      [](const FairnessLevel& level) { return level.energies.rounding.thin_plate; },
      &FairnessRecord::thin_plate);
  compare(
      "curvature variation",
      [](const FairnessLevel& level) { return level.energies.curvature_variation; },
      [](const FairnessLevel& level) { return level.energies.rounding.curvature_variation; },
      &FairnessRecord::curvature_variation);
  const char* verdict = larger == 0 && smaller > 0   ? "confirmed"
                        : smaller == 0 && larger > 0 ? "contradicted"
                        : smaller > 0                ? "depends on the energy"
                                                     : "undecided";
  return fmt::format("{} ({} against {}): {}", verdict, fairer.words, other.words, words);
}

Result<std::vector<PaperFinding>> loop_claims(const Findings& found, Studio& studio) {
  const Members& m = studio.members;
  const Result<std::string> spectrum = eigenvalues_of_laplacian(studio);
  if (!spectrum) return spectrum.error();
  const Result<std::string> same = equivalence();
  if (!same) return same.error();
  const Result<std::string> sign = low_pass_at_three(m);
  if (!sign) return sign.error();
  const Result<std::string> volumes = outlines(studio);
  if (!volumes) return volumes.error();
  return std::vector<PaperFinding>{
      {"§3.1", "L = I − HA has real eigenvalues between 0 and 2", *spectrum},
      {"§3.3", "tangent plane continuous if and only if 0 < a < kβ − 2/8 + 2/8 cos(2π/k) for all k",
       high_pass_range(found)},
      {"§3.3", "then the limit surface is C1", lost_smoothness(found)},
      {"§3.3", "high pass with a = á(kβ − 1/2) is the low pass", *same},
      {"§3.3", "at k = 3 the low pass is a high pass", *sign},
      {"§3.4", "high pass surfaces keep outlines more than Loop's; the low pass shrinks them",
       *volumes},
      {"§3.4", "on the torus Loop's surface is fairer than that of the low pass",
       fairness_words(found.torus, m.loop, m.low)},
  };
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
  page.add_findings("Claims", *claims);
  return Done{};
}

}  // namespace limn::ks
