#include "limn/regular/smoothness/box_spline.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>

#include <fmt/core.h>

#include "limn/regular/regular_mask.h"

namespace limn::regular {
namespace {

/// The shortest of the parallel vectors, of the two the one that is greater.
LatticeVector line_of(LatticeVector k) {
  const int length = std::gcd(k[0], k[1]);
  const LatticeVector step{k[0] / length, k[1] / length};
  return std::max(step, LatticeVector{-step[0], -step[1]});
}

using Counts = std::map<LatticeVector, int>;  // by line

Counts counts_of(const Factorization& factors, Lattice lattice) {
  Counts counts;
  for (const LatticeVector step : edge_directions(lattice))
    if (factors.stages > 0) counts[line_of(step)] += factors.stages;
  for (const auto& [step, count] : factors.directions) counts[line_of(step)] += count;
  return counts;
}

/// The directions a step later.
Counts carried(const Counts& counts, const LatticeMatrix& dilation) {
  Counts images;
  for (const auto& [step, count] : counts) images[line_of(dilation.apply(step))] += count;
  return images;
}

/// The least p ≤ 2 for which p steps stretch by arity(M), turns and mirrors apart.
int steps_of_a_cycle(const LatticeMatrix& dilation) {
  const int q = arity(dilation), growth = dilation.growth();
  if (growth == q * q) return 1;
  return growth == q ? 2 : 0;
}

}  // namespace

std::string BoxSpline::text() const {
  return fmt::format("φ is the box spline of {} directions, of which {} are parallel", directions,
                     parallel);
}

std::optional<BoxSpline> find_box_spline(const Mask& mask) {
  const int steps = steps_of_a_cycle(mask.dilation);
  const Factorization factors = factor(mask);
  if (steps == 0 || factors.kernel != Laurent{{{0, 0}, Rational(1)}}) return std::nullopt;
  const Counts own = counts_of(factors, mask.lattice);
  Counts all, level = own;
  for (int i = 0; i < steps; ++i) {
    for (const auto& [step, count] : level) all[step] += count;
    level = carried(level, mask.dilation);
  }
  if (level != own || all.size() < 2) return std::nullopt;
  BoxSpline spline;
  for (const auto& [step, count] : all) {
    spline.directions += count;
    spline.parallel = std::max(spline.parallel, count);
  }
  return spline;
}

}  // namespace limn::regular
