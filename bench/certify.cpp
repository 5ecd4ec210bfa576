/// Certificates of C1: the search over the valences 3 … the last, and the check of what it found.

#include <benchmark/benchmark.h>

#include <numeric>

#include "limn/certify/certify.h"

namespace {

std::vector<int> valences(const benchmark::State& state) {
  std::vector<int> result(static_cast<std::size_t>(state.range(0) - 2));
  std::iota(result.begin(), result.end(), 3);
  return result;
}

void search(benchmark::State& state, const std::string& name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  for (auto _ : state)
    benchmark::DoNotOptimize(limn::certify::certify(scheme, valences(state)).value());
}

void check(benchmark::State& state, const std::string& name) {
  const limn::Scheme scheme = limn::find_scheme(name).value();
  const auto certificate = limn::certify::certify(scheme, valences(state)).value();
  for (auto _ : state)
    if (!limn::certify::check_certificate(certificate)) state.SkipWithError("refused");
}

[[maybe_unused]] const bool kRows = [] {
  for (const char* name : {"loop", "catmull-clark", "doo-sabin", "sqrt3", "butterfly-modified"}) {
    const auto declare = [name](const char* what, auto function) {
      benchmark::RegisterBenchmark((std::string(what) + "/" + name).c_str(), function, name)
          ->Arg(50)
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
    };
    declare("search", search);
    declare("check", check);
  }
  return true;
}();

}  // namespace

BENCHMARK_MAIN();
