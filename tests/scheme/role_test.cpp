/// Walks as text, and the table of named roles.

#include "limn/scheme/role.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "limn/scheme/placement.h"

namespace limn {
namespace {

std::string shown(const std::string& text) {
  const Result<Walk> walk = parse_walk(text);
  if (walk) return to_string(*walk);
  return std::to_string(walk.error().column) + ": " + walk.error().message;
}

TEST(Role, RuleNamesRoundTrip) {
  std::set<std::string_view> names;
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    EXPECT_EQ(find_rule(rule_name(kind)), kind);
    names.insert(rule_name(kind));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kRuleKinds));
  EXPECT_FALSE(find_rule("").has_value());
  EXPECT_FALSE(find_rule("Vertex").has_value());
}

TEST(Role, WalksAsText) {
  for (const char* text :
       {"", "v", "efev", "bv", "(ef)*v", "(ve)*", "F", "vF", "e(ef)*vev", "(ef)*F"})
    EXPECT_EQ(shown(text), text);
  const Walk walk = parse_walk("e(fe)*vevF").value();
  EXPECT_EQ(walk.before, Moves{Move::edge});
  EXPECT_EQ(walk.step, (Moves{Move::face, Move::edge}));
  EXPECT_EQ(walk.after, (Moves{Move::vertex, Move::edge, Move::vertex}));
  EXPECT_TRUE(walk.repeated);
  EXPECT_TRUE(walk.reads_face);
}

TEST(Role, FaultsOfWalks) {
  EXPECT_EQ(shown("evx"), "3: found 'x'");
  EXPECT_EQ(shown("e v"), "2: found ' '");
  EXPECT_EQ(shown("Fv"), "2: found 'v'");
  EXPECT_EQ(shown("FF"), "2: found 'F'");
  EXPECT_EQ(shown("(ef"), "4: found no ')*' to end the repeated step");
  EXPECT_EQ(shown("(ef)"), "4: found no ')*' to end the repeated step");
  EXPECT_EQ(shown("(eF)*"), "3: found no ')*' to end the repeated step");
  EXPECT_EQ(shown("()*"), "2: the repeated step is empty");
  EXPECT_EQ(shown("(ef)*(ef)*"), "6: found '('");
  EXPECT_EQ(shown("*"), "1: found '*'");
  EXPECT_EQ(shown(")"), "1: found ')'");
  EXPECT_EQ(shown(std::string(24, 'v')), std::string(24, 'v'));
  EXPECT_EQ(shown(std::string(25, 'v')), "25: the walk is too long");
  EXPECT_EQ(shown(std::string("v\0", 2)), std::string("2: found '\0'", 12));
}

RC_GTEST_PROP(RoleLaws, TextRoundTrip, ()) {
  const auto moves = rc::gen::container<Moves>(
      rc::gen::element(Move::vertex, Move::edge, Move::face, Move::boundary));
  Walk walk;
  walk.before = *rc::gen::resize(6, moves);
  walk.repeated = *rc::gen::arbitrary<bool>();
  if (walk.repeated) {
    walk.step = *rc::gen::nonEmpty(rc::gen::resize(6, moves));
    walk.after = *rc::gen::resize(6, moves);
  }
  walk.reads_face = *rc::gen::arbitrary<bool>();
  const Result<Walk> again = parse_walk(to_string(walk));
  RC_ASSERT(again.ok());
  RC_ASSERT(*again == walk);
}

/// Any text is either a walk that says the same again, or a fault within it.
RC_GTEST_PROP(RoleLaws, AnyText, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::element('v', 'e', 'f', 'b', 'F', '(', ')', '*', 'x'));
  const Result<Walk> walk = parse_walk(text);
  if (walk) RC_ASSERT(to_string(*walk) == text);
  if (!walk) RC_ASSERT(walk.error().column >= 1);
  if (!walk) RC_ASSERT(walk.error().column <= static_cast<int>(text.size()) + 1);
}

TEST(Role, NamedRolesAreWalksWithPlaces) {
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    for (int i = 0; i < kRuleKinds; ++i) {
      const auto kind = static_cast<RuleKind>(i);
      const std::vector<NamedRole> roles = named_roles(kind, lattice);
      EXPECT_FALSE(roles.empty()) << rule_name(kind);
      std::set<std::string_view> names;
      for (const NamedRole& role : roles) {
        EXPECT_TRUE(names.insert(role.name).second) << role.name;
        EXPECT_FALSE(role.meaning.empty());
        const Result<Walk> walk = parse_walk(role.walk);
        ASSERT_TRUE(walk.ok()) << role.name;
        EXPECT_TRUE(scheme::place(kind, lattice, *walk).ok())
            << rule_name(kind) << " " << role.name;
      }
    }
  }
}

}  // namespace
}  // namespace limn
