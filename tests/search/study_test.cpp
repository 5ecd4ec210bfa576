#include "limn/search/study.h"

#include <gtest/gtest.h>

#include "toy.h"

namespace limn::test {
namespace {

TEST(Study, ReadsWhatTheFileSays) {
  const Result<search::Study> study = search::parse_study(kLoopStudy, "toy.toml");
  ASSERT_TRUE(study) << study.error().text();
  EXPECT_EQ(study->valences, (std::vector<int>{4, 5, 6, 9}));
  ASSERT_EQ(study->coordinates.size(), 1U);
  EXPECT_EQ(study->coordinates[0].high, Rational("1/2"));
  EXPECT_EQ(study->coordinates[0].own, Rational("3/8"));
  EXPECT_TRUE(study->objectives[1].maximise);
  EXPECT_EQ(study->method.points, 9);  // of the grid
}

TEST(Study, FreesALetAtEachValence) {
  const std::string text = replaced(kLoopStudy, "[[objective]]",
                                    "[[free]]\nname = \"beta\"\nvalences = \"3..5, 7\"\nlow = 0\n"
                                    "high = \"1/n\"\nsteps = 2\n[[objective]]");
  const Result<search::Study> study = search::parse_study(text, "toy.toml");
  ASSERT_TRUE(study) << study.error().text();
  ASSERT_EQ(study->coordinates.size(), 5U);
  EXPECT_EQ(study->coordinates[4].label(), "beta@7");
  EXPECT_EQ(study->coordinates[4].high, Rational("1/7"));
  EXPECT_EQ(study->coordinates[1].own, Rational("3/16"));  // Loop at valence 3
}

struct Bad {
  const char *from, *to;
  const char* message;
  const char* place;
};

class BadStudy : public testing::TestWithParam<Bad> {};

TEST_P(BadStudy, IsRefusedWithItsPlace) {
  const Result<search::Study> study =
      search::parse_study(replaced(kLoopStudy, GetParam().from, GetParam().to), "toy.toml");
  ASSERT_FALSE(study);
  const std::string text = study.error().text();
  EXPECT_NE(text.find(GetParam().message), std::string::npos) << text;
  EXPECT_NE(text.find(GetParam().place), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadStudy,
    testing::Values(
        Bad{"loop-type", "lop", "lop", "toy.toml:3:12:"},
        Bad{"scheme   =", "skeme   =", "the study names no scheme", "toy.toml"},
        Bad{"\"b\"", "\"bb\"", "bb", "toy.toml:6:1:"},
        Bad{"low   = \"1/4\"", "low   = 0.25", "a decimal", "toy.toml:8:9:"},
        Bad{"low   = \"1/4\"", "low   = \"3/4\"", "the range of 'b' is empty", "toy.toml:6:1:"},
        Bad{"low   = \"1/4\"", "low   = \"1/(n-n)\"", "", "toy.toml:8:"},
        Bad{"low   = \"1/4\"", "", "needs name, low and high", "toy.toml:6:1:"},
        Bad{"high  = \"1/2\"", "high  = \"1/2", "string does not end", "toy.toml:9:"},
        Bad{"steps = 9", "steps = 1", "steps is a whole number from 2", "toy.toml:10:9:"},
        Bad{"steps = 9", "", "method grid needs steps of 'b'", "toy.toml:23:"},
        Bad{"artifact(1/4, 0)", "artefact(1/4, 0)", "did you mean artifact", "toy.toml:13:10:"},
        Bad{"artifact(1/4, 0)", "artifact(1/4)", "takes 2 arguments, not 1", "toy.toml:13:10:"},
        Bad{"artifact(1/4, 0)", "artifact(1/4, y)", "not the name 'y'", "toy.toml:13:24:"},
        Bad{"artifact(1/4, 0)", "artifact(1/4, 1/0)", "division by zero", "toy.toml:13:25:"},
        Bad{"artifact(1/4, 0)", "cup(2)", "a valence", "toy.toml:13:14:"},
        Bad{"artifact(1/4, 0)", "thin_plate(none.obj, 3)", "none.obj", "toy.toml:13:21:"},
        Bad{"\"min\"", "\"least\"", "unknown goal", "toy.toml:14:9:"},
        Bad{"goal  = \"min\"", "", "needs value and goal", "toy.toml:12:1:"},
        Bad{"that = \"c1\"", "that = \"c2\"", "unknown name 'c2'", "toy.toml:21:8:"},
        Bad{"that = \"c1\"", "that = \"cup < 1\"\ncertified = true", "can be certified",
            "toy.toml:20:1:"},
        Bad{"that = \"c1\"", "value = \"sum_rules()\"", "at_least or at_most", "toy.toml:20:1:"},
        Bad{"\"grid\"", "\"gird\"", "unknown method", "toy.toml:24:9:"},
        Bad{"\"grid\"", "\"local\"", "one objective, not 2", "toy.toml:23:"},
        Bad{"\"grid\"", "\"pareto\"", "batch of 8", "toy.toml:23:"},
        Bad{"batch = 4", "batch = 0", "batch is a whole number", "toy.toml:25:9:"},
        Bad{"batch = 4", "bach = 4", "did you mean batch", "toy.toml:25:1:"},
        Bad{"4, 5, 6, 9", "9..3", "no valence or range", "toy.toml:4:12:"},
        Bad{"4, 5, 6, 9", "3..99999999999999", "no valence or range", "toy.toml:4:12:"},
        Bad{"title    = \"Loop type\"", "title = \"\xff\"", "UTF-8", "toy.toml:2:"}));

TEST(Study, TellsAllFaultsAtOnce) {
  std::string text = replaced(kLoopStudy, "\"min\"", "\"least\"");
  text = replaced(text, "\"grid\"", "\"gird\"");
  const Result<search::Study> study = search::parse_study(text, "toy.toml");
  ASSERT_FALSE(study);
  EXPECT_NE(study.error().text().find("unknown goal"), std::string::npos);
  EXPECT_NE(study.error().text().find("unknown method"), std::string::npos);
}

TEST(Study, SurvivesEveryBeginningOfAFile) {
  const std::string all = kLoopStudy;
  for (std::size_t length = 0; length < all.size(); length += 3)
    (void)search::parse_study(all.substr(0, length), "toy.toml");
}

TEST(Study, IsAnotherWhereItsResultsWouldBe) {
  const std::string own = search::parse_study(kLoopStudy, "toy.toml")->identity();
  const auto changed = [&](const char* from, const char* to) {
    const Result<search::Study> study =
        search::parse_study(replaced(kLoopStudy, from, to), "toy.toml");
    EXPECT_TRUE(study) << study.error().text();
    return study->identity();
  };
  EXPECT_EQ(own, changed("\"Loop type\"", "\"another title\""));
  EXPECT_NE(own, changed("loop-type", "optimal"));
  EXPECT_NE(own, changed("steps = 9", "steps = 5"));
  EXPECT_NE(own, changed("1/4, 0", "1/4, 1/8"));
  EXPECT_NE(own, changed("\"max\"", "\"min\""));
  EXPECT_NE(own, changed("4, 5, 6, 9", "4, 5"));
  EXPECT_NE(own, changed("that = \"c1\"", "that = \"c1\"\ncertified = true"));
}

}  // namespace
}  // namespace limn::test
