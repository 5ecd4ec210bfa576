/// The outputs of a command are all or none, whatever goes wrong.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

namespace fs = std::filesystem;
const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";
const std::string kRefine = "\"$LIMN\" refine " + kBracket + " -s loop -n 2 -o ";

TEST(Outputs, AreNoneWhereTheReportCannotBePrinted) {
  for (const std::string stream : {">&-", ">/dev/full"}) {
    if (stream == ">/dev/full" && !std::ifstream("/dev/full").good()) continue;
    const Folder folder;
    folder.write("kept.obj", "as it was");
    for (const std::string& job : std::vector<std::string>{
             kRefine + "new.obj", kRefine + "kept.obj --curvatures c.csv", kRefine + "x.ply --json",
             "\"$LIMN\" draw " + kBracket + " -s loop -n 1 -o new.svg",
             "\"$LIMN\" artifacts loop --map m.csv", "\"$LIMN\" eigen loop --map m.svg",
             "\"$LIMN\" prescribe loop --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o mine.toml",
             std::string(
                 "\"$LIMN\" tune sqrt3 --free alpha --require 'cup = tangent^2' --valence 5 "
                 "-o tuned.toml")})
      expect_refused(folder.shell(job + " " + stream), {"standard output"});
    EXPECT_EQ(folder.count(), 1);
    EXPECT_EQ(folder.read("kept.obj"), "as it was");
  }
}

TEST(Outputs, AreNoneWhereOneOfThemCannotBeWritten) {
  const Folder folder;
  fs::create_directory(folder.file("folder.obj"));
  for (const char* bad : {"none/a.obj", "folder.obj", "/proc/self/a.obj"})
    expect_refused(folder.shell(kRefine + bad + " --curvatures c.csv"), {bad, "cannot write"});
  expect_refused(folder.shell(kRefine + "a.obj --curvatures none/c.csv"), {"none/c.csv"});
  expect_refused(folder.limn("fairness " + kBracket +
                             " -s loop -n 1 --chart a.svg --spectrum "
                             "none/b.svg"),
                 {"none/b.svg"});
  EXPECT_EQ(folder.count(), 1);
}

TEST(Outputs, OfTheSameNameAreRefused) {
  const Folder folder;
  fs::create_symlink("a.csv", folder.file("b.csv"));
  fs::create_symlink("x.svg", folder.file("y.svg"));
  expect_refused(
      folder.limn("fairness " + kBracket + " -s loop -n 1 --chart x.svg --spectrum ./y.svg"),
      {"x.svg", "y.svg", "same file"});
  expect_refused(folder.shell(kRefine + "a.csv --format obj --curvatures b.csv"), {"same file"});
}

TEST(Outputs, ReplaceTheInputOnlyIfAsked) {
  const Folder folder;
  fs::copy_file(LIMN_EXAMPLES "/bracket.obj", folder.file("a.obj"));
  fs::create_hard_link(folder.file("a.obj"), folder.file("hard.obj"));
  fs::create_symlink("a.obj", folder.file("soft.obj"));
  fs::permissions(folder.file("a.obj"), fs::perms(0640));
  const std::string before = folder.read("a.obj");
  for (const std::string output : {"soft.obj", "./soft.obj", "a.obj"})
    expect_refused(folder.limn("refine soft.obj -s loop -n 1 -o " + output),
                   {output, "the control mesh itself", "--overwrite"});
  EXPECT_EQ(folder.read("a.obj"), before);
  ASSERT_EQ(folder.limn("refine soft.obj -s loop -n 1 -o soft.obj --overwrite").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder.file("soft.obj")));
  EXPECT_NE(folder.read("a.obj"), folder.read("hard.obj"));  // the old content lives on
  EXPECT_EQ(fs::status(folder.file("a.obj")).permissions(), fs::perms(0640));
  EXPECT_EQ(folder.count(), 3);
}

TEST(Outputs, NeverReplaceASchemeByOneThatExtendsIt) {
  const Folder folder;
  const std::string text = "extends = \"loop\"\n";
  folder.write("mine.toml", text);
  folder.write("further.toml", "extends = \"mine.toml\"\n");
  for (const std::string base : {"mine.toml", "./further.toml"})
    for (const std::string output : {"mine.toml", "./mine.toml"})
      expect_refused(folder.limn("prescribe " + base +
                                 " --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o " + output),
                     {"circular"});
  fs::copy_file(LIMN_SCHEMES "/sqrt3.toml", folder.file("root.toml"));
  const std::string root = folder.read("root.toml");
  expect_refused(folder.limn("tune ./root.toml --free alpha --require 'cup = tangent^2' "
                             "--valence 5 -o ./root.toml"),
                 {"circular"});
  EXPECT_EQ(folder.read("mine.toml"), text);
  EXPECT_EQ(folder.read("root.toml"), root);
}

TEST(Outputs, IntoDevicesAndStandardOutputAreWrittenDirectly) {
  const Folder folder;
  const std::string plain = folder.shell(kRefine + "a.obj && cat a.obj").out;
  const std::string mesh = folder.read("a.obj");
  EXPECT_EQ(folder.shell(kRefine + "/dev/null --format obj").code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Outcome device = folder.shell(kRefine + "/dev/stdout --format obj");
  EXPECT_EQ(device.out, mesh);
  const Outcome appended = folder.shell("{ echo '# first'; " + kRefine +
                                        "/dev/stdout --format obj; echo '# last'; } >all");
  EXPECT_EQ(folder.read("all"), "# first\n" + mesh + "# last\n") << appended.err;
  fs::create_symlink("/dev/stdout", folder.file("link.obj"));
  EXPECT_EQ(folder.shell(kRefine + "link.obj | cat").out, mesh);
  EXPECT_TRUE(fs::is_symlink(folder.file("link.obj")));
}

TEST(Outputs, HaveNamesThatAreNotUtf8) {
  const Folder folder;
  fs::copy_file(LIMN_EXAMPLES "/bracket.obj", folder.file("m\xff.obj"));
  fs::copy_file(LIMN_SCHEMES "/loop.toml", folder.file("s\xff.toml"));
  const std::string mesh = "'m\xff.obj'", scheme = "'./s\xff.toml'";
  for (const std::string& job :
       {"refine " + mesh + " -s " + scheme + " -n 1 -o 'o\xff.obj'",
        "draw " + mesh + " -s " + scheme + " -n 1 -o 'o\xff.svg'",
        "fairness " + mesh + " -s " + scheme + " -n 1", "show " + scheme, "regularity " + scheme,
        "eigen " + scheme + " --valence 5", "artifacts " + scheme + " --frequency 0.1,0",
        "compare loop " + scheme + " --valence 5 --budget 10",
        "artifacts " + scheme + " --map 'o\xff.csv'"}) {
    const Outcome outcome = folder.limn(job + " --json");
    EXPECT_EQ(outcome.code, 0) << job << outcome.err;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << job;  // one object, and UTF-8
  }
  EXPECT_TRUE(fs::exists(folder.file("o\xff.obj")));
  // a scheme file is UTF-8, so that it cannot name such a file
  expect_refused(folder.limn("tune " + scheme +
                             " --free beta --require 'cup = 1/4' --valence 5 "
                             "-o tuned.toml"),
                 {"UTF-8"});
}

TEST(Outputs, OfThePapersAreAFolderOrNone) {
  const Folder folder;
  const std::string papers = "\"$LIMN\" papers barthe -o ";
  folder.write("file", "x");
  expect_refused(folder.shell(papers + "file"), {"file", "folder"});
  EXPECT_EQ(folder.count(), 1);
  fs::create_directory(folder.file("there"));
  folder.write("there/mine", "mine");
  for (const std::string seconds : {"0.3", "1", "2"}) {
    // the folder appears with its index page, which is written last, or not at all
    (void)folder.shell("timeout --signal=TERM " + seconds + " " + papers + "deep/er");
    const bool done = fs::exists(folder.file("deep/er/index.html"));
    EXPECT_EQ(folder.count(), done ? 3 : 2) << seconds;
    (void)folder.shell("timeout --signal=TERM " + seconds + " " + papers + "there");
    const auto files = std::distance(fs::directory_iterator(folder.file("there")), {});
    EXPECT_TRUE(fs::exists(folder.file("there/index.html")) ? files > 1 : files == 1) << files;
    fs::remove_all(folder.file("deep"));
  }
  EXPECT_EQ(folder.read("there/mine"), "mine");
}

}  // namespace
}  // namespace limn::test
