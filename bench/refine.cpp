// Full refinement: a control mesh of about 3000 vertices to levels 3 … 5, ns per output vertex,
// on one thread and on all. LIMN_BENCH_MESH=FILE adds that mesh.

#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/refine/refine.h"
#include "peers/control_meshes.h"

namespace limn {
namespace {

constexpr std::array kSchemes{"loop", "catmull-clark", "sqrt3", "doo-sabin", "butterfly-modified"};

struct Job {
  Scheme scheme;
  Mesh mesh;
  std::vector<Point3> positions;
};

void run(benchmark::State& state, const Job& job, int level, int threads) {
  set_thread_limit(threads);
  double vertices = 0;
  for (auto _ : state) {
    const auto result = refine::refine(job.scheme, job.mesh, job.positions, level);
    if (!result) return state.SkipWithError(result.error().text().c_str());
    vertices = result->mesh.vertex_count();
  }
  set_thread_limit(0);
  using benchmark::Counter;
  state.counters["vertices"] = vertices;
  state.counters["s/vertex"] =
      Counter(vertices, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void add(const std::string& mesh_name, const Polygons& triangles, const Polygons& polygons) {
  for (const char* name : kSchemes) {
    Scheme scheme = find_scheme(name).value();
    const Polygons& control = scheme.split->any_polygons ? polygons : triangles;
    const auto job = std::make_shared<const Job>(
        Job{std::move(scheme), Mesh::build(control).value(), control.positions});
    for (int level = 3; level <= 5; ++level)
      for (const int threads : {1, 0})
        benchmark::RegisterBenchmark(
            fmt::format("{}/{}/level:{}/{}", mesh_name, name, level,
                        threads == 1 ? "one_thread" : "all_threads")
                .c_str(),
            [=](benchmark::State& state) { run(state, *job, level, threads); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
  }
}

const bool kAdded = [] {
  constexpr unsigned kSeed = 1;
  add("sphere", peers::random_sphere(4, 800, 12, kSeed),
      peers::cut_into_quads(peers::random_sphere(3, 200, 12, kSeed)));
  if (const char* path = std::getenv("LIMN_BENCH_MESH")) {
    const Result<Polygons> mesh = read_mesh(path);
    if (mesh) {
      add("file", triangulated(*mesh), *mesh);
    } else {
      fmt::print(stderr, "{}\n", mesh.error().text());
    }
  }
  return true;
}();

}  // namespace
}  // namespace limn
