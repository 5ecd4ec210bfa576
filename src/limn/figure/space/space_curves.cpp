#include "limn/figure/space/space_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/base/parallel.h"

namespace limn::figure {
namespace {

constexpr double kRayStep = 0.35;    // points of the page between two rays
constexpr double kCut = 0.005;       // and between the last ones about a cut
constexpr double kShortest = 0.25;   // of a part
constexpr double kDeviation = 0.02;  // of a simplified line

double page_distance(const PagePoint& a, const PagePoint& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// From a point of the page to a segment.
double page_distance(const PagePoint& p, const PagePoint& a, const PagePoint& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
  double t = square > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square : 0;
  t = std::clamp(t, 0.0, 1.0);
  return page_distance(p, {a[0] + t * x, a[1] + t * y});
}

/// Part of a curve, all visible or all hidden.
struct Part {
  bool hidden;
  Polyline line;
};

double length_of(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += page_distance(line[i - 1], line[i]);
  return sum;
}

/// Cuts one curve.
class Cutter {
 public:
  Cutter(const RayCaster& rays, const FramePlacement& place, double tolerance)
      : rays_(rays), place_(place), tolerance_(tolerance) {}

  [[nodiscard]] std::vector<Part> parts(const SpaceCurve& curve) {
    parts_.clear();
    parts_.push_back({hidden(curve.front()), {place_.page(curve.front())}});
    for (std::size_t i = 1; i < curve.size(); ++i) add_segment(curve[i - 1], curve[i]);
    return std::move(parts_);
  }

 private:
  [[nodiscard]] bool hidden(const SpaceVector& at) const { return rays_.hides(at, tolerance_); }

  void add_segment(const SpaceVector& a, const SpaceVector& b) {
    const double size = page_distance(place_.page(a), place_.page(b));
    const int steps = static_cast<int>(std::clamp(std::ceil(size / kRayStep), 1.0, 1e5));
    double before = 0;
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      if (hidden(between(a, b, t)) != parts_.back().hidden) {
        const PagePoint cut = place_.page(between(a, b, cut_between(a, b, before, t, size)));
        parts_.back().line.push_back(cut);
        parts_.push_back({!parts_.back().hidden, {cut}});
      }
      before = t;
    }
    parts_.back().line.push_back(place_.page(b));
  }

  [[nodiscard]] double cut_between(const SpaceVector& a, const SpaceVector& b, double low,
                                   double high, double size) const {
    while ((high - low) * size > kCut) {
      const double middle = (low + high) / 2;
      (hidden(between(a, b, middle)) == parts_.back().hidden ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const RayCaster& rays_;
  const FramePlacement& place_;
  double tolerance_;
  std::vector<Part> parts_;
};

/// Parts too short to see become as the one before (or after) them, and equal neighbours join.
std::vector<Part> without_specks(std::vector<Part> parts) {
  std::vector<Part> result;
  for (Part& part : parts) {
    const bool speck = length_of(part.line) < kShortest;
    if (!result.empty() && (speck || result.back().hidden == part.hidden)) {
      Polyline& line = result.back().line;
      line.insert(line.end(), part.line.begin() + 1, part.line.end());
    } else {
      result.push_back(std::move(part));
    }
  }
  if (result.size() > 1 && length_of(result[0].line) < kShortest) {
    result[1].line.insert(result[1].line.begin(), result[0].line.begin(), result[0].line.end() - 1);
    result.erase(result.begin());
  }
  return result;
}

/// Segments by the names of their ends.
class Ends {
 public:
  explicit Ends(const std::vector<SpaceSegment>& segments) {
    for (std::size_t k = 0; k < segments.size(); ++k) {
      ends_.emplace_back(segments[k].from, k);
      ends_.emplace_back(segments[k].to, k);
    }
    std::sort(ends_.begin(), ends_.end());
  }

  /// Indices of the segments there, paired with the name.
  [[nodiscard]] auto at(long long name) const {
    const auto first =
        std::lower_bound(ends_.begin(), ends_.end(), std::pair(name, std::size_t{0}));
    auto last = first;
    while (last != ends_.end() && last->first == name) ++last;
    return std::pair(first, last);
  }

 private:
  std::vector<std::pair<long long, std::size_t>> ends_;
};

}  // namespace

std::vector<SpaceCurve> joined(const std::vector<SpaceSegment>& segments) {
  const Ends ends(segments);
  std::vector<char> used(segments.size(), 0);
  std::vector<SpaceCurve> curves;
  const auto passes = [&](long long name) {
    const auto [first, last] = ends.at(name);
    return last - first == 2;
  };
  const auto follow = [&](std::size_t k, long long from) {
    SpaceCurve& curve = curves.emplace_back();
    curve.push_back(segments[k].from == from ? segments[k].a : segments[k].b);
    for (long long name = from; !used[k];) {
      used[k] = 1;
      const bool forward = segments[k].from == name;
      curve.push_back(forward ? segments[k].b : segments[k].a);
      name = forward ? segments[k].to : segments[k].from;
      if (!passes(name)) break;
      const auto [first, last] = ends.at(name);
      k = first->second == k ? std::prev(last)->second : first->second;
    }
  };
  for (std::size_t k = 0; k < segments.size(); ++k)
    for (const long long end : {segments[k].from, segments[k].to})
      if (!used[k] && !passes(end)) follow(k, end);
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (!used[k]) follow(k, segments[k].from);
  return curves;
}

DrawnCurves drawn_curves(const std::vector<SpaceCurve>& curves, const RayCaster& rays,
                         const FramePlacement& place, double tolerance) {
  std::vector<std::vector<Part>> parts(curves.size());
  const auto cut = [&](std::size_t i) {
    if (curves[i].size() < 2) return;
    parts[i] = without_specks(Cutter(rays, place, tolerance).parts(curves[i]));
    for (Part& part : parts[i]) part.line = simplified(part.line, kDeviation);
  };
  base::parallel_for(
      std::size_t{0}, curves.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) cut(i);
      },
      16);
  DrawnCurves drawn;
  for (std::vector<Part>& of_curve : parts)
    for (Part& part : of_curve)
      if (length_of(part.line) > 0)
        (part.hidden ? drawn.hidden : drawn.visible).push_back(std::move(part.line));
  return drawn;
}

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t corner = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = page_distance(line[i], line[first], line[last]);
      if (off > farthest) farthest = off, corner = i;
    }
    if (corner == 0) continue;
    kept[corner] = 1;
    open.emplace_back(first, corner);
    open.emplace_back(corner, last);
  }
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) result.push_back(line[i]);
  return result;
}

}  // namespace limn::figure
