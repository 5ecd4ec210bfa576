#include "limn/report/papers/kawaharada_evidence.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "limn/regular/regular_mask.h"
#include "limn/regular/second_differences.h"

namespace limn::ks {
namespace {

constexpr int kLastRangeValence = 20;

/// Outwards, so that what is printed still encloses.
double down(double value) { return std::floor(value * 1000) / 1000; }

std::string yes_no(Truth truth) { return std::string(to_string(truth)); }

/// Smoothness of every member: on the regular lattice, and where its vertices are irregular.
Status add_smoothness_table(PaperPage& page, const std::vector<const Evidence*>& all) {
  std::vector<std::vector<std::string>> rows{{"scheme", "Hölder exponent, regular vertices", "C1",
                                              "C2",
                                              "C1 ruled out at n =", "curvature unbounded at n ="}};
  DataTable numbers{{"scheme", "holder_lower", "holder_upper"}, {}};
  for (const Evidence* one : all) {
    const HolderBracket& bracket = one->regularity.holder;
    rows.push_back({one->member.words, bracket_text(bracket),
                    yes_no(one->regularity.smoothness[1].verdict),
                    yes_no(one->regularity.smoothness[2].verdict), valences_text(*one, fails_c1),
                    valences_text(*one, unbounds_curvature)});
    numbers.rows.push_back(
        {static_cast<double>(numbers.rows.size() + 1), bracket.lower, bracket.upper.value_or(NAN)});
  }
  return page.add_table(
      {"Smoothness", "smoothness"}, rows, numbers,
      fmt::format(
          "What an analysis of the 1-ring cannot see: `limn regularity` on the regular "
          "lattice, and `limn eigen` on the whole neighbourhood at the valences {} … {}. C1 not "
          "being ruled out by the eigenvalues proves nothing; curvature is unbounded by the "
          "eigenvalues or by the regular surface round the vertex.",
          kFirstValence, kLastValence));
}

/// [KS §3.3]: −μ1 − μ1² < a < μ1 − μ1².
Status add_range_table(PaperPage& page, const std::vector<ValenceRange>& ranges,
                       const std::vector<double>& tangents) {
  std::vector<std::vector<std::string>> rows{
      {"n", "paper: 0 < a <", "−μ1 − μ1² < a < μ1 − μ1²", "limn, from the whole neighbourhood"}};
  DataTable numbers{{"n", "low", "high", "formula_low", "formula_high"}, {}};
  double worst = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const ValenceRange& range = ranges[i];
    const int n = range.valence;
    const double tangent = tangents[i];
    const double low = -tangent - tangent * tangent, high = tangent - tangent * tangent;
    if (range.parts.size() != 1)
      return Error{fmt::format("the range of a at valence {} has {} parts", n, range.parts.size()),
                   {},
                   {},
                   0,
                   0};
    const RangePart& part = range.parts.front();
    worst = std::max({worst, std::abs(part.low.value - low), std::abs(part.high.value - high)});
    rows.push_back({fmt::format("{}", n), fmt::format("{:.6f}", high),
                    fmt::format("({:.6f}, {:.6f})", low, high),
                    fmt::format("({:.6f}, {:.6f})", part.low.value, part.high.value)});
    numbers.rows.push_back({static_cast<double>(n), part.low.value, part.high.value, low, high});
  }
  return page.add_table(
      {"§3.3, the range of a", "range"}, rows, numbers,
      fmt::format(
          "`limn tune laplacian-loop --free a --require c1 --valence 3..{} --range`; it "
          "differs from the formula by at most {:.0e}. Negative a, which smooth, are as good "
          "as positive ones: the paper's lower bound 0 is not needed.",
          kLastRangeValence, worst));
}

/// At the valences kFirstValence … last.
Result<std::vector<Eigencomponents>> components_of(const Scheme& scheme, int last) {
  const RegularPart regular = find_regular_part(scheme);
  FrequencyAnalysis analysis(scheme);
  std::vector<Eigencomponents> valences;
  for (int n = kFirstValence; n <= last; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    valences.push_back(approx_eigencomponents(*blocks, regular));
  }
  return valences;
}

/// μ1 of Loop, which the high pass does not change, at the valences of the ranges.
Result<std::vector<double>> loop_tangents(const Member& member) {
  const Result<Scheme> loop = member.load();
  if (!loop) return loop.error();
  const Result<std::vector<Eigencomponents>> valences = components_of(*loop, kLastRangeValence);
  if (!valences) return valences.error();
  std::vector<double> tangents;
  for (const Eigencomponents& found : *valences) tangents.push_back(found.tangent.value_or(NAN));
  return tangents;
}

/// Energies of the limit surfaces at the finest level, and whether they converge.
Status add_fairness_table(PaperPage& page, const Control& control,
                          const std::vector<FairnessRecord>& records) {
  std::vector<std::vector<std::string>> rows{
      {"scheme", "Σ|Lp|² at the last level", "thin plate", "curvature variation"}};
  DataTable numbers{{"scheme", "laplacian_energy", "thin_plate", "curvature_variation"}, {}};
  const auto cell = [](double value, const Trend& trend) {
    return fmt::format("{:.4g}{}", value,
                       trend.converges == Truth::yes  ? ""
                       : trend.converges == Truth::no ? " and grows without bound"
                                                      : " (not settled)");
  };
  for (const FairnessRecord& record : records) {
    const FairnessLevel& last = record.last();
    rows.push_back({record.scheme, fmt::format("{:.4g}", last.laplacian_energy),
                    cell(last.energies.thin_plate, record.thin_plate),
                    cell(last.energies.curvature_variation, record.curvature_variation)});
    numbers.rows.push_back({static_cast<double>(numbers.rows.size() + 1), last.laplacian_energy,
                            last.energies.thin_plate, last.energies.curvature_variation});
  }
  return page.add_table(
      {"Fairness: " + control.title, "fairness-" + control.name}, rows, numbers,
      fmt::format("`limn fairness {}.obj -s …` after {} steps, at limit points. The "
                  "paper judges by eye; smaller is fairer.",
                  control.name, records.front().last().level));
}

Result<std::vector<FairnessRecord>> fairness_of(PaperPage& page, const Control& control,
                                                const std::vector<Member>& members) {
  std::vector<FairnessRecord> records;
  FairnessOptions options;
  options.levels = control.steps;
  for (const Member& member : members) {
    const Result<Scheme> scheme = member.load();
    if (!scheme) return scheme.error();
    Result<FairnessRecord> record =
        approx_fairness(member.words, *scheme, control.mesh, control.points, options);
    if (!record) return record.error();
    records.push_back(std::move(*record));
  }
  if (Status status = add_fairness_table(page, control, records); !status) return status.error();
  return records;
}

}  // namespace

Result<Evidence> evidence_of(const Member& member) {
  const Result<Scheme> scheme = member.load();
  if (!scheme) return scheme.error();
  const Result<Mask> mask = regular_mask(*scheme);
  if (!mask) return mask.error();
  Result<Regularity> regularity = enclose_regularity(*mask);
  if (!regularity) return regularity.error();
  Result<std::vector<Eigencomponents>> valences = components_of(*scheme, kLastValence);
  if (!valences) return valences.error();
  return Evidence{member, std::move(*regularity), std::move(*valences)};
}

std::string bracket_text(const HolderBracket& bracket) {
  if (!bracket.upper) return fmt::format("at least {:.3f}", down(bracket.lower));
  return fmt::format("[{:.3f}, {:.3f}]", down(bracket.lower), -down(-*bracket.upper));
}

std::string valences_text(const Evidence& evidence, bool (*holds)(const Eigencomponents&)) {
  std::vector<int> list;
  for (const Eigencomponents& found : evidence.valences)
    if (holds(found)) list.push_back(found.valence);
  return runs_text(list);
}

bool fails_c1(const Eigencomponents& found) { return found.verdict.c1_necessary == Truth::no; }
bool unbounds_curvature(const Eigencomponents& found) {
  return found.verdict.bounded_curvature == Truth::no;
}

Result<std::vector<ValenceRange>> c1_ranges(const std::string& scheme, const std::string& name,
                                            int first, int last) {
  const Result<Scheme> found = find_scheme(scheme);
  if (!found) return found.error();
  Result<FreedScheme> freed = FreedScheme::make(*found, name);
  if (!freed) return freed.error();
  const Result<Requirement> requirement = Requirement::parse("c1", *found);
  if (!requirement) return requirement.error();
  std::vector<ValenceRange> ranges;
  for (int n = first; n <= last; ++n) {
    Result<ValenceRange> range = range_at(*freed, *requirement, n);
    if (!range) return range.error();
    ranges.push_back(std::move(*range));
  }
  return ranges;
}

Result<Findings> find_all(PaperPage& page, Studio& studio) {
  Findings found;
  const Members& m = studio.members;
  const std::vector<std::pair<Evidence*, const Member*>> all{{&found.loop, &m.loop},
                                                             {&found.high, &m.high},
                                                             {&found.low, &m.low},
                                                             {&found.butterfly, &m.butterfly},
                                                             {&found.eighth, &m.eighth},
                                                             {&found.sixteenths, &m.sixteenths},
                                                             {&found.quarter, &m.quarter},
                                                             {&found.optimal, &m.optimal},
                                                             {&found.optimal_high, &m.optimal_high},
                                                             {&found.optimal_low, &m.optimal_low}};
  std::vector<const Evidence*> evidence;
  for (const auto& [place, member] : all) {
    Result<Evidence> one = evidence_of(*member);
    if (!one) return one.error();
    *place = std::move(*one);
    evidence.push_back(place);
  }
  page.add_heading("What limn finds");
  if (Status status = add_smoothness_table(page, evidence); !status) return status.error();
  for (const auto& [ranges, scheme, name, first, last] :
       {std::tuple{&found.a_of_high, "laplacian-loop", "a", kFirstValence, kLastRangeValence},
        std::tuple{&found.b_of_type, "loop-type", "b", kFirstValence, kLastRangeValence},
        std::tuple{&found.b_of_butterfly, "laplacian-butterfly", "b", 6, 6}}) {
    Result<std::vector<ValenceRange>> one = c1_ranges(scheme, name, first, last);
    if (!one) return one.error();
    *ranges = std::move(*one);
  }
  const Result<std::vector<double>> tangents = loop_tangents(m.loop);
  if (!tangents) return tangents.error();
  if (Status status = add_range_table(page, found.a_of_high, *tangents); !status)
    return status.error();
  const std::vector<Member> loops{m.loop, m.high, m.low};
  const std::vector<Member> butterflies{m.butterfly, m.eighth, m.sixteenths};
  const std::vector<Member> optimals{m.optimal_high, m.optimal, m.optimal_low};
  for (const auto& [place, control, lists] :
       {std::tuple{&found.torus, &studio.torus, std::vector{&loops}},
        std::tuple{&found.cube, &studio.cube, std::vector{&loops, &butterflies, &optimals}},
        std::tuple{&found.raised, &studio.raised, std::vector{&loops, &butterflies, &optimals}}}) {
    std::vector<Member> members;
    for (const std::vector<Member>* list : lists)
      members.insert(members.end(), list->begin(), list->end());
    Result<std::vector<FairnessRecord>> records = fairness_of(page, *control, members);
    if (!records) return records.error();
    *place = std::move(*records);
  }
  return found;
}

}  // namespace limn::ks
