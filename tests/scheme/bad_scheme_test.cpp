/// Every file of tests/data/bad-schemes is refused, at the right place and with a telling message.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "limn/base/file.h"
#include "limn/scheme/scheme.h"

namespace limn {
namespace {

struct Expected {
  std::string file, place, message, hint;
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
    list.push_back({fields[0], fields[1], fields[2], fields[3]});
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

class BadScheme : public testing::TestWithParam<Expected> {};

TEST_P(BadScheme, IsRefusedAtItsPlace) {
  const Expected& expected = GetParam();
  const std::string path = (folder() / expected.file).string();
  const Result<Scheme> scheme = read_scheme(path);
  ASSERT_FALSE(scheme.ok());
  const Error& error = scheme.error();
  EXPECT_EQ(error.file, path);
  EXPECT_EQ(std::to_string(error.line) + ":" + std::to_string(error.column), expected.place)
      << error.text();
  EXPECT_NE(without_folder(error.message).find(expected.message), std::string::npos)
      << error.text();
  EXPECT_NE(error.hint.find(expected.hint), std::string::npos) << error.text();
  for (const char c : error.text()) EXPECT_GE(static_cast<unsigned char>(c), ' ') << error.text();
}

/// The same without a file: only the name differs.
TEST_P(BadScheme, IsRefusedAsText) {
  const Expected& expected = GetParam();
  const std::string text = *read_file((folder() / expected.file).string());
  const Result<Scheme> scheme = parse_scheme(text, {});
  ASSERT_FALSE(scheme.ok());
  EXPECT_TRUE(scheme.error().file.empty()) << scheme.error().file;
  EXPECT_FALSE(scheme.error().message.empty());
  EXPECT_EQ(std::to_string(scheme.error().line) + ":" + std::to_string(scheme.error().column),
            expected.place);
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

Error error_of(const std::string& text) {
  const Result<Scheme> scheme = parse_scheme(text, "text.toml");
  return scheme.ok() ? Error{"no error", {}, {}, 0, 0} : scheme.error();
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
