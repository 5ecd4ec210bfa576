#include "limn/tune/solve.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/number/near_rational.h"
#include "limn/tune/block_curve.h"
#include "limn/tune/line_search.h"
#include "limn/tune/margin.h"
#include "limn/tune/running_components.h"

namespace limn {
namespace {

constexpr int kRangeSamples = 257;
constexpr int kSlowRangeSamples = 65;
constexpr double kForbidden = 2 * kEqualBelow;  // the margin's stand-in there: near, but not enough

constexpr double kMet = 1e-6;    // of sides within rounding of where they meet
constexpr double kFlat = 1e-14;  // from sample to sample, by rounding

class RangeSearch {
 public:
  RangeSearch(FreedScheme& scheme, const Requirement& requirement, int n, Interval interval,
              const Stop& stop)
      : scheme_(scheme),
        requirement_(requirement),
        stop_(stop),
        curve_(scheme, n, interval),
        components_(requirement, curve_, interval) {
    result_.valence = n;
    result_.searched = interval;
    result_.closed = tune::is_closed(requirement.relation);
    result_.samples = curve_.quick() ? kRangeSamples : kSlowRangeSamples;
  }

  Result<ValenceRange> run() {
    if (forbids_all()) return std::move(result_);
    if (Status status = take_samples(); !status) return status.error();
    if (!asked(stop_)) look_between();
    if (!asked(stop_)) collect_parts();
    result_.solved = components_.solved();
    result_.time_ended = asked(stop_);
    if (result_.time_ended) return std::move(result_);
    if (result_.parts.empty() && result_.reason.empty()) say_absent();
    return std::move(result_);
  }

 private:
  struct Sample {
    double x;
    bool holds;
    double margin;           // -infinity where there is none
    bool forbidden = false;  // by the lattice; the eigenvalues would do
    bool unknown = false;    // forbidden because what the lattice allows is undecided
  };

  Result<double> value_at(double x, tune::Blocks which = tune::Blocks::quick) {
    const Result<const Eigencomponents*> found = components_.at(x, which);
    if (!found) return found.error();
    return tune::margin(requirement_, scheme_, x, **found);
  }
  /// Whether the regular lattice is the same for all x and does not allow it.
  bool forbids_all() {
    if (scheme_.everywhere(result_.valence)) return false;
    const RegularPart part =
        tune::allowed_by_lattice(requirement_, scheme_, result_.valence, result_.searched.low);
    if (part.bounded == Truth::yes) return false;
    result_.undecided = part.bounded == Truth::undecided;
    result_.samples = 0;
    result_.reason =
        fmt::format("{}, whatever {} is: {}curvature of the regular surface round it: {}",
                    result_.undecided ? "undecided" : "nowhere", scheme_.name(),
                    result_.undecided ? "" : "unbounded ", part.reason);
    return true;
  }
  /// Whether the regular lattice allows it at x; asked only where the eigenvalues do.
  Truth lattice_at(double x) {
    return tune::allowed_by_lattice(requirement_, scheme_, result_.valence, x).bounded;
  }
  bool allowed_at(double x) { return lattice_at(x) == Truth::yes; }
  double margin_at(double x, tune::Blocks which = tune::Blocks::quick) {
    const Result<double> value = value_at(x, which);
    return value ? *value : -HUGE_VAL;
  }
  [[nodiscard]] bool enough(double margin) const {
    return tune::is_closed(requirement_.relation) ? margin >= -kEqualBelow : margin > 0;
  }
  Sample sample_at(double x) {
    const double value = margin_at(x);
    const Truth lattice = enough(value) ? lattice_at(x) : Truth::yes;
    if (lattice == Truth::yes) return {x, enough(value), value};
    return {x, false, -kForbidden, true, lattice == Truth::undecided};
  }

  Status take_samples() {
    const auto [low, high] = result_.searched;
    bool any = false;
    for (int k = 0; k < result_.samples; ++k) {
      if (asked(stop_)) return Done{};
      const double share = static_cast<double>(k) / (result_.samples - 1);
      samples_.push_back(sample_at(low * (1 - share) + high * share));
      any = any || std::isfinite(samples_.back().margin);
      if (k > 0 && samples_.back().unknown && samples_[samples_.size() - 2].unknown)
        result_.undecided = true;
    }
    if (any) return Done{};
    const double middle = low / 2 + high / 2;
    const Result<FrequencyBlocks> blocks = curve_.exact(middle);
    if (!blocks) {
      Error error = blocks.error();
      error.message += fmt::format(", with {} = {:.6g}", scheme_.name(), middle);
      return error;
    }
    const Result<double> value = value_at(middle);
    result_.reason = value ? "the requirement has no value in this range" : value.error().text();
    return Done{};
  }

  /// Adds samples where three show a peak of the margin that may rise above 0 between them, or a
  /// dip that may fall below it.
  void look_between() {
    std::vector<Sample> all{samples_.front()};
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      if (const auto between = isolated_between(samples_[k - 1], samples_[k]))
        all.push_back(*between);
      if (k + 1 < samples_.size()) {
        const Sample &a = samples_[k - 1], &m = samples_[k], &b = samples_[k + 1];
        const double sign = m.holds ? 1 : -1;
        // where something else than x bounds it, it is flat, and there is nothing to look for
        const bool flat =
            std::abs(m.margin - a.margin) < kFlat && std::abs(m.margin - b.margin) < kFlat;
        const bool turns = !flat && !m.forbidden && a.holds == m.holds && m.holds == b.holds &&
                           std::isfinite(m.margin) && sign * m.margin <= sign * a.margin &&
                           sign * m.margin <= sign * b.margin;
        if (turns) {
          const double x =
              tune::approx_minimum(a.x, b.x, [&](double t) { return sign * margin_at(t); });
          if (const Sample turning = sample_at(x); turning.holds != m.holds) all.push_back(turning);
        }
      }
      all.push_back(samples_[k]);
    }
    std::sort(all.begin(), all.end(), [](const Sample& a, const Sample& b) { return a.x < b.x; });
    samples_ = std::move(all);
  }

  /// Where the lattice is what forbids it on one side and the eigenvalues on the other, their bound
  /// lies between; a lattice with the sum rules that bounded curvature needs has equal sides there.
  /// Such a lattice is found where the bound is a simple fraction, not a sample.
  std::optional<Sample> isolated_between(const Sample& a, const Sample& b) {
    if (a.holds || b.holds || a.forbidden == b.forbidden || !scheme_.everywhere(result_.valence))
      return std::nullopt;
    const Sample &inside = a.forbidden ? a : b, &outside = a.forbidden ? b : a;
    if (!std::isfinite(outside.margin)) return std::nullopt;
    constexpr double kNear = 1e-9;
    const auto simple = number::near_rational(
        tune::last_holding(inside.x, outside.x, [&](double x) { return enough(margin_at(x)); }),
        kNear);
    if (!simple) return std::nullopt;
    const double x = to_double(*simple);
    if (x <= a.x || x >= b.x) return std::nullopt;
    const Sample sample = sample_at(x);
    return sample.holds ? std::optional(sample) : std::nullopt;
  }

  void collect_parts() {
    for (std::size_t first = 0; first < samples_.size(); ++first) {
      if (!samples_[first].holds) continue;
      std::size_t last = first;
      while (last + 1 < samples_.size() && samples_[last + 1].holds) ++last;
      RangePart part;
      part.low =
          first == 0
              ? RangeEnd{samples_[first].x, number::near_rational(samples_[first].x), true, {}}
              : end_between(sound(first, last, 1), samples_[first - 1]);
      part.high =
          last + 1 == samples_.size()
              ? RangeEnd{samples_[last].x, number::near_rational(samples_[last].x), true, {}}
              : end_between(sound(last, first, -1), samples_[last + 1]);
      result_.parts.push_back(std::move(part));
      first = last;
    }
  }

  /// A sample at or beside one end of a part, where the two sides are not equal if there is one:
  /// the end itself may be a sample.
  [[nodiscard]] const Sample& sound(std::size_t end, std::size_t other_end, int inwards) const {
    if (end == other_end || samples_[end].margin > kEqualBelow) return samples_[end];
    const Sample& beside = samples_[end + static_cast<std::size_t>(inwards)];
    return beside.margin > kEqualBelow ? beside : samples_[end];
  }

  /// Whether the lattice allows it at this x and not beside it, as it does where sum rules hold.
  bool is_isolated(const Sample& inside, const Sample& outside) {
    if (requirement_.relation != Relation::bounded_curvature) return false;
    if (!scheme_.everywhere(result_.valence)) return false;
    return !allowed_at(inside.x + (outside.x - inside.x) / 1024);
  }

  /// The last x, from `inside` on, at which it holds. Where an exact value needs no star, these
  /// have the last word on what was found in interpolated blocks.
  double last_between(double inside, double outside, bool plain) {
    const auto holds = [&](tune::Blocks which) {
      return [this, which, plain](double t) {
        const double value = margin_at(t, which);
        return (plain ? value > 0 : enough(value)) && allowed_at(t);
      };
    };
    const double x = tune::last_holding(inside, outside, holds(tune::Blocks::quick));
    if (!curve_.interpolated() || scheme_.everywhere(result_.valence)) return x;
    const double reach = std::copysign(1e-12 * (1 + std::abs(x)), outside - inside);
    const auto exact = holds(tune::Blocks::exact);
    const auto [low, high] = std::minmax(inside, outside);
    const double before = std::clamp(x - reach, low, high);
    const double after = std::clamp(x + reach, low, high);
    if (exact(before) && !exact(after)) return tune::last_holding(before, after, exact);
    return tune::last_holding(inside, outside, exact);
  }

  RangeEnd end_between(const Sample& inside, const Sample& outside) {
    // where the two sides are not all along equal, 0 itself can be found
    const bool plain = inside.margin > kEqualBelow;
    const double x =
        is_isolated(inside, outside) ? inside.x : last_between(inside.x, outside.x, plain);
    // far enough on that nothing is undecided, near enough that nothing else has changed
    const double beyond = std::clamp(x + std::copysign(1e-5, outside.x - inside.x),
                                     result_.searched.low, result_.searched.high);
    const std::optional<Rational> rational = number::near_rational(x);
    return {rational ? to_double(*rational) : x, rational, false,
            why_not(beyond, [&](double) { return how_it_ends(x); })};
  }

  /// At an end of a part where sides are compared.
  std::string how_it_ends(double x) {
    const double reach = 1e-12 * (1 + std::abs(x));
    const bool meet =
        std::abs(margin_at(x - reach)) < kMet || std::abs(margin_at(x + reach)) < kMet;
    return meet ? "the two sides are equal" : "the two sides jump past one another, as at a pole";
  }

  /// `apart(margin)` says it of sides that are compared.
  template <class Apart>
  std::string why_not(double x, const Apart& apart) {
    const Result<FrequencyBlocks> blocks = curve_(x);
    if (!blocks) return blocks.error().text();
    const RegularPart regular = tune::allowed_by_lattice(requirement_, scheme_, result_.valence, x);
    const Eigencomponents found = approx_eigencomponents(*blocks, regular);
    if (requirement_.left) {
      const Result<double> value = tune::margin(requirement_, scheme_, x, found);
      return value ? apart(*value) : value.error().text();
    }
    for (const std::string& reason : found.verdict.reasons)
      for (const char* kind : {"not convergent", "not C1", "undecided C1", "unbounded curvature",
                               "undecided curvature"})
        if (reason.rfind(kind, 0) == 0) return reason;
    return "undecided";
  }

  void say_absent() {
    const auto [low, high] = result_.searched;
    double most = -HUGE_VAL;
    for (const Sample& sample : samples_) most = std::max(most, sample.margin);
    std::vector<double> best;  // a plateau, as a rule, of what does not depend on x
    for (const Sample& sample : samples_)
      if (sample.margin >= most - kEqualBelow) best.push_back(sample.x);
    const double x = best[best.size() / 2];
    result_.reason = fmt::format(
        "nowhere in [{:.6g}, {:.6g}]; the nearest is {} = {:.6g}: {}", low, high, scheme_.name(), x,
        why_not(x, [](double margin) { return fmt::format("it fails by {:.6g}", -margin); }));
  }

  FreedScheme& scheme_;
  const Requirement& requirement_;
  const Stop& stop_;
  tune::BlockCurve curve_;
  tune::RunningComponents components_;
  ValenceRange result_;
  std::vector<Sample> samples_;
};

}  // namespace

Result<ValenceRange> range_at(FreedScheme& scheme, const Requirement& requirement, int n,
                              const SearchRange* range, const Stop& stop) {
  if (!requirement.has_range())
    return Error{fmt::format("requirement '{}' is an equation", requirement.text),
                 "its values are points, not ranges"};
  const Result<Interval> interval = scheme.search_range(n, range);
  if (!interval) return interval.error();
  return RangeSearch(scheme, requirement, n, *interval, stop).run();
}

std::vector<Interval> common_range(const std::vector<ValenceRange>& ranges) {
  std::vector<Interval> common;
  for (const ValenceRange& range : ranges) {
    std::vector<Interval> next;
    for (const RangePart& part : range.parts) {
      if (&range == &ranges.front()) next.push_back({part.low.value, part.high.value});
      for (const Interval& other : common) {
        const Interval both{std::max(part.low.value, other.low),
                            std::min(part.high.value, other.high)};
        if (both.low <= both.high) next.push_back(both);
      }
    }
    common = std::move(next);
  }
  std::sort(common.begin(), common.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  return common;
}

}  // namespace limn
