#include "limn/base/parallel.h"

#include <atomic>
#include <memory>
#include <utility>

#include "limn/base/interrupt.h"

#if defined(LIMN_PLAIN_THREADS)
#include <exception>
#include <thread>
#include <vector>
#elif defined(LIMN_HAS_TBB)
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <mutex>
#endif

namespace limn {
namespace {

std::atomic<int> most_threads{0};
thread_local base::InterruptCheck interrupt_check = nullptr;

void run_serially(std::ptrdiff_t count, void (*chunk)(void*, std::ptrdiff_t), void* context) {
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    base::check_interrupt();
    chunk(context, c);
  }
}

#if defined(LIMN_PLAIN_THREADS)

thread_local bool inside_a_loop = false;

/// Threads made for the one loop. For the thread sanitizer, which sees how they synchronise; it
/// does not see into TBB.
void run_on_plain_threads(std::ptrdiff_t count, int most, void (*chunk)(void*, std::ptrdiff_t),
                          void* context) {
  std::atomic<std::ptrdiff_t> next{0};
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(most));
  std::vector<std::thread> threads;
  for (std::exception_ptr& failure : failures)
    threads.emplace_back([&] {
      inside_a_loop = true;
      try {
        for (std::ptrdiff_t c = next++; c < count; c = next++) chunk(context, c);
      } catch (...) {
        failure = std::current_exception();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

#elif defined(LIMN_HAS_TBB)

std::mutex arena_guard;

/// An arena of our own, so that a limit on it leaves alone whatever else in the process uses TBB.
/// A loop shares its ownership: a new limit makes a new arena and waits for no loop.
std::shared_ptr<tbb::task_arena> arena(int threads) {
  static std::shared_ptr<tbb::task_arena> current;
  static int size = 0;
  const std::lock_guard<std::mutex> hold(arena_guard);
  if (size != threads) {
    current = std::make_shared<tbb::task_arena>(threads);
    size = threads;
  }
  return current;
}

#endif

}  // namespace

void set_thread_limit(int threads) { most_threads = threads > 0 ? threads : 0; }

int thread_limit() { return most_threads; }

base::InterruptCheck base::set_interrupt_check(base::InterruptCheck check) {
  return std::exchange(interrupt_check, check);
}

void base::check_interrupt() {
  if (interrupt_check != nullptr) interrupt_check();
}

namespace base::detail {

void run_chunks(std::ptrdiff_t count, void (*chunk)(void* context, std::ptrdiff_t c),
                void* context) {
  const int most = most_threads;
#if defined(LIMN_PLAIN_THREADS)
  check_interrupt();  // as none of the threads is the calling one
  if (count > 1 && most != 1 && !inside_a_loop)
    return run_on_plain_threads(count, most == 0 ? 4 : most, chunk, context);
#elif defined(LIMN_HAS_TBB)
  if (count > 1 && most != 1) {
    const auto loop = [&] {
      tbb::parallel_for(std::ptrdiff_t{0}, count, [&](std::ptrdiff_t c) {
        base::check_interrupt();  // of the thread that called; others have none
        chunk(context, c);
      });
    };
    if (most == 0) return loop();
    return arena(most)->execute(loop);
  }
#else
  static_cast<void>(most);
#endif
  run_serially(count, chunk, context);
}

}  // namespace base::detail
}  // namespace limn
