// A written scheme file, read back and analysed anew.

#include "limn/report/tuned_scheme.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shipped.h"

namespace limn::test {
namespace {

struct Tuned {
  std::vector<ValenceSolutions> solutions;
  Result<std::string> text;
};

Tuned tuned(const std::string& name, const std::string& free, const std::string& text, int first,
            int last) {
  FreedScheme freed = FreedScheme::make(shipped(name), free).value();
  const Requirement requirement = Requirement::parse(text, shipped(name)).value();
  std::vector<ValenceSolutions> all;
  for (int n = first; n <= last; ++n) all.push_back(solve_at(freed, requirement, n).value());
  Result<std::string> file = report::tuned_scheme_text(freed, requirement, all, name);
  return {std::move(all), std::move(file)};
}

Eigencomponents at(const Scheme& scheme, int n) {
  return approx_eigencomponents(FrequencyAnalysis(scheme).blocks(n).value());
}

TEST(TunedScheme, SolvesItsRequirementWhenItIsRead) {
  for (const auto& [name, free] : {std::pair("sqrt3", "alpha"), {"loop", "beta"}}) {
    const Tuned file = tuned(name, free, "cup = 3*tangent^2/4", 5, 9);
    const Result<Scheme> back = parse_scheme(file.text.value(), "tuned.toml");
    ASSERT_TRUE(back.ok()) << back.error().text();
    for (int n = 5; n <= 9; ++n) {
      const Eigencomponents found = at(*back, n);
      const double part = n == 6 ? 1 : 0.75;  // the regular valence keeps its value
      EXPECT_NEAR(*found.cup, part * *found.tangent * *found.tangent, 1e-14) << name << ' ' << n;
    }
    EXPECT_NEAR(*at(*back, 12).cup, *at(shipped(name), 12).cup, 1e-15) << "kept elsewhere";
  }
}

TEST(TunedScheme, SaysWhatItKeeps) {
  const Tuned file = tuned("sqrt3", "alpha", "cup = tangent^2", 3, 6);
  EXPECT_NE(file.text.value().find("# The value of 'sqrt3' is kept at n = 3, 6."),
            std::string::npos);
  EXPECT_NE(file.text.value().find("(n == 4) * (4/9)"), std::string::npos) << file.text.value();
}

TEST(TunedScheme, MayKeepDecimalsOfItsBase) {
  const std::string name = "loop-tuned-regularity";
  const Tuned file = tuned(name, "w", "tangent = 1/2", 5, 5);
  const Result<Scheme> back = parse_scheme(file.text.value(), "tuned.toml");
  ASSERT_TRUE(back.ok()) << back.error().text();
  EXPECT_NEAR(*at(*back, 5).tangent, 1 / 2., 1e-14);
  EXPECT_NEAR(*at(*back, 7).tangent, *at(shipped(name), 7).tangent, 1e-15) << "kept elsewhere";
}

TEST(TunedScheme, WritesParametersWithTheirRange) {
  const Tuned file = tuned("butterfly", "w", "cup = tangent^2", 6, 6);
  EXPECT_NE(file.text.value().find("default = \"1/16\"\nrange   = [\"0\", \"1/8\"]"),
            std::string::npos)
      << file.text.value();
  const Scheme back = parse_scheme(file.text.value(), "tuned.toml").value();
  EXPECT_EQ(back.parameters.front().meaning, shipped("butterfly").parameters.front().meaning);
}

TEST(TunedScheme, IsRefusedWhereThereIsNothingToWrite) {
  const auto refused = [](const Tuned& file, const std::string& part) {
    ASSERT_FALSE(file.text.ok());
    EXPECT_NE(file.text.error().text().find(part), std::string::npos) << file.text.error().text();
  };
  refused(tuned("butterfly", "w", "cup = tangent^2", 5, 6), "one number everywhere");
  refused(tuned("sqrt3", "alpha", "cup = tangent^2", 3, 3), "no alpha was found");
}

}  // namespace
}  // namespace limn::test
