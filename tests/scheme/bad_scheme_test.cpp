/// Every file of tests/data/bad-schemes is refused, at the right place and with a telling message.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "limn/base/files/file.h"
#include "limn/scheme/scheme.h"

namespace limn {
namespace {

struct Fault {
  std::string place, message, hint;
};

/// A file and its faults in the order of their places.
struct Expected {
  std::string file;
  std::vector<Fault> faults;
  friend std::ostream& operator<<(std::ostream& out, const Expected& e) { return out << e.file; }
};

std::filesystem::path folder() { return std::filesystem::path(LIMN_TEST_DATA) / "bad-schemes"; }

std::vector<Expected> expectations() {
  std::vector<Expected> list;
  std::ifstream in(folder() / "expected.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields(1);
    for (std::size_t at = 0; at < line.size(); ++at) {
      if (line.compare(at, 3, " | ") == 0) {
        fields.emplace_back();
        at += 2;
      } else {
        fields.back() += line[at];
      }
    }
    fields.resize(4);
    if (list.empty() || list.back().file != fields[0]) list.push_back({fields[0], {}});
    list.back().faults.push_back({fields[1], fields[2], fields[3]});
  }
  return list;
}

/// As if the file were read from its own folder.
std::string without_folder(std::string text) {
  const std::string prefix = folder().string() + "/";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
    text.erase(at, prefix.size());
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class BadScheme : public testing::TestWithParam<Expected> {};

TEST_P(BadScheme, IsRefusedAtItsPlace) {
  const Expected& expected = GetParam();
  const std::string path = (folder() / expected.file).string();
  const Result<Scheme> scheme = read_scheme(path);
  ASSERT_FALSE(scheme.ok());
  const Error& error = scheme.error();
  EXPECT_EQ(error.file, path);
  const Fault& first = expected.faults.front();
  EXPECT_EQ(std::to_string(error.line) + ":" + std::to_string(error.column), first.place)
      << error.text();
  // a line for each fault, no more
  const std::vector<std::string> lines = lines_of(without_folder(error.text()));
  ASSERT_EQ(lines.size(), expected.faults.size()) << error.text();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Fault& fault = expected.faults[i];
    EXPECT_EQ(lines[i].find(expected.file + ":" + fault.place + ": "), 0U) << lines[i];
    EXPECT_NE(lines[i].find(fault.message), std::string::npos) << lines[i];
    EXPECT_NE(lines[i].find(fault.hint), std::string::npos) << lines[i];
    for (const char c : lines[i]) EXPECT_GE(static_cast<unsigned char>(c), ' ') << lines[i];
  }
  if (lines.size() == 1) EXPECT_NE(error.hint.find(first.hint), std::string::npos) << error.text();
}

/// The same without a file: only the name differs.
TEST_P(BadScheme, IsRefusedAsText) {
  const Expected& expected = GetParam();
  const std::string text = *base::read_file((folder() / expected.file).string());
  const Result<Scheme> scheme = parse_scheme(text, {});
  ASSERT_FALSE(scheme.ok());
  EXPECT_TRUE(scheme.error().file.empty()) << scheme.error().file;
  EXPECT_FALSE(scheme.error().message.empty());
  EXPECT_EQ(std::to_string(scheme.error().line) + ":" + std::to_string(scheme.error().column),
            expected.faults.front().place);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadScheme, testing::ValuesIn(expectations()),
                         [](const testing::TestParamInfo<Expected>& info) {
                           std::string name = info.param.file;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

TEST(BadSchemes, EveryFileHasAnExpectation) {
  std::map<std::string, int> listed;
  for (const Expected& expected : expectations()) ++listed[expected.file];
  EXPECT_GT(listed.size(), 200u);
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const std::string name = entry.path().filename().string();
    if (name != "expected.txt") EXPECT_EQ(listed[name], 1) << name;
  }
  for (const auto& [name, count] : listed) EXPECT_TRUE(std::filesystem::exists(folder() / name));
}

TEST(BadSchemes, ManyFaultsAreBounded) {
  std::string text = "split = \"triangle-dyadic\"\n";
  for (int i = 0; i < 10'000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  const Result<Scheme> scheme = parse_scheme(text, "text.toml");
  ASSERT_FALSE(scheme.ok());
  const std::vector<std::string> lines = lines_of(scheme.error().text());
  ASSERT_EQ(lines.size(), 21U);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(
        lines[static_cast<std::size_t>(i)].find("text.toml:" + std::to_string(i + 2) + ":1: "), 0U);
  EXPECT_EQ(lines.back(), "and 9980 more faults");
}

/// Whatever is wrong together, every place is one of those that are wrong alone: no fault is told
/// for what is only a consequence of another.
RC_GTEST_PROP(BadSchemes, NoFaultFollowsFromAnother, ()) {
  struct Slip {
    std::size_t line;  ///< of the good file, from 0
    std::string text;  ///< in its place
    std::string place;
  };
  const std::vector<std::string> good{"split = \"triangle-dyadic\"",
                                      "[let]",
                                      "b = \"3/8/n\"",
                                      "c = \"1/8\"",
                                      "[parameter.w]",
                                      "default = \"1/16\"",
                                      "range = [\"0\", \"1/8\"]",
                                      "[vertex]",
                                      "self = \"1 - n*b\"",
                                      "ring = \"b\"",
                                      "[edge]",
                                      "end = \"1/2 - c + w\"",
                                      "wing = \"c - w\"",
                                      "[boundary.edge]",
                                      "end = \"1/2\""};
  const std::vector<Slip> slips{{0, "splitt = \"triangle-dyadic\"", "1:1"},
                                {0, "split = \"triangle-dyadc\"", "1:9"},
                                {2, "b = \"3/8/m\"", "3:10"},
                                {2, "b = \"3/8/\"", "3:10"},
                                {3, "c = 0.125", "4:5"},
                                {3, "c = \"c\"", "4:6"},
                                {5, "default = \"1/4\"", "6:11"},
                                {6, "rnge = [\"0\", \"1/8\"]", "7:1"},
                                {9, "rng = \"b\"", "10:1"},
                                {9, "ring = \"b)\"", "10:10"},
                                {12, "wing = \"c - w + 1/8\"", "11:1"},
                                {14, "end = \"1/3\"", "14:1"}};
  std::vector<std::string> lines = good;
  std::set<std::string> made;
  for (const std::size_t i :
       *rc::gen::container<std::set<std::size_t>>(rc::gen::inRange<std::size_t>(0, slips.size()))) {
    if (lines[slips[i].line] != good[slips[i].line]) continue;  // one a line
    lines[slips[i].line] = slips[i].text;
    made.insert(slips[i].place);
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const Result<Scheme> scheme = parse_scheme(text, "f");
  RC_ASSERT(scheme.ok() == made.empty());
  if (made.empty()) return;
  std::set<std::string> told;
  for (const std::string& line : lines_of(scheme.error().text()))
    told.insert(line.substr(2, line.find(": ") - 2));
  for (const std::string& place : told) RC_ASSERT(made.count(place) == 1U);
  // those that need no other part to be judged are always told
  for (const std::string& place : made)
    if (place != "11:1" && place != "14:1" && place != "6:11" && place != "10:1")
      RC_ASSERT(told.count(place) == 1U);
}

Error error_of(const std::string& text) {
  const Result<Scheme> scheme = parse_scheme(text, "text.toml");
  return scheme.ok() ? Error{"no error"} : scheme.error();
}

const std::string kHead = "split = \"triangle-dyadic\"\n";

TEST(BadSchemes, TwoMebibytes) {
  const Error error = error_of(kHead + std::string(2 << 20, '#'));
  EXPECT_EQ(error.text(), "text.toml: the scheme file is larger than 256 KiB");
  EXPECT_EQ(error_of(kHead + std::string(2 << 20, '[')).message, error.message);
}

TEST(BadSchemes, NumberOfAHundredThousandDigits) {
  const Error error = error_of(kHead + "[vertex]\nself = \"" + std::string(100'000, '7') + "\"\n");
  EXPECT_EQ(error.line, 3);
  EXPECT_NE(error.message.find("the expression has more than 4096 bytes"), std::string::npos);
  const Error bare = error_of(kHead + "[vertex]\nself = " + std::string(100'000, '7') + "\n");
  EXPECT_EQ(bare.line, 3);
}

TEST(BadSchemes, DeepNestingOfEveryKind) {
  const std::string deep(100'000, '(');
  EXPECT_EQ(error_of(kHead + "[vertex]\nself = \"" + deep + "\"\n").line, 3);
  for (const char* opening : {"[", "{a=", "[{a=", "[[", "a."}) {
    std::string text = kHead + "x = ";
    if (*opening == 'a') text = kHead;
    for (int i = 0; i < 30'000; ++i) text += opening;
    EXPECT_NE(error_of(text).message, "no error") << opening;
  }
  std::string tables = kHead;  // each within the one before
  for (int i = 0; i < 200; ++i) {
    tables += "[a";
    for (int j = 0; j < i; ++j) tables += ".a";
    tables += "]\n";
  }
  EXPECT_NE(error_of(tables).message, "no error");
}

TEST(BadSchemes, MissingFileAndFolder) {
  const std::string none = (folder() / "none.toml").string();
  const Result<Scheme> missing = read_scheme(none);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().file, none);
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
  const Result<Scheme> directory = read_scheme(folder().string());
  ASSERT_FALSE(directory.ok());
  EXPECT_NE(directory.error().message.find("directory"), std::string::npos);
  EXPECT_FALSE(find_scheme(none).ok());
  EXPECT_FALSE(find_scheme(folder().string()).ok());
}

/// Whatever is cut off or changed, the reader answers; under the sanitizers this is the test
/// that it reads nothing outside the text.
TEST(BadSchemes, EveryPrefixAndEveryChangedByteIsAnswered) {
  const std::string good =
      "split='triangle-dyadic'\n[let]\nb=\"1/8\"\n[roles.edge]\nfar=\"efev\"\n"
      "[edge]\nend=\"1/2-2*b\"\nfar=\"b/n^0\"\n[vertex]\nself=1\n[parameter.w]\n"
      "range=[-1,\"1\"]\ndefault=\"b\"\n";
  EXPECT_EQ(error_of(good).message, "n has no value here, in the edge rule");
  for (std::size_t size = 0; size < good.size(); ++size) {
    const std::string cut(good.data(), size);  // of its own, so that its end is guarded
    const Result<Scheme> scheme = parse_scheme(cut, "cut");
    if (!scheme.ok()) EXPECT_FALSE(scheme.error().message.empty());
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char byte : {'\0', '\n', '9', '"', '\xff'}) {
      std::string changed = good;
      changed[at] = byte;
      const Result<Scheme> scheme = parse_scheme(changed, "changed");
      if (!scheme.ok()) EXPECT_FALSE(scheme.error().message.empty());
    }
  }
}

}  // namespace
}  // namespace limn
