/// What the commands show: names with control characters, help, LaTeX, charts and tables.

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "limn/scheme/scheme.h"
#include "run_command.h"
#include "support/latex_structure.h"

namespace limn::test {
namespace {

const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";

constexpr const char* kRules =
    "split = \"triangle-dyadic\"\n"
    "[vertex]\nself = \"5/8\"\nring = \"3/8/n\"\n[edge]\nend = \"3/8\"\nwing = \"1/8\"\n"
    "[boundary.vertex]\nself = \"3/4\"\nnext = \"1/8\"\n[boundary.edge]\nend = \"1/2\"\n"
    "[parameter.a]\ndefault = 0\nrange = [0, 1]\nmeaning = \"a\\u001b[31m\"\n";

/// A scheme whose name and words would do harm where they are shown raw.
void write_evil(const Folder& folder) {
  folder.write("evil.toml",
               "name = \"evil\\n\\\\input{x}\\u001b[31m\"\ntitle = \"t\\nEVIL\\u001b\"\n"
               "source = \"s\\nEVIL\"\nnotes = \"n\\u0007\"\n" +
                   std::string(kRules));
}

/// Nothing that a terminal obeys, and no line that a name began.
void expect_tame(const std::string& text, const std::string& what) {
  for (const char c : text)
    EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' || c == '\n') << what << ": " << text;
  EXPECT_EQ(text.find("\x7f"), std::string::npos) << what;
  for (const char* begun : {"\n\\input", "\nEVIL"})
    EXPECT_EQ(text.find(begun), std::string::npos) << what << ": " << text;
}

TEST(CommandText, ControlCharactersInNamesAreShownEscaped) {
  const Folder folder;
  write_evil(folder);
  const std::string evil_mesh = "'m\x1b\nEVIL.obj'";
  folder.write(
      "m\x1b\nEVIL.obj", folder.limn("show loop").out.empty() ? "" : [] {
        return std::string(
            "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 4\nf 3 2 1\nf 1 4 3\n"
            "f 2 3 4\n");
      }());
  const std::string jobs[] = {
      "show evil.toml",
      "show evil.toml --latex",
      "eigen evil.toml --valence 5",
      "eigen evil.toml --formulas",
      "eigen evil.toml --formulas --latex",
      "eigen evil.toml --valence 5 --map 'm\x1b.svg' --chart 'c\x1b.svg' --table 't\x1b.tex'",
      "artifacts evil.toml --frequency 0.1,0.1",
      "artifacts evil.toml --tolerance 1 --map 'a\x1b.svg'",
      "regularity evil.toml",
      "compare evil.toml loop --valence 4",
      "refine " + evil_mesh + " -s evil.toml -n 1 -o 'o\x1b\nEVIL.obj'",
      "fairness " + evil_mesh + " -s evil.toml -n 1",
      "draw " + evil_mesh + " -s evil.toml -n 1 -o 'd\x1b\nEVIL.svg'",
      "tune loop --free beta --require 'cup = tangent^2' --valence 5 -o 't\x1b.toml'",
      "prescribe loop --valence 5 --eigenvalues 1/4,1/2,1/4 -o 'p\x1b.toml'",
      "show 'no\x1b\nEVIL.toml'",
      "show 'no\x1b\nEVIL'",
      "'frob\x1b\nEVIL'",
      "show loop -p 'a\x1b\nEVIL=1'",
      "show laplacian-loop -p 'a=1/8\n\\input\x1b'",
      "refine 'none\x1b\nEVIL.obj' -s loop -o x.obj",
      "artifacts loop --frequency '1\x1b\nEVIL,2'",
      "eigen loop --valence '3\x1b\nEVIL'",
      "draw t.obj -s loop --azimuth 'x\x1b\nEVIL' -o x.svg"};
  for (const std::string& job : jobs) {
    const Outcome outcome = folder.limn(job);
    expect_tame(outcome.out, job);
    expect_tame(outcome.err, job);
    EXPECT_FALSE(outcome.out.empty() && outcome.err.empty()) << job;
  }
  for (const char* file : {"m\x1b.svg", "c\x1b.svg", "a\x1b.svg", "t\x1b.tex"})
    expect_tame(folder.read(file), file);
}

TEST(CommandText, JsonKeepsTheNameAsItIs) {
  const Folder folder;
  write_evil(folder);
  const Outcome outcome = folder.limn("show evil.toml --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("name"), "evil\n\\input{x}\x1b[31m");
}

TEST(CommandText, AllFaultsOfASchemeFileAreLines) {
  const Folder folder;
  folder.write("bad.toml",
               "splitt = \"triangle-dyadic\"\n[vertex]\nself = \"1/2\"\n[edge]\nedn = 1\n");
  const Outcome outcome = folder.limn("show bad.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.find("limn: bad.toml:1:1: "), 0U) << outcome.err;
  EXPECT_NE(outcome.err.find("did you mean split?"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("\nlimn: bad.toml:2:1: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("\nlimn: bad.toml:5:1: "), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3);
}

TEST(CommandText, HelpExplainsOutputsAlike) {
  const Folder folder;
  const std::string figure = ".pdf, .svg or .png";
  const auto help = [&](const std::string& command) {
    std::string text = folder.limn(command + " --help").out;
    std::string joined;  // in one line, single blanks
    for (const char c : text)
      if (c != '\n' && (c != ' ' || joined.empty() || joined.back() != ' '))
        joined += c;
      else if (c == '\n' && (joined.empty() || joined.back() != ' '))
        joined += ' ';
    return joined;
  };
  struct Option {
    std::string command, option, text;
  };
  const Option options[] = {
      {"artifacts", "--map FILE", "into FILE (" + figure + ")"},
      {"eigen", "--map FILE", "into FILE (" + figure + ")"},
      {"eigen", "--chart FILE", "into FILE (" + figure + ")"},
      {"eigen", "--table FILE", "to FILE (.csv, .json or .tex)"},
      {"fairness", "--chart FILE", "into FILE (" + figure + ")"},
      {"draw", "--output FILE", "into FILE (" + figure + "; - is standard output)"},
      {"compare", "--output FILE", "into FILE (" + figure + "; - is standard output)"},
      {"refine", "--output FILE", "to FILE (.obj"},
      {"prescribe", "--output FILE", "to FILE (.toml)"},
      {"tune", "--output FILE", "to FILE (.toml)"}};
  for (const Option& option : options) {
    const std::string text = help(option.command);
    const std::size_t at = text.find(option.option);
    ASSERT_NE(at, std::string::npos) << option.command << option.option << "\n" << text;
    EXPECT_LT(text.find(option.text, at), at + 300) << option.command << " " << option.option;
  }
}

TEST(CommandText, InheritedLetsThatNothingUsesAreNotListed) {
  const Folder folder;
  folder.write("base.toml", std::string("let.used = \"1/8\"\nlet.by_used = \"1/2\"\n"
                                        "let.idle = \"by_idle\"\nlet.by_idle = \"1/3\"\n") +
                                kRules);
  folder.write("mine.toml",
               "split = \"triangle-dyadic\"\nextends = \"base.toml\"\nlet.own = \"1/7\"\n"
               "[vertex]\nself = \"1 - used - by_used\"\nring = \"(used + by_used)/n\"\n");
  const Outcome outcome = folder.limn("show mine.toml --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json lets = nlohmann::json::parse(outcome.out).at("lets");
  EXPECT_EQ(lets.size(), 3U) << lets;
  for (const char* name : {"own", "used", "by_used"}) EXPECT_TRUE(lets.contains(name)) << name;
  EXPECT_EQ(folder.limn("show mine.toml").out.find("idle"), std::string::npos);
  // they are there all the same
  EXPECT_EQ(folder.limn("show mine.toml -p a=idle").code, 0);
}

TEST(CommandText, EigenvaluesAsChartTableAndLatex) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("eigen loop --valence 3..20 --chart c.svg --table t.csv --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("valences").size(), 18U);
  EXPECT_EQ(folder.read("c.svg").substr(0, 5), "<?xml");
  const std::string csv = folder.read("t.csv");
  EXPECT_EQ(csv.find("valence,tangent,tangent squared,cup,saddle,largest other,"), 0U) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 19);
  EXPECT_EQ(folder.limn("eigen loop --valence 3..4 --table t.json").code, 0);
  EXPECT_EQ(nlohmann::json::parse(folder.read("t.json")).at("rows").size(), 2U);
  EXPECT_EQ(folder.limn("eigen loop --valence 3..4 --table t.tex").code, 0);
  EXPECT_EQ(latex_fault(folder.read("t.tex")), "");
  expect_refused(folder.limn("eigen loop --chart c.csv"), ".svg");
  expect_refused(folder.limn("eigen loop --table t.pdf"), {"--table", ".tex"});
  expect_refused(folder.limn("eigen loop --formulas --table t.csv"), "--table");
}

}  // namespace
}  // namespace limn::test
