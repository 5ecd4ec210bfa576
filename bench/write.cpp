// Mesh files: formatting and writing a mesh of 2.6 million vertices, beside the floor of writing as
// many bytes from the caches. The file is in the folder for temporary files, and removed again.

#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_refiner.h"
#include "limn/mesh/io/mesh_file.h"
#include "peers/control_meshes.h"

namespace limn {
namespace {

/// A file's path; the file is removed at the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& extension)
      : path_(
            (std::filesystem::temp_directory_path() / ("limn_bench_write." + extension)).string()) {
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

const Polygons& fine_mesh() {
  static const Polygons mesh = [] {
    const Polygons control = peers::random_sphere(4, 800, 12, 1);
    const Scheme loop = find_scheme("loop").value();
    return fast_refine(loop, Mesh::build(control).value(), control.positions, 5).value();
  }();
  return mesh;
}

void report(benchmark::State& state, std::uintmax_t bytes) {
  using benchmark::Counter;
  const double vertices = fine_mesh().vertex_count();
  state.counters["s/vertex"] =
      Counter(vertices, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["bytes/vertex"] = static_cast<double>(bytes) / vertices;
}

void write(benchmark::State& state, const std::string& extension, int threads) {
  const TemporaryFile file(extension);
  const Polygons& mesh = fine_mesh();
  set_thread_limit(threads);
  for (auto _ : state)
    if (const Status status = write_mesh(file.path(), mesh); !status)
      state.SkipWithError(status.error().text().c_str());
  set_thread_limit(0);
  report(state, std::filesystem::file_size(file.path()));
}

void write_floor(benchmark::State& state, std::size_t bytes) {
  const TemporaryFile file("bytes");
  const std::string piece(100000, 'x');
  for (auto _ : state) {
    const Status status = base::write_file(file.path(), [&](const base::Sink& sink) {
      for (std::size_t done = 0; done < bytes; done += piece.size()) sink(piece);
    });
    if (!status) state.SkipWithError(status.error().text().c_str());
  }
  report(state, bytes);
}

const bool kAdded = [] {
  const auto add = [](const std::string& name, auto body) {
    benchmark::RegisterBenchmark(name.c_str(), body)->UseRealTime()->Unit(benchmark::kMillisecond);
  };
  using State = benchmark::State;
  for (const std::string extension : {"ply", "stl", "glb", "obj", "off"})
    for (const int threads : {1, 0})
      add(fmt::format("write/{}/{}", extension, threads == 1 ? "one_thread" : "all_threads"),
          [=](State& state) { write(state, extension, threads); });
  add("write/floor/50_bytes_per_vertex", [](State& state) {
    write_floor(state, 50 * static_cast<std::size_t>(fine_mesh().vertex_count()));
  });
  return true;
}();

}  // namespace
}  // namespace limn
