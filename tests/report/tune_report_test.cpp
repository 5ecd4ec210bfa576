// Text and JSON of solutions and ranges, by a made result.

#include "limn/report/tune_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace limn::test {
namespace {

ValenceSolutions made() {
  ValenceSolutions solutions;
  solutions.valence = 5;
  solutions.searched = {0, 1};
  solutions.samples = 3;
  Solution half;
  half.value = 0.5;
  half.rational = Rational(1, 2);
  half.holds = Truth::yes;
  half.found.tangent = 0.25;
  Solution doubtful;
  doubtful.value = 0.7071067811865476;
  doubtful.is_double = true;
  doubtful.reason = "why";
  solutions.solutions = {half, doubtful};
  solutions.throughout = {{0.75, 1}};
  return solutions;
}

TEST(TuneReport, GivesSolutionsAsJson) {
  const nlohmann::json json = report::tune_json(made());
  EXPECT_EQ(json.at("searched"), (nlohmann::json{0., 1.}));
  const nlohmann::json& first = json.at("solutions")[0];
  EXPECT_EQ(first.at("exact"), "1/2");
  EXPECT_EQ(first.at("holds"), true);
  EXPECT_EQ(first.at("components").at("tangent"), 0.25);
  EXPECT_TRUE(first.at("components").at("cup").is_null());
  const nlohmann::json& second = json.at("solutions")[1];
  EXPECT_TRUE(second.at("holds").is_null()) << "undecided";
  EXPECT_EQ(second.at("value"), 0.7071067811865476);
  EXPECT_EQ(second.at("double"), true);
  EXPECT_EQ(json.at("throughout")[0], (nlohmann::json{0.75, 1.}));
}

TEST(TuneReport, GivesSolutionsAsText) {
  const std::string text = report::tune_text("g", made());
  EXPECT_NE(text.find("0.5 = 1/2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("0.7071067811865476 (double)\n           why\n"), std::string::npos) << text;
  EXPECT_NE(text.find("      5  solved by every g in [0.75 = 3/4, 1]\n"), std::string::npos)
      << text;
}

TEST(TuneReport, TellsOpenEndsFromClosedOnes) {
  ValenceRange range;
  range.valence = 7;
  range.parts = {{{0, Rational(0), true, {}}, {0.3, std::nullopt, false, "because"}}};
  EXPECT_EQ(report::tune_text("g", range).substr(0, 26), "      7  0 <= g < 0.3\n    ");
  EXPECT_NE(report::tune_text("g", range).find("to 0.3: because"), std::string::npos);
  range.closed = true;
  EXPECT_NE(report::tune_text("g", range).find("0 <= g <= 0.3"), std::string::npos);
  const nlohmann::json json = report::tune_json(range);
  EXPECT_EQ(json.at("parts")[0].at("low").at("end_of_search"), true);
  EXPECT_EQ(json.at("parts")[0].at("high").at("reason"), "because");
  EXPECT_NE(report::common_text("g", {}).find("no g serves"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
