#include "limn/base/near_word.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace limn {
namespace {

using Words = std::vector<std::string>;

TEST(NearWord, SlipsOfThePen) {
  const Words keys{"name", "title", "split", "source", "notes", "extends", "let", "vertex", "edge"};
  EXPECT_EQ(base::near_words("splitt", keys), Words{"split"});
  EXPECT_EQ(base::near_words("slpit", keys), Words{"split"});
  EXPECT_EQ(base::near_words("Split", keys), Words{"split"});
  EXPECT_EQ(base::near_words("titel", keys), Words{"title"});
  EXPECT_EQ(base::near_words("note", keys), Words{"notes"});
  EXPECT_EQ(base::near_words("lte", keys), Words{"let"});
  EXPECT_EQ(base::near_words("egde", keys), Words{"edge"});
  EXPECT_EQ(base::near_words("extend", keys), Words{"extends"});
  EXPECT_TRUE(base::near_words("valence", keys).empty());
  EXPECT_TRUE(base::near_words("x", keys).empty());
  EXPECT_TRUE(base::near_words("", keys).empty());
}

TEST(NearWord, ShortWordsAreNotAllNear) {
  EXPECT_TRUE(base::near_words("w", {"i", "j", "p", "q"}).empty());
  EXPECT_EQ(base::near_words("k4", {"i", "j", "k3"}), Words{"k3"});
}

TEST(NearWord, AsAQuestion) {
  EXPECT_EQ(base::did_you_mean("lop", {"loop", "sqrt3"}), "did you mean loop?");
  EXPECT_EQ(base::did_you_mean("abc", {"abd", "abe"}), "did you mean abd or abe?");
  EXPECT_EQ(base::did_you_mean("zzz", {"loop"}), "");
  EXPECT_EQ(base::did_you_mean("zzz", {"loop"}, "it has loop"), "it has loop");
  EXPECT_EQ(base::did_you_mean("lopp", {"loop"}, "it has loop"), "did you mean loop? it has loop");
  EXPECT_EQ(base::did_you_mean("modified", {"butterfly", "butterfly-modified"}),
            "did you mean butterfly-modified?");
}

/// One slip of any kind in a long word is found; the slip is made here, letter by letter.
RC_GTEST_PROP(NearWordLaws, OneSlipIsFound, ()) {
  const std::string word =
      *rc::gen::container<std::string>(12, rc::gen::inRange('a', static_cast<char>('z' + 1)));
  const auto at = *rc::gen::inRange<std::size_t>(0, word.size() - 1);
  std::string slip = word;
  switch (*rc::gen::inRange(0, 4)) {
    case 0: slip.erase(at, 1); break;
    case 1: slip.insert(at, 1, 'q'); break;
    case 2: slip[at] = 'q'; break;
    default: std::swap(slip[at], slip[at + 1]);
  }
  RC_ASSERT(base::near_words(slip, {"entirely other", word}) == Words{word});
}

}  // namespace
}  // namespace limn
