// Drawings of stencils: what stands where.

#include "limn/report/stencil_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "support/shipped.h"

namespace limn::test {
namespace {

std::vector<study::RulePicture> pictures_of(const std::string& name) {
  Result<std::vector<study::RulePicture>> pictures = study::rule_pictures(shipped(name));
  EXPECT_TRUE(pictures.ok()) << name;
  return *std::move(pictures);
}

/// The weight at a place, or "".
std::string at(const study::RulePicture& picture, double x, double y) {
  for (const study::RulePicture::Spot& spot : picture.weights)
    if (std::hypot(spot.at[0] - x, spot.at[1] - y) < 1e-9) return spot.weight;
  return {};
}

TEST(RulePictures, PutWeightsWhereTheyAre) {
  const std::vector<study::RulePicture> loop = pictures_of("loop");
  const study::RulePicture& edge = loop[1];
  ASSERT_EQ(edge.kind, RuleKind::edge);
  const double up = std::sqrt(3) / 2;
  EXPECT_EQ(at(edge, 0, 0), "3/8");
  EXPECT_EQ(at(edge, 1, 0), "3/8");
  EXPECT_EQ(at(edge, 0.5, up), "1/8");
  EXPECT_EQ(at(edge, 0.5, -up), "1/8");
  EXPECT_EQ(edge.weights.size(), 4U);
  EXPECT_EQ(edge.edges.size(), 5U);  // of its two triangles
  EXPECT_NEAR(edge.made[0], 0.5, 1e-12);
  const study::RulePicture& vertex = loop[0];
  EXPECT_EQ(vertex.valence, 6);
  EXPECT_EQ(at(vertex, 0, 0), "5/8");
  EXPECT_EQ(at(vertex, 0.5, up), "1/16");
}

/// Each case once, and every rule's weights add up to 1 where they are fractions.
TEST(RulePictures, ShowEveryCaseOfEveryShippedScheme) {
  for (const std::string& name : shipped_schemes()) {
    SCOPED_TRACE(name);
    std::size_t cases = 0;
    for (const auto& rule : shipped(name).rules)
      if (rule) cases += rule->size();
    const std::vector<study::RulePicture> pictures = pictures_of(name);
    EXPECT_EQ(pictures.size(), cases);
    for (const study::RulePicture& picture : pictures) {
      double sum = 0;
      for (const study::RulePicture::Spot& spot : picture.weights) {
        const std::size_t slash = spot.weight.find('/');
        sum += std::stod(spot.weight) /
               (slash == std::string::npos ? 1 : std::stod(spot.weight.substr(slash + 1)));
      }
      EXPECT_NEAR(sum, 1, 1e-2) << rule_name(picture.kind);
      EXPECT_FALSE(picture.vertices.empty());
    }
    EXPECT_EQ(report::stencils_json(pictures).size(), cases);
    EXPECT_TRUE(report::stencils_figure(name, pictures).check().ok());
  }
}

TEST(StencilText, DrawsInLetters) {
  const std::string text = report::stencils_text({pictures_of("loop")[1]});
  EXPECT_NE(text.find("  edge\n\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    3/8  [ ] 3/8\n"), std::string::npos) << text;
  const std::size_t wing = text.find("1/8");
  EXPECT_NE(text.find("1/8", wing + 1), std::string::npos) << text;
}

}  // namespace
}  // namespace limn::test
