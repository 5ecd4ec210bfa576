/// Parameters that are set again and again: the answers of set_parameters, with less to check.

#include <gtest/gtest.h>

#include <random>

#include "limn/scheme/parameter_setter.h"
#include "scheme/refined.h"

namespace limn {
namespace {

using test::must_parse;

constexpr const char* kHead = "extends = \"loop\"\nsplit = \"triangle-dyadic\"\n";

/// Both answer alike: with the same values, or with the same error.
void expect_as_set_parameters(scheme::ParameterSetter& setter,
                              const std::vector<std::string>& how) {
  Scheme plain = setter.scheme();
  const Status status = set_parameters(plain, how);
  const Result<Scheme> found = setter.with(how);
  ASSERT_EQ(found.ok(), status.ok()) << how.front();
  if (!found) {
    EXPECT_EQ(found.error().text(), status.error().text());
    return;
  }
  for (std::size_t i = 0; i < plain.parameters.size(); ++i)
    EXPECT_EQ(found->parameters[i].value.expression.text(),
              plain.parameters[i].value.expression.text());
}

TEST(ParameterSetter, AnswersAsSetParameters) {
  std::mt19937 random(2026);
  for (const std::string& name : shipped_schemes()) {
    const Scheme scheme = find_scheme(name).value();
    if (scheme.parameters.empty()) continue;
    scheme::ParameterSetter setter(scheme);
    for (int round = 0; round < 8; ++round) {
      std::vector<std::string> how;
      for (const Parameter& parameter : scheme.parameters)
        if (how.empty() || round % 3 == 0)
          how.push_back(parameter.name + "=" +
                        std::to_string(static_cast<int>(random() % 40) - 10) + "/32");
      SCOPED_TRACE(name + " " + how.front());
      expect_as_set_parameters(setter, how);
    }
    const std::string& first = scheme.parameters.front().name;
    for (const std::string value :
         {"nothing", "1/0", "1 +", "1e9", "n/8", "1/8", "99", first.c_str()})
      expect_as_set_parameters(setter, {first + "=" + value});
    expect_as_set_parameters(setter, {"zzz=1"});
    expect_as_set_parameters(setter, {first + "=1/8", first + "=1/8"});
  }
}

TEST(ParameterSetter, KnowsTheDegreeOfWeights) {
  const auto degree = [](const std::string& weights, const char* name = "a") {
    return scheme::detail::degree_of_weights(
        must_parse(std::string(kHead) + weights + "\n[parameter.a]\ndefault = \"1\"\n"), name);
  };
  EXPECT_EQ(degree("edge = { end = \"3/8\", wing = \"1/8\" }"), 0);
  EXPECT_EQ(degree("edge = { end = \"1/2 - a/8\", wing = \"a/8\" }"), 1);
  EXPECT_EQ(degree("let.b = \"(a - 2)^2*a/8\"\nedge = { end = \"1/2 - b\", wing = \"b\" }"), 3);
  EXPECT_EQ(degree("edge = { end = \"1/2 - 1/(8*a)\", wing = \"1/(8*a)\" }"), std::nullopt);
  EXPECT_EQ(degree("edge = { end = \"1/2 - sqrt(a)/8\", wing = \"sqrt(a)/8\" }"), std::nullopt);
  EXPECT_EQ(degree("edge = { end = \"1/2 - (a < 2)/8\", wing = \"(a < 2)/8\" }"), std::nullopt);
  EXPECT_EQ(degree("[[vertex]]\nwhen = \"a < 2\"\nself = \"1 - n*beta\"\nring = \"beta\"\n"
                   "[[vertex]]\nself = \"1 - n*beta\"\nring = \"beta\""),
            std::nullopt);
}

// The sum of the weights is 1 at two values of a, and nowhere else.
TEST(ParameterSetter, TakesNoTwoValuesForAProofOfAParabola) {
  scheme::ParameterSetter setter(
      must_parse(std::string(kHead) +
                 "vertex = { self = \"1 - n*beta + (a - 1)*(2*a - 1)\", ring = \"beta\" }\n"
                 "[parameter.a]\ndefault = \"1\"\n"));
  EXPECT_TRUE(setter.with({"a=1/2"}).ok());
  EXPECT_TRUE(setter.with({"a=1/2"}).ok());
  EXPECT_TRUE(setter.with({"a=1"}).ok());
  for (int round = 0; round < 3; ++round)
    for (const char* value : {"a=1/4", "a=0", "a=3"}) EXPECT_FALSE(setter.with({value}).ok());
}

// What is known of one parameter is so for the others' values alone.
TEST(ParameterSetter, KeepsApartWhatIsKnownAtOtherValuesOfTheRest) {
  scheme::ParameterSetter setter(must_parse(
      std::string(kHead) + "vertex = { self = \"1 - n*beta + a*(b - 1)\", ring = \"beta\" }\n" +
      "[parameter.a]\ndefault = \"1\"\n[parameter.b]\ndefault = \"1\"\n"));
  for (const char* value : {"a=2", "a=3", "a=4"}) EXPECT_TRUE(setter.with({value}).ok());
  EXPECT_FALSE(setter.with({"a=5", "b=2"}).ok());
  EXPECT_FALSE(setter.with({"b=2"}).ok());
  EXPECT_TRUE(setter.with({"a=0", "b=7"}).ok());
  EXPECT_TRUE(setter.with({"a=0", "b=8"}).ok());
  EXPECT_FALSE(setter.with({"a=2", "b=8"}).ok());
}

TEST(ParameterSetter, ChecksRangesAtEveryValue) {
  scheme::ParameterSetter setter(find_scheme("laplacian-loop-low").value());
  for (const char* value : {"a=1/3", "a=1/4", "a=1/5"}) EXPECT_TRUE(setter.with({value}).ok());
  for (const char* value : {"a=-1/9", "a=11/10"}) expect_as_set_parameters(setter, {value});
  EXPECT_FALSE(setter.with({"a=11/10"}).ok());
}

}  // namespace
}  // namespace limn
