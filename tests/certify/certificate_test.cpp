// What a certificate claims is checked anew, with nothing of it taken on trust.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "certify/certified.h"
#include "limn/certify/certificate/certificate_json.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

constexpr int kLeavesChanged = 12;  // of each certificate

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

}  // namespace
}  // namespace limn::certify
