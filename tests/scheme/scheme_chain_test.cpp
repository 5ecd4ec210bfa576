/// Files that extend one another, from a loader in memory and from folders.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <map>

#include "limn/base/files/file.h"
#include "limn/scheme/file/scheme_files.h"
#include "mesh/io/mesh_samples.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

/// Files by name; all in one folder.
using Files = std::map<std::string, std::string>;

SchemeLoader loader_of(const Files& files) {
  return [&files](const std::string& name, const std::string&) -> Result<SchemeText> {
    const auto found = files.find(name);
    if (found == files.end()) return Error{"no such file", {}, name, 0, 0};
    return SchemeText{found->second, name, name};
  };
}

Result<Scheme> read_of(const Files& files, const std::string& name) {
  return parse_scheme(files.at(name), name, loader_of(files));
}

const std::string kRoot =
    "split = \"triangle-dyadic\"\nvertex = { self = 1 }\nedge = { end = \"1/2\" }\n";

TEST(SchemeChain, ThatEndsInNothing) {
  Files files{{"a", "extends = \"\"\n"},
              {"b", "extends = \"a\"\n"},
              {"c", "split = \"triangle-dyadic\"\nextends = \"b\"\n[edge]\nend = \"1/2\"\n"},
              {"d",
               "extends = ''\nsplit = \"triangle-dyadic\"\nvertex = { self = 1 }\n"
               "edge = { end = \"1/2\" }\n"},
              {"e", "extends = \" \"\n"},
              {"f", "extends = []\n"}};
  for (const auto& [name, text] : files) {
    const Result<Scheme> scheme = read_of(files, name);
    ASSERT_FALSE(scheme.ok()) << name;
    EXPECT_GT(scheme.error().line, 0) << name;
    EXPECT_EQ(scheme.error().file, name);
  }
  EXPECT_NE(read_of(files, "c").error().text().find("a:1:11: extends names no scheme"),
            std::string::npos);
}

TEST(SchemeChain, TellsAFaultFarAwayInOneLine) {
  Files files{{"0",
               "split = \"triangle-dyadic\"\nvertex = { self = 1 }\n"
               "edge = { end = \"1/3\" }\n"}};
  for (int i = 1; i <= 20; ++i)
    files[std::to_string(i)] = "extends = \"" + std::to_string(i - 1) + "\"\n";
  const std::string fault = "0:3:8: the edge rule has weights that sum to 2/3, not 1";
  EXPECT_EQ(read_of(files, "1").error().message.find("extends '0': " + fault), 0u)
      << read_of(files, "1").error().message;
  EXPECT_EQ(read_of(files, "2").error().message.find("extends '1', which extends '0': " + fault),
            0u)
      << read_of(files, "2").error().message;
  EXPECT_EQ(
      read_of(files, "5").error().message.find("extends '4' and, by way of others, '0': " + fault),
      0u)
      << read_of(files, "5").error().message;
  EXPECT_EQ(read_of(files, "20").error().message,
            "extends '19' and, by way of others, '11': more than 8 schemes extend one another");
}

/// A file for each number; what each extends: a number, nothing, "" or a file that is not there.
/// Following the numbers by hand says whether a scheme comes out.
RC_GTEST_PROP(SchemeChain, IsReadExactlyWhereItEndsInARootSoonEnough, ()) {
  constexpr int kCount = 12;
  constexpr int kRootFile = -1, kEmpty = -2, kMissing = -3;
  const auto next = *rc::gen::container<std::vector<int>>(kCount, rc::gen::inRange(-3, kCount));
  Files files;
  for (int i = 0; i < kCount; ++i) {
    const int to = next[static_cast<std::size_t>(i)];
    std::string text = kRoot;
    if (to == kEmpty) text = "extends = \"\"\n";
    if (to == kMissing) text = "extends = \"none\"\n";
    if (to >= 0) text = "extends = \"" + std::to_string(to) + "\"\n";
    files[std::to_string(i)] = text;
  }
  for (int i = 0; i < kCount; ++i) {
    int at = i, steps = 0;
    while (at >= 0 && next[static_cast<std::size_t>(at)] >= 0 && steps <= kCount) {
      at = next[static_cast<std::size_t>(at)];
      ++steps;
    }
    const bool ends_well = next[static_cast<std::size_t>(at)] == kRootFile && steps <= 8;
    const Result<Scheme> scheme = read_of(files, std::to_string(i));
    RC_ASSERT(scheme.ok() == ends_well);
    if (!scheme.ok()) RC_ASSERT(!scheme.error().message.empty());
  }
}

class SchemeFolder : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + ("/" + name); }
  std::string write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    EXPECT_TRUE(base::write_file(path(name), text).ok());
    return path(name);
  }
  [[nodiscard]] std::string fault(const std::string& file) const {
    const Result<Scheme> scheme = find_scheme(file);
    return scheme.ok() ? "none" : scheme.error().text();
  }
  test::TemporaryFolder owner_;
  std::string folder_ = owner_ / "x";
};

TEST_F(SchemeFolder, CirclesAreSeenByWhateverNames) {
  const auto circular = [&](const std::string& file) {
    EXPECT_NE(fault(file).find("circular"), std::string::npos) << fault(file);
  };
  circular(write("self.toml", "extends = \"self.toml\"\n"));
  circular(write("dots.toml", "extends = \"./sub/../dots.toml\"\n"));
  circular(write("whole.toml", "extends = \"" + path("whole.toml") + "\"\n"));
  const std::string target = write("target.toml", "extends = \"link.toml\"\n");
  std::filesystem::create_symlink(target, path("link.toml"));
  circular(target);
  write("sub/down.toml", "extends = \"../up.toml\"\n");
  circular(write("up.toml", "extends = \"sub/down.toml\"\n"));
}

TEST_F(SchemeFolder, WhatIsNoFileIsRefused) {
  std::filesystem::create_directories(path("folder.toml"));
  for (const char* name :
       {"folder.toml", ".", "..", "/", "sub/", "folder.toml/", "none.toml", "/dev/null",
        "/dev/zero", "none", "a\\u0000b", "\\u001b[31m.toml", "//"}) {
    const std::string file = write("one.toml", "extends = \"" + std::string(name) + "\"\n");
    const std::string text = fault(file);
    EXPECT_NE(text, "none") << name;
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << name;
    EXPECT_NE(text.find("one.toml:1:11: "), std::string::npos) << text;
  }
  EXPECT_NE(fault(write("long.toml", "extends = \"" + std::string(100'000, 'a') + "\"\n")), "none");
}

TEST_F(SchemeFolder, NamesThatAreNotUtf8) {
  const std::string root = write("r\xff\n.toml", kRoot);
  EXPECT_EQ(fault(root), "none");
  const Result<Scheme> scheme = find_scheme(root);
  ASSERT_TRUE(scheme.ok());
  EXPECT_EQ(scheme->name, "r\xff\n");
  const std::string broken = write("b\xff\n.toml", "splitt = 1\n");
  EXPECT_NE(fault(broken).find("b\\xff\\n.toml:1:1: "), std::string::npos) << fault(broken);
  EXPECT_EQ(fault(broken).find('\n'), std::string::npos);
}

TEST(SetParameters, EachOnce) {
  Scheme scheme = find_scheme("butterfly").value();
  const Status twice = set_parameters(scheme, {"w=1/20", " w = 1/20"});
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().message.find("'w' is set twice"), std::string::npos);
  EXPECT_EQ(scheme.parameters.front().value.expression.text(),
            find_scheme("butterfly")->parameters.front().value.expression.text());
}

TEST(SchemeChain, FromItsOwnTextsAlone) {
  const Files files{{"root", kRoot},
                    {"middle", "extends = \"root\"\n"},
                    {"leaf", "extends = \"middle\"\ntitle = \"leaf\"\n"}};
  const Result<Scheme> read = read_of(files, "leaf");
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->texts.size(), 3U);
  const Result<Scheme> again = parse_texts(read->texts);
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(again->title, "leaf");
  EXPECT_EQ(again->name, read->name);
  std::vector<SourceText> texts = read->texts;
  texts.pop_back();
  EXPECT_FALSE(parse_texts(texts).ok());
  texts = read->texts;
  texts.push_back(texts.back());
  EXPECT_FALSE(parse_texts(texts).ok());
  EXPECT_FALSE(parse_texts({}).ok());
}

}  // namespace
}  // namespace limn
