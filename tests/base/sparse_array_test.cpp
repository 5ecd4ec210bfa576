#include "limn/base/sparse_array.h"

#include <gtest/gtest.h>

#include <utility>

namespace limn {
namespace {

constexpr std::size_t kSize = 300'001;  // more than a huge page, and no whole number of pages

TEST(SparseArray, HoldsWhatIsWrittenAndZeroElsewhere) {
  for (const base::SparseArray::Pages pages :
       {base::SparseArray::Pages::small, base::SparseArray::Pages::huge}) {
    base::SparseArray array(kSize, pages);
    ASSERT_EQ(array.size(), kSize);
    // ranges within a page, over several, of nothing, and to the end, prepared or not
    for (const auto& [first, count] : {std::pair<std::size_t, std::size_t>{3, 5},
                                       {1000, 40'000},
                                       {60'000, 0},
                                       {kSize - 9'999, 9'999}}) {
      array.prepare(first, count);
      for (std::size_t i = first; i < first + count; ++i) array.data()[i] = static_cast<double>(i);
    }
    array.prepare(100'000, 50'000);
    const base::SparseArray& read = array;
    EXPECT_EQ(read.data()[0], 0);
    EXPECT_EQ(read.data()[3], 3);
    EXPECT_EQ(read.data()[8], 0);
    EXPECT_EQ(read.data()[40'999], 40'999);
    EXPECT_EQ(read.data()[120'000], 0);
    EXPECT_EQ(read.data()[kSize - 1], kSize - 1);
  }
}

TEST(SparseArray, CanBeWrittenAgainOnceItIsDropped) {
  base::SparseArray array(kSize);
  array.prepare(0, kSize);
  array.data()[7] = 1;
  array.drop();
  array.prepare(0, 20'000);
  array.data()[7] = 2;
  base::SparseArray other = std::move(array);
  EXPECT_EQ(other.data()[7], 2);
}

TEST(SparseArray, OfNothingIsNothing) {
  base::SparseArray array;
  EXPECT_EQ(array.size(), 0U);
  array.drop();
  EXPECT_EQ(base::SparseArray(0).size(), 0U);
}

}  // namespace
}  // namespace limn
