#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "run_command.h"

namespace limn::test {
namespace {

using nlohmann::json;

/// The record in a page, read back.
json record_of(const std::string& html) {
  const std::string begin = R"(<script type="application/json" id="record">)";
  const std::size_t at = html.find(begin);
  EXPECT_NE(at, std::string::npos);
  const std::size_t from = at + begin.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from), nullptr, false);
}

TEST(ReportCommand, WritesOneFileWithTheRecordInIt) {
  const Folder folder;
  const Outcome outcome = folder.limn("report loop --valence 3..7 -o loop.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.count(), 1);
  const std::string html = folder.read("loop.html");
  EXPECT_EQ(html.find("<!doctype html>"), 0U) << html.substr(0, 100);
  EXPECT_NE(html.find("Content-Security-Policy"), std::string::npos);
  const json record = record_of(html);
  EXPECT_EQ(record.at("scheme").at("name"), "loop");
  const json& valences = record.at("record").at("valences");
  ASSERT_EQ(valences.size(), 5U);
  const json eigen = json::parse(folder.limn("eigen loop --valence 7 --json").out);
  EXPECT_EQ(valences.at(4).at("components"), eigen.at("valences").at(0).at("components"));
  EXPECT_EQ(record.at("record").at("regularity").at("holder").at("exact"), "3");
  EXPECT_EQ(record.at("show"), json::parse(folder.limn("show loop --json").out));
  EXPECT_FALSE(record.at("facts").empty());
}

TEST(ReportCommand, TheRecordIsPrintedAsJson) {
  const Folder folder;
  const Outcome outcome = folder.limn("report laplacian-loop -p a=1/8 --valence 5 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
  const json record = json::parse(outcome.out);
  EXPECT_EQ(record.at("scheme").at("parameters"), json({{"a", "1/8"}}));
  EXPECT_EQ(record.at("scheme").at("label"), "laplacian-loop a=1/8");
  const json proofs = record.at("certificate");
  if (!proofs.is_null()) {
    const Outcome certify = folder.limn("certify laplacian-loop -p a=1/8 --valence 5 --json");
    EXPECT_EQ(proofs, json::parse(certify.out));
  } else {
    EXPECT_NE(record.at("certificate_reason"), "");
  }
}

TEST(ReportCommand, TextOfASchemeCannotEndTheRecord) {
  const Folder folder;
  folder.write("wild.toml",
               "name = \"wild</script><script>alert(1)</script>\"\nsplit = \"triangle-dyadic\"\n"
               "notes = \"<b>&amp;\"\nvertex = { self = \"5/8\", ring = \"3/(8*n)\" }\n"
               "edge = { end = \"3/8\", wing = \"1/8\" }\n");
  const Outcome outcome = folder.limn("report ./wild.toml --valence 3 --time 1 -o wild.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string html = folder.read("wild.html");
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(record_of(html).at("scheme").at("name"), "wild</script><script>alert(1)</script>");
}

TEST(ReportCommand, RefusesBeforeTheWork) {
  const Folder folder;
  expect_refused(folder.limn("report loop"), "-o is missing");
  expect_refused(folder.limn("report loop -o -  --json"), "standard output");
  expect_refused(folder.limn("report no-such-scheme -o x.html"), "no-such-scheme");
  expect_refused(folder.limn("report loop --valence 2 -o x.html"), "valence");
  expect_refused(folder.limn("report loop -o missing/x.html"), "missing");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace limn::test
