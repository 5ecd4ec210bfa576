#include <fmt/core.h>

#include "limn/extraordinary/eigencomponents.h"
#include "limn/report/eigen_figures.h"
#include "limn/report/papers/barthe_parts.h"
#include "limn/scheme/check.h"

namespace limn::bgsk {
namespace {

/// Schemes given by a mask or factors alone have no rules at extraordinary vertices.
bool has_rules(const Scheme& scheme) { return !scheme.mask && !scheme.factors; }

struct Study {
  Scheme scheme;
  std::vector<Eigencomponents> valences;  // 3 … kLastValence
};

Result<Study> study(const std::string& name) {
  Result<Scheme> scheme = find_scheme(name);
  if (!scheme) return scheme.error();
  Study result{std::move(*scheme), {}};
  if (!has_rules(result.scheme)) return result;
  FrequencyAnalysis analysis(result.scheme);
  for (int n = kSmallestValence; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    result.valences.push_back(approx_eigencomponents(*blocks));
  }
  return result;
}

std::string number_text(std::optional<double> value) {
  return value ? fmt::format("{:.6f}", *value) : "–";
}

std::string shape_text(std::optional<Curvature> shape) {
  return shape ? std::string(to_string(*shape)) : "–";
}

std::vector<std::vector<std::string>> table_rows(const Study& study) {
  std::vector<std::vector<std::string>> rows{
      {"n", "tangent", "cup", "saddle", "C1 necessary", "bounded curvature", "cup", "saddle"}};
  for (const Eigencomponents& found : study.valences)
    rows.push_back({fmt::format("{}", found.valence), number_text(found.tangent),
                    number_text(found.cup), number_text(found.saddle),
                    std::string(to_string(found.verdict.c1_necessary)),
                    std::string(to_string(found.verdict.bounded_curvature)),
                    shape_text(found.verdict.cup), shape_text(found.verdict.saddle)});
  return rows;
}

/// The valences of which something holds.
template <class Holds>
std::string valences_where(const Study& study, const Holds& holds) {
  std::vector<int> list;
  for (const Eigencomponents& found : study.valences)
    if (holds(found)) list.push_back(found.valence);
  return runs_text(list);
}

std::string summary(const Study& study) {
  const auto not_c1 = valences_where(
      study, [](const Eigencomponents& found) { return found.verdict.c1_necessary == Truth::no; });
  const auto bounded = valences_where(study, [](const Eigencomponents& found) {
    return found.verdict.bounded_curvature == Truth::yes;
  });
  return fmt::format("necessary conditions of C1 fail at: {}; bounded curvature at: {}.", not_c1,
                     bounded);
}

}  // namespace

Status add_schemes(PaperPage& page) {
  page.add_heading("Every shipped scheme at the valences 3 … 20");
  page.add_paragraph(
      "Eigenvalues by rotational frequency, on as many rings as control the surface round the "
      "vertex (dual schemes: the face). Curvature is bounded where nothing exceeds tangent².");
  for (const std::string& name : shipped_schemes()) {
    const Result<Study> found = study(name);
    if (!found) return found.error();
    if (found->valences.empty()) continue;
    const DataTable numbers = eigenvalue_table(found->valences);
    Status status = page.add_figure({name, "eigenvalues-" + name}, eigenvalue_figure(name, numbers),
                                    numbers, "(not in the paper)", summary(*found));
    if (!status) return status;
    status =
        page.add_table({name, "table-" + name}, table_rows(*found), numbers, found->scheme.source);
    if (!status) return status;
  }
  return Done{};
}

}  // namespace limn::bgsk
