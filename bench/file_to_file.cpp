// File to file: `limn refine` as a whole process, from a mesh file to a PLY file, beside `cp` of
// what it wrote. Both take turns; the counters have the least times of each, and the most memory
// that was resident. The files are in the folder for temporary files, and removed again.

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "limn/mesh/io/mesh_file.h"
#include "peers/control_meshes.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() / fmt::format("limn_bench_file_{}", ::getpid())) {
    fs::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// What processes took.
struct Taken {
  double seconds = std::numeric_limits<double>::infinity();
  double processor_seconds = std::numeric_limits<double>::infinity();
  double peak_bytes = 0;
  bool ok = true;

  void add(const Taken& other) {
    seconds = std::min(seconds, other.seconds);
    processor_seconds = std::min(processor_seconds, other.processor_seconds);
    peak_bytes = std::max(peak_bytes, other.peak_bytes);
    ok = ok && other.ok;
  }
};

Taken run(std::vector<std::string> arguments) {
  std::vector<char*> list;
  for (std::string& argument : arguments) list.push_back(argument.data());
  list.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(127);  // no report
    ::execvp(list[0], list.data());
    ::_exit(127);
  }
  int status = 0;
  struct rusage usage {};
  ::wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {passed.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime),
          1024.0 * static_cast<double>(usage.ru_maxrss),
          WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

struct Job {
  std::string name;
  Polygons control;
  std::vector<std::string> arguments;
};

void file_to_file(benchmark::State& state, const Job& job) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.ply", out = folder / "out.ply", copy = folder / "copy.ply";
  if (const Status status = write_mesh(in, job.control); !status)
    return state.SkipWithError(status.error().text().c_str());
  std::vector<std::string> refine{LIMN_COMMAND, "--quiet", "refine", in, "-o", out};
  refine.insert(refine.end(), job.arguments.begin(), job.arguments.end());
  Taken refining, copying;
  for (auto _ : state) {
    std::error_code ignored;
    fs::remove(out, ignored);
    const Taken once = run(refine);
    refining.add(once);
    fs::remove(copy, ignored);
    copying.add(run({"cp", out, copy}));
    state.SetIterationTime(once.seconds);
  }
  if (!refining.ok || !copying.ok) return state.SkipWithError("a process failed");
  const auto bytes = static_cast<double>(fs::file_size(out));
  state.counters["file_MB"] = bytes / 1e6;
  state.counters["least_ms"] = 1e3 * refining.seconds;
  state.counters["processor_ms"] = 1e3 * refining.processor_seconds;
  state.counters["cp_ms"] = 1e3 * copying.seconds;
  state.counters["cp_processor_ms"] = 1e3 * copying.processor_seconds;
  state.counters["times_cp"] = refining.seconds / copying.seconds;
  state.counters["peak_MB"] = refining.peak_bytes / 1e6;
  state.counters["peak/file"] = refining.peak_bytes / bytes;
}

const bool kAdded = [] {
  constexpr unsigned kSeed = 1;
  const Polygons sphere = peers::random_sphere(4, 800, 12, kSeed);
  const Polygons large = peers::random_sphere(6, 12800, 12, kSeed);
  const Polygons quads = peers::cut_into_quads(peers::random_sphere(3, 200, 12, kSeed));
  using Words = std::vector<std::string>;
  const auto add = [](const std::string& mesh, const Polygons& control, const char* scheme,
                      const char* levels, const Words& more) {
    std::string name = fmt::format("file_to_file/{}/{}/level:{}", mesh, scheme, levels);
    Words arguments{"-s", scheme, "-n", levels};
    for (const std::string& word : more) {
      name += "/" + word.substr(2);
      arguments.push_back(word);
    }
    const Job job{name, control, arguments};
    benchmark::RegisterBenchmark(name.c_str(),
                                 [job](benchmark::State& state) { file_to_file(state, job); })
        ->UseManualTime()
        ->Iterations(7)
        ->Unit(benchmark::kMillisecond);
  };
  add("sphere-2562", sphere, "loop", "5", {});
  add("sphere-2562", sphere, "loop", "6", {});
  add("sphere-40962", large, "loop", "3", {});
  add("sphere-2562", sphere, "sqrt3", "6", {});
  add("quads-3842", quads, "catmull-clark", "5", {});
  add("quads-3842", quads, "doo-sabin", "5", {});
  add("sphere-2562", sphere, "loop", "5", {"--limit", "--normals"});
  return true;
}();

}  // namespace
}  // namespace limn
