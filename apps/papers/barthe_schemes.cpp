#include <fmt/core.h>

#include "limn/regular/smoothness/regularity.h"
#include "limn/report/eigen/eigen_figures.h"
#include "limn/scheme/check.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/study/c1_answers.h"
#include "papers/barthe_parts.h"

namespace limn::bgsk {
namespace {

/// Schemes given by a mask or factors alone have no rules at extraordinary vertices.
bool has_rules(const Scheme& scheme) { return !scheme.mask && !scheme.factors; }

struct Study {
  Scheme scheme;
  RegularPart regular;
  std::vector<Eigencomponents> valences;  // 3 … kLastValence
  std::vector<certify::Answer> proofs;    // of C1, likewise
};

Result<Study> study(Scheme scheme) {
  Study result{std::move(scheme), {}, {}, {}};
  if (!has_rules(result.scheme)) return result;
  result.regular = find_regular_part(result.scheme);
  result.proofs = study::c1_answers(result.scheme, scheme::kSmallestValence, kLastValence);
  FrequencyAnalysis analysis(result.scheme);
  for (int n = scheme::kSmallestValence; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    result.valences.push_back(approx_eigencomponents(*blocks, result.regular));
  }
  return result;
}

std::string number_text(std::optional<double> value) {
  return value ? fmt::format("{:.6f}", *value) : "–";
}

std::string shape_text(std::optional<Curvature> shape) {
  return shape ? std::string(to_string(*shape)) : "–";
}

std::string proof_text(const Study& study, const Eigencomponents& found) {
  return std::string(certify::to_string(
      study.proofs[static_cast<std::size_t>(found.valence - scheme::kSmallestValence)]));
}

std::vector<std::vector<std::string>> table_rows(const Study& study) {
  std::vector<std::vector<std::string>> rows{{"n", "tangent", "cup", "saddle", "C1: necessary",
                                              "C1", "curvature bounded, if C1",
                                              "cup against tangent²", "saddle against tangent²"}};
  for (const Eigencomponents& found : study.valences)
    rows.push_back({fmt::format("{}", found.valence), number_text(found.tangent),
                    number_text(found.cup), number_text(found.saddle),
                    std::string(to_string(found.verdict.c1_necessary)), proof_text(study, found),
                    std::string(to_string(found.verdict.bounded_curvature)),
                    shape_text(found.verdict.cup), shape_text(found.verdict.saddle)});
  return rows;
}

/// The verdicts as a file.
report::DescribedTable verdicts_of(const Study& study) {
  report::DescribedTable table{
      {{"scheme", "its name"},
       {"valence", "edges of the vertex, of dual schemes corners of the face"},
       {"convergent", "whether 1 is simple and leads"},
       {"c1_necessary", "whether the necessary conditions of C1 hold"},
       {"c1", "proved or refuted in ball arithmetic, as `limn certify` does; or undecided"},
       {"bounded_curvature", "whether curvature is bounded at the vertex, if it is C1 there"},
       {"cup", "its eigenvalue against the tangent's squared: flat is less, unbounded more"},
       {"saddle", "its eigenvalue against the tangent's squared: flat is less, unbounded more"},
       {"reasons", "of the verdicts"}},
      {}};
  for (const Eigencomponents& found : study.valences) {
    const Verdict& verdict = found.verdict;
    std::string reasons;
    for (const std::string& reason : verdict.reasons)
      reasons += (reasons.empty() ? "" : "; ") + reason;
    table.rows.push_back({study.scheme.name, static_cast<double>(found.valence),
                          std::string(to_string(verdict.convergent)),
                          std::string(to_string(verdict.c1_necessary)), proof_text(study, found),
                          std::string(to_string(verdict.bounded_curvature)),
                          shape_text(verdict.cup), shape_text(verdict.saddle), reasons});
  }
  return table;
}

/// The valences of which something holds.
template <class Holds>
std::string valences_where(const Study& study, const Holds& holds) {
  std::vector<int> list;
  for (const Eigencomponents& found : study.valences)
    if (holds(found)) list.push_back(found.valence);
  return runs_text(list);
}

const char* words_of(Truth bounded) {
  return bounded == Truth::yes ? "bounded" : bounded == Truth::no ? "unbounded" : "undecided";
}

std::string summary(const Study& study) {
  const auto not_c1 = valences_where(
      study, [](const Eigencomponents& found) { return found.verdict.c1_necessary == Truth::no; });
  const auto bounded = valences_where(study, [](const Eigencomponents& found) {
    return found.verdict.bounded_curvature == Truth::yes;
  });
  return fmt::format(
      "C1 is proved at: {}; necessary conditions of C1 fail at: {}; curvature bounded, where C1, "
      "at: {}. On the regular "
      "lattice curvature is {} ({}).",
      c1_answers_text(study.proofs, scheme::kSmallestValence), not_c1, bounded,
      words_of(study.regular.bounded), study.regular.reason);
}

/// Where eigenvalues are complex: " Complex, shown by modulus, at: …."
std::string complex_words(const report::DataTable& numbers) {
  const std::vector<int> list = report::complex_valences(numbers);
  return list.empty() ? "" : " Complex, shown by modulus, at: " + runs_text(list) + ".";
}

}  // namespace

Status add_schemes(PaperPage& page) {
  page.add_heading("Every shipped scheme at the valences 3 … 20");
  page.add_paragraph(
      "Eigenvalues by rotational frequency, on as many rings as control the surface round the "
      "vertex (dual schemes: the face), in double precision. Curvature is bounded at a C1 vertex "
      "where no other eigenvalue exceeds tangent², those equal to it have no Jordan block, and the "
      "regular surface round it has bounded curvature. “C1: necessary” is what C1 needs of the "
      "eigenvalues; it does not suffice. The last two columns compare an eigenvalue with tangent²: "
      "flat is less, bounded equal, unbounded greater.");
  std::vector<std::pair<std::string, Scheme>> schemes;
  for (const std::string& name : shipped_schemes()) {
    const Result<Scheme> scheme = find_scheme(name);
    if (!scheme) return scheme.error();
    for (Scheme& one : scheme::lattice_schemes(*scheme)) {
      const bool alone = !one.stages || !one.stages->only;
      const std::string_view lattice = scheme::lattice_name(one.split->lattice);
      schemes.emplace_back(alone ? name : fmt::format("{}-on-{}s", name, lattice), std::move(one));
    }
  }
  for (auto& [name, scheme] : schemes) {
    const Result<Study> found = study(std::move(scheme));
    if (!found) return found.error();
    if (found->valences.empty()) continue;
    const report::DataTable numbers = report::eigenvalue_table(found->valences);
    Status status =
        page.add_figure({name, "eigenvalues-" + name}, report::eigenvalue_figure(name, numbers),
                        report::described_eigenvalues(numbers, name), "(not in the paper)",
                        summary(*found) + complex_words(numbers));
    if (!status) return status;
    status = page.add_table({name, "table-" + name}, table_rows(*found), verdicts_of(*found),
                            found->scheme.source);
    if (!status) return status;
  }
  return Done{};
}

}  // namespace limn::bgsk
