#include "limn/certify/certify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <random>

#include "limn/certify/certificate/certificate_json.h"
#include "limn/limit/characteristic_map.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

constexpr int kLeavesChanged = 12;  // of each certificate

std::vector<int> valences(int first, int last) {
  std::vector<int> result(static_cast<std::size_t>(last - first + 1));
  std::iota(result.begin(), result.end(), first);
  return result;
}

Certificate certified(const Scheme& scheme, int first, int last) {
  Result<Certificate> certificate = certify(scheme, valences(first, last));
  EXPECT_TRUE(certificate.ok()) << certificate.error().text();
  return certificate ? *certificate : Certificate{};
}

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

/// A weight of the file that is another one: the claim falls or the verdict changes.
TEST(Certificate, IsOfItsTextsRules) {
  Certificate certificate = certified(test::shipped("loop"), 5, 5);
  ASSERT_TRUE(check_certificate(certificate).ok());
  std::string& text = certificate.texts.front().text;
  text.replace(text.find("5/8 - lambda^2"), 3, "4/8");
  EXPECT_FALSE(check_certificate(certificate).ok());
}

/// Each number of a certificate, one after the other, made another one.
TEST(Certificate, IsRefusedWithAnyNumberChanged) {
  for (const auto& [name, n] : {std::pair{"loop", 4}, std::pair{"loop", 7},
                                std::pair{"loop-7-shrinking", 7}, std::pair{"doo-sabin", 5}}) {
    SCOPED_TRACE(name);
    nlohmann::json json =
        nlohmann::json::parse(certificate_json(certified(test::shipped(name), n, n)).dump());
    const auto verified = [&] {
      const Result<Certificate> read = parse_certificate(json.dump());
      return read.ok() && check_certificate(*read).ok();
    };
    ASSERT_TRUE(verified());
    int changed = 0;
    const auto visit = [&](auto&& self, nlohmann::json& value, const std::string& path) -> void {
      if (value.is_structured()) {
        for (auto it = value.begin(); it != value.end(); ++it)
          self(self, *it,
               path + "/" + (value.is_object() ? it.key() : std::to_string(it - value.begin())));
        return;
      }
      if (!value.is_number() || path.ends_with("/bits") || path == "/version") return;
      const nlohmann::json kept = value;
      if (value.is_number_integer())
        value = value.get<int>() + 1;
      else
        value = value.get<double>() * (1 + 1e-9) + 1e-9;
      EXPECT_FALSE(verified()) << path << " " << kept << " -> " << value;
      value = kept;
      ++changed;
    };
    visit(visit, json, "");
    EXPECT_GT(changed, 15);
    // the parts of a cell
    for (nlohmann::json& cell : json["valences"][0]["ring"]) {
      const nlohmann::json kept = cell["parts"];
      cell["parts"] = "0 1 2";
      EXPECT_FALSE(verified());
      cell["parts"] = kept;
    }
    json["valences"][0]["c1"] = "undecided";
    EXPECT_FALSE(verified());
  }
}

/// Of all valences: read again as it was, and refused with other numbers.
TEST(Certificate, OfAllValencesIsCheckedToo) {
  CertifyOptions options;
  options.all = true;
  const Result<Certificate> found = certify(test::shipped("catmull-clark"), {}, options);
  ASSERT_TRUE(found.ok()) << found.error().text();
  ASSERT_TRUE(found->all);
  EXPECT_EQ(found->all->c1, Answer::proved) << found->all->reason;
  EXPECT_TRUE(found->all->exceptions.empty());
  const nlohmann::json json = nlohmann::json::parse(certificate_json(*found).dump());
  const auto verified = [](const nlohmann::json& some) {
    const Result<Certificate> read = parse_certificate(some.dump());
    return read.ok() && check_certificate(*read).ok();
  };
  ASSERT_TRUE(verified(json));
  const auto refused = [&](const std::string& path, const nlohmann::json& value) {
    nlohmann::json other = json;
    other[nlohmann::json::json_pointer(path)] = value;
    EXPECT_FALSE(verified(other)) << path;
  };
  refused("/all/from", 4);
  refused("/all/together_from", json["all"]["together_from"].get<int>() + 1);
  refused("/all/exceptions", nlohmann::json::array({{{"valence", 5}, {"c1", "undecided"}}}));
  refused("/all/intervals/0/eigenvalue", 0.8);
  refused("/all/intervals/0/end", "1/1000000");
  refused("/all/turns/0/end", "1/1000000");
  refused("/valences", nlohmann::json::array());
}

/// What would go unread makes a claim another one.
TEST(Certificate, HoldsNothingBesideWhatItsCurvatureNeeds) {
  const auto refused = [](Certificate certificate, auto&& change) {
    ASSERT_TRUE(check_certificate(certificate).ok());
    change(certificate.valences.front().curvature);
    EXPECT_FALSE(check_certificate(certificate).ok());
  };
  const Certificate bounded = certified(test::shipped("loop"), 5, 5);
  const Certificate unbounded = certified(test::shipped("loop"), 7, 7);
  const LargeEigenvalue large = unbounded.valences.front().curvature.large.value();
  refused(bounded, [&](CurvatureClaim& claim) { claim.large = large; });
  refused(bounded, [](CurvatureClaim& claim) { claim.jordan = {0, 2}; });
  refused(bounded, [](CurvatureClaim& claim) { claim.equal.push_back(claim.equal.front()); });
  refused(bounded, [](CurvatureClaim& claim) { claim.answer = CurvatureAnswer::undecided; });
  refused(unbounded, [](CurvatureClaim& claim) { claim.jordan = {0, 2}; });
  refused(unbounded, [](CurvatureClaim& claim) { claim.answer = CurvatureAnswer::undecided; });
  refused(unbounded, [](CurvatureClaim& claim) { claim.answer = CurvatureAnswer::flat; });
}

/// The places of all values in a document that are no lists or objects.
std::vector<nlohmann::json::json_pointer> leaves_of(const nlohmann::json& json) {
  std::vector<nlohmann::json::json_pointer> result;
  const nlohmann::json flat = json.flatten();
  for (const auto& [path, value] : flat.items())
    if (!value.is_null()) result.emplace_back(path);  // null: an empty list
  return result;
}

/// What is only said, as docs/certificates.md names it: `reason`, `bits`, `version`, the name of
/// the scheme's own text; and the text, which what is verified is verified of.
bool is_informative(const std::string& path) {
  return path.ends_with("/reason") || path.ends_with("/bits") || path == "/version" ||
         path == "/texts/0/name" || path.ends_with("/text");
}

nlohmann::json another(const nlohmann::json& value, std::mt19937& random) {
  if (value.is_number_integer()) return value.get<int>() + (random() % 2 == 0 ? 1 : -1);
  if (value.is_number()) return value.get<double>() * (1 + 1e-7) + 1e-7;
  std::string text = value.get<std::string>();
  if (text.empty()) return "0";
  char& one = text[random() % text.size()];
  one = one == '0' ? '1' : '0';
  return text;
}

/// Any leaf of certificates of proofs, of refutations both ways and of all valences.
TEST(Certificate, IsRefusedWithAnyLeafChanged) {
  CertifyOptions all;
  all.all = true;
  std::mt19937 random(15);
  for (const Certificate& certificate :
       {certified(test::shipped("loop"), 4, 8), certified(test::shipped("butterfly"), 7, 8),
        certify(test::shipped("catmull-clark"), {}, all).value(),
        certify(test::shipped("loop-7-shrinking"), {}, all).value()}) {
    SCOPED_TRACE(certificate.scheme);
    nlohmann::json json = nlohmann::json::parse(certificate_json(certificate).dump());
    const auto verified = [&] {
      const Result<Certificate> read = parse_certificate(json.dump());
      return read.ok() && check_certificate(*read).ok();
    };
    ASSERT_TRUE(verified());
    std::vector<nlohmann::json::json_pointer> leaves = leaves_of(json);
    std::shuffle(leaves.begin(), leaves.end(), random);
    int changed = 0;
    for (const auto& leaf : leaves) {
      if (is_informative(leaf.to_string())) continue;
      const nlohmann::json kept = json[leaf];
      json[leaf] = another(kept, random);
      EXPECT_FALSE(verified()) << leaf << " " << kept << " -> " << json[leaf];
      json[leaf] = kept;
      if (++changed == kLeavesChanged) break;
    }
    EXPECT_EQ(changed, kLeavesChanged);
  }
}

TEST(Certificate, HasNoKeysThatNobodyReads) {
  nlohmann::json json =
      nlohmann::json::parse(certificate_json(certified(test::shipped("loop"), 6, 6)).dump());
  json["valences"][0]["more"] = 1;
  EXPECT_FALSE(parse_certificate(json.dump()).ok());
  EXPECT_FALSE(parse_certificate("[]").ok());
  EXPECT_FALSE(parse_certificate("{").ok());
  EXPECT_FALSE(parse_certificate("null").ok());
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
