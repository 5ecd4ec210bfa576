/// Weights that are decimals from a table.

#include <gtest/gtest.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/rule_tables.h"
#include "scheme/refined.h"

namespace limn {
namespace {

using test::expect_same_refinement;
using test::must_parse;

constexpr const char* kHead = "extends = \"loop\"\nsplit = \"triangle-dyadic\"\n";

TEST(Decimals, AreTheFractionsThatTheySpell) {
  const Scheme scheme = must_parse(std::string(kHead) +
                                   "weights = \"decimal\"\n"
                                   "edge = { end = \"0.375\", wing = \".125\" }\n");
  EXPECT_TRUE(scheme.has_decimals);
  expect_same_refinement(scheme, find_scheme("loop").value(), mesh::torus(Lattice::triangle, 5, 4));
  const refine::Row<number::Exact> row =
      refine::tabulate_row<number::Exact>(scheme, RuleKind::edge, 0).value();
  EXPECT_EQ(row.weights.front().rational(), Rational(3, 8));
  EXPECT_EQ(scheme.rule(RuleKind::edge)->front().weights.front().value.expression.text(), "0.375");
}

TEST(Decimals, ThatSumToOneToRoundingAloneAreDividedByTheirSum) {
  const Scheme scheme = must_parse(std::string(kHead) +
                                   "weights = \"decimal\"\n"
                                   "edge = { end = \"0.3333\", wing = \"0.1666\" }\n"
                                   "[[vertex]]\nwhen = \"n == 5\"\n"
                                   "self = \"0.5805\"\nring = \"0.0840\"\n"
                                   "[[vertex]]\nself = \"5/8\"\nring = \"3/(8*n)\"\n");
  const refine::Row<number::Exact> edge =
      refine::tabulate_row<number::Exact>(scheme, RuleKind::edge, 0).value();
  EXPECT_EQ(edge.weights.front().rational(), Rational(3333, 9998));
  const refine::Row<number::Exact> vertex =
      refine::tabulate_row<number::Exact>(scheme, RuleKind::vertex, 5).value();
  EXPECT_EQ(vertex.weights.front().rational(), Rational(5805, 10005));
  const refine::Row<number::Exact> exact =
      refine::tabulate_row<number::Exact>(scheme, RuleKind::vertex, 7).value();
  EXPECT_EQ(exact.weights.front().rational(), Rational(5, 8));  // as it stands
}

TEST(Decimals, AreRefusedUnlessTheFileAsksForThem) {
  const Result<Scheme> scheme = parse_scheme(
      std::string(kHead) + "edge = { end = \"0.375\", wing = \"1/8\" }\n", "test.toml");
  ASSERT_FALSE(scheme.ok());
  EXPECT_EQ(scheme.error().line, 3);
  EXPECT_NE(scheme.error().text().find("weights = \"decimal\""), std::string::npos)
      << scheme.error().text();
  EXPECT_TRUE(parse_scheme(std::string(kHead) + "weights = \"exact\"\n", "test.toml").ok());
  // parameters are set in exact numbers, whatever the file has
  Scheme butterfly =
      must_parse("extends = \"butterfly\"\nsplit = \"triangle-dyadic\"\nweights = \"decimal\"\n");
  EXPECT_FALSE(set_parameter(butterfly, "w=0.05").ok());
}

}  // namespace
}  // namespace limn
