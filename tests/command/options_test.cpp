/// Options that several commands share: SCHEME with parameters, numbers, levels.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "limn/scheme/scheme.h"
#include "run_command.h"

namespace limn::test {
namespace {

const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";

/// The command line of every command that takes a SCHEME, `%` in its place.
const std::vector<std::string>& commands() {
  static const std::vector<std::string> list{
      "show %",
      "eigen % --valence 5",
      "eigen % --formulas",
      "artifacts % --frequency 0.1,0.2",
      "regularity % --budget 20",
      "compare % loop --valence 5 --budget 20",
      "refine " + kBracket + " -s % -n 1 -o out.obj",
      "draw " + kBracket + " -s % -n 1 -o out.svg",
      "fairness " + kBracket + " -s % -n 1",
      "tune % --free beta --require 'cup = tangent^2' --valence 5"};
  return list;
}

std::string with(const std::string& command, const std::string& scheme) {
  std::string line = command;
  return line.replace(line.find('%'), 1, scheme);
}

TEST(Options, ParametersAfterAColonOrByOptionInEveryCommand) {
  const Folder folder;
  for (const std::string& command : commands()) {
    const Outcome plain = folder.limn(with(command, "laplacian-loop"));
    const Outcome colon = folder.limn(with(command, "laplacian-loop:a=1/16"));
    ASSERT_EQ(colon.code, plain.code) << command << colon.err;
    if (plain.code != 0) continue;  // built without what it needs
    EXPECT_EQ(folder.limn(with(command, "laplacian-loop:a=2")).code, 2) << command;
    // compare's -p is for all of its schemes, and loop has none
    if (command.starts_with("compare")) continue;
    const Outcome option = folder.limn(with(command, "laplacian-loop") + " -p a=1/16");
    EXPECT_EQ(option.code, 0) << command << option.err;
    if (!command.starts_with("refine") && !command.starts_with("draw"))
      EXPECT_NE(colon.out, plain.out) << command;
  }
}

TEST(Options, BothFormsMeanTheSame) {
  const Folder folder;
  for (const std::string command : {"show % --json", "eigen % --valence 5 --json",
                                    "eigen % --formulas", "regularity % --json --budget 20"}) {
    const Outcome colon = folder.limn(with(command, "laplacian-loop:a=1/16"));
    const Outcome option = folder.limn(with(command, "laplacian-loop") + " -p a=1/16");
    EXPECT_EQ(colon.out, option.out) << command;
    EXPECT_EQ(colon.code, option.code) << command;
  }
}

TEST(Options, AParameterHasOneValue) {
  const Folder folder;
  for (const std::string& command : commands())
    for (const char* twice : {"laplacian-loop:a=1/8,a=1/16", "laplacian-loop:a=1/8 -p a=1/8",
                              "laplacian-loop -p a=1/8 -p a=1/16"})
      expect_refused(folder.limn(with(command, twice)), {"'a' is set twice"});
  EXPECT_EQ(folder.count(), 0);
}

TEST(Options, PrescribeKeepsTheParametersThatAreSet) {
  const Folder folder;
  folder.write(
      "base.toml",
      "split = \"triangle-dyadic\"\n[parameter.w]\ndefault = \"1/8\"\nrange = [0, 1]\n"
      "[vertex]\nself = \"5/8\"\nring = \"3/8/n\"\n[edge]\nend = \"1/2 - w\"\nwing = \"w\"\n");
  for (const char* scheme : {"base.toml:w=1/16", "base.toml -p w=1/16"}) {
    const Outcome made = folder.limn("prescribe " + std::string(scheme) +
                                     " --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o mine.toml");
    ASSERT_EQ(made.code, 0) << made.err;
    const Result<Scheme> mine = find_scheme(folder.file("mine.toml"));
    ASSERT_TRUE(mine.ok()) << mine.error().text();
    EXPECT_EQ(mine->parameters.at(0).value.expression.text(), "1/16");
  }
}

TEST(Options, WhatIsNotWrittenIsNotCited) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("prescribe loop --valence 7 --eigenvalues 1/4,'1/(n-7)',1/4,1/8 -o mine.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("division by zero"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("mine.toml:"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
}

TEST(Options, NoNumberIsNanOrInfinite) {
  const Folder folder;
  const std::string jobs[] = {"draw " + kBracket + " -s loop -o x.svg --azimuth %",
                              "draw " + kBracket + " -s loop -o x.svg --elevation %",
                              "draw " + kBracket + " -s loop -o x.svg --lights %",
                              "draw " + kBracket + " -s loop -o x.svg -n %",
                              "compare loop sqrt3 --tolerance %",
                              "compare loop sqrt3 --budget %",
                              "compare loop sqrt3 --mesh " + kBracket + " --azimuth % -o x.svg",
                              "compare loop sqrt3 --mesh " + kBracket + " -n %",
                              "artifacts loop --tolerance %",
                              "artifacts loop --frequency %,0",
                              "artifacts loop --frequency 0,%",
                              "artifacts loop --steps % --frequency 0.1,0",
                              "artifacts loop --stages % --frequency 0.1,0",
                              "regularity loop --tolerance %",
                              "regularity loop --budget %",
                              "regularity loop --time %",
                              "compare loop sqrt3 --time %",
                              "tune loop --free beta --require 'cup = 1/4' --time %",
                              "eigen loop --rings %",
                              "eigen loop --valence %",
                              "fairness " + kBracket + " -s loop -n %",
                              "fairness " + kBracket + " -s loop --spectrum %",
                              "prescribe loop --valence % --eigenvalues 1/4,1/2 -o x.toml",
                              "tune loop --free beta --require 'cup = 1/4' --between 0,%",
                              "show laplacian-loop -p a=%",
                              "refine " + kBracket + " -s loop -o x.obj -n %",
                              "--threads % schemes"};
  for (const std::string& job : jobs)
    for (const char* value : {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999", "'nan(1)'"})
      EXPECT_EQ(folder.limn(with(job, value)).code, 2) << with(job, value);
  EXPECT_EQ(folder.count(), 0);
}

TEST(Options, LevelsOutOfReachAreRefusedInEveryCommand) {
  const Folder folder;
  for (const char* levels : {"64", "40", "30"})
    for (const std::string& job :
         {"compare loop sqrt3 --mesh " + kBracket, "fairness " + kBracket + " -s loop",
          "draw " + kBracket + " -s loop -o x.svg", "refine " + kBracket + " -s loop -o x.obj"}) {
      const Outcome outcome = folder.limn(job + " -n " + levels);
      EXPECT_EQ(outcome.code, 2) << job;
      EXPECT_NE(outcome.err.find("levels"), std::string::npos) << job << outcome.err;
    }
  EXPECT_EQ(folder.count(), 0);
}

TEST(Options, NearWordsAreSuggested) {
  const Folder folder;
  const auto suggests = [&](const std::string& job, const std::string& word) {
    expect_refused(folder.limn(job), {"did you mean " + word});
  };
  suggests("show butterly", "butterfly");
  suggests("show laplacian-butterfly -p bb=1/8", "b?");
  suggests("tune sqrt3 --free alhpa --require 'cup = tangent^2'", "alpha?");
  suggests("tune sqrt3 --free alpha --require 'cpu = tangent^2'", "cup?");
  suggests("papers bathe -o x", "barthe?");
  suggests("refnie", "refine?");
}

}  // namespace
}  // namespace limn::test
