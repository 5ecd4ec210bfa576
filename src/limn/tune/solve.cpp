#include "limn/tune/solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "limn/number/near_rational.h"
#include "limn/tune/margin.h"
#include "limn/tune/root_search.h"

namespace limn {
namespace {

constexpr int kSamples = 1025;
constexpr int kSlowSamples = 257;

// how far a root may lie from where it was found
constexpr double kSimpleAccuracy = 1e-13;
constexpr double kDoubleAccuracy = 1e-9;
constexpr double kHiddenAccuracy = 1e-7;  // where the eigenvalue is defective

std::string described(const Eigenvalue& one) {
  return fmt::format("{:.9g} of frequency {} (ring {})", one.value.real(), one.frequency, one.ring);
}

std::string other_leads(const Requirement& requirement, const Solution& solution) {
  const Component& sought = kComponents[tune::sought_component(requirement).value()];
  const auto& spectrum = solution.found.spectra[static_cast<std::size_t>(sought.frequency)];
  return fmt::format("{} solves it, but the {} is {}", described(solution.eigenvalue), sought.name,
                     described(spectrum.eigenvalues[sought.index]));
}

/// The branch that continues the root's.
std::optional<tune::Branch> nearest_branch(const tune::BranchSample& sample,
                                           const Eigenvalue& eigenvalue) {
  std::optional<tune::Branch> nearest;
  const auto distance = [&](const tune::Branch& branch) {
    return std::abs(branch.eigenvalue.value - eigenvalue.value);
  };
  for (const tune::Branch& branch : sample.branches)
    if (branch.eigenvalue.ring == eigenvalue.ring &&
        (!nearest || distance(branch) < distance(*nearest)))
      nearest = branch;
  return nearest;
}

/// Frequencies of the components that an equation uses, ascending; 0 where it uses none.
std::vector<int> frequencies_of(const Requirement& requirement, int n) {
  std::vector<int> list{0};
  for (const std::size_t i : requirement.used)
    if (kComponents[i].exists_at(n)) list.push_back(kComponents[i].frequency);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// Makes solutions of roots, at one valence.
class Solver {
 public:
  Solver(FreedScheme& scheme, const Requirement& requirement, int n, Interval interval,
         const Stop& stop)
      : scheme_(scheme),
        requirement_(requirement),
        n_(n),
        stop_(stop),
        curve_(scheme, n, interval, frequencies_of(requirement, n)) {
    result_.valence = n;
    result_.searched = interval;
    result_.samples = curve_.quick() ? kSamples : kSlowSamples;
  }

  Result<ValenceSolutions> run() {
    const tune::RootsFound found =
        tune::find_roots(requirement_, scheme_, curve_, result_.searched, result_.samples, stop_);
    result_.time_ended = asked(stop_);
    if (result_.time_ended) return std::move(result_);
    if (!found.any_value) return without_value();
    result_.throughout = found.throughout;
    for (const tune::Root& root : found.roots)
      if (!throughout(root.x)) keep(solution_at(root));
    std::sort(result_.solutions.begin(), result_.solutions.end(),
              [](const Solution& a, const Solution& b) { return a.value < b.value; });
    if (result_.solutions.empty() && result_.throughout.empty()) say_absent(found);
    return std::move(result_);
  }

 private:
  /// What the equation lacks; an error where the scheme has no blocks.
  Result<ValenceSolutions> without_value() {
    const double x = result_.searched.low / 2 + result_.searched.high / 2;
    const Result<FrequencyBlocks> blocks = curve_.exact(x);
    if (!blocks) {
      Error error = blocks.error();
      error.message += fmt::format(", with {} = {:.6g}", scheme_.name(), x);
      return error;
    }
    const Result<tune::BranchSample> sample =
        tune::sample_branches(requirement_, scheme_, *blocks, x);
    result_.has_value = false;
    result_.reason = sample ? "the equation has no value in this range" : sample.error().text();
    return std::move(result_);
  }

  [[nodiscard]] bool throughout(double x) const {
    return std::any_of(result_.throughout.begin(), result_.throughout.end(), [&](Interval part) {
      return x >= part.low - kDoubleAccuracy && x <= part.high + kDoubleAccuracy;
    });
  }

  std::optional<tune::Branch> branch_of(const tune::Root& root,
                                        const Result<FrequencyBlocks>& blocks, double x,
                                        Near near = Near::apart) {
    if (!blocks) return std::nullopt;
    const Result<tune::BranchSample> sample =
        tune::sample_branches(requirement_, scheme_, *blocks, x, near);
    if (!sample) return std::nullopt;
    return nearest_branch(*sample, root.eigenvalue);
  }

  /// Secant steps with the blocks themselves, where the root was found in interpolated ones.
  double polished(const tune::Root& root) {
    if (!curve_.interpolated() || root.is_double) return root.x;
    const double step = (result_.searched.high - result_.searched.low) * 1e-7;
    const auto left = branch_of(root, curve_(root.x - step), root.x - step);
    const auto right = branch_of(root, curve_(root.x + step), root.x + step);
    if (!left || !right || left->difference == right->difference) return root.x;
    const double slope = (right->difference - left->difference) / (2 * step);
    double best = root.x;
    double least = HUGE_VAL;
    double x = root.x;
    for (int i = 0; i < 4; ++i) {
      const std::optional<tune::Branch> branch = branch_of(root, curve_.exact(x), x);
      if (!branch) break;
      if (std::abs(branch->difference) < least) {
        least = std::abs(branch->difference);
        best = x;
      }
      x -= branch->difference / slope;
    }
    return best;
  }

  /// Nothing where the branch jumps across 0 instead of vanishing.
  std::optional<Solution> solution_at(const tune::Root& root) {
    Solution solution;
    solution.value = polished(root);
    solution.is_double = root.is_double;
    std::optional<tune::Branch> branch =
        branch_of(root, curve_.exact(solution.value), solution.value);
    if (!branch || std::abs(branch->difference) > kUndecidedResidual) return std::nullopt;
    const bool hidden = std::abs(branch->difference) > kSolved;
    const double accuracy = hidden           ? kHiddenAccuracy
                            : root.is_double ? kDoubleAccuracy
                                             : kSimpleAccuracy;
    if (const auto rational = number::near_rational(solution.value, accuracy)) {
      const double x = to_double(*rational);
      const std::optional<tune::Branch> there =
          branch_of(root, curve_.exact(x), x, hidden ? Near::joined : Near::apart);
      if (there && std::abs(there->difference) <=
                       std::max(std::abs(branch->difference) / 1000, kSimpleAccuracy)) {
        solution.rational = rational;
        solution.value = x;
        branch = there;
      }
    }
    solution.residual = std::abs(branch->difference);
    solution.eigenvalue = branch->eigenvalue;
    judge(solution);
    if (solution.holds != Truth::yes && is_on_a_stretch(root)) return std::nullopt;
    return solution;
  }

  /// Whether an eigenvalue that is not the label solves all along, on a side of the root: then the
  /// root is only where rounding ends that.
  bool is_on_a_stretch(const tune::Root& root) {
    const double step =
        (result_.searched.high - result_.searched.low) / (3 * (result_.samples - 1));
    for (const double x : {root.x - step, root.x + step}) {
      const Result<FrequencyBlocks> blocks = curve_(x);
      if (!blocks) continue;
      const Result<tune::BranchSample> sample =
          tune::sample_branches(requirement_, scheme_, *blocks, x);
      if (!sample) continue;
      for (const tune::Branch& branch : sample->branches)
        if (branch.eigenvalue.ring == root.eigenvalue.ring && std::abs(branch.difference) < kSolved)
          return true;
    }
    return false;
  }

  void judge(Solution& solution) {
    RegularPart regular = scheme_.regular_part(n_, solution.value);
    if (!solution.rational && scheme_.everywhere(n_))
      regular = {Truth::undecided, tune::known_in_digits_only(scheme_.name())};
    solution.found = approx_eigencomponents(curve_.exact(solution.value).value(), regular);
    const tune::ComponentValues values = tune::component_values(solution.found);
    const Result<double> own = tune::difference(requirement_, scheme_, n_, solution.value, values);
    if (solution.residual > kSolved) {
      solution.reason = fmt::format("rounding hides it: the residual is {:.1e}", solution.residual);
    } else if (own && std::abs(*own) <= kEqualBelow) {
      solution.holds = Truth::yes;
    } else if (own && std::abs(*own) < kUndecidedBelow) {
      solution.reason = fmt::format("the labels miss it by {:.1e}", std::abs(*own));
    } else {
      solution.holds = Truth::no;
      solution.reason = own ? other_leads(requirement_, solution) : own.error().text();
    }
  }

  /// How far a solution may be from the root it stands for.
  static double doubt(const Solution& solution) {
    if (solution.residual > kSolved) return kHiddenAccuracy;
    return solution.is_double ? kDoubleAccuracy : kSolved;
  }

  /// Two branches may vanish at one value: that is one solution, the one that holds.
  void keep(std::optional<Solution> solution) {
    if (!solution) return;
    for (Solution& known : result_.solutions) {
      const double tolerance = std::max(doubt(known), doubt(*solution));
      if (std::abs(known.value - solution->value) > tolerance * (1 + std::abs(known.value)))
        continue;
      const auto worth = [](const Solution& one) {
        return one.holds == Truth::yes ? 2 : one.holds == Truth::no ? 1 : 0;
      };
      if (worth(*solution) > worth(known)) known = std::move(*solution);
      return;
    }
    result_.solutions.push_back(std::move(*solution));
  }

  void say_absent(const tune::RootsFound& found) {
    const auto [low, high] = result_.searched;
    result_.reason = fmt::format("none found in [{:.6g}, {:.6g}]", low, high);
    if (found.nearest)
      result_.reason +=
          fmt::format("; the nearest is {} = {:.6g}, where {} misses by {:.3g}", scheme_.name(),
                      found.nearest_x, described(found.nearest->eigenvalue),
                      std::abs(found.nearest->difference));
  }

  FreedScheme& scheme_;
  const Requirement& requirement_;
  int n_;
  const Stop& stop_;
  tune::BlockCurve curve_;
  ValenceSolutions result_;
};

}  // namespace

Result<ValenceSolutions> solve_at(FreedScheme& scheme, const Requirement& requirement, int n,
                                  const SearchRange* range, const Stop& stop) {
  if (requirement.has_range())
    return Error{fmt::format("requirement '{}' is no equation", requirement.text),
                 "its values fill ranges, not points"};
  const Result<Interval> interval = scheme.search_range(n, range);
  if (!interval) return interval.error();
  return Solver(scheme, requirement, n, *interval, stop).run();
}

}  // namespace limn
