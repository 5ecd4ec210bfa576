#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "run_command.h"

namespace limn::test {
namespace {

/// The cells of each line of a CSV file, quotes taken off (RFC 4180).
std::vector<std::vector<std::string>> csv_cells(const std::string& text) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      lines.back().emplace_back();
    } else if (c == '\n' && !quoted) {
      lines.push_back({""});
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();  // what follows the last line break
  return lines;
}

/// Every file of a paper's folder: not empty, no other's twin; tables rectangular and described.
void expect_files_of_use(const Folder& folder, const std::string& name) {
  std::map<std::string, std::string> seen;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() + "/" + name)) {
    const std::string file = name + "/" + entry.path().filename().string();
    const std::string text = folder.read(file);
    EXPECT_FALSE(text.empty()) << file;
    const auto [other, fresh] = seen.emplace(text, file);
    EXPECT_TRUE(fresh) << file << " is the twin of " << other->second;
    if (file.ends_with(".csv")) {
      const auto lines = csv_cells(text);
      ASSERT_GE(lines.size(), 2U) << file;
      for (const std::string& head : lines.front()) {
        EXPECT_NE(head.find(": "), std::string::npos) << file << ' ' << head;
        EXPECT_GT(head.size(), head.find(": ") + 3) << file << ' ' << head;
      }
      for (const auto& line : lines) EXPECT_EQ(line.size(), lines.front().size()) << file;
    }
    if (file.ends_with(".json")) {
      const auto table = nlohmann::json::parse(text);
      EXPECT_FALSE(table.at("rows").empty()) << file;
      EXPECT_EQ(table.at("columns").size(), table.at("meanings").size()) << file;
      for (const auto& row : table.at("rows"))
        EXPECT_EQ(row.size(), table.at("columns").size()) << file;
    }
  }
}

/// The verdict on the claim whose text holds `words`.
std::string verdict_on(const Folder& folder, const std::string& name, const std::string& words) {
  const auto table = nlohmann::json::parse(folder.read(name + "/claims.json"));
  for (const auto& row : table.at("rows"))
    if (row.at(1).get<std::string>().find(words) != std::string::npos)
      return row.at(2).get<std::string>();
  return "no such claim";
}

TEST(PapersCommand, MakesAugsdoerfersFiguresAndTables) {
  const Folder folder;
  const Outcome outcome = folder.limn("papers augsdorfer -o ads --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string index = folder.read("ads/index.html");
  for (const char* stem : {"fig01", "fig02", "fig03", "fig04", "fig05", "fig06", "fig07", "fig08",
                           "fig09", "fig10", "fig11", "fig12"}) {
    EXPECT_NE(index.find(std::string("src=\"") + stem + ".svg\""), std::string::npos) << stem;
    for (const char* extension : {".pdf", ".svg", ".csv", ".json"})
      EXPECT_GT(folder.read("ads/" + std::string(stem) + extension).size(), 100U) << stem;
  }
  for (const char* stem : {"table1", "table2", "table3"})
    for (const char* extension : {".tex", ".csv", ".json"})
      EXPECT_GT(folder.read("ads/" + std::string(stem) + extension).size(), 100U) << stem;
  EXPECT_NE(index.find("Misprints"), std::string::npos);
  expect_files_of_use(folder, "ads");
  // [ADS Table 1, 2] at θ = (0, π·0.55·√3/2, …): c1 = 1, c2 = c3 = c
  const double c = std::cos(std::numbers::pi * 0.55 * std::sqrt(3.0) / 2);
  const double loop = (2 - 2 * c) * (2 - 2 * c) * (4 - 2 * c) / 96 /
                      ((2 + 2 * c) * (2 + 2 * c) * (4 + 2 * c) / 96) * 100 / std::sqrt(3.0);
  const double butterfly =
      (2 + c) * (1 - c) * (1 - c) / ((2 - c) * (1 + c) * (1 + c)) * 100 / std::sqrt(3.0);
  EXPECT_NEAR(loop, 39.8, 0.05);
  EXPECT_NEAR(butterfly, 46.2, 0.05);
  for (const double percent : {loop, butterfly}) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1f %%", percent);
    EXPECT_NE(index.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(verdict_on(folder, "ads", "far more tolerant"), "refined");
  EXPECT_EQ(verdict_on(folder, "ads", "no artifacts Y2, Y3"), "confirmed");
  EXPECT_EQ(verdict_on(folder, "ads", "every further step"), "refined");
  // [ADS (19), (20)] K's rows sum to 10 − 6 = 4, and N N = 4 I: NKN/4 takes a constant to 4
  EXPECT_NE(index.find("else the signal of a constant is 4"), std::string::npos);
  // Σ X = 0
  const auto vectors = nlohmann::json::parse(folder.read("ads/fig02.json")).at("rows");
  double x = 0, y = 0;
  for (int k = 0; k < 3; ++k) {
    x += vectors.at(static_cast<std::size_t>(k)).at(2).get<double>();
    y += vectors.at(static_cast<std::size_t>(k)).at(3).get<double>();
  }
  EXPECT_NEAR(std::hypot(x, y), 0, 1e-15);
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
  EXPECT_NE(index.find("(i = 1, 2, 3)"), std::string::npos);
  expect_files_of_use(folder, "bgsk");
  EXPECT_EQ(verdict_on(folder, "bgsk", "a bare list"), "confirmed");
  EXPECT_EQ(verdict_on(folder, "bgsk", "are the dominant eigenvalues"), "refined");
  EXPECT_EQ(verdict_on(folder, "bgsk", "cup configuration"), "refined");  // at v = 3 it does not
}

/// Column `name` of a table of numbers that a paper's folder holds.
std::vector<double> column(const Folder& folder, const std::string& path, const std::string& name) {
  const auto table = nlohmann::json::parse(folder.read(path));
  const auto& columns = table.at("columns");
  const auto at =
      static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
  std::vector<double> values;
  for (const auto& row : table.at("rows")) values.push_back(row.at(at));
  return values;
}

TEST(PapersCommand, MakesKawaharadasFiguresAndJudgesItsClaims) {
  const Folder folder;
  const Outcome outcome = folder.limn("papers kawaharada -o ks --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string index = folder.read("ks/index.html");
  for (const char* stem :
       {"fig01", "fig02-05", "fig16", "fig17-22", "fig35", "fig06-09", "fig10-13", "fig14", "fig15",
        "fig23-26", "fig27-28", "fig29-32", "fig33-34", "fig36", "fig37-40", "fig41-45", "fig46"}) {
    EXPECT_NE(index.find(std::string("src=\"") + stem + ".svg\""), std::string::npos) << stem;
    for (const char* extension : {".pdf", ".svg", ".csv", ".json"})
      EXPECT_GT(folder.read("ks/" + std::string(stem) + extension).size(), 50U) << stem;
  }
  for (const char* mesh : {"torus", "cube", "raised"})
    EXPECT_EQ(folder.limn(std::string("refine ks/") + mesh + ".obj -s loop -n 1 -o fine.obj").code,
              0);

  // [KS Fig. 21] the stencil, reconstructed: 1/384 of the mask's numbers
  EXPECT_EQ(column(folder, "ks/stencils.json", "b_1_8"),
            (std::vector<double>{182 / 384., 46 / 384., -19 / 384., 2 / 384.}));
  // the tops of basis functions: interpolating schemes keep 1, Loop has its limit stencil's 1/2
  for (const double top : column(folder, "ks/fig23-26.json", "highest")) EXPECT_NEAR(top, 1, 1e-12);
  EXPECT_NEAR(column(folder, "ks/fig37-40.json", "highest").at(3), 1 / 2., 1e-12);
  // the low pass shrinks, the high pass does not
  for (const char* figure : {"ks/fig06-09.json", "ks/fig10-13.json"}) {
    const std::vector<double> volumes = column(folder, figure, "volume");
    EXPECT_LT(volumes.at(2), volumes.at(0));
    EXPECT_GT(volumes.at(1), volumes.at(0));
  }
  // −μ1 − μ1² < a < μ1 − μ1², from the whole neighbourhood
  const auto low = column(folder, "ks/range.json", "low"),
             high = column(folder, "ks/range.json", "high");
  ASSERT_EQ(low.size(), 18U);
  for (std::size_t i = 0; i < low.size(); ++i) {
    const double tangent = 3 / 8. + std::cos(2 * std::numbers::pi / static_cast<double>(i + 3)) / 4;
    EXPECT_NEAR(low[i], -tangent - tangent * tangent, 1e-12);
    EXPECT_NEAR(high[i], tangent - tangent * tangent, 1e-12);
  }
  // Hölder exponents on the regular lattice [theory]; in the order of the page
  const auto least = column(folder, "ks/smoothness.json", "holder_lower");
  const auto most = column(folder, "ks/smoothness.json", "holder_upper");
  const std::vector<double> exponents{3, 1.411, 1.7725, 2, 1.2195, 1.09, 1, 1.846, 1.5805, 1.8655};
  ASSERT_EQ(least.size(), exponents.size());
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    EXPECT_LT(least[i], exponents[i] + 0.015) << i;
    EXPECT_GT(most[i], exponents[i] - 0.015) << i;
    EXPECT_LT(most[i] - least[i], 0.05) << i;
  }
  for (const char* words : {"5 eigenvalues are equal, with a Jordan block of size 2",
                            "contradicted at k = 4", "to an affine image of it"})
    EXPECT_NE(index.find(words), std::string::npos) << words;
  EXPECT_NE(index.find("Misprints"), std::string::npos);
  expect_files_of_use(folder, "ks");
  EXPECT_EQ(verdict_on(folder, "ks", "no concrete gain"), "confirmed");
  EXPECT_EQ(verdict_on(folder, "ks", "regular k-gon where k is odd"), "contradicted");
  EXPECT_EQ(verdict_on(folder, "ks", "0 ≤ á ≤ 1"), "supported");
  // what a word leaves open, and what the eigenvalues leave open at k = 3
  EXPECT_EQ(verdict_on(folder, "ks", "generate good surfaces"), "depends on the measure");
  EXPECT_EQ(verdict_on(folder, "ks", "optimal schemes are C1"), "refined");
  EXPECT_EQ(index.find("without bound"), std::string::npos);
  for (const double k : column(folder, "ks/fairness-valences.json", "k"))
    EXPECT_TRUE(k >= 3 && k <= 10) << k;
  for (const double most : column(folder, "ks/range-low.json", "high")) EXPECT_EQ(most, 1);
}

TEST(PapersCommand, RefusesUnknownPapersAndFolders) {
  const Folder folder;
  expect_refused(folder.limn("papers nobody -o x"), "augsdorfer");
  expect_refused(folder.limn("papers augsdorfer"), "--output");
  folder.write("file", "x");
  // named is what stands in the way
  expect_refused(folder.limn("papers augsdorfer -o file/x"), "file: cannot make the folder");
}

}  // namespace
}  // namespace limn::test
