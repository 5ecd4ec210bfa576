#include "limn/base/huge_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <utility>

namespace limn {
namespace {

TEST(HugeArray, KeepsWhatIsWritten) {
  // below and above what is asked for in huge pages
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{3} << 20U}) {
    base::HugeArray<int> array(size);
    ASSERT_EQ(array.size(), size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % 64, 0U);
    std::iota(array.begin(), array.end(), 0);
    if (size > 0) EXPECT_EQ(array[size - 1], static_cast<int>(size) - 1);
  }
}

TEST(HugeArray, MovesWithoutCopying) {
  base::HugeArray<float> a(100);
  a[7] = 3;
  const float* place = a.data();
  base::HugeArray<float> b(std::move(a));
  EXPECT_EQ(b.data(), place);
  base::HugeArray<float> c;
  EXPECT_EQ(c.size(), 0U);
  c = std::move(b);
  EXPECT_EQ(c.data(), place);
  EXPECT_EQ(c[7], 3);
  EXPECT_EQ(c.size(), 100U);
}

}  // namespace
}  // namespace limn
