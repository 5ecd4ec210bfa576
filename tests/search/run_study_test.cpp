#include "limn/search/run_study.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

#include "limn/base/parallel.h"
#include "limn/search/search.h"
#include "support/temporary_folder.h"
#include "toy.h"

namespace limn::test {
namespace {

std::string study_by(const std::string& method) {
  return "scheme = \"loop-type\"\nvalences = \"3..7\"\n"
         "[[free]]\nname = \"b\"\nlow = \"1/8\"\nhigh = \"1/2\"\nsteps = 5\n"
         "[[free]]\nname = \"beta\"\nvalences = \"3, 5\"\nlow = 0\nhigh = \"1/3\"\nsteps = 3\n"
         "[[objective]]\nvalue = \"artifact(1/4, 0)\"\ngoal = \"min\"\n" +
         std::string(method == "pareto" ? "[[objective]]\nvalue = \"cup_gap()\"\ngoal = \"min\"\n"
                                        : "") +
         "[[require]]\nthat = \"c1\"\n[method]\nkind = \"" + method +
         "\"\npoints = 40\nbatch = 8\n";
}

/// What a run has of its points, times left out.
std::vector<std::string> told(const search::StudyRun& run) {
  std::vector<std::string> lines;
  for (const search::Evaluated& one : run.points) {
    std::string line = std::to_string(one.generation) + " " + std::to_string(one.place) + " " +
                       search::point_key(one.point) + (one.outcome.feasible ? " yes" : " no ") +
                       one.outcome.reason;
    for (const auto& value : one.outcome.objectives) {
      char text[64];
      std::snprintf(text, sizeof text, " %a", value.value_or(-1));
      line += text;
    }
    lines.push_back(line);
  }
  return lines;
}

class Interrupted : public testing::TestWithParam<const char*> {};

TEST_P(Interrupted, EndsAsIfItHadNotBeen) {
  const TemporaryFolder folder;
  const Result<search::Study> study = search::parse_study(study_by(GetParam()), "toy.toml");
  ASSERT_TRUE(study) << study.error().text();
  const auto run = [&](const std::string& name, int most) {
    Result<search::Store> store = search::Store::open((folder.path() / name).string(), *study);
    EXPECT_TRUE(store) << store.error().text();
    std::atomic<int> left = most;
    search::StudyOptions options;
    options.stop = [&left] { return left-- <= 0; };
    Result<search::StudyRun> done = search::run_study(*study, *store, options);
    EXPECT_TRUE(done) << done.error().text();
    return *std::move(done);
  };
  const search::StudyRun whole = run("whole.sqlite", 1000);
  EXPECT_TRUE(whole.finished);
  EXPECT_GE(whole.points.size(), 20U);
  long long evaluated = 0;
  for (const int most : {1, 5, 0, 11, 9}) {
    set_thread_limit(most % 2 + 1);
    const search::StudyRun part = run("parts.sqlite", most);
    EXPECT_FALSE(part.finished);
    EXPECT_LE(part.evaluated, most);
    evaluated += part.evaluated;
  }
  set_thread_limit(0);
  const search::StudyRun rest = run("parts.sqlite", 1000);
  EXPECT_EQ(evaluated + rest.evaluated, whole.evaluated) << "no point twice";
  EXPECT_EQ(told(rest), told(whole));
}
INSTANTIATE_TEST_SUITE_P(Methods, Interrupted,
                         testing::Values("grid", "random", "sobol", "local", "global", "pareto"));

TEST(Search, BeginsAtTheSchemesOwnNumbersExactly) {
  // 3/8 of 1/8 … 1/2 lies at 2/3, which no multiple of a power of 1/2 is.
  for (const char* method : {"local", "global", "pareto"}) {
    const Result<search::Study> study = search::parse_study(study_by(method), "toy.toml");
    ASSERT_TRUE(study) << study.error().text();
    Result<search::Search> search = search::Search::begin(*study);
    ASSERT_TRUE(search) << search.error().text();
    const search::Generation first = search->next();
    ASSERT_FALSE(first.points.empty());
    EXPECT_EQ(first.points[0][0], Rational("3/8")) << method;
    EXPECT_EQ(first.points[0][1], Rational("3/16")) << method;
  }
}

TEST(Store, RefusesAnotherStudyUnlessItMayRestart) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "study.sqlite").string();
  const Result<search::Study> one = search::parse_study(study_by("grid"), "toy.toml");
  const Result<search::Study> other = search::parse_study(study_by("sobol"), "toy.toml");
  {
    Result<search::Store> store = search::Store::open(path, *one);
    ASSERT_TRUE(store);
    ASSERT_TRUE(search::run_study(*one, *store));
    const Result<search::Store> second = search::Store::open(path, *one);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("another limn study is at work"), std::string::npos)
        << second.error().text();
  }
  EXPECT_EQ(search::Store::open(path, *one)->size(), 45U);
  const Result<search::Store> refused = search::Store::open(path, *other);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("--restart"), std::string::npos);
  EXPECT_EQ(search::Store::open(path, *other, true)->size(), 0U);
}

TEST(Store, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "study.sqlite").string();
  {
    std::FILE* file = std::fopen(path.c_str(), "w");
    std::fputs("this is a text of some length, and no data base at all, as one sees at once", file);
    std::fclose(file);
  }
  const Result<search::Study> study = search::parse_study(study_by("grid"), "toy.toml");
  const Result<search::Store> store = search::Store::open(path, *study);
  ASSERT_FALSE(store);
  EXPECT_NE(store.error().text().find("no store of a study"), std::string::npos)
      << store.error().text();
}

TEST(Forecast, MeasuresAFew) {
  const Result<search::Study> study = search::parse_study(study_by("grid"), "toy.toml");
  const Result<search::StudyForecast> forecast = search::forecast_study(*study, 3);
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->points, 45);
  EXPECT_EQ(forecast->measured, 3);
  EXPECT_GT(forecast->seconds_each, 0);
  EXPECT_NEAR(forecast->seconds, 45 * forecast->seconds_each / forecast->threads, 1e-9);
}

}  // namespace
}  // namespace limn::test
