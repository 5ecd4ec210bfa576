#include "limn/regular/regular_mask.h"

#include <algorithm>
#include <numeric>

#include "limn/scheme/mask_rules.h"

namespace limn {
namespace {

constexpr int kFarthest = 2;  // coordinates of the directions that are tried

/// The lattice's edges first, one of each pair ±step, no multiples of shorter ones.
std::vector<LatticeVector> directions_to_try(Lattice lattice) {
  std::vector<LatticeVector> steps = edge_directions(lattice);
  for (int x = 0; x <= kFarthest; ++x)
    for (int y = -kFarthest; y <= kFarthest; ++y) {
      const LatticeVector step{x, y};
      if (step > LatticeVector{0, 0} && std::gcd(x, y) == 1 &&
          std::find(steps.begin(), steps.end(), step) == steps.end())
        steps.push_back(step);
    }
  return steps;
}

}  // namespace

Factorization factor(const Mask& mask) {
  const int box = arity(mask.dilation);
  Laurent rest = scaled(mask.coefficients, Rational(1, mask.dilation.growth()));
  Factorization factors;
  for (const LatticeVector step : directions_to_try(mask.lattice)) {
    int count = 0;
    while (std::optional<Laurent> quotient = divided_by_box(rest, step, box)) {
      rest = scaled(*quotient, Rational(box));
      ++count;
    }
    if (count > 0) factors.directions.emplace_back(step, count);
  }
  const auto count_of = [&](LatticeVector step) {
    for (const auto& [known, count] : factors.directions)
      if (known == step) return count;
    return 0;
  };
  const std::vector<LatticeVector> edges = edge_directions(mask.lattice);
  factors.stages = count_of(edges.front());
  for (const LatticeVector step : edges) factors.stages = std::min(factors.stages, count_of(step));
  for (auto& [step, count] : factors.directions)
    if (std::find(edges.begin(), edges.end(), step) != edges.end()) count -= factors.stages;
  auto& list = factors.directions;
  list.erase(std::remove_if(list.begin(), list.end(), [](const auto& d) { return d.second == 0; }),
             list.end());
  factors.kernel = std::move(rest);
  return factors;
}

Laurent expand(const Factorization& factors, const Mask& shape) {
  Laurent result = scaled(factors.kernel, Rational(shape.dilation.growth()));
  const Laurent stage = smoothing_stage(shape.lattice, shape.dilation);
  for (int i = 0; i < factors.stages; ++i) result = product(result, stage);
  for (const auto& [step, count] : factors.directions)
    for (int i = 0; i < count; ++i)
      result = product(result, scheme::smoothing_direction(step, shape.dilation));
  return result;
}

Laurent smoothing_stage(Lattice lattice, const LatticeMatrix& dilation) {
  Laurent stage{{{0, 0}, Rational(1)}};
  for (const LatticeVector step : edge_directions(lattice))
    stage = product(stage, scheme::smoothing_direction(step, dilation));
  return stage;
}

}  // namespace limn
