#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

TEST(PapersCommand, MakesAugsdoerfersFiguresAndTables) {
  const Folder folder;
  const Outcome outcome = folder.limn("papers augsdorfer -o ads --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string index = folder.read("ads/index.html");
  for (const char* stem : {"fig01", "fig03", "fig04", "fig05", "fig06", "fig07", "fig08", "fig09",
                           "fig10", "fig11", "fig12"}) {
    EXPECT_NE(index.find(std::string("src=\"") + stem + ".svg\""), std::string::npos) << stem;
    for (const char* extension : {".pdf", ".svg", ".csv", ".json"})
      EXPECT_GT(folder.read("ads/" + std::string(stem) + extension).size(), 100U) << stem;
  }
  for (const char* stem : {"table1", "table2", "table3"})
    for (const char* extension : {".tex", ".csv", ".json"})
      EXPECT_GT(folder.read("ads/" + std::string(stem) + extension).size(), 100U) << stem;
  EXPECT_NE(index.find("Misprints"), std::string::npos);
}

TEST(PapersCommand, MakesBarthesFiguresAndTables) {
  const Folder folder;
  const Outcome outcome = folder.limn("papers barthe -o bgsk --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string index = folder.read("bgsk/index.html");
  for (const char* stem : {"fig01", "fig01-lines", "fig02", "eigenvalues-sqrt3"}) {
    EXPECT_NE(index.find(std::string("src=\"") + stem + ".svg\""), std::string::npos) << stem;
    for (const char* extension : {".pdf", ".svg", ".csv", ".json"})
      EXPECT_GT(folder.read("bgsk/" + std::string(stem) + extension).size(), 50U) << stem;
  }
  // the three variants, as the paper's (4), (5) and (6) print them
  const auto numbers = nlohmann::json::parse(folder.read("bgsk/fig01.json")).at("rows");
  const std::vector<std::vector<double>> printed{{1, 1, .5, .5, .25, .25, .25},
                                                 {2, 1, .25, .25, .25, .5, .5},
                                                 {3, 1, .5, .5, .25, .125, .125}};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < printed[row].size(); ++i)
      EXPECT_NEAR(numbers[row][i], printed[row][i], 1e-13) << row << ' ' << i;
  const auto blocks = nlohmann::json::parse(folder.read("bgsk/sqrt3-blocks.json")).at("rows");
  for (const auto& row : blocks) EXPECT_LT(row[2], 1e-14);
  const auto alphas = nlohmann::json::parse(folder.read("bgsk/sqrt3-alpha.json")).at("rows");
  ASSERT_GE(alphas.size(), 18U);
  for (const auto& row : alphas) EXPECT_NEAR(row[3], 0, 1e-13) << row[0];
  EXPECT_NE(index.find("Misprints"), std::string::npos);
}

TEST(PapersCommand, RefusesUnknownPapersAndFolders) {
  const Folder folder;
  expect_refused(folder.limn("papers nobody -o x"), "augsdorfer");
  expect_refused(folder.limn("papers augsdorfer"), "--output");
  folder.write("file", "x");
  expect_refused(folder.limn("papers augsdorfer -o file/x"), "file/x");
}

}  // namespace
}  // namespace limn::test
