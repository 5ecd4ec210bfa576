#include "limn/regular/symbol.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace limn {
namespace {

constexpr double kPi = std::numbers::pi;
const double kHalfRoot3 = std::sqrt(3.0) / 2;

}  // namespace

std::array<double, 2> cartesian(Lattice lattice, std::array<double, 2> x) {
  if (lattice == Lattice::quad) return x;
  return {x[0] - x[1] / 2, kHalfRoot3 * x[1]};
}

Phase control_phase(Lattice lattice, Frequency f) {
  const auto [fx, fy] = f;
  if (lattice == Lattice::quad) return {2 * kPi * fx, 2 * kPi * fy};
  return {2 * kPi * fx, 2 * kPi * (kHalfRoot3 * fy - fx / 2)};
}

Frequency frequency_of_phase(Lattice lattice, Phase t) {
  const double x = t[0] / (2 * kPi);
  const double y = t[1] / (2 * kPi);
  if (lattice == Lattice::quad) return {x, y};
  return {x, (y + x / 2) / kHalfRoot3};
}

std::vector<Frequency> nyquist_region(Lattice lattice) {
  if (lattice == Lattice::quad) return {{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}};
  const double height = 0.5 / kHalfRoot3;
  return {{2.0 / 3, 0},  {1.0 / 3, height},   {-1.0 / 3, height},
          {-2.0 / 3, 0}, {-1.0 / 3, -height}, {1.0 / 3, -height}};
}

double nyquist_distance(Lattice lattice, double degrees) {
  const double angle = degrees * kPi / 180;
  double nearest = 0;
  const std::vector<Frequency> corners = nyquist_region(lattice);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Frequency& a = corners[i];
    const Frequency& b = corners[(i + 1) % corners.size()];
    const Frequency middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    // the side's line is {f : f·middle = |middle|²}
    const double along = std::cos(angle) * middle[0] + std::sin(angle) * middle[1];
    nearest = std::max(nearest, along / (middle[0] * middle[0] + middle[1] * middle[1]));
  }
  return 1 / nearest;
}

Symbol::Symbol(const Laurent& doubled, double scale) {
  for (const auto& [k, value] : doubled) {
    if (k < LatticeVector{0, 0}) continue;
    const double weight = to_double(value) * scale;
    terms_.push_back({{k[0] / 2.0, k[1] / 2.0}, k == LatticeVector{0, 0} ? weight : 2 * weight});
  }
}

Symbol::Symbol(const std::vector<Term>& all) {
  for (const Term& term : all)
    if (term.k >= std::array<double, 2>{0, 0})
      terms_.push_back(
          {term.k, term.k == std::array<double, 2>{0, 0} ? term.weight : 2 * term.weight});
}

double Symbol::operator()(Phase theta) const {
  double sum = 0;
  for (const Term& term : terms_)
    sum += term.weight * std::cos(term.k[0] * theta[0] + term.k[1] * theta[1]);
  return sum;
}

Symbol product(const Symbol& a, const Symbol& b) {
  // cos x cos y = (cos(x+y) + cos(x-y))/2, and both are even
  std::map<std::array<double, 2>, double> sums;
  for (const Symbol::Term& p : a.terms())
    for (const Symbol::Term& q : b.terms())
      for (const double sign : {1.0, -1.0}) {
        const std::array<double, 2> k{p.k[0] + sign * q.k[0], p.k[1] + sign * q.k[1]};
        sums[k] += p.weight * q.weight / 4;
        sums[{-k[0], -k[1]}] += p.weight * q.weight / 4;
      }
  std::vector<Symbol::Term> all;
  all.reserve(sums.size());
  for (const auto& [k, weight] : sums) all.push_back({k, weight});
  return Symbol(all);
}

bool is_point_symmetric(const Laurent& a) { return reflected(a) == a; }

}  // namespace limn
