#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "papers/augsdorfer_parts.h"

namespace limn::ads {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kFarMore = 2;  ///< times as much, at least, is "far more"

double largest(const report::DataTable& table, const std::string& name) {
  double most = 0;
  for (const double value : report::column(table, name)) most = std::max(most, std::abs(value));
  return most;
}

/// The largest of Y2 and Y3 along Y1's direction.
double across_y1(const ArtifactAnalysis& analysis) {
  const report::DataTable curve = report::artifact_curve(analysis, {}, 90, 241).value();
  return std::max(largest(curve, "Y2"), largest(curve, "Y3"));
}

/// [ADS §2.3] The factor 1 - c1 + c2 - c3 of a stage vanishes where c1 = 1 and c2 = c3.
PaperFinding extruded(const Study& study) {
  PaperFinding result{"§2.3", "no artifacts Y2, Y3 where f is along Y1", {}, {}};
  std::string words;
  bool none = true, stages = true;
  for (const study::NamedAnalysis& scheme : study.schemes) {
    const double most = across_y1(scheme.analysis);
    none = none && most < kRounding;
    stages = stages && scheme.analysis.factors().stages > 0;
    words += fmt::format("{}{:.1g} ({})", words.empty() ? "" : ", ", most, scheme.name);
  }
  result.judgement = !none    ? Judgement::contradicted
                     : stages ? Judgement::confirmed
                              : Judgement::supported;
  result.found = "at most " + words + ", which is rounding: each mask has a smoothing stage, and " +
                 "its factors (1 ∓ c1 ± c2 − c3)/4 of Y2 and Y3 vanish where c1 = 1, c2 = c3.";
  if (const auto scheme = find_scheme("laplacian-butterfly"))
    if (const auto mask = regular_mask(*scheme))
      if (const auto other = ArtifactAnalysis::of(*mask))
        result.found += fmt::format(
            " It is no law of all schemes: laplacian-butterfly, with {} whole stages, has up to "
            "{:.3g}.",
            other->factors().stages, across_y1(*other));
  return result;
}

/// [ADS Fig. 3] Y2 and Y3 at a frequency are Y1 at that frequency turned by ∓60°.
PaperFinding rotated(const Study& study) {
  const ArtifactAnalysis& analysis = study.schemes.front().analysis;
  double worst = 0;
  for (const Frequency& f : study.grid.nodes) {
    std::vector<double> turned;
    const Components here = analysis.after_stages(f, 1);
    for (int i = 0; i < 6; ++i) {
      const double angle = std::numbers::pi / 3 * i;
      turned.push_back(analysis
                           .after_stages({std::cos(angle) * f[0] - std::sin(angle) * f[1],
                                          std::sin(angle) * f[0] + std::cos(angle) * f[1]},
                                         1)
                           .artifacts[0]);
    }
    for (std::size_t which : {1U, 2U}) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::size_t i : {which, 3 - which})
        nearest = std::min(nearest, std::abs(turned[i] - here.artifacts[which]));
      worst = std::max(worst, nearest);
    }
  }
  return {"Fig. 3", "the three artifacts are rotated copies of one another",
          fmt::format("at {} frequencies Y2 and Y3 are Y1 at f turned by 60° or 120°, to {:.0e}.",
                      study.grid.nodes.size(), worst),
          worst < kRounding ? Judgement::confirmed : Judgement::contradicted};
}

/// [ADS §2.3] The second stage against the first, node by node.
PaperFinding smoothing(const Study& study) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  std::size_t kept = 0;
  for (const char* name : {"signal", "Y1", "Y2", "Y3"}) {
    const std::vector<double> one = report::column(study.stages[0], name);
    const std::vector<double> two = report::column(study.stages[1], name);
    for (std::size_t i = 0; i < one.size(); ++i) {
      if (std::abs(one[i]) < kRounding) continue;
      const double factor = std::abs(two[i] / one[i]);
      low = std::min(low, factor);
      high = std::max(high, factor);
      kept += factor > 1 - kRounding ? 1 : 0;
    }
  }
  return {
      "§2.3", "signal and artifacts both decrease with every smoothing stage",
      fmt::format("a stage multiplies each by (1 ± c1 ± c2 ± c3)/4, which is at most 1 in size: "
                  "over the region by {:.4g} to {:.4g}, and by 1 itself {} (the signal of f = 0).",
                  low, high, kept == 1 ? "once" : fmt::format("{} times", kept)),
      high > 1 + kRounding ? Judgement::contradicted : Judgement::confirmed};
}

/// The most that a magnitude grows by; below 0 where none does.
double growth_between(const Components& before, const Components& after) {
  double growth = std::abs(after.signal) - std::abs(before.signal);
  for (std::size_t i = 0; i < before.artifacts.size(); ++i)
    growth = std::max(growth, std::abs(after.artifacts[i]) - std::abs(before.artifacts[i]));
  return growth;
}

constexpr int kStepsCompared = 4;  ///< one after another

/// [ADS §2.3, §4] The limit against the first step, at that step's points; and each wave alone,
/// step by step.
PaperFinding later_steps(const Study& study) {
  std::string words = "the limit at the points of the first step: ";
  bool first = true;
  double alone = 0;
  int falling = 0, kept = 0, count = 0;
  for (const study::NamedAnalysis& scheme : study.schemes) {
    double growth = 0, change = 0;
    for (const Frequency& f : study.grid.nodes) {
      const Components one = scheme.analysis.after_steps(f, 1);
      const Components limit = scheme.analysis.in_limit(f);
      growth = std::max(growth, growth_between(one, limit));
      Components before = one;
      for (int step = 2; step <= kStepsCompared; ++step) {
        const Components after = scheme.analysis.after_steps(f, step);
        alone = std::max(alone, growth_between(before, after));
        before = after;
      }
      change = std::max(change, std::abs(limit.signal - one.signal));
      for (std::size_t i = 0; i < one.artifacts.size(); ++i)
        change = std::max(change, std::abs(limit.artifacts[i] - one.artifacts[i]));
    }
    ++count;
    kept += change < kRounding ? 1 : 0;
    falling += growth < kRounding && change >= kRounding ? 1 : 0;
    words += fmt::format("{}{}: {}", std::exchange(first, false) ? "" : "; ", scheme.name,
                         change < kRounding ? "the limit has the magnitudes of the first step"
                         : growth < kRounding
                             ? fmt::format("none grows, they fall by up to {:.3f}", change)
                             : fmt::format("they grow by up to {:.3f}", growth));
  }
  return {"§2.3, §4", "the magnitudes after one step decrease with every further step",
          words + ". Interpolating schemes keep them, as §3.2 and §3.3 say themselves. " +
              (alone < kRounding
                   ? fmt::format("Each wave alone, without the new waves of later steps, grows in "
                                 "none of the steps 2 … {}.",
                                 kStepsCompared)
                   : fmt::format("A wave alone, without the new waves of later steps, grows in the "
                                 "steps 2 … {} by up to {:.2g}.",
                                 kStepsCompared, alone)),
          falling == count                         ? Judgement::confirmed
          : falling > 0 && falling + kept == count ? Judgement::refined
                                                   : Judgement::contradicted};
}

/// [ADS §3] The stages that divide each mask.
PaperFinding stage_counts(const Study& study) {
  constexpr std::array<int, 3> printed{2, 1, 2};
  std::string words;
  bool equal = true;
  for (std::size_t i = 0; i < study.schemes.size(); ++i) {
    const int found = study.schemes[i].analysis.factors().stages;
    equal = equal && found == printed[i];
    words += fmt::format("{}{} {}", i == 0 ? "" : ", ", study.schemes[i].name, found);
  }
  return {"§3", "Loop has two smoothing stages, the butterfly one, the third scheme two",
          "stages that divide the masks over the rationals, as often as they do: " + words + ".",
          equal ? Judgement::confirmed : Judgement::contradicted};
}

/// Loop against another scheme over all nodes but f = 0.
struct Tally {
  int nodes = 0, signal_less = 0, percent_less = 0, percent_ties = 0;
};
Tally tally(const Study& study, std::size_t other) {
  Tally result;
  for (const Frequency& f : study.grid.nodes) {
    if (std::hypot(f[0], f[1]) < kRounding) continue;
    const Components loop = study.schemes[0].analysis.in_limit(f);
    const Components there = study.schemes[other].analysis.in_limit(f);
    ++result.nodes;
    result.signal_less += loop.signal < there.signal ? 1 : 0;
    const double difference = there.percent_of_signal() - loop.percent_of_signal();
    const bool tie = std::abs(difference) < 1e-9;
    result.percent_ties += tie ? 1 : 0;
    result.percent_less += !tie && difference > 0 ? 1 : 0;
  }
  return result;
}

PaperFinding retained(const Study& study) {
  std::string words;
  bool signal = true, percent = true;
  for (std::size_t other = 1; other < study.schemes.size(); ++other) {
    const Tally counts = tally(study, other);
    signal = signal && counts.signal_less == counts.nodes;
    percent = percent && counts.percent_less + counts.percent_ties == counts.nodes;
    words += fmt::format(
        "{}{} keeps more of the signal than Loop at {} of {} frequencies and has "
        "the higher percentage at {}, the same at {}",
        words.empty() ? "" : "; ", study.schemes[other].name, counts.signal_less, counts.nodes,
        counts.percent_less, counts.percent_ties);
  }
  return {"§4, Fig. 12",
          "interpolating schemes retain the signal well, but with a higher percentage of artifacts",
          words + ".",
          signal && percent ? Judgement::confirmed
          : signal          ? Judgement::refined
                            : Judgement::contradicted};
}

double percent(const study::NamedAnalysis& scheme, double fy) {
  return scheme.analysis.in_limit({0, fy}).percent_of_signal();
}

/// Least ratio of the other schemes' percentages to Loop's.
double tolerance_ratio(const Study& study, double fy) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < study.schemes.size(); ++i)
    least = std::min(least, percent(study.schemes[i], fy) / percent(study.schemes[0], fy));
  return least;
}

/// [ADS §4] The key observation, at 95 % of the way to the rim.
PaperFinding near_nyquist(const Study& study) {
  constexpr double fy = 0.55;
  const double rim = nyquist_distance(Lattice::triangle, 90);
  std::string at_f, at_rim;
  for (const study::NamedAnalysis& scheme : study.schemes) {
    at_f +=
        fmt::format("{}{:.1f} % ({})", at_f.empty() ? "" : ", ", percent(scheme, fy), scheme.name);
    at_rim += fmt::format("{}{:.1f} %", at_rim.empty() ? "" : ", ", percent(scheme, rim));
  }
  double low = rim / 8, high = rim;  // the ratio falls from one to the other
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (tolerance_ratio(study, middle) >= kFarMore ? low : high) = middle;
  }
  const double ratio = tolerance_ratio(study, fy);
  return {"§4, the key observation",
          "Loop is far more tolerant to features sampled near the Nyquist limit than the "
          "interpolating schemes",
          fmt::format("more tolerant, but not far more: at f = (0, {}), {:.0f} % of the way to the "
                      "limit, the artifacts are {} of the signal, {:.2f} times Loop's. They are {} "
                      "times Loop's, which is taken for \"far more\" here, only up to f = (0, "
                      "{:.3f}), and at the limit itself all "
                      "schemes are level: {}.",
                      fy, 100 * fy / rim, at_f, ratio, kFarMore, low, at_rim),
          ratio >= kFarMore ? Judgement::confirmed
          : ratio > 1       ? Judgement::refined
                            : Judgement::contradicted};
}

/// [ADS §4] The practical outcome.
Result<PaperFinding> density(const Study& study) {
  std::string words;
  double loop = 0;
  bool higher = true;
  for (const study::NamedAnalysis& scheme : study.schemes) {
    const Result<SamplingDensity> found =
        sampling_density(scheme.analysis, 1, ArtifactMeasure::mean_energy);
    if (!found) return found.error();
    const double edges = found->worst.edges_per_wavelength;
    if (words.empty())
      loop = edges;
    else
      higher = higher && edges > loop;
    words += fmt::format("{}{:.3f} ({})", words.empty() ? "" : ", ", edges, scheme.name);
  }
  return PaperFinding{
      "§4", "interpolating schemes need a denser mesh for the same quality",
      "control edges per wavelength that keep the mean energy within 1 % in every direction: " +
          words + "; the table below has more.",
      higher ? Judgement::confirmed : Judgement::contradicted};
}

/// [ADS §3.2, §3.3] α + β + γ + δ = 1 where old points stay.
PaperFinding interpolating(const Study& study) {
  std::string words;
  bool as_printed = true;
  for (std::size_t i = 0; i < study.schemes.size(); ++i) {
    double worst = 0;
    for (const Frequency& f : study.grid.nodes) {
      const Components limit = study.schemes[i].analysis.in_limit(f);
      worst = std::max(worst, std::abs(limit.signal + limit.sum() - 1));
    }
    as_printed = as_printed && (worst < kRounding) == (i > 0);
    words += fmt::format("{}{:.1g} ({})", i == 0 ? "" : ", ", worst, study.schemes[i].name);
  }
  return {
      "§3.2, §3.3", "the butterfly and the third scheme interpolate, Loop does not",
      "old points stay where α + β + γ + δ = 1; over the region the sum differs from 1 by up to " +
          words + ".",
      as_printed ? Judgement::confirmed : Judgement::contradicted};
}

}  // namespace

Result<std::vector<PaperFinding>> claims(const Study& study) {
  const Result<PaperFinding> denser = density(study);
  if (!denser) return denser.error();
  return std::vector<PaperFinding>{retained(study),    near_nyquist(study), *denser,
                                   extruded(study),    rotated(study),      smoothing(study),
                                   later_steps(study), stage_counts(study), interpolating(study)};
}

}  // namespace limn::ads
