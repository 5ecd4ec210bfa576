/// Frequency blocks and eigenvalues for every valence up to a largest one, beside the dense spatial
/// matrix's eigenvalues at valences up to 24: how both grow.

#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>

#include "limn/extraordinary/eigencomponents.h"
#include "limn/refine/subdivision_matrix.h"

namespace {

void blocks(benchmark::State& state, const char* name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  for (auto _ : state) {
    limn::FrequencyAnalysis analysis(scheme);
    for (int n = 3; n <= state.range(0); ++n)
      benchmark::DoNotOptimize(limn::approx_eigencomponents(analysis.blocks(n).value()));
  }
}

/// The plain way: the matrix of all vertices of as many rings, all its eigenvalues at once.
void dense(benchmark::State& state, const char* name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  const int rings = limn::FrequencyAnalysis(scheme).blocks(5).value().rings;
  for (auto _ : state)
    for (int n = 3; n <= state.range(0); ++n) {
      const auto matrix = limn::subdivision_matrix<double>(scheme, n, rings).value();
      Eigen::MatrixXd entries(matrix.size, matrix.size);
      for (int i = 0; i < matrix.size; ++i)
        for (int j = 0; j < matrix.size; ++j) entries(i, j) = matrix(i, j);
      benchmark::DoNotOptimize(entries.eigenvalues().eval());
    }
}

#define LIMN_ROWS(name, title)                                                              \
  BENCHMARK_CAPTURE(blocks, name, title)->Arg(24)->Arg(200)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(dense, name, title)->Arg(12)->Arg(24)->Unit(benchmark::kMillisecond)

LIMN_ROWS(loop, "loop");
LIMN_ROWS(sqrt3, "sqrt3");
LIMN_ROWS(catmull_clark, "catmull-clark");
LIMN_ROWS(doo_sabin, "doo-sabin");
LIMN_ROWS(butterfly, "butterfly");
LIMN_ROWS(butterfly_modified, "butterfly-modified");
LIMN_ROWS(laplacian_butterfly, "laplacian-butterfly");

}  // namespace
