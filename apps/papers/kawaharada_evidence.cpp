#include "papers/kawaharada_evidence.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/scope.h"

namespace limn::ks {
namespace {

constexpr int kLastRangeValence = 20;

/// Outwards, so that what is printed still encloses.
double down(double value) { return std::floor(value * 1000) / 1000; }

std::string yes_no(Truth truth) { return std::string(to_string(truth)); }

/// Smoothness of every member: on the regular lattice, and where its vertices are irregular.
Status add_smoothness_table(PaperPage& page, const std::vector<const Evidence*>& all) {
  std::vector<std::vector<std::string>> rows{
      {"scheme", "Hölder exponent, regular vertices", "C1", "C2",
       "C1 proved at n =", "C1 ruled out at n =", "curvature unbounded at n ="}};
  report::DescribedTable numbers{
      {{"scheme", "its name"},
       {"holder_lower", "of the Hölder exponent at regular vertices, proved"},
       {"holder_upper", "of the same; empty where none is proved"},
       {"c1", "at regular vertices"},
       {"c2", "at regular vertices"},
       {"c1_proved_at", "valences at which C1 is proved, and refuted, in ball arithmetic"},
       {"not_c1_at", "valences at which C1 is ruled out"},
       {"unbounded_at",
        "valences at which curvature is unbounded, even if the surface is C1 there"}},
      {}};
  for (const Evidence* one : all) {
    const HolderBracket& bracket = one->regularity.holder;
    rows.push_back(
        {one->member.words, bracket_text(bracket), yes_no(one->regularity.smoothness[1].verdict),
         yes_no(one->regularity.smoothness[2].verdict), c1_answers_text(one->proofs, kFirstValence),
         valences_text(*one, fails_c1), valences_text(*one, unbounds_curvature)});
    numbers.rows.push_back(
        {one->member.words, bracket.lower, bracket.upper.value_or(NAN),
         yes_no(one->regularity.smoothness[1].verdict),
         yes_no(one->regularity.smoothness[2].verdict), c1_answers_text(one->proofs, kFirstValence),
         valences_text(*one, fails_c1), valences_text(*one, unbounds_curvature)});
  }
  return page.add_table(
      {"Smoothness", "smoothness"}, rows, numbers,
      fmt::format(
          "What an analysis of the 1-ring cannot see: `limn regularity` on the regular "
          "lattice, and `limn eigen` on the whole neighbourhood at the valences {} … {}. C1 not "
          "being ruled out by the eigenvalues proves nothing; where it is proved `limn certify` "
          "has "
          "enclosed the characteristic map; curvature is unbounded by the "
          "eigenvalues or by the regular surface round the vertex.",
          kFirstValence, kLastValence));
}

/// [KS §3.3]: −μ1 − μ1² < a < μ1 − μ1².
Status add_range_table(PaperPage& page, const std::vector<ValenceRange>& ranges,
                       const std::vector<double>& tangents) {
  std::vector<std::vector<std::string>> rows{
      {"n", "paper: 0 < a <", "−μ1 − μ1² < a < μ1 − μ1²", "limn, from the whole neighbourhood"}};
  report::DescribedTable numbers{
      {{"n", "edges of the vertex"},
       {"low", "least a at which C1 is not ruled out, from all blocks"},
       {"high", "largest a at which C1 is not ruled out, from all blocks"},
       {"formula_low", "−μ1 − μ1²"},
       {"formula_high", "μ1 − μ1², the paper's upper end"}},
      {}};
  double worst = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const ValenceRange& range = ranges[i];
    const int n = range.valence;
    const double tangent = tangents[i];
    const double low = -tangent - tangent * tangent, high = tangent - tangent * tangent;
    if (range.parts.size() != 1)
      return Error{fmt::format("the range of a at valence {} has {} parts", n, range.parts.size())};
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
          "differs from the formula by at most {:.0e}. Nor is C1 ruled out at negative a down "
          "to its lower end: for this condition, which is necessary, the paper's 0 is not needed.",
          kLastRangeValence, worst));
}

/// [KS §3.2, §3.3] The range of á: printed 0 ≤ á ≤ 1; by the condition the ends are where
/// |μ1² + á(kβ − 1/2)| is μ1.
Status add_low_pass_range(PaperPage& page, const Findings& found, const Member& low) {
  const Result<Scheme> scheme = low.load();
  if (!scheme) return scheme.error();
  std::vector<std::vector<std::string>> rows{
      {"n", "paper", "the condition allows", "limn, of 0 ≤ á ≤ 1"}};
  report::DescribedTable numbers{
      {{"n", "edges of the vertex"},
       {"low", "least á of [0, 1] at which C1 is not ruled out, from all blocks"},
       {"high", "largest á of [0, 1] at which C1 is not ruled out"},
       {"condition_low", "á where μ1² + á(kβ − 1/2) reaches ±μ1, the lower"},
       {"condition_high", "the same, the upper"}},
      {}};
  for (std::size_t i = 0; i < found.a_of_low.size(); ++i) {
    const ValenceRange& range = found.a_of_low[i];
    const Result<double> full = scheme::Scope<double>(*scheme, range.valence, std::nullopt)(
        scheme->equivalences.front().with.front().second);  // á = 1 as a high pass
    if (!full) return full.error();
    const double tangent = found.tangents[i];
    double ends[2] = {(-tangent - tangent * tangent) / *full,
                      (tangent - tangent * tangent) / *full};
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    const double least = range.parts.empty() ? NAN : range.parts.front().low.value;
    const double most = range.parts.empty() ? NAN : range.parts.back().high.value;
    rows.push_back({fmt::format("{}", range.valence), "0 ≤ á ≤ 1",
                    fmt::format("({:.3f}, {:.3f})", ends[0], ends[1]),
                    fmt::format("[{:.3f}, {:.3f}]", least, most)});
    numbers.rows.push_back({static_cast<double>(range.valence), least, most, ends[0], ends[1]});
  }
  return page.add_table({"§3.2, the range of á", "range-low"}, rows, numbers,
                        "`limn tune laplacian-loop-low --free a --require c1 --range`. The range "
                        "that the paper gives is far inside the one that its condition allows.");
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

/// Of a table of energies; `unit` of length.
report::DescribedTable fairness_columns(const std::string& unit) {
  const std::string squared = fmt::format(" [{}, squared]", unit);
  return {{{"scheme", "its name"},
           {"level", "the last, at which energies are taken [steps]"},
           {"laplacian_energy", "Σ|Lp|² at that level" + squared},
           {"scaled_laplacian", "the same times 4^level" + squared},
           {"scaled_laplacian_converges", "over the levels"},
           {"thin_plate", "∫ κ1² + κ2² dA [no unit]"},
           {"thin_plate_converges", "over the levels"},
           {"curvature_variation", "∫ |∇II|² dA [1 / length²]"},
           {"curvature_variation_converges", "over the levels"}},
          {}};
}

std::vector<report::Cell> fairness_row(const study::FairnessRecord& record) {
  const study::FairnessLevel& last = record.last();
  return {record.scheme,
          static_cast<double>(last.level),
          last.laplacian_energy,
          last.scaled_laplacian,
          yes_no(record.scaled_laplacian.converges),
          last.energies.thin_plate,
          yes_no(record.thin_plate.converges),
          last.energies.curvature_variation,
          yes_no(record.curvature_variation.converges)};
}

/// Energies of the limit surfaces at the finest level, and whether they converge.
Status add_fairness_table(PaperPage& page, const Control& control,
                          const std::vector<study::FairnessRecord>& records) {
  std::vector<std::vector<std::string>> rows{
      {"scheme", "Σ|Lp|² · 4^level", "thin plate", "curvature variation"}};
  report::DescribedTable numbers = fairness_columns(fmt::format("unit of {}.obj", control.name));
  const auto cell = [](double value, const fairness::Trend& trend) {
    return fmt::format("{:.4g}{}", value,
                       trend.converges == Truth::yes  ? ""
                       : trend.converges == Truth::no ? " and growing"
                                                      : " (not settled)");
  };
  for (const study::FairnessRecord& record : records) {
    const study::FairnessLevel& last = record.last();
    rows.push_back({record.scheme, cell(last.scaled_laplacian, record.scaled_laplacian),
                    cell(last.energies.thin_plate, record.thin_plate),
                    cell(last.energies.curvature_variation, record.curvature_variation)});
    numbers.rows.push_back(fairness_row(record));
  }
  return page.add_table(
      {"Fairness: " + control.title, "fairness-" + control.name}, rows, numbers,
      fmt::format(
          "`limn fairness {}.obj -s …` after {} steps, at limit points. The "
          "paper judges by eye; smaller is fairer. “And growing” is seen from step to step, "
          "not proved.",
          control.name, records.front().last().level));
}

Result<std::vector<study::FairnessRecord>> fairness_of(PaperPage& page, const Control& control,
                                                       const std::vector<Member>& members) {
  std::vector<study::FairnessRecord> records;
  study::FairnessOptions options;
  options.levels = control.steps;
  for (const Member& member : members) {
    const Result<Scheme> scheme = member.load();
    if (!scheme) return scheme.error();
    Result<study::FairnessRecord> record =
        study::approx_fairness(member.words, *scheme, control.mesh, control.points, options);
    if (!record) return record.error();
    records.push_back(std::move(*record));
  }
  if (Status status = add_fairness_table(page, control, records); !status) return status.error();
  return records;
}

/// The optimal scheme and its low pass at valences that the cube does not have.
Result<std::vector<std::pair<int, std::vector<study::FairnessRecord>>>> fairness_by_valence(
    PaperPage& page, const Members& m) {
  std::vector<std::pair<int, std::vector<study::FairnessRecord>>> all;
  std::vector<std::vector<std::string>> rows{
      {"k", "scheme", "Σ|Lp|² · 4^level", "thin plate", "curvature variation"}};
  report::DescribedTable numbers = fairness_columns("edge of the flat mesh");
  numbers.columns.insert(numbers.columns.begin(), {"k", "edges of the raised vertex"});
  for (const int k : {3, 4, 5, 6, 7, 8, 10}) {
    const Control control = raised_control(k);
    std::vector<study::FairnessRecord> records;
    for (const Member& member : {m.optimal, m.optimal_low}) {
      const Result<Scheme> scheme = member.load();
      if (!scheme) return scheme.error();
      study::FairnessOptions options;
      options.levels = 4;
      Result<study::FairnessRecord> record =
          study::approx_fairness(member.words, *scheme, control.mesh, control.points, options);
      if (!record) return record.error();
      std::vector<report::Cell> row = fairness_row(*record);
      row.insert(row.begin(), static_cast<double>(k));
      numbers.rows.push_back(std::move(row));
      const auto cell = [](double value, const fairness::Trend& trend) {
        return fmt::format("{:.4g}{}", value, trend.converges == Truth::no ? " and growing" : "");
      };
      const SurfaceEnergies& energies = record->last().energies;
      rows.push_back({fmt::format("{}", k), member.words,
                      cell(record->last().scaled_laplacian, record->scaled_laplacian),
                      cell(energies.thin_plate, record->thin_plate),
                      cell(energies.curvature_variation, record->curvature_variation)});
      records.push_back(std::move(*record));
    }
    all.emplace_back(k, std::move(records));
  }
  Status status = page.add_table(
      {"Fairness by valence", "fairness-valences"}, rows, numbers,
      "Limit surfaces of a vertex with k edges raised by 1 over a flat mesh that is regular "
      "elsewhere: the cube, by which the paper judges k ≥ 5, has the valences 3 and 6 alone.");
  if (!status) return status.error();
  return all;
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
  return Evidence{member, std::move(*regularity), std::move(*valences),
                  study::c1_answers(*scheme, kFirstValence, kLastValence)};
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
        std::tuple{&found.a_of_low, "laplacian-loop-low", "a", kFirstValence, kLastRangeValence},
        std::tuple{&found.b_of_type, "loop-type", "b", kFirstValence, kLastRangeValence},
        std::tuple{&found.b_of_butterfly, "laplacian-butterfly", "b", 6, 6}}) {
    Result<std::vector<ValenceRange>> one = c1_ranges(scheme, name, first, last);
    if (!one) return one.error();
    *ranges = std::move(*one);
  }
  const Result<std::vector<double>> tangents = loop_tangents(m.loop);
  if (!tangents) return tangents.error();
  found.tangents = *tangents;
  if (Status status = add_range_table(page, found.a_of_high, *tangents); !status)
    return status.error();
  if (Status status = add_low_pass_range(page, found, m.low); !status) return status.error();
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
    Result<std::vector<study::FairnessRecord>> records = fairness_of(page, *control, members);
    if (!records) return records.error();
    *place = std::move(*records);
  }
  auto by_valence = fairness_by_valence(page, m);
  if (!by_valence) return by_valence.error();
  found.by_valence = std::move(*by_valence);
  return found;
}

}  // namespace limn::ks
