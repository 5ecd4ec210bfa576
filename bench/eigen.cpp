/// Frequency blocks and eigenvalues for every valence up to a largest one, beside the dense spatial
/// matrix's eigenvalues at valences up to 24: how both grow.

#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>

#include "limn/refine/subdivision_matrix.h"
#include "limn/spectrum/eigencomponents.h"

namespace {

void blocks(benchmark::State& state, const std::string& name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  for (auto _ : state) {
    limn::FrequencyAnalysis analysis(scheme);
    for (int n = 3; n <= state.range(0); ++n)
      benchmark::DoNotOptimize(limn::approx_eigencomponents(analysis.blocks(n).value()));
  }
}

/// The plain way: the matrix of all vertices of as many rings, all its eigenvalues at once.
void dense(benchmark::State& state, const std::string& name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  const int rings = limn::FrequencyAnalysis(scheme).blocks(5).value().rings;
  for (auto _ : state)
    for (int n = 3; n <= state.range(0); ++n) {
      const auto matrix = limn::refine::subdivision_matrix<double>(scheme, n, rings).value();
      Eigen::MatrixXd entries(matrix.size, matrix.size);
      for (int i = 0; i < matrix.size; ++i)
        for (int j = 0; j < matrix.size; ++j) entries(i, j) = matrix(i, j);
      benchmark::DoNotOptimize(entries.eigenvalues().eval());
    }
}

/// Rows for every shipped scheme that has rules.
[[maybe_unused]] const bool kRows = [] {
  for (const std::string& name : limn::shipped_schemes()) {
    const limn::Scheme scheme = limn::find_scheme(name).value();
    if (scheme.mask || scheme.factors || scheme.split->mixed) continue;
    benchmark::RegisterBenchmark(("blocks/" + name).c_str(), blocks, name)
        ->Arg(24)
        ->Arg(200)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("dense/" + name).c_str(), dense, name)
        ->Arg(12)
        ->Arg(24)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
