#include "limn/report/compare/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "limn/report/compare/compare_rows.h"

namespace limn {
namespace {

report::Comparison comparison_of(const std::vector<std::string>& names) {
  study::RecordOptions options{.first_valence = 3, .last_valence = 5};
  options.regularity.budget = 20;
  report::Comparison comparison;
  for (const std::string& name : names)
    comparison.schemes.push_back(study::approx_record(name, *find_scheme(name), options));
  return comparison;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Every cell is the one that `limn compare` shows of these schemes.
TEST(Field, TurnsTheRowsOfTheComparison) {
  const report::Comparison comparison = comparison_of({"loop", "butterfly", "box-spline-triangle"});
  const std::vector<report::TableRow> rows = report::field_rows(comparison);
  std::vector<report::TableRow> all;
  for (const report::TableSection& section : report::compare_sections(comparison))
    all.insert(all.end(), section.rows.begin(), section.rows.end());
  for (const report::TableRow& row : rows)
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const report::TableRow& one) {
      return std::equal(
          one.cells.begin(), one.cells.end(), row.cells.begin(), row.cells.end(),
          [](const report::TableCell& a, const report::TableCell& b) { return a.text == b.text; });
    })) << row.name;
  const std::vector<std::string> text = lines(report::field_text(comparison));
  ASSERT_GE(text.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(text[i + 1].find(comparison.schemes[i].label), 0U) << text[i + 1];
    for (const report::TableRow& row : rows)
      EXPECT_NE(text[i + 1].find(row.cells[i].text), std::string::npos) << text[i + 1];
  }
}

TEST(Field, MarkdownHasALineForEachSchemeAndAsManyCells) {
  const report::Comparison comparison = comparison_of({"loop", "four-eight"});
  const std::vector<std::string> text = lines(report::field_markdown(comparison));
  ASSERT_EQ(text.size(), 4U);
  for (const std::string& line : text)
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'),
              std::count(text[1].begin(), text[1].end(), '|'));
  EXPECT_EQ(text[2].find("| loop | triangle-dyadic | no | 3"), 0U) << text[2];
  EXPECT_EQ(text[3].find("| four-eight | quad-sqrt2 | no | 5"), 0U) << text[3];
}

TEST(Field, ChartNamesEverySchemeThatHasBothNumbers) {
  const report::Comparison comparison = comparison_of({"loop", "catmull-clark", "butterfly"});
  const Result<std::string> svg =
      report::field_figure(comparison).canvas().render(figure::FigureFormat::svg);
  if (!svg) GTEST_SKIP() << "without cairo";
  EXPECT_GT(svg->size(), 1000U);
  const figure::Figure nothing = report::field_figure({});
  EXPECT_TRUE(nothing.canvas().render(figure::FigureFormat::svg).ok());
}

}  // namespace
}  // namespace limn
