#include "limn/regular/difference_norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/regular/rounding.h"
#include "limn/regular/symmetric_hull.h"
#include "limn/regular/transition_operators.h"

namespace limn {
namespace {

constexpr double kMostWork = 4e7;  // sequences times the square of their size
constexpr std::ptrdiff_t kGrain = 8;

/// A sequence moved so that its least coordinates are 0, and signed so that its first value is
/// positive: neither changes the norm.
Laurent standard(const Laurent& v) {
  if (v.empty()) return v;
  int low = v.begin()->first[1];
  for (const auto& [k, value] : v) low = std::min(low, k[1]);
  const Rational sign = v.begin()->second < 0 ? -1 : 1;
  Laurent result;
  for (const auto& [k, value] : v) result[{k[0] - v.begin()->first[0], k[1] - low}] = sign * value;
  return result;
}

/// The differences that make up the ball, as vectors in a box of points. Sequences orthogonal to
/// polynomials of degree < order are known without their values at a triangle of points.
class Box {
 public:
  Box(Lattice lattice, int order, LatticeVector size) : order_(order), size_(size), hull_(rows()) {
    for (const Laurent& difference : unit_differences(edge_directions(lattice), order)) {
      const Laurent atom = standard(difference);
      for (int x = 0; x < size_[0]; ++x)
        for (int y = 0; y < size_[1]; ++y) add(atom, {x, y});
    }
    if (!hull_.spans()) return;
    axis_norms_ = hull_.axis_norms();
    start_ = hull_.start_at(hull_.first_basis());
  }

  /// The norm of a sequence in the box, rounded up.
  [[nodiscard]] double norm(const Laurent& v) const {
    if (!hull_.spans()) return std::numeric_limits<double>::infinity();
    const Eigen::VectorXd u = coordinates(v, {0, 0});
    const SymmetricHull::Combination found = hull_.least_combination(u, start_, 0);
    const Eigen::VectorXd slack = u.cwiseAbs() * rounding_error(2);
    return inflated(found.norm + hull_.residual_bound(u, slack, found).dot(axis_norms_));
  }

 private:
  [[nodiscard]] Eigen::Index rows() const {
    return size_[0] * size_[1] - order_ * (order_ + 1) / 2;
  }
  void add(const Laurent& atom, LatticeVector at) {
    for (const auto& [k, value] : atom)
      if (k[0] + at[0] >= size_[0] || k[1] + at[1] >= size_[1]) return;
    hull_.add(coordinates(atom, at));
  }
  [[nodiscard]] Eigen::VectorXd coordinates(const Laurent& v, LatticeVector at) const {
    Eigen::VectorXd result(rows());
    Eigen::Index row = 0;
    for (int x = 0; x < size_[0]; ++x)
      for (int y = 0; y < size_[1]; ++y) {
        if (x + y < order_) continue;
        const auto entry = v.find({x - at[0], y - at[1]});
        result(row++) = entry == v.end() ? 0 : to_double(entry->second);
      }
    return result;
  }

  int order_;
  LatticeVector size_;
  SymmetricHull hull_;
  Eigen::VectorXd axis_norms_;
  SymmetricHull::Start start_;
};

LatticeVector size_of(const std::set<Laurent>& sequences, int order) {
  LatticeVector size{order + 1, order + 1};
  for (const Laurent& v : sequences)
    for (const auto& [k, value] : v)
      size = {std::max(size[0], k[0] + 1), std::max(size[1], k[1] + 1)};
  return size;
}

}  // namespace

std::vector<double> difference_norms(const Mask& mask, int order, int most_steps, double enough,
                                     const Stop& stop) {
  const Laurent a = integer_offsets(mask);
  const std::vector<LatticeVector> digits = cosets(mask.dilation);
  std::set<Laurent> sequences;
  for (const Laurent& v : unit_differences(edge_directions(mask.lattice), order))
    sequences.insert(standard(v));
  std::vector<double> norms;
  for (int k = 1; k <= most_steps; ++k) {
    std::set<Laurent> next;
    for (const Laurent& v : sequences)
      for (const LatticeVector digit : digits) {
        if (asked(stop)) return norms;
        next.insert(standard(transition(a, mask.dilation, digit, v)));
      }
    next.erase(Laurent{});
    sequences = std::move(next);
    const LatticeVector size = size_of(sequences, order);
    const double points = static_cast<double>(size[0]) * size[1];
    if (static_cast<double>(sequences.size()) * points * points > kMostWork) break;
    const Box box(mask.lattice, order, size);
    const std::vector<Laurent> list(sequences.begin(), sequences.end());
    std::vector<double> each(list.size(), 0);
    parallel_for(
        std::size_t{0}, list.size(),
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last && !asked(stop); ++i) each[i] = box.norm(list[i]);
        },
        kGrain);
    if (asked(stop)) break;
    norms.push_back(each.empty() ? 0 : *std::max_element(each.begin(), each.end()));
    if (norms.back() < std::pow(enough, k)) break;
  }
  return norms;
}

}  // namespace limn
