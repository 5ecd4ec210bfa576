#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

/// A study whose points take some hundredths of a second each.
const char* const kStudy = R"toml(
title    = "Loop type"
scheme   = "loop-type"
valences = "3..6"
[[free]]
name = "b"
low  = "1/4"
high = "7/16"
[[free]]
name     = "beta"
valences = "3..6"
low      = 0
high     = "3/(5*n)"
[[objective]]
value = "worst_artifact(4)"
goal  = "min"
[[objective]]
value = "holder_lower()"
goal  = "max"
[[require]]
that      = "c1"
certified = true
[method]
kind   = "pareto"
points = 48
batch  = 8
[[compare]]
scheme = "loop"
)toml";

TEST(StudyCommand, KilledAgainAndAgainEndsAsIfItHadNotBeen) {
  const Folder folder;
  folder.write("s.toml", kStudy);
  const Outcome whole = folder.limn("study s.toml -o whole --csv --json");
  ASSERT_EQ(whole.code, 0) << whole.err;
  int killed = 0;
  for (const char* seconds : {"0.31", "0.9", "0.07", "1.3", "0.55"}) {
    const Outcome outcome = folder.shell(std::string("timeout -s KILL ") + seconds +
                                         " \"$LIMN\" study s.toml -o parts --csv --quiet");
    killed += outcome.code == 0 ? 0 : 1;
  }
  EXPECT_GE(killed, 3) << "the study is too quick for this test";
  const Outcome rest = folder.limn("study s.toml -o parts --csv --json --threads 1");
  ASSERT_EQ(rest.code, 0) << rest.err;
  EXPECT_EQ(folder.read("parts/points.csv"), folder.read("whole/points.csv"));
  EXPECT_EQ(folder.read("parts/front.csv"), folder.read("whole/front.csv"));
  EXPECT_EQ(folder.read("parts/best/01.toml"), folder.read("whole/best/01.toml"));
  const nlohmann::json all = nlohmann::json::parse(whole.out);
  const nlohmann::json last = nlohmann::json::parse(rest.out);
  EXPECT_EQ(all.at("evaluated"), all.at("points"));
  EXPECT_LT(last.at("evaluated"), all.at("evaluated"));
  EXPECT_EQ(last.at("points"), all.at("points"));
}

TEST(StudyCommand, WritesSchemesWithCertificatesThatHold) {
  const Folder folder;
  folder.write("s.toml", kStudy);
  const Outcome outcome = folder.limn("study s.toml -o out --json --best 2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("best")[0].at("scheme"), "out/best/01.toml");
  EXPECT_EQ(folder.limn("certify --check out/best/01.certificate.json").code, 0);
  // the command that computes the number by itself finds what the study says
  const Outcome compared = folder.limn("regularity out/best/01.toml --json --time 0");
  ASSERT_EQ(compared.code, 0) << compared.err;
  const double lower = nlohmann::json::parse(compared.out).at("holder").at("lower");
  const double studied = json.at("best")[0].at("objectives")[1];
  EXPECT_LE(studied, lower + 1e-9);  // both are proved; a study looks less closely
  EXPECT_GE(studied, lower - 0.15);
  EXPECT_NE(folder.read("out/front.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(json.at("compare")[0].at("label"), "loop");
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(StudyCommand, FoundSchemesHaveCertificatesOfTheirTexts) {
  const Folder folder;
  int schemes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LIMN_SCHEMES "/../studies/found")) {
    std::filesystem::path path = entry.path();
    if (path.extension() != ".toml") continue;
    ++schemes;
    const std::string text = content_of(path);
    path.replace_extension(".certificate.json");
    const nlohmann::json certificate = nlohmann::json::parse(content_of(path));
    EXPECT_EQ(certificate.at("texts").at(0).at("text"), text) << path;
    const Outcome checked = folder.limn("certify --check '" + path.string() + "' --json");
    ASSERT_EQ(checked.code, 0) << checked.err;
    const nlohmann::json answers = nlohmann::json::parse(checked.out);
    for (const auto& valence : answers.at("valences"))
      EXPECT_EQ(valence.at("c1"), "proved") << path;
  }
  EXPECT_GE(schemes, 5);
}

TEST(StudyCommand, RefusesAChangedStudy) {
  const Folder folder;
  std::string text = kStudy;
  const auto change = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change("points = 48", "points = 8");
  folder.write("s.toml", text);
  ASSERT_EQ(folder.limn("study s.toml -o out").code, 0);
  change("3/(5*n)", "1/(2*n)");
  folder.write("s.toml", text);
  expect_refused(folder.limn("study s.toml -o out"), {"another study", "--restart"});
  EXPECT_EQ(folder.limn("study s.toml -o out --restart").code, 0);
  change("points = 8", "points = 16");  // more of the same
  folder.write("s.toml", text);
  const Outcome more = folder.limn("study s.toml -o out --json");
  ASSERT_EQ(more.code, 0) << more.err;
  EXPECT_EQ(nlohmann::json::parse(more.out).at("evaluated"), 8);
}

TEST(StudyCommand, SaysWhatItCosts) {
  const Folder folder;
  folder.write("s.toml", kStudy);
  const Outcome outcome = folder.limn("study s.toml --dry-run --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("points"), 48);
  EXPECT_EQ(folder.count(), 1) << "nothing is written";
  const Outcome list = folder.limn("study --quantities");
  EXPECT_EQ(list.code, 0);
  EXPECT_NE(list.out.find("holder_lower()"), std::string::npos);
}

TEST(StudyCommand, RefusesBadUse) {
  const Folder folder;
  folder.write("s.toml", kStudy);
  expect_refused(folder.limn("study"), "STUDY.toml is missing");
  expect_refused(folder.limn("study none.toml -o out"), "none.toml");
  expect_refused(folder.limn("study s.toml"), "-o is missing");
  expect_refused(folder.limn("study s.toml -o -"), "standard output");
  expect_refused(folder.limn("study s.toml -o s.toml"), "s.toml");
  folder.write("bad.toml", "scheme = \"loop\"\nx = 1\n");
  expect_refused(folder.limn("study bad.toml -o out"), {"bad.toml:2:1:", "unknown key 'x'"});
}

}  // namespace
}  // namespace limn::test
