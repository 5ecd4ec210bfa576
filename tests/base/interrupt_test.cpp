#include "limn/base/interrupt.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "limn/base/parallel.h"

namespace limn {
namespace {

struct Ended {};
thread_local int looks = 0;

void count() { ++looks; }
void end_at_once() { throw Ended{}; }

class Interrupt : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_thread_limit(GetParam()); }
  void TearDown() override {
    set_thread_limit(0);
    base::set_interrupt_check(nullptr);
  }
  static void loop() {
    base::parallel_for(
        0, 1000, [](int, int) {}, 1);
  }
};

TEST_P(Interrupt, WhatTheCheckThrowsEndsTheLoop) {
  loop();  // without one
  EXPECT_EQ(base::set_interrupt_check(end_at_once), nullptr);
  EXPECT_THROW(loop(), Ended);
  EXPECT_EQ(base::set_interrupt_check(nullptr), end_at_once);
  loop();
}

TEST_P(Interrupt, TheThreadThatSetItIsTheOneThatLooks) {
  base::set_interrupt_check(count);
  looks = 0;
  loop();
  EXPECT_GT(looks, 0);
  std::atomic<int> of_other{0};
  std::thread([&] {
    loop();
    of_other = looks;
  }).join();
  EXPECT_EQ(of_other, 0);
}

INSTANTIATE_TEST_SUITE_P(Threads, Interrupt, ::testing::Values(0, 1, 3));

}  // namespace
}  // namespace limn
