// Requirements: what is understood, what is refused, and margins against the verdicts.

#include "limn/tune/freed_scheme.h"
#include "limn/tune/margin.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(Requirement, IsReadInAllItsForms) {
  const Scheme& loop = shipped("loop");
  const auto relation = [&](const char* text) {
    return Requirement::parse(text, loop).value().relation;
  };
  EXPECT_EQ(relation("cup = tangent^2"), Relation::equal);
  EXPECT_EQ(relation("cup == tangent^2"), Relation::equal);
  EXPECT_EQ(relation("cup < tangent^2"), Relation::above);
  EXPECT_EQ(relation("cup >= (n == 6)*tangent^2"), Relation::at_least);
  EXPECT_EQ(relation(" c1 "), Relation::c1);
  EXPECT_EQ(relation("convergent"), Relation::convergent);
  EXPECT_EQ(relation("bounded-curvature"), Relation::bounded_curvature);
}

TEST(Requirement, SeeksTheComponentThatStandsAlone) {
  const auto sought = [&](const char* text) -> std::string {
    const auto i = tune::sought_component(Requirement::parse(text, shipped("loop")).value());
    return i ? std::string(kComponents[*i].name) : "";
  };
  EXPECT_EQ(sought("cup = tangent^2"), "cup");
  EXPECT_EQ(sought("tangent^2 = cup"), "cup");
  EXPECT_EQ(sought("saddle = cup"), "saddle");
  EXPECT_EQ(sought("cup + saddle = 2*tangent^2"), "cup");
  EXPECT_EQ(sought("beta = 1/16"), "");
}

TEST(Requirement, IsRefusedWithItsColumn) {
  const auto refused = [&](const std::string& text, const std::string& part) {
    const Result<Requirement> read = Requirement::parse(text, shipped("loop"));
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_NE(read.error().text().find(part), std::string::npos) << read.error().text();
  };
  refused("", "column 1");
  refused("cup", "column 4: found the end, expected a relation");
  refused("cup = ", "column 7: found the end");
  refused("= cup", "column 1: found the end");
  refused("cup = tangnt^2", "column 7: unknown name 'tangnt'");
  refused("cup + k = 1", "column 7: unknown name 'k'");
  refused("cup = 0.5", "column 7: a decimal");
  refused("cup = 1/4 = saddle", "column 11: found a second relation");
  refused("cup != 1/4", "column 5: found '!'");
  refused("cup = (1/4", "expected ')'");
}

TEST(Requirement, SaysWhatIsMissing) {
  const Scheme& loop = shipped("loop");
  FreedScheme freed = FreedScheme::make(loop, "beta").value();
  const Requirement requirement = Requirement::parse("saddle = n*beta", loop).value();
  EXPECT_NEAR(tune::difference(requirement, freed, 5, 0.125, {{1., {}, {}, 0.5}}).value(), -0.125,
              1e-16);
  const Result<double> none = tune::difference(requirement, freed, 3, 0.125, {{1., .25, .5, {}}});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().text().find("no saddle at valence 3"), std::string::npos);
}

/// margin > 0 if and only if the verdict is yes, wherever neither is close.
void expect_margins_agree(FreedScheme& freed, const Scheme& scheme, int n, double x) {
  const Result<FrequencyBlocks> blocks = freed.blocks(n, x);
  RC_PRE(blocks.ok());
  const Eigencomponents found = approx_eigencomponents(*blocks);
  const std::array<std::pair<const char*, Truth>, 3> verdicts{
      {{"convergent", found.verdict.convergent},
       {"c1", found.verdict.c1_necessary},
       {"bounded-curvature", found.verdict.curvature_necessary}}};
  for (const auto& [name, verdict] : verdicts) {
    const Requirement requirement = Requirement::parse(name, scheme).value();
    const double distance = tune::margin(requirement, freed, x, found).value();
    if (std::abs(distance) < 1e-7) continue;
    RC_ASSERT(verdict == (distance > 0 ? Truth::yes : Truth::no));
  }
}

TEST(Requirement, MarginOfC1SeesThatTheTangentIsLessThan1) {
  const Scheme scheme = parse_scheme(
                            "split = \"triangle-dyadic\"\nextends = \"loop\"\n[parameter.g]\n"
                            "default = \"3/8\"\n[edge]\nend = \"g\"\nwing = \"1/2 - g\"\n",
                            "edge.toml")
                            .value();
  FreedScheme freed = FreedScheme::make(scheme, "g").value();
  const Requirement c1 = Requirement::parse("c1", scheme).value();
  const auto margin_at = [&](double g) {  // the tangent at n = 3 is an end less a wing
    const Eigencomponents found = approx_eigencomponents(freed.blocks(3, g).value());
    EXPECT_NEAR(*found.tangent, 2 * g - 0.5, 1e-14);
    EXPECT_EQ(found.verdict.c1_necessary, g < 0.75 ? Truth::yes : Truth::no) << g;
    return tune::margin(c1, freed, g, found).value();
  };
  EXPECT_GT(margin_at(0.5), 0);
  EXPECT_NEAR(margin_at(0.8), -0.1, 1e-14);
}

RC_GTEST_PROP(Requirement, MarginsAgreeWithTheVerdicts, ()) {
  const auto [scheme, name] =
      *rc::gen::element(std::pair("loop", "beta"), std::pair("sqrt3", "alpha"),
                        std::pair("laplacian-loop", "a"), std::pair("optimal", "beta"));
  FreedScheme freed = FreedScheme::make(shipped(scheme), name).value();
  const int n = *rc::gen::inRange(3, 10);
  if (n == 6) return;  // costs a star for each x
  const double x = *rc::gen::inRange(-1000, 1000) / 1000.;
  expect_margins_agree(freed, shipped(scheme), n, x);
}

}  // namespace
}  // namespace limn::test
