#include "measure.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace limn::peers {
namespace {

// Several runs are as many as fit into this time, but at least and at most so many.
constexpr double kNanoseconds = 0.4e9;
constexpr int kLeastRuns = 1, kMostRuns = 10;

double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double nanoseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

template <class Work>
double duration(const Contender& contender, Work&& work) {
  const clockid_t clock = contender.threads == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
  const double start = nanoseconds(clock);
  work();
  return nanoseconds(clock) - start;
}

/// A preparation and a run; `trial` is nullptr afterwards where there is no such method.
Measurement measure_once(const Contender& contender, std::unique_ptr<Trial>& trial) {
  trial.reset();
  const double before = resident_bytes();
  const double preparation = duration(contender, [&] { trial = contender.prepare(); });
  if (!trial) return {};
  const double run = duration(contender, [&] { trial->run(); });
  const double vertices = trial->size().vertices;
  return {preparation / vertices, run / vertices, (peak_bytes() - before) / vertices,
          trial->size()};
}

Measurement measure_here(const Contender& contender, Manner manner) {
  if (manner == Manner::warm) {
    mallopt(M_MMAP_MAX, 0);         // all from the heap,
    mallopt(M_TRIM_THRESHOLD, -1);  // which never shrinks
    mallopt(M_ARENA_MAX, 1);
  }
  std::unique_ptr<Trial> trial;
  Measurement best = measure_once(contender, trial);
  if (!trial || manner == Manner::cold) return best;
  best.run = Measurement::kNever;  // the first run is not warm
  double spent = 0;
  for (int i = 0; i < kLeastRuns || (i < kMostRuns && spent < kNanoseconds); ++i) {
    const double vertices = best.size.vertices;
    const double run = manner == Manner::warm
                           ? measure_once(contender, trial).run
                           : duration(contender, [&] { trial->run(); }) / vertices;
    best.run = std::min(best.run, run);
    spent += run * vertices;
  }
  return best;
}

}  // namespace

void Measurement::keep_least(const Measurement& other) {
  preparation = std::min(preparation, other.preparation);
  run = std::min(run, other.run);
  bytes = std::min(bytes, other.bytes);
  size.vertices = std::max(size.vertices, other.size.vertices);
  size.corners = std::max(size.corners, other.size.corners);
}

Measurement measure(const Contender& contender, Manner manner) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    Measurement result;
    try {
      result = measure_here(contender, manner);
    } catch (const std::exception&) {
      _exit(1);
    }
    _exit(write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
  }
  close(ends[1]);
  Measurement result;
  if (read(ends[0], &result, sizeof result) != sizeof result) result = {};
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return result;
}

}  // namespace limn::peers
