#include "limn/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace limn {
namespace {

class Parallel : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_thread_limit(GetParam()); }
  void TearDown() override { set_thread_limit(0); }
};

TEST_P(Parallel, ChunksDependOnTheGrainAlone) {
  EXPECT_EQ(thread_limit(), GetParam());
  std::set<std::pair<int, int>> chunks;
  std::mutex guard;
  const auto note = [&](int first, int last) {
    const std::lock_guard<std::mutex> hold(guard);
    EXPECT_TRUE(chunks.insert({first, last}).second);
  };
  base::parallel_for(5, 26, note, 10);
  EXPECT_EQ(chunks, (std::set<std::pair<int, int>>{{5, 15}, {15, 25}, {25, 26}}));
  chunks.clear();
  base::parallel_for(0, 20, note, 10);
  EXPECT_EQ(chunks, (std::set<std::pair<int, int>>{{0, 10}, {10, 20}}));
  chunks.clear();
  base::parallel_for(3, 3, note, 10);
  base::parallel_for(3, -7, note, 10);
  EXPECT_TRUE(chunks.empty());
  base::parallel_for(0, 2, note, 0);  // a grain below one counts as one
  EXPECT_EQ(chunks.size(), 2U);
}

TEST_P(Parallel, MeetsEveryIndexOnce) {
  const std::int32_t count = 1000003;
  std::vector<std::int32_t> met(static_cast<std::size_t>(count), 0);
  base::parallel_for_each(count, [&](std::int32_t i) { met[i] += i + 1; });
  for (std::int32_t i = 0; i < count; ++i) ASSERT_EQ(met[i], i + 1);
}

TEST_P(Parallel, Nests) {
  std::atomic<long> sum{0};
  base::parallel_for(
      0, 4,
      [&](int first, int last) {
        for (int i = first; i < last; ++i)
          base::parallel_for(
              0L, 100L, [&](long a, long b) { sum += b - a; }, 7);
      },
      1);
  EXPECT_EQ(sum, 400);
}

TEST_P(Parallel, PassesExceptionsOn) {
  EXPECT_THROW(base::parallel_for(
                   0, 100,
                   [](int first, int) {
                     if (first == 50) throw std::runtime_error("fifty");
                   },
                   10),
               std::runtime_error);
}

TEST_P(Parallel, EndsAreSafeAtTheLimitsOfTheIndex) {
  const std::int32_t top = 2147483647;
  std::atomic<long> length{0};
  base::parallel_for(
      top - 5, top, [&](std::int32_t a, std::int32_t b) { length += b - a; }, 4096);
  EXPECT_EQ(length, 5);
}

TEST(ThreadLimit, MayChangeWhileLoopsRun) {
  std::atomic<int> running{2};
  const auto work = [&] {
    for (int round = 0; round < 300; ++round) {
      std::atomic<long> sum{0};
      base::parallel_for(
          0, 64,
          [&](int first, int last) {
            for (int i = first; i < last; ++i)
              base::parallel_for(
                  0, 8, [&](int a, int b) { sum += b - a; }, 2);
          },
          1);
      EXPECT_EQ(sum, 64 * 8);
    }
    --running;
  };
  std::thread one(work), other(work);
  for (int threads = 0; running > 0; threads = (threads + 1) % 5) {
    set_thread_limit(threads);
    std::this_thread::yield();
  }
  one.join();
  other.join();
  set_thread_limit(0);
}

INSTANTIATE_TEST_SUITE_P(Limits, Parallel, ::testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace limn
