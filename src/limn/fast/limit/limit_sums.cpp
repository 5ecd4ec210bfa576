#include "limn/fast/limit/limit_sums.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace limn::fast {
namespace {

using Form = refine::LinearForm<double>;

double largest_of(const Form& form) {
  double largest = 0;
  for (const auto& [vertex, weight] : form.terms) largest = std::max(largest, std::abs(weight));
  return largest;
}

/// Less of a weight comes from the eigenvectors' rounding.
double unit_of(double largest) { return std::ldexp(largest, -42); }

double product(const Form& a, const Form& b) {
  double sum = 0;
  for (const auto& [vertex, weight] : a.terms) sum += weight * b.coefficient(vertex);
  return sum;
}

}  // namespace

void drop_rounding(Form& form) {
  const double least = unit_of(largest_of(form));
  std::erase_if(form.terms, [&](const auto& term) { return std::abs(term.second) <= least; });
}

Stencil rounded_stencil(const std::vector<Offset>& places, std::vector<double> weights) {
  double largest = 0;
  for (const double w : weights) largest = std::max(largest, std::abs(w));
  const double unit = unit_of(largest);
  // weights that are alike get their mean, so that rounding moves no sum
  std::map<double, std::pair<double, int>> alike;  // by size in units: sum and number
  const auto size_of = [&](double weight) { return std::round(std::abs(weight) / unit); };
  for (const double w : weights) {
    auto& [sum, count] = alike[size_of(w)];
    sum += std::abs(w);
    ++count;
  }
  Stencil stencil;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (std::abs(weights[i]) <= unit) continue;
    const auto& [sum, count] = alike[size_of(weights[i])];
    stencil.push_back({places[i], std::copysign(sum / count, weights[i])});
  }
  std::sort(stencil.begin(), stencil.end(),
            [](const Tap& p, const Tap& q) { return p.place < q.place; });
  return stencil;
}

bool same_limit(std::span<const Form> a, std::span<const Form> b) {
  constexpr double kSame = 1e-10;
  const auto differ = [](Form form, double weight, const Form& other) {
    refine::add_scaled(form, -weight, other);
    return form;
  };
  if (largest_of(differ(a[0], 1, b[0])) > kSame) return false;
  // b's tangents as sums of a's
  const double uu = product(a[1], a[1]), uv = product(a[1], a[2]), vv = product(a[2], a[2]);
  const double det = uu * vv - uv * uv;
  if (!(det > kSame * uu * vv)) return false;
  std::array<std::array<double, 2>, 2> map{};
  for (const std::size_t i : {0, 1}) {
    const Form& t = b[i + 1];
    const double u = product(t, a[1]), v = product(t, a[2]);
    map[i] = {(u * vv - v * uv) / det, (v * uu - u * uv) / det};
    const Form rest = differ(differ(t, map[i][0], a[1]), map[i][1], a[2]);
    if (largest_of(rest) > 10 * kSame * largest_of(t)) return false;
  }
  return map[0][0] * map[1][1] > map[0][1] * map[1][0];
}

std::pair<RowTable, std::vector<Offset>> limit_rows(const LimitStencils& stencils) {
  std::vector<Offset> places;
  for (const Stencil& stencil : stencils)
    for (const Tap& tap : stencil) places.push_back(tap.place);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  RowTable rows;
  rows.sources = static_cast<int>(places.size());
  for (const Stencil& stencil : stencils) {
    for (const Tap& tap : stencil) {
      const auto at = std::lower_bound(places.begin(), places.end(), tap.place);
      rows.terms.push_back({static_cast<int>(at - places.begin()), tap.weight});
    }
    rows.row_begin.push_back(static_cast<int>(rows.terms.size()));
  }
  return {std::move(rows), std::move(places)};
}

RowTable isolated_limit_rows() { return {1, {0, 1, 1, 1}, {{0, 1.0}}}; }

}  // namespace limn::fast
