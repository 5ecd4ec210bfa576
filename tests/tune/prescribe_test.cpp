// Prescribed spectra: what comes out has the eigenvalues that were asked for.

#include "limn/tune/prescribe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <fmt/core.h>

#include "limn/spectrum/eigencomponents.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(Prescribe, GivesEachFrequencyItsEigenvalue) {
  std::mt19937 random(7);
  for (int n = 3; n <= 12; ++n) {
    if (n == 6) continue;  // the regular valence
    tune::Prescription wanted{n, "", {}};
    const auto draw = [&] { return fmt::format("{}/100", 20 + random() % 60); };
    wanted.cup = draw();
    for (int i = 0; i < n / 2; ++i) wanted.eigenvalues.push_back(draw());
    for (const std::string base : {"loop", "optimal"}) {
      const Result<tune::Prescribed> text =
          tune::prescribed_scheme(shipped(base), base, "drawn", wanted);
      ASSERT_TRUE(text.ok()) << text.error().text();
      const Scheme scheme = parse_scheme(text->text, "drawn.toml").value();
      const Eigencomponents found =
          approx_eigencomponents(FrequencyAnalysis(scheme).blocks(n).value());
      const auto value = [](const std::string& part) { return std::stod(part) / 100; };
      EXPECT_NEAR(found.cup.value(), value(wanted.cup), 1e-13) << n;
      for (int i = 1; i <= n / 2; ++i)
        EXPECT_NEAR(std::abs(found.spectra[static_cast<std::size_t>(i)].eigenvalues[0].value),
                    value(wanted.eigenvalues[static_cast<std::size_t>(i - 1)]), 1e-13)
            << n << ' ' << i;
    }
  }
}

TEST(Prescribe, LeavesOtherValencesAlone) {
  const auto text =
      tune::prescribed_scheme(shipped("loop"), "loop", "drawn", {7, "1/4", {"1/2", "1/4", "1/8"}});
  const Scheme scheme = parse_scheme(text.value().text, "drawn.toml").value();
  for (const int n : {3, 6, 8}) {
    const auto ours = FrequencyAnalysis(scheme).blocks(n).value();
    const auto loops = FrequencyAnalysis(shipped("loop")).blocks(n).value();
    for (std::size_t i = 0; i < ours.blocks.size(); ++i)
      EXPECT_LT((ours.blocks[i] - loops.blocks[i]).norm(), 1e-14);
  }
}

TEST(Prescribe, MakesTheShippedVariants) {
  for (const auto& [name, values] :
       {std::pair<std::string, std::vector<std::string>>{"loop-7-bounded", {"1/2", "1/4", "1/8"}},
        {"loop-7-shrinking", {"1/4", "1/2", "1/8"}},
        {"loop-7-flat", {"1/2", "1/8", "1/4"}}}) {
    const auto text = tune::prescribed_scheme(shipped("loop"), "loop", "made", {7, "1/4", values});
    const Scheme scheme = parse_scheme(text.value().text, "made.toml").value();
    const auto made = FrequencyAnalysis(scheme).blocks(7).value();
    const auto shipped_blocks = FrequencyAnalysis(shipped(name)).blocks(7).value();
    for (std::size_t i = 0; i < made.blocks.size(); ++i)
      EXPECT_LT((made.blocks[i] - shipped_blocks.blocks[i]).norm(), 1e-14) << name;
  }
}

/// The first ring's eigenvalues are prescribed; those of the second, 1/8 and 1/16, stay.
TEST(Prescribe, StatesOnlyFactsThatHold) {
  const auto text =
      tune::prescribed_scheme(shipped("loop"), "loop", "made", {5, "1/16", {"1/2", "1/16"}});
  ASSERT_EQ(text.value().unmet.size(), 2U);
  EXPECT_NE(text->unmet[0].message.find("the cup is 0.125, not 1/16"), std::string::npos);
  EXPECT_NE(text->unmet[1].message.find("the saddle is 0.125, not 1/16"), std::string::npos);
  EXPECT_NE(text->text.find("tangent = \"1/2\""), std::string::npos);
  EXPECT_EQ(text->text.find("cup"), std::string::npos);
  const auto met =
      tune::prescribed_scheme(shipped("loop"), "loop", "made", {5, "1/4", {"1/2", "1/4"}});
  EXPECT_TRUE(met.value().unmet.empty());
  EXPECT_NE(met->text.find("saddle  = \"1/4\""), std::string::npos);
}

TEST(Prescribe, SaysWhatIsWrong) {
  const auto message = [](const std::string& base, const std::string& name,
                          const tune::Prescription& p) {
    const Result<tune::Prescribed> text = tune::prescribed_scheme(shipped(base), base, name, p);
    EXPECT_FALSE(text.ok());
    return text.ok() ? "" : text.error().text();
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(message("loop", "x", {7, "1/4", {"1/2"}}), "frequencies 1 to 3");
  has(message("loop", "x", {6, "1/4", {"1/2", "1/4", "1/8"}}), "regular");
  has(message("loop", "x", {2, "1/4", {"1/2"}}), "below 3");
  has(message("loop", "x", {4, "1/4", {"1/2", "0.25"}}), "0.25");
  has(message("loop", "x", {4, "1/4", {"1/2", "beta"}}), "n alone");
  has(message("loop", "a b", {4, "1/4", {"1/2", "1/4"}}), "no name");
  has(message("butterfly", "x", {4, "1/4", {"1/2", "1/4"}}), "cannot be prescribed");
  has(message("catmull-clark", "x", {4, "1/4", {"1/2", "1/4"}}), "cannot be prescribed");
}

}  // namespace
}  // namespace limn::test
