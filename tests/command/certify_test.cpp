#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "run_command.h"
#include "support/latex_structure.h"

namespace limn::test {
namespace {

TEST(CertifyCommand, GivesTheContractsJson) {
  const Folder folder;
  const Outcome outcome = folder.limn("certify loop --valence 5..7 --json -o loop.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("scheme"), "loop");
  EXPECT_EQ(json.at("regular").at("c1"), "proved");
  ASSERT_EQ(json.at("valences").size(), 3);
  const nlohmann::json& seven = json.at("valences")[2];
  EXPECT_EQ(seven.at("valence"), 7);
  EXPECT_EQ(seven.at("c1"), "proved");
  EXPECT_EQ(seven.at("curvature"), "unbounded");
  EXPECT_EQ(seven.at("bits"), 128);
  EXPECT_TRUE(seven.at("reason").is_string());
  const Outcome checked = folder.limn("certify --check loop.json --json");
  ASSERT_EQ(checked.code, 0) << checked.err;
  EXPECT_EQ(nlohmann::json::parse(checked.out).at("verified"), true);
  EXPECT_EQ(nlohmann::json::parse(checked.out).at("text_is_shipped"), true);
}

TEST(CertifyCommand, ExitsByWhatIsDecided) {
  const Folder folder;
  EXPECT_EQ(folder.limn("certify optimal --valence 3").code, 3);
  EXPECT_EQ(folder.limn("certify optimal --valence 4").code, 0);
  const Outcome refuted = folder.limn("certify butterfly --valence 8");
  EXPECT_EQ(refuted.code, 0);
  EXPECT_NE(refuted.out.find("refuted"), std::string::npos);
}

TEST(CertifyCommand, RefusesWhatIsWrong) {
  const Folder folder;
  expect_refused(folder.limn("certify"), "SCHEME");
  expect_refused(folder.limn("certify loop --valence 2"), "2");
  expect_refused(folder.limn("certify box-spline-quad --valence 5"), "rule");
  expect_refused(folder.limn("certify --check nothing.json"), "nothing.json");
  folder.write("none.json", "{\"format\": 1}");
  expect_refused(folder.limn("certify --check none.json"), "none.json");
  ASSERT_EQ(folder.limn("certify loop --valence 4 -o four.json").code, 0);
  std::string text = folder.read("four.json");
  const std::size_t at = text.find("\"eigenvalue\": 0.375");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 19, "\"eigenvalue\": 0.376");
  folder.write("other.json", text);
  expect_refused(folder.limn("certify --check other.json"), "valence 4");
}

TEST(CertifyCommand, ProvesEveryValence) {
  const Folder folder;
  const Outcome outcome = folder.limn("certify loop --all --json -o all.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json all = nlohmann::json::parse(outcome.out).at("all");
  EXPECT_EQ(all.at("from"), 3);
  EXPECT_EQ(all.at("c1"), "proved");
  EXPECT_EQ(all.at("exceptions"), nlohmann::json::array());
  EXPECT_EQ(folder.limn("certify --check all.json").code, 0);
  const Outcome seven = folder.limn("certify loop-7-shrinking --all");
  EXPECT_NE(seven.out.find("n ≥ 3 except 7 (refuted)"), std::string::npos) << seven.out;
}

TEST(CertifyCommand, PrintsAProof) {
  const Folder folder;
  const Outcome proof = folder.limn("certify butterfly --valence 7..8 --latex");
  ASSERT_EQ(proof.code, 0) << proof.err;
  EXPECT_EQ(latex_fault(proof.out), "") << proof.out;
  EXPECT_NE(proof.out.find("8 & refuted & 2 & 0.469"), std::string::npos) << proof.out;
  expect_refused(folder.limn("certify loop --latex --json"), "--json");
}

TEST(CertifyCommand, GoesOnFromACertificate) {
  const Folder folder;
  ASSERT_EQ(folder.limn("certify loop --valence 4..5 -o some.json").code, 0);
  const Outcome more = folder.limn("certify loop --valence 4..6 --resume some.json -o more.json");
  ASSERT_EQ(more.code, 0) << more.err;
  EXPECT_EQ(folder.limn("certify --check more.json").code, 0);
  expect_refused(folder.limn("certify butterfly --valence 4 --resume some.json"), "another scheme");
}

TEST(CertifyCommand, LeavesCurvatureUndecidedWhereC1AloneIsAskedFor) {
  const Folder folder;
  const Outcome outcome = folder.limn("certify loop --valence 5 --c1-only --json -o five.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto valence = nlohmann::json::parse(outcome.out).at("valences").at(0);
  EXPECT_EQ(valence.at("c1"), "proved");
  EXPECT_EQ(valence.at("curvature"), "undecided");
  EXPECT_EQ(folder.limn("certify --check five.json").code, 0);
  // what was left is looked for by another run
  const Outcome rest = folder.limn("certify loop --valence 5 --json --resume five.json");
  EXPECT_EQ(nlohmann::json::parse(rest.out).at("valences").at(0).at("curvature"), "bounded");
}

TEST(CertifyCommand, KnowsSchemesThatExtendOthersAndTheirParameters) {
  const Folder folder;
  folder.write("mine.toml",
               "name = \"mine\"\nsplit = \"triangle-dyadic\"\nextends = \"base.toml\"\n"
               "[let]\nbeta = \"3/(8*n)\"\n");
  folder.write("base.toml", "name = \"base\"\nsplit = \"triangle-dyadic\"\nextends = \"loop\"\n");
  ASSERT_EQ(folder.limn("certify mine.toml --valence 5 -o mine.json").code, 0);
  folder.write("base.toml", "broken");  // the certificate has its text
  EXPECT_EQ(folder.limn("certify --check mine.json").code, 0);
  ASSERT_EQ(folder.limn("certify laplacian-loop:a=1/16 --valence 6 -o a.json").code, 0);
  EXPECT_EQ(folder.limn("certify --check a.json").code, 0);
}

}  // namespace
}  // namespace limn::test
