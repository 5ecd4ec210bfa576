// The fast engine: a control mesh refined to the end (topology, positions, faces), and positions
// evaluated again for one topology; ns per output vertex, beside what writing the same bytes
// takes. Memory is kept between runs, but in the rows that say cold.

#include <benchmark/benchmark.h>

#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "limn/base/huge_array.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_refiner.h"
#include "peers/control_meshes.h"

namespace limn {
namespace {

using Schemes = std::vector<const char*>;

struct Job {
  Scheme scheme;
  Mesh mesh;
  std::vector<float> positions;
  int levels = 0;
  Sharpness sharpness = {};

  [[nodiscard]] Result<FastRefiner> refiner() const {
    return FastRefiner::make(scheme, mesh, levels, sharpness);
  }
};

/// Some 5 % of the edges sharp, a fifth of them for ever, the others by 0.5, 1, … 4.
Sharpness some_sharp(const Mesh& mesh) {
  std::mt19937 random(1);
  Sharpness sharpness;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const bool sharp = random() % 20 == 0, stays = random() % 5 == 0;
    const double value = stays ? kInfinitelySharp : 0.5 * static_cast<double>(1 + random() % 8);
    sharpness.edges.push_back(sharp ? value : 0);
  }
  return sharpness;
}

struct Output {
  base::HugeArray<float> positions;
  base::HugeArray<Index> corners;

  explicit Output(const FastRefiner& refiner)
      : positions(3 * static_cast<std::size_t>(refiner.vertex_count())),
        corners(static_cast<std::size_t>(refiner.corner_count())) {}
};

void report(benchmark::State& state, const FastRefiner& refiner) {
  using benchmark::Counter;
  const double vertices = refiner.vertex_count();
  state.counters["vertices"] = vertices;
  state.counters["s/vertex"] =
      Counter(vertices, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["held_bytes/vertex"] = static_cast<double>(refiner.bytes()) / vertices;
}

/// The floor: the bytes of the result, written once.
void write_bytes(benchmark::State& state, const Job& job, bool faces) {
  const FastRefiner refiner = job.refiner().value();
  Output output(refiner);
  for (auto _ : state) {
    std::memset(output.positions.data(), 1, output.positions.size() * sizeof(float));
    if (faces) std::memset(output.corners.data(), 1, output.corners.size() * sizeof(Index));
    benchmark::ClobberMemory();
  }
  report(state, refiner);
}

void refine_fully(benchmark::State& state, const Job& job, int threads, bool cold) {
  set_thread_limit(threads);
  const FastRefiner first = job.refiner().value();
  auto output = std::make_unique<Output>(first);
  FastRefiner::Scratch<float> scratch;
  for (auto _ : state) {
    if (cold) {
      output = std::make_unique<Output>(first);
      scratch = {};
    }
    const FastRefiner refiner = job.refiner().value();
    refiner.evaluate<float>(job.positions, output->positions, scratch);
    refiner.write_faces(output->corners);
    benchmark::ClobberMemory();
  }
  set_thread_limit(0);
  report(state, first);
}

void evaluate_again(benchmark::State& state, const Job& job, int threads) {
  set_thread_limit(threads);
  const FastRefiner refiner = job.refiner().value();
  Output output(refiner);
  FastRefiner::Scratch<float> scratch;
  for (auto _ : state) {
    refiner.evaluate<float>(job.positions, output.positions, scratch);
    benchmark::ClobberMemory();
  }
  set_thread_limit(0);
  report(state, refiner);
}

/// Limit positions and unit normals, the topology being known.
void evaluate_limit(benchmark::State& state, const Job& job, int threads) {
  set_thread_limit(threads);
  const FastRefiner refiner = job.refiner().value();
  const auto limit = approx_fast_limit(job.scheme, refiner).value();
  if (!limit) return state.SkipWithError("no quick limit");
  Output output(refiner);
  base::HugeArray<float> normals(output.positions.size());
  FastRefiner::Scratch<float> scratch;
  for (auto _ : state) {
    refiner.evaluate_limit<float>(*limit, job.positions, output.positions, normals, scratch);
    benchmark::ClobberMemory();
  }
  set_thread_limit(0);
  report(state, refiner);
}

void add(const std::string& mesh_name, const Polygons& control, int levels,
         const Schemes& schemes) {
  const auto row = [&](const std::string& what, auto body) {
    benchmark::RegisterBenchmark(fmt::format("{}/level:{}/{}", mesh_name, levels, what).c_str(),
                                 body)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  for (const char* name : schemes) {
    const auto job = std::make_shared<Job>();
    job->scheme = find_scheme(name).value();
    job->mesh = Mesh::build(control).value();
    job->levels = levels;
    for (const Point3& p : control.positions)
      for (const double c : {p.x, p.y, p.z}) job->positions.push_back(static_cast<float>(c));
    using State = benchmark::State;
    for (const int threads : {1, 0}) {
      const std::string on =
          fmt::format("{}/{}", name, threads == 1 ? "one_thread" : "all_threads");
      row(on + "/full", [=](State& state) { refine_fully(state, *job, threads, false); });
      row(on + "/again", [=](State& state) { evaluate_again(state, *job, threads); });
      row(on + "/limit", [=](State& state) { evaluate_limit(state, *job, threads); });
    }
    row(fmt::format("{}/one_thread/full_cold", name),
        [=](State& state) { refine_fully(state, *job, 1, true); });
    const auto creased = std::make_shared<Job>(*job);
    creased->sharpness = some_sharp(job->mesh);
    if (creased->refiner()) {
      const std::string on = fmt::format("{}/one_thread", name);
      row(on + "/sharp", [=](State& state) { refine_fully(state, *creased, 1, false); });
      row(on + "/sharp_again", [=](State& state) { evaluate_again(state, *creased, 1); });
    }
    if (name != schemes.front()) continue;
    row("floor/full", [=](State& state) { write_bytes(state, *job, true); });
    row("floor/again", [=](State& state) { write_bytes(state, *job, false); });
  }
}

const bool kAdded = [] {
  constexpr unsigned kSeed = 1;
  const Schemes triangles{"loop", "butterfly-modified", "laplacian-butterfly"};
  const Schemes quads{"catmull-clark", "doo-sabin"};
  const Schemes sqrt3{"sqrt3"};
  const Polygons sphere = peers::random_sphere(4, 800, 12, kSeed);
  add("sphere-2562", sphere, 5, triangles);
  const Polygons large = peers::random_sphere(6, 12800, 12, kSeed);
  add("sphere-40962", large, 3, triangles);
  add("sphere-2562", sphere, 6, sqrt3);
  add("sphere-40962", large, 4, sqrt3);
  add("quads-3842", peers::cut_into_quads(peers::random_sphere(3, 200, 12, kSeed)), 5, quads);
  add("quads-61442", peers::cut_into_quads(peers::random_sphere(5, 3200, 12, kSeed)), 3, quads);
  add("sphere-2562", sphere, 5, {"catmull-clark"});  // the first step is the plain engine's
  return true;
}();

}  // namespace
}  // namespace limn
