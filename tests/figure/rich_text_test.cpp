#include "limn/figure/canvas/rich_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace limn {
namespace {

std::string plain(std::string_view text) {
  std::string result;
  for (const figure::TextRun& run : figure::parse_rich_text(text)) result += run.text;
  return result;
}

TEST(RichText, MarksNeedABrace) {
  EXPECT_EQ(plain("modified_butterfly 2*3/4^5 {x}"), "modified_butterfly 2*3/4^5 {x}");
  EXPECT_EQ(figure::parse_rich_text("modified_butterfly").size(), 1u);
  EXPECT_TRUE(figure::parse_rich_text("").empty());
}

TEST(RichText, MarksNest) {
  const std::vector<figure::TextRun> runs = figure::parse_rich_text("a_{b/{c}}*{d}^{e}");
  ASSERT_EQ(runs.size(), 5u);
  EXPECT_LT(runs[1].rise, 0);
  EXPECT_LT(runs[1].scale, 1);
  EXPECT_FALSE(runs[1].italic);
  EXPECT_TRUE(runs[2].italic);
  EXPECT_EQ(runs[2].rise, runs[1].rise);
  EXPECT_TRUE(runs[3].bold);
  EXPECT_EQ(runs[3].scale, 1);
  EXPECT_GT(runs[4].rise, 0);
}

TEST(RichText, BadBytesAndOpenBracesAreHarmless) {
  EXPECT_EQ(plain("a\xff\xc3"), "a\uFFFD\uFFFD");
  EXPECT_EQ(plain("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_EQ(plain("x_{open"), "xopen");
  EXPECT_EQ(plain("a\nb\x1b"), "a\\nb\\x1b");  // shown, as everywhere
  EXPECT_EQ(plain("α₁β"), "α₁β");
}

RC_GTEST_PROP(RichTextLaws, AnyBytesGiveRuns, (const std::string& text)) {
  for (const figure::TextRun& run : figure::parse_rich_text(text)) RC_ASSERT(!run.text.empty());
}

}  // namespace
}  // namespace limn
