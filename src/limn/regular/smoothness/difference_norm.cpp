#include "limn/regular/smoothness/difference_norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/regular/algebra/echelon.h"
#include "limn/regular/smoothness/exact_radius.h"
#include "limn/regular/smoothness/rounding.h"
#include "limn/regular/smoothness/symmetric_hull.h"
#include "limn/regular/smoothness/transition_operators.h"

namespace limn::regular {
namespace {

constexpr double kMostWork = 4e7;  // sequences times the square of their size
constexpr double kMostExactWork = 2e6;
constexpr std::ptrdiff_t kNormGrain = 8;
constexpr int kWider = 2;         // points by which a box may be larger than what it holds
constexpr double kNearly = 1e-9;  // by which a norm in double precision may miss an exact bound

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
class PointBox {
 public:
  PointBox(const std::vector<Laurent>& differences, int order, LatticeVector size)
      : order_(order), size_(size), hull_(rows()) {
    for (const Laurent& difference : differences) {
      const Laurent atom = standard(difference);
      for (int x = 0; x < size_[0]; ++x)
        for (int y = 0; y < size_[1]; ++y) add(atom, {x, y});
    }
    if (!hull_.spans()) return;
    axis_norms_ = hull_.axis_norms();
    start_ = hull_.start_at(hull_.first_basis());
  }

  [[nodiscard]] bool spans() const { return hull_.spans(); }

  /// The norm of a sequence in the box, rounded up.
  [[nodiscard]] double norm(const Laurent& v) const {
    if (!hull_.spans()) return std::numeric_limits<double>::infinity();
    const Eigen::VectorXd u = coordinates(v, {0, 0});
    const SymmetricHull::Combination found = hull_.least_combination(u, start_, 0);
    const Eigen::VectorXd slack = u.cwiseAbs() * rounding_error(2);
    return inflated(found.norm + hull_.residual_bound(u, slack, found).dot(axis_norms_));
  }

  /// Whether the norm is at most `bound`: proved in rationals, of the differences that the linear
  /// program in double precision takes.
  [[nodiscard]] bool is_within(const Laurent& v, const Rational& bound) const {
    if (!hull_.spans()) return false;
    const SymmetricHull::Combination found =
        hull_.least_combination(coordinates(v, {0, 0}), start_, 0);
    if (found.norm > to_double(bound) * (1 + kNearly)) return false;
    const FieldVector<Rational> u = exact_coordinates(v);
    std::vector<FieldVector<Rational>> points;
    for (const Eigen::Index point : found.points) {
      points.emplace_back();
      for (const double entry : hull_.points().col(point))  // integers, exact in double precision
        points.back().emplace_back(entry);
    }
    const std::optional<FieldVector<Rational>> c = Coordinates(points).of(u);
    if (!c) return false;
    Rational sum = 0;
    for (const Rational& entry : *c) sum += abs(entry);
    return sum <= bound;
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
  /// Calls each(value) for the coordinates of v, moved to `at`.
  template <class Each>
  void for_coordinates(const Laurent& v, LatticeVector at, Each each) const {
    const Rational zero = 0;
    for (int x = 0; x < size_[0]; ++x)
      for (int y = 0; y < size_[1]; ++y) {
        if (x + y < order_) continue;
        const auto entry = v.find({x - at[0], y - at[1]});
        each(entry == v.end() ? zero : entry->second);
      }
  }
  [[nodiscard]] Eigen::VectorXd coordinates(const Laurent& v, LatticeVector at) const {
    Eigen::VectorXd result(rows());
    Eigen::Index row = 0;
    for_coordinates(v, at, [&](const Rational& value) { result(row++) = to_double(value); });
    return result;
  }
  [[nodiscard]] FieldVector<Rational> exact_coordinates(const Laurent& v) const {
    FieldVector<Rational> result;
    for_coordinates(v, {0, 0}, [&](const Rational& value) { result.push_back(value); });
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

/// What differences of the unit impulse become in k = 1, 2, … steps.
class RefinedDifferences {
 public:
  RefinedDifferences(const Mask& mask, int order, int most_alike)
      : mask_(mask),
        order_(order),
        differences_(unit_differences(edge_directions(mask.lattice), order, most_alike)),
        a_(integer_offsets(mask)),
        digits_(cosets(mask.dilation)) {
    for (const Laurent& v : differences_) sequences_.insert(standard(v));
  }

  /// False where it was stopped before it was done.
  bool step(const Stop& stop = {}) {
    std::set<Laurent> next;
    for (const Laurent& v : sequences_)
      for (const LatticeVector digit : digits_) {
        if (asked(stop)) return false;
        next.insert(standard(transition(a_, mask_.dilation, digit, v)));
      }
    next.erase(Laurent{});
    sequences_ = std::move(next);
    return true;
  }
  /// Of measuring them all.
  [[nodiscard]] double work() const {
    const LatticeVector size = size_of(sequences_, order_);
    const double points = static_cast<double>(size[0]) * size[1];
    return static_cast<double>(sequences_.size()) * points * points;
  }
  /// What `measure` says of each, in a box that holds them all.
  template <class T, class Measure>
  [[nodiscard]] std::vector<T> each(Measure measure) const {
    const PointBox box = spanned_box();
    const std::vector<Laurent> list(sequences_.begin(), sequences_.end());
    std::vector<T> results(list.size());
    base::parallel_for(
        std::size_t{0}, list.size(),
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) results[i] = measure(box, list[i]);
        },
        kNormGrain);
    return results;
  }

 private:
  /// A box that holds the sequences, and enough differences to combine them from.
  [[nodiscard]] PointBox spanned_box() const {
    LatticeVector size = size_of(sequences_, order_);
    PointBox box(differences_, order_, size);
    for (int more = 1; more <= kWider && !box.spans(); ++more)
      box = PointBox(differences_, order_, {size[0] + more, size[1] + more});
    return box;
  }

  const Mask& mask_;
  int order_;
  std::vector<Laurent> differences_;  // that the norm is of
  Laurent a_;
  std::vector<LatticeVector> digits_;
  std::set<Laurent> sequences_;
};

}  // namespace

std::vector<double> difference_norms(const Mask& mask, int order, int most_steps, double enough,
                                     const Stop& stop) {
  RefinedDifferences differences(mask, order, order);
  std::vector<double> norms;
  for (int k = 1; k <= most_steps; ++k) {
    if (!differences.step(stop)) return norms;
    if (differences.work() > kMostWork) break;
    const std::vector<double> each = differences.each<double>(
        [&stop](const PointBox& box, const Laurent& v) { return asked(stop) ? 0 : box.norm(v); });
    if (asked(stop)) break;
    norms.push_back(each.empty() ? 0 : *std::max_element(each.begin(), each.end()));
    if (norms.back() < std::pow(enough, k)) break;
  }
  return norms;
}

std::optional<int> steps_that_bound_differences(const Mask& mask, int order, int most_alike,
                                                int most_steps, const Stop& stop) {
  RefinedDifferences differences(mask, order, most_alike);
  const int growth = mask.dilation.growth();
  Rational squared = 1;  // of the bound
  for (int k = 1; k <= most_steps; ++k) {
    if (!differences.step(stop) || differences.work() > kMostExactWork) break;
    for (int i = 0; i < order; ++i) squared /= growth;
    const std::optional<Rational> bound = rational_root(squared, 2);
    if (!bound) continue;
    const std::vector<char> each =
        differences.each<char>([&](const PointBox& box, const Laurent& v) {
          return static_cast<char>(!asked(stop) && box.is_within(v, *bound) ? 1 : 0);
        });
    if (std::find(each.begin(), each.end(), 0) == each.end()) return k;
  }
  return std::nullopt;
}

}  // namespace limn::regular
