/// The manual page and the shells' completion say what is declared, all of it.

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "run_command.h"

namespace limn::test {
namespace {

/// The commands that `limn --help` lists.
std::vector<std::string> commands(const Folder& folder) {
  const std::string help = folder.limn("--help").out;
  std::vector<std::string> names;
  const std::regex line("\\n  ([a-z]+)  +");
  const std::string list = help.substr(help.find("Subcommands:"));
  for (std::sregex_iterator it(list.begin(), list.end(), line), end; it != end; ++it)
    names.push_back((*it)[1]);
  return names;
}

/// The options that a command's help lists: "--levels", "-n".
std::set<std::string> options(const Folder& folder, const std::string& command) {
  const std::string help = folder.limn(command + " --help").out;
  std::set<std::string> names;
  const std::regex line("\\n  (-[a-z])?,?(--[a-z0-9-]+)?");
  for (std::sregex_iterator it(help.begin(), help.end(), line), end; it != end; ++it)
    for (const int part : {1, 2})
      if ((*it)[part].matched) names.insert((*it)[part]);
  return names;
}

TEST(Manual, HasEveryCommandAndOption) {
  const Folder folder;
  const Outcome man = folder.limn("man");
  ASSERT_EQ(man.code, 0);
  const std::vector<std::string> names = commands(folder);
  ASSERT_GE(names.size(), 12u);
  for (const std::string& command : names) {
    const std::size_t begin = man.out.find("\n.SS " + command + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = man.out.substr(begin, man.out.find("\n.SS ", begin + 1) - begin);
    const std::set<std::string> all = options(folder, command);
    EXPECT_FALSE(all.empty()) << command;
    for (const std::string& option : all)
      EXPECT_NE(section.find("\\fB" + std::regex_replace(option, std::regex("-"), "\\-") + "\\fR"),
                std::string::npos)
          << command << " " << option;
  }
}

TEST(Manual, IsFreeOfWarnings) {
  const Folder folder;
  if (std::system("command -v groff >/dev/null") != 0) GTEST_SKIP() << "no groff";
  const Outcome outcome = folder.shell("\"$LIMN\" man | groff -man -Tutf8 -ww -z");
  EXPECT_EQ(outcome.err, "");
}

TEST(Completion, HasEveryCommandAndOption) {
  const Folder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string text = folder.limn("completion " + shell).out;
    for (const std::string& command : commands(folder)) {
      EXPECT_NE(text.find(command), std::string::npos) << shell << " " << command;
      for (const std::string& option : options(folder, command)) {
        const std::string word = shell != "fish" ? option
                                                 : (option[1] == '-' ? "-l " + option.substr(2)
                                                                     : "-s " + option.substr(1));
        EXPECT_NE(text.find(word), std::string::npos) << shell << " " << command << option;
      }
    }
  }
  expect_refused(folder.limn("completion tcsh"), {"tcsh", "bash"});
}

TEST(Completion, OfBashCompletes) {
  const Folder folder;
  if (std::system("command -v bash >/dev/null") != 0) GTEST_SKIP() << "no bash";
  folder.write("mesh.obj", "");
  folder.write("complete.sh",
               "eval \"$('" LIMN_COMMAND
               "' completion bash)\"\n"
               "COMP_WORDS=(limn \"$@\"); COMP_CWORD=$#; _limn; echo \"${COMPREPLY[@]}\"\n");
  const auto completed = [&](const std::string& words) {
    return folder.shell("bash complete.sh " + words).out;
  };
  EXPECT_EQ(completed("refi"), "refine\n");
  EXPECT_EQ(completed("refine --lev"), "--levels\n");
  EXPECT_EQ(completed("--quiet refine --thr"), "--threads\n");
  EXPECT_EQ(completed("refine mes"), "mesh.obj\n");
  EXPECT_EQ(completed("show doo-s"), "doo-sabin\n");
  EXPECT_EQ(completed("show --lev"), "\n");
  // Values are no commands, and some are of a few words.
  EXPECT_EQ(completed("--threads 4 refi"), "refine\n");
  EXPECT_EQ(completed("--threads = 4 refi"), "refine\n");
  EXPECT_EQ(completed("refine mesh.obj -s doo"), "doo-sabin\n");
  EXPECT_EQ(completed("refine mesh.obj --scheme = doo"), "doo-sabin\n");
  EXPECT_EQ(completed("refine mesh.obj --engine pl"), "plain\n");
  EXPECT_EQ(completed("draw --format sv"), "svg\n");
  EXPECT_EQ(completed("completion z"), "zsh\n");
  EXPECT_EQ(completed("refine catm"), "\n");
}

}  // namespace
}  // namespace limn::test
