#include "limn/base/large_vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace limn {
namespace {

TEST(LargeVector, IsAVector) {
  // below and above what is asked for in huge pages, and with what is left over of one
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1000},
                                 std::size_t{1} << 20U, (std::size_t{3} << 20U) + 7}) {
    std::vector<int> values = base::large_vector<int>(size);
    ASSERT_EQ(values.size(), size);
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](int value) { return value == 0; }));
    std::iota(values.begin(), values.end(), 0);
    if (size > 0) EXPECT_EQ(values.back(), static_cast<int>(size) - 1);
    const std::vector<int> copy = values;
    EXPECT_EQ(copy, values);
    EXPECT_EQ(base::large_vector<int>(size, -1), std::vector<int>(size, -1));
  }
}

TEST(LargeVector, ReservesRoomForWhatIsThereToo) {
  std::vector<double> values{1, 2, 3};
  base::reserve_large(values, std::size_t{2} << 20U);
  const double* const place = values.data();
  values.resize(std::size_t{2} << 20U, 4);
  EXPECT_EQ(values.data(), place);
  EXPECT_EQ(values[2], 3);
  EXPECT_EQ(values.back(), 4);
  base::reserve_large(values, 1);
  EXPECT_EQ(values.data(), place);
}

}  // namespace
}  // namespace limn
