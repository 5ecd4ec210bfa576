#include "limn/report/compare/compare_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "limn/report/compare/compare_rows.h"

namespace limn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

report::TableRow row(report::Better better,
                     const std::vector<std::optional<report::Between>>& values) {
  report::TableRow row{"row", better};
  for (const auto& value : values) row.cells.push_back({"", value});
  return row;
}

std::vector<bool> best(report::Better better,
                       const std::vector<std::optional<report::Between>>& values) {
  return report::best_cells(row(better, values));
}

report::Between exactly(double value) { return {value, value}; }

TEST(CompareTable, MarksTheBest) {
  const std::vector<std::optional<report::Between>> three = {exactly(2), exactly(1), exactly(3)};
  EXPECT_EQ(best(report::Better::more, three), (std::vector{false, false, true}));
  EXPECT_EQ(best(report::Better::less, three), (std::vector{false, true, false}));
  EXPECT_EQ(best(report::Better::none, three), (std::vector{false, false, false}));
}

TEST(CompareTable, MarksAllThatTieAndNoneWhereAllDo) {
  EXPECT_EQ(best(report::Better::less, {exactly(1), exactly(1 + 1e-12), exactly(2)}),
            (std::vector{true, true, false}));
  EXPECT_EQ(best(report::Better::less, {exactly(1), exactly(1 + 1e-12)}),
            (std::vector{false, false}));
  EXPECT_EQ(best(report::Better::more, {exactly(0), exactly(0)}), (std::vector{false, false}));
}

TEST(CompareTable, OfOverlappingBracketsNoneIsBetter) {
  EXPECT_EQ(best(report::Better::more, {report::Between{1.8, 1.9}, report::Between{1.85, 2}}),
            (std::vector{false, false}));
  EXPECT_EQ(best(report::Better::more, {report::Between{1.8, 1.9}, report::Between{1.95, 2}}),
            (std::vector{false, true}));
  EXPECT_EQ(best(report::Better::more, {report::Between{1.8, kInfinity}, exactly(3)}),
            (std::vector{false, false}));
  EXPECT_EQ(best(report::Better::less, {report::Between{1.8, kInfinity}, exactly(1)}),
            (std::vector{false, true}));
  EXPECT_EQ(best(report::Better::less, {exactly(kInfinity), exactly(1)}),
            (std::vector{false, true}));
  EXPECT_EQ(best(report::Better::less, {exactly(kInfinity), exactly(kInfinity)}),
            (std::vector{false, false}));
  EXPECT_EQ(best(report::Better::less, {exactly(-kInfinity), exactly(-2), exactly(1)}),
            (std::vector{true, false, false}));
}

TEST(CompareTable, WhatIsNotKnownIsNotCompared) {
  EXPECT_EQ(best(report::Better::more, {exactly(2), {}, exactly(1)}),
            (std::vector{true, false, false}));
  EXPECT_EQ(best(report::Better::more, {exactly(2), {}}), (std::vector{false, false}));
  EXPECT_EQ(best(report::Better::more, {}), std::vector<bool>());
}

TEST(CompareTable, AlignsItsColumnsAndKeepsDifferences) {
  const std::vector<report::TableSection> sections = {
      {"", {{"split", report::Better::none, {{"ä"}, {"ä"}}}}},
      {"smooth",
       {{"C1", report::Better::more, {{"no", exactly(0)}, {"yes", exactly(1)}}},
        {"C0", report::Better::more, {{"yes", exactly(1)}, {"yes", exactly(1)}}}}},
      {"empty", {}}};
  EXPECT_EQ(report::table_text({"one", "other"}, sections, false),
            "         one  other\n"
            "split    ä    ä\n"
            "\n"
            "smooth\n"
            "  C1     no   yes *\n"
            "  C0     yes  yes\n");
  EXPECT_EQ(report::table_text({"one", "other"}, sections, true),
            "      one  other\n"
            "\n"
            "smooth\n"
            "  C1  no   yes *\n");
}

TEST(CompareTable, WritesNumbers) {
  EXPECT_EQ(report::numbers_text({}), "none");
  EXPECT_EQ(report::numbers_text({7}), "7");
  EXPECT_EQ(report::numbers_text({3, 4, 6, 7, 8, 12}), "3, 4, 6…8, 12");
}

}  // namespace
}  // namespace limn
