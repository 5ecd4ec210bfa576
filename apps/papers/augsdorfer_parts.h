#pragma once
/// Private to the page of [ADS]: what its parts share.

#include "limn/report/lattice/artifact_figures.h"
#include "papers/paper_page.h"

namespace limn::ads {

/// The three schemes of the paper and their numbers over the region of frequencies.
struct Study {
  std::vector<study::NamedAnalysis> schemes;
  figure::TriangleGrid grid;
  std::vector<report::DataTable> limit;   ///< a scheme each
  std::vector<report::DataTable> stages;  ///< after one and after two smoothing stages
};

[[nodiscard]] Result<Study> study();

/// Least and largest value of a column, and the frequency of the largest.
struct Extremes {
  double low, high;
  Frequency at;
};
[[nodiscard]] Extremes extremes(const report::DataTable& table, const std::string& name);

/// How much larger the largest value of a column is after one smoothing stage than after two.
[[nodiscard]] double stage_ratio(const Study& study, const std::string& name);

/// Fig. 2: the refined lattice with its shifts X, the plane of frequencies with the artifacts' Y.
[[nodiscard]] Status add_lattices(PaperPage& page, const Study& study);

/// Tables 1-3: the paper's expressions beside limn's, and how far they differ.
[[nodiscard]] Status add_table(PaperPage& page, const Study& study, std::size_t which);

/// What the paper says, judged by its own numbers made anew.
[[nodiscard]] Result<std::vector<PaperFinding>> claims(const Study& study);

/// Sampling density, claims and misprints.
[[nodiscard]] Status add_words(PaperPage& page, const Study& study);

}  // namespace limn::ads
