/// Artifact maps: the row-separable evaluation beside the plain one, point by point and cosine by
/// cosine, over the same 512 × 512 frequencies, one thread.

#include <cmath>

#include <benchmark/benchmark.h>

#include "limn/regular/artifact_map.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"

namespace {

constexpr int kSide = 512;

limn::ArtifactAnalysis analysis_of(const char* name) {
  return limn::ArtifactAnalysis::of(limn::regular_mask(limn::find_scheme(name).value()).value())
      .value();
}

void map(benchmark::State& state, const char* name) {
  const limn::ArtifactAnalysis analysis = analysis_of(name);
  const limn::regular::FrequencyGrid grid =
      limn::regular::nyquist_grid(analysis.mask().lattice, kSide, kSide);
  for (auto _ : state) benchmark::DoNotOptimize(limn::regular::limit_map(analysis, grid));
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}

/// Each component at each frequency: its phases, and a cosine for each term of the two symbols.
void plain(benchmark::State& state, const char* name) {
  const limn::ArtifactAnalysis analysis = analysis_of(name);
  const limn::Mask& mask = analysis.mask();
  const limn::regular::FrequencyGrid grid = limn::regular::nyquist_grid(mask.lattice, kSide, kSide);
  const double turn = 2 * std::acos(-1.0);
  for (auto _ : state)
    for (const limn::LatticeVector kappa : limn::dual_cosets(mask.dilation))
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
          limn::Phase t =
              limn::control_phase(mask.lattice, {grid.x0 + i * grid.dx, grid.y0 + j * grid.dy});
          t = {t[0] + turn * kappa[0], t[1] + turn * kappa[1]};
          const limn::Phase theta = mask.dilation.refined_phase(t);
          benchmark::DoNotOptimize(analysis.symbol()(theta) * analysis.limit_symbol()(theta));
        }
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}

void whole_analysis(benchmark::State& state, const char* name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  for (auto _ : state)
    benchmark::DoNotOptimize(limn::ArtifactAnalysis::of(limn::regular_mask(scheme).value()));
}

void density(benchmark::State& state, const char* name) {
  const limn::ArtifactAnalysis analysis = analysis_of(name);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        limn::sampling_density(analysis, 1, limn::ArtifactMeasure::total_energy));
}

#define LIMN_ROWS(function, unit)                                                    \
  BENCHMARK_CAPTURE(function, loop, "loop")->Unit(unit);                             \
  BENCHMARK_CAPTURE(function, butterfly, "butterfly")->Unit(unit);                   \
  BENCHMARK_CAPTURE(function, interpolating_loop, "interpolating-loop")->Unit(unit); \
  BENCHMARK_CAPTURE(function, sqrt3, "sqrt3")->Unit(unit);                           \
  BENCHMARK_CAPTURE(function, catmull_clark, "catmull-clark")->Unit(unit);           \
  BENCHMARK_CAPTURE(function, laplacian_butterfly, "laplacian-butterfly")->Unit(unit)

LIMN_ROWS(map, benchmark::kMillisecond);
LIMN_ROWS(plain, benchmark::kMillisecond);
LIMN_ROWS(whole_analysis, benchmark::kMillisecond);
LIMN_ROWS(density, benchmark::kMillisecond);

}  // namespace
