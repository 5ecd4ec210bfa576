#include "limn/base/parallel.h"

#ifdef LIMN_HAS_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace limn {
namespace {

int limit = 0;

void run_serially(std::ptrdiff_t count, void (*chunk)(void*, std::ptrdiff_t), void* context) {
  for (std::ptrdiff_t c = 0; c < count; ++c) chunk(context, c);
}

#ifdef LIMN_HAS_TBB
// an arena of our own: a limit on it leaves alone whatever else in the process uses TBB
tbb::task_arena& limited_arena() {
  static tbb::task_arena arena;
  return arena;
}
#endif

}  // namespace

void set_thread_limit(int threads) {
  limit = threads > 0 ? threads : 0;
#ifdef LIMN_HAS_TBB
  if (limit > 1) {
    limited_arena().terminate();
    limited_arena().initialize(limit);
  }
#endif
}

int thread_limit() { return limit; }

namespace detail {

void run_chunks(std::ptrdiff_t count, void (*chunk)(void*, std::ptrdiff_t), void* context) {
#ifdef LIMN_HAS_TBB
  if (count > 1 && limit != 1) {
    const auto loop = [&] {
      tbb::parallel_for(std::ptrdiff_t{0}, count, [&](std::ptrdiff_t c) { chunk(context, c); });
    };
    if (limit == 0) return loop();
    return limited_arena().execute(loop);
  }
#endif
  run_serially(count, chunk, context);
}

}  // namespace detail
}  // namespace limn
