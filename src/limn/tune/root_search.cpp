#include "limn/tune/root_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/tune/line_search.h"
#include "limn/tune/solve.h"

namespace limn::tune {
namespace {

constexpr int kDeepest = 40;  // halvings towards a place where branches come or go
constexpr int kMostBisections =
    1000;  // in all: rounding may have a defective one come and go often

/// A difference that eigenvalues left apart, though rounding split them, may have in place of 0.
constexpr double kSplitNearZero = 1e-6;

bool crosses(double a, double b) { return (a < 0) != (b < 0); }
bool is_zero(double difference) { return std::abs(difference) <= kSolved; }

class RootSearch {
 public:
  RootSearch(const Requirement& requirement, FreedScheme& scheme, const BlockCurve& curve,
             const Stop& stop)
      : requirement_(requirement), scheme_(scheme), curve_(curve), stop_(stop) {}

  RootsFound run(Interval interval, int samples) {
    take_samples(interval, samples);
    if (!result_.any_value) return std::move(result_);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      if (asked(stop_)) return std::move(result_);
      if (k > 0) cell(samples_[k - 1], samples_[k], kDeepest);
      if (k > 0 && k + 1 < samples_.size())
        triple(samples_[k - 1], samples_[k], samples_[k + 1]);
      else
        end_of_range(k);
    }
    find_stretches();
    return std::move(result_);
  }

 private:
  BranchSample at(double x) const {
    if (const Result<FrequencyBlocks> blocks = curve_(x))
      if (Result<BranchSample> sample = sample_branches(requirement_, scheme_, *blocks, x))
        return std::move(*sample);
    return {x, false, {}, std::nullopt};
  }

  void take_samples(Interval interval, int samples) {
    for (int k = 0; k < samples && !asked(stop_); ++k) {
      const double share = static_cast<double>(k) / (samples - 1);
      samples_.push_back(at(interval.low * (1 - share) + interval.high * share));
      const BranchSample& sample = samples_.back();
      result_.any_value = result_.any_value || sample.defined;
      for (const Branch& branch : sample.branches) note_nearest(sample.x, branch);
    }
  }

  void note_nearest(double x, const Branch& branch) {
    std::optional<Branch>& nearest = result_.nearest;
    if (nearest && std::abs(branch.difference) >= std::abs(nearest->difference)) return;
    nearest = branch;
    result_.nearest_x = x;
  }

  /// Roots between two samples; where branches come or go between them, on either side of that.
  void cell(const BranchSample& a, const BranchSample& b, int depth) {
    if (!a.defined && !b.defined) return;
    if (!same_rings(a, b)) {
      if (depth == 0 || ++halvings_ > kMostBisections) return;
      const BranchSample middle = at(a.x / 2 + b.x / 2);
      cell(a, middle, depth - 1);
      cell(middle, b, depth - 1);
      return;
    }
    for (std::size_t i = 0; i < a.branches.size(); ++i) {
      const double left = a.branches[i].difference;
      const double right = b.branches[i].difference;
      if (!is_zero(left) && !is_zero(right) && crosses(left, right)) bisect(i, a, b, depth);
    }
  }

  /// Branch i changes its sign from a to b.
  void bisect(std::size_t i, BranchSample a, BranchSample b, int depth) {
    while (std::abs(b.x - a.x) > kNarrowest) {
      const double x = a.x + (b.x - a.x) / 2;
      if (x == a.x || x == b.x) break;
      BranchSample middle = at(x);
      if (!same_rings(a, middle)) {
        if (depth == 0) return;
        cell(a, middle, depth - 1);
        cell(middle, b, depth - 1);
        return;
      }
      const bool right = crosses(middle.branches[i].difference, b.branches[i].difference);
      (right ? a : b) = std::move(middle);
    }
    const BranchSample& nearer =
        std::abs(a.branches[i].difference) < std::abs(b.branches[i].difference) ? a : b;
    result_.roots.push_back({nearer.x, nearer.branches[i].eigenvalue, false});
  }

  /// Roots at the middle one of three samples, and pairs of roots, or a double one, near it.
  void triple(const BranchSample& a, const BranchSample& m, const BranchSample& b) {
    if (!same_rings(a, m) || !same_rings(m, b)) return;
    for (std::size_t i = 0; i < m.branches.size(); ++i) {
      const double left = a.branches[i].difference;
      const double middle = m.branches[i].difference;
      const double right = b.branches[i].difference;
      if (is_zero(middle) && !is_zero(left) && !is_zero(right) && crosses(left, right))
        bisect(i, a, b, kDeepest);
      const double rise = std::max(std::abs(left), std::abs(right)) - std::abs(middle);
      // a smooth branch sinks below its lowest sample by less than the others rise above it
      const bool dips = !crosses(left, right) && (is_zero(middle) || !crosses(left, middle)) &&
                        std::abs(middle) <= std::min(std::abs(left), std::abs(right)) &&
                        rise > kSolved && std::abs(middle) <= 4 * rise;
      if (dips && !(is_zero(middle) && (is_zero(left) || is_zero(right)))) dip(i, a, b);
    }
  }

  /// |Branch i| has a least value between a and b, where it has one sign.
  void dip(std::size_t i, const BranchSample& a, const BranchSample& b) {
    const double sign = a.branches[i].difference < 0 ? -1 : 1;
    const double x = approx_minimum(a.x, b.x, [&](double t) {
      const BranchSample sample = at(t);
      return same_rings(sample, a) ? sign * sample.branches[i].difference + kSolved : HUGE_VAL;
    });
    const BranchSample lowest = at(x);
    if (!same_rings(lowest, a)) return;
    const Branch& branch = lowest.branches[i];
    note_nearest(x, branch);
    if (is_zero(branch.difference)) {
      result_.roots.push_back({stationary(i, a, b, x), branch.eigenvalue, true});
    } else if (crosses(branch.difference, a.branches[i].difference)) {
      bisect(i, a, lowest, kDeepest);
      bisect(i, lowest, b, kDeepest);
    }
  }

  /// Where the derivative of branch i vanishes, near x: there the branch itself is too flat to say.
  double stationary(std::size_t i, const BranchSample& a, const BranchSample& b, double x) {
    const double h = std::min((b.x - a.x) / 16, 1e-3);
    const auto slope = [&](double t) -> std::optional<double> {
      double sum = 0;
      for (const auto& [step, weight] :
           {std::pair(h, 8.0), {-h, -8.0}, {2 * h, -1.0}, {-2 * h, 1.0}}) {
        const BranchSample sample = at(t + step);
        if (!same_rings(sample, a)) return std::nullopt;
        sum += weight * sample.branches[i].difference;
      }
      return sum;
    };
    double other = x + h / 4;
    std::optional<double> at_other = slope(other);
    for (int step = 0; step < 6; ++step) {
      const std::optional<double> at_x = slope(x);
      if (!at_x || !at_other || *at_x == *at_other) break;
      const double next = x - *at_x * (x - other) / (*at_x - *at_other);
      if (!(std::abs(next - x) < h)) break;
      other = std::exchange(x, next);
      at_other = at_x;
    }
    return x;
  }

  /// The first and the last sample have no neighbour beyond them.
  void end_of_range(std::size_t k) {
    const BranchSample& end = samples_[k];
    const BranchSample& beside = samples_[k == 0 ? 1 : k - 1];
    if (!same_rings(end, beside)) return;
    for (std::size_t i = 0; i < end.branches.size(); ++i)
      if (std::abs(end.branches[i].difference) <= kUndecidedResidual &&
          !is_zero(beside.branches[i].difference))
        result_.roots.push_back({end.x, end.branches[i].eigenvalue, false});
  }

  [[nodiscard]] bool holds(double x) const {
    const auto difference = labelled_difference(requirement_, scheme_, curve_, x);
    return difference && std::abs(*difference) <= kEqualBelow;
  }

  void find_stretches() {
    std::vector<bool> held;
    held.reserve(samples_.size());
    for (const BranchSample& sample : samples_)
      held.push_back(sample.labelled && std::abs(*sample.labelled) < kSplitNearZero &&
                     holds(sample.x));
    const auto end_towards = [&](std::size_t inside, std::size_t outside) {
      return last_holding(samples_[inside].x, samples_[outside].x,
                          [&](double x) { return holds(x); });
    };
    for (std::size_t first = 0; first < held.size() && !asked(stop_); ++first) {
      if (!held[first]) continue;
      std::size_t last = first;
      while (last + 1 < held.size() && held[last + 1]) ++last;
      if (last > first)
        result_.throughout.push_back(
            {first == 0 ? samples_[first].x : end_towards(first, first - 1),
             last + 1 == held.size() ? samples_[last].x : end_towards(last, last + 1)});
      first = last;
    }
  }

  const Requirement& requirement_;
  FreedScheme& scheme_;
  const BlockCurve& curve_;
  const Stop& stop_;
  std::vector<BranchSample> samples_;
  int halvings_ = 0;
  RootsFound result_;
};

}  // namespace

RootsFound find_roots(const Requirement& requirement, FreedScheme& scheme, const BlockCurve& curve,
                      Interval interval, int samples, const Stop& stop) {
  return RootSearch(requirement, scheme, curve, stop).run(interval, samples);
}

std::optional<double> labelled_difference(const Requirement& requirement, FreedScheme& scheme,
                                          const BlockCurve& curve, double x) {
  const Result<FrequencyBlocks> blocks = curve(x);
  if (!blocks) return std::nullopt;
  const Result<BranchSample> sample =
      sample_branches(requirement, scheme, *blocks, x, Near::joined);
  return sample ? sample->labelled : std::nullopt;
}

}  // namespace limn::tune
