#include "limn/certify/certify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "certify/certified.h"
#include "limn/limit/characteristic_map.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

class Proved : public testing::TestWithParam<const char*> {};

TEST_P(Proved, AtSmallAndLargeValences) {
  const Scheme& scheme = test::shipped(GetParam());
  for (const auto& [first, last] : {std::pair{3, 12}, std::pair{49, 50}}) {
    const Certificate certificate = certified(scheme, first, last);
    for (const ValenceClaim& claim : certificate.valences)
      EXPECT_EQ(claim.c1, Answer::proved) << claim.valence << ": " << claim.reason;
    const Status shown = check_certificate(certificate);
    EXPECT_TRUE(shown.ok()) << shown.error().text();
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Proved,
                         testing::Values("loop", "loop-warren", "catmull-clark", "doo-sabin",
                                         "sqrt3", "four-eight", "butterfly-modified",
                                         "interpolating-loop", "laplacian-butterfly",
                                         "laplacian-loop", "laplacian-loop-low", "loop-ternary"));

TEST(Certify, LeavesCurvatureOutWhereItIsNotAskedFor) {
  CertifyOptions options;
  options.curvature = false;
  const Result<Certificate> without = certify(test::shipped("loop"), {3, 5, 7}, options);
  ASSERT_TRUE(without.ok()) << without.error().text();
  for (const ValenceClaim& claim : without->valences) {
    EXPECT_EQ(claim.c1, Answer::proved) << claim.valence;
    EXPECT_EQ(claim.curvature.answer, CurvatureAnswer::undecided) << claim.valence;
    EXPECT_EQ(claim.curvature.reason, "was not asked for") << claim.valence;
  }
  EXPECT_TRUE(check_certificate(*without).ok());
}

TEST(Certify, RefutesTheButterflyFromEightOn) {
  const Certificate certificate = certified(test::shipped("butterfly"), 3, 12);
  for (const ValenceClaim& claim : certificate.valences) {
    const Answer expected = claim.valence == 3  ? Answer::undecided
                            : claim.valence < 8 ? Answer::proved
                                                : Answer::refuted;
    EXPECT_EQ(claim.c1, expected) << claim.valence << ": " << claim.reason;
  }
  EXPECT_NE(certificate.valences.front().reason.find("a tie: 1/4 exactly"), std::string::npos)
      << certificate.valences.front().reason;
  EXPECT_TRUE(check_certificate(certificate).ok());
}

TEST(Certify, RefutesTheShrinkingVariantAtSeven) {
  const Certificate certificate = certified(test::shipped("loop-7-shrinking"), 7, 7);
  EXPECT_EQ(certificate.valences.front().c1, Answer::refuted);
  EXPECT_EQ(certificate.valences.front().frequency, 2);
  EXPECT_TRUE(check_certificate(certificate).ok());
}

/// A rule at the vertex's edges with so large a first harmonic that the map folds, at one place of
/// the half sector; with a smaller one it does not.
TEST(Certify, RefutesAMapThatFolds) {
  const auto scheme = [](const char* harmonic) {
    return parse_scheme(
               "name = \"fold\"\nsplit = \"triangle-dyadic\"\n"
               "extends = \"butterfly-modified\"\n[[edge-end]]\nwhen = \"n != 6\"\n"
               "self = \"3/4\"\nring = \"(1/4 + " +
                   std::string(harmonic) + "*cos(2*pi*k/n) + cos(4*pi*k/n)/2)/n\"\n",
               "")
        .value();
  };
  for (const char* harmonic : {"17/10", "185/100"}) {
    const Scheme folded = scheme(harmonic);
    const Certificate certificate = certified(folded, 7, 8);
    for (const ValenceClaim& claim : certificate.valences) {
      EXPECT_EQ(claim.c1, Answer::refuted) << harmonic << " " << claim.reason;
      EXPECT_TRUE(claim.fold.has_value());
      EXPECT_NE(approx_characteristic_map(folded, claim.valence)->regular, Truth::yes);
    }
    EXPECT_TRUE(check_certificate(certificate).ok());
    Certificate swapped = certificate;
    std::swap((*swapped.valences[0].fold)[0], (*swapped.valences[0].fold)[1]);
    EXPECT_FALSE(check_certificate(swapped).ok());
  }
  EXPECT_EQ(certified(scheme("3/2"), 7, 7).valences.front().c1, Answer::proved);
}

/// Weights that cancel on the lattice and part at another valence: of walks that turn too far round
/// the anchor, of walks that turn round a vertex on their way, and of two walks along the one-ring
/// to one point of the lattice, one each way round the vertex. Surfaces of the last fold.
TEST(Certify, LeavesRulesThatAreNotTheMaskOpen) {
  const auto answer = [](const std::string& text) {
    const Result<Scheme> scheme = parse_scheme(text, "");
    EXPECT_TRUE(scheme.ok()) << scheme.error().text();
    const Result<Certificate> certificate = certify(*scheme, {5, 7});
    EXPECT_TRUE(certificate.ok()) << certificate.error().text();
    for (const ValenceClaim& claim : certificate->valences)
      EXPECT_TRUE(claim.reason.find("walk") != std::string::npos ||
                  claim.reason.find("not the regular mask") != std::string::npos)
          << claim.reason;
    return certificate->valences.front().c1;
  };
  EXPECT_EQ(answer(R"(
name = "turn"
split = "triangle-dyadic"
[let]
beta = "(5/8 - (3/8 + cos(2*pi/n)/4)^2)/n"
[roles.edge]
two = "efev"
eight = "efefefefefefefev"
[vertex]
self = "1 - n*beta"
ring = "beta"
[edge]
end = "3/8"
wing = "1/8"
two = "1/8"
eight = "-1/8"
)"),
            Answer::undecided);
  EXPECT_EQ(answer(R"(
name = "through"
split = "quad-dyadic"
[roles.vertex]
near = "vefevefevev"
far = "vefevefevefefev"
[face]
corner = "1/n"
[edge]
end = "1/4"
face = "1/4"
[vertex]
self = "(n - 2)/n"
ring = "1/n^2"
face = "1/n^2"
near = "5"
far = "-5"
)"),
            Answer::undecided);
  EXPECT_EQ(answer(R"(
name = "around"
split = "triangle-dyadic"
extends = "loop"
[roles.edge]
right = "vefevefev"
left = "efevefevefev"
[edge]
end = "3/8"
wing = "1/8"
right = "5"
left = "-5"
)"),
            Answer::undecided);
}

/// A walk of five turns is one of one on the lattice, and not at another valence n: there half of
/// the weight of edges' wings is at 5·2π/n.
TEST(Certify, FollowsWalksRoundTheirAnchor) {
  const Scheme scheme = parse_scheme(R"(
name = "five"
split = "triangle-dyadic"
extends = "loop"
[roles.edge]
five = "efefefefev"
[edge]
end = "3/8"
wing = "1/16"
five = "1/16"
)",
                                     "")
                            .value();
  for (const int n : {5, 7, 14}) {
    const Certificate certificate = certified(scheme, n, n);
    const ValenceClaim& claim = certificate.valences.front();
    EXPECT_EQ(claim.c1, Answer::proved) << claim.reason;
    const double turn = 2 * std::numbers::pi / n;
    // of the five turns' weight a half is at the ends that are regular
    EXPECT_NEAR(claim.eigenvalue,
                3.0 / 8 + (1.0 / 8 + 1.0 / 16) * std::cos(turn) + std::cos(5 * turn) / 16, 1e-12);
  }
}

TEST(Certify, LeavesTheOptimalSchemesTieAtThreeOpen) {
  const Certificate certificate = certified(test::shipped("optimal"), 3, 6);
  EXPECT_EQ(certificate.valences[0].c1, Answer::undecided);
  EXPECT_NE(certificate.valences[0].reason.find("0.166667"), std::string::npos)
      << certificate.valences[0].reason;
  EXPECT_NE(certificate.valences[0].reason.find("a tie: 1/6 exactly"), std::string::npos)
      << certificate.valences[0].reason;
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(certificate.valences[i].c1, Answer::proved);
}

/// -μ1 - μ1² < a < μ1 - μ1² is necessary [KS], at n = 6: -3/4 < a < 1/4; and the lattice is C1
/// there well inside.
TEST(Certify, FollowsTheLaplacianFamilysRange) {
  for (const auto& [a, proved] : {std::pair{"-1/4", true}, std::pair{"1/8", true},
                                  std::pair{"26/100", false}, std::pair{"-76/100", false}}) {
    Scheme scheme = test::shipped("laplacian-loop");
    ASSERT_TRUE(set_parameters(scheme, {std::string("a=") + a}).ok());
    const Result<Certificate> certificate = certify(scheme, {6});
    ASSERT_TRUE(certificate.ok()) << certificate.error().text();
    EXPECT_EQ(certificate->valences[0].c1 == Answer::proved, proved)
        << a << ": " << certificate->valences[0].reason;
  }
}

TEST(Certify, ProvesCurvature) {
  const auto answer = [](const char* name, int n) {
    const Certificate certificate = certified(test::shipped(name), n, n);
    EXPECT_TRUE(check_certificate(certificate).ok());
    return certificate.valences.front().curvature.answer;
  };
  EXPECT_EQ(answer("loop", 3), CurvatureAnswer::unbounded);  // 1/8 > 1/16
  EXPECT_EQ(answer("loop", 4), CurvatureAnswer::bounded);    // cup = tangent² exactly
  EXPECT_EQ(answer("loop", 5), CurvatureAnswer::bounded);
  EXPECT_EQ(answer("loop", 6), CurvatureAnswer::bounded);
  EXPECT_EQ(answer("loop", 7), CurvatureAnswer::unbounded);  // saddle > tangent²
  EXPECT_EQ(answer("catmull-clark", 4), CurvatureAnswer::bounded);
  EXPECT_EQ(answer("catmull-clark", 5), CurvatureAnswer::unbounded);
  for (const int n : {3, 5, 8, 12})
    EXPECT_EQ(answer("catmull-clark-bounded", n), CurvatureAnswer::bounded) << n;
  EXPECT_EQ(answer("sqrt3", 6), CurvatureAnswer::bounded);
  EXPECT_EQ(answer("doo-sabin", 4), CurvatureAnswer::bounded);
  EXPECT_EQ(answer("doo-sabin", 5), CurvatureAnswer::unbounded);  // a Jordan block
  EXPECT_EQ(answer("loop-7-flat", 7), CurvatureAnswer::bounded);  // cup = tangent², saddles less
  EXPECT_EQ(answer("laplacian-loop", 6), CurvatureAnswer::unbounded);  // the lattice itself
}

/// Proved maps show no fold in samples; refuted folds show one.
TEST(Certify, AgreesWithSamplesOfRandomFamilies) {
  std::mt19937 random(2026);
  int proved = 0;
  int refuted = 0;
  for (int round = 0; round < 60; ++round) {
    Scheme scheme = test::shipped("loop-type");
    const int b = 26 + static_cast<int>(random() % 22);
    const int n = 3 + static_cast<int>(random() % 7);
    const int beta = 1 + static_cast<int>(random() % 40);
    if (!set_parameters(scheme, {"b=" + std::to_string(b) + "/100",
                                 "beta=" + std::to_string(beta) + "/(100*n)"}))
      continue;
    const Result<Certificate> certificate = certify(scheme, {n});
    if (!certificate) continue;
    const ValenceClaim& claim = certificate->valences.front();
    if (claim.c1 == Answer::undecided) continue;
    EXPECT_TRUE(check_certificate(*certificate).ok());
    const Result<CharacteristicMap> map = approx_characteristic_map(scheme, n);
    if (claim.c1 == Answer::proved) {
      ++proved;
      ASSERT_TRUE(map.ok());
      EXPECT_NE(map->regular, Truth::no) << map->reason;
    } else {
      ++refuted;
      if (claim.fold) EXPECT_NE(map->regular, Truth::yes) << n;
    }
  }
  EXPECT_GT(proved, 5);
  EXPECT_GT(refuted, 1);
}

}  // namespace
}  // namespace limn::certify
