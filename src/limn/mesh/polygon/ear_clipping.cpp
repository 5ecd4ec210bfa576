#include "limn/mesh/polygon/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "limn/mesh/polygon/corner_tree.h"

namespace limn::mesh {
namespace {

double extent(Point2 a, Point2 b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

}  // namespace

// Corners that are no ears for the moment wait for what keeps them from it: a corner in the way, or
// a change of a neighbour. So no corner is tried again in vain.
class EarClipper::Work {
 public:
  bool cut(std::span<const Point2> points, std::vector<std::array<Index, 3>>& triangles) {
    points_ = points;
    triangles_ = &triangles;
    left_ = static_cast<Index>(points.size());
    clean_ = true;
    flat_ = false;
    gone_.assign(points.size(), 0);
    stamp_.assign(points.size(), 0);
    before_.resize(points.size());
    after_.resize(points.size());
    for (Index v = 0; v < left_; ++v) {
      before_[v] = v > 0 ? v - 1 : left_ - 1;
      after_[v] = v + 1 < left_ ? v + 1 : 0;
    }
    some_ = 0;
    // First what is an ear beyond rounding: corners that are collinear but for it then get
    // triangles with some area. What is left by exact signs.
    constexpr double tolerance = 1e-9;
    for (const double slack : {tolerance, 0.0}) {
      slack_ = slack;
      if (left_ > 3) begin();
      clip_all();
    }
    while (left_ > 3) {
      clip(least_bad());
      clean_ = false;
      clip_all();
    }
    finish();
    return clean_;
  }

 private:
  [[nodiscard]] Point2 at(Index v) const { return points_[static_cast<std::size_t>(v)]; }

  /// Whether b turns to the left, by more than the slack (a sine).
  [[nodiscard]] bool turns_left(Point2 a, Point2 b, Point2 c) const {
    if (slack_ == 0) return turn(a, b, c) > 0;
    return approx_turn(a, b, c) > slack_ * std::sqrt(length2(a, b) * length2(b, c));
  }
  static double length2(Point2 a, Point2 b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  }
  [[nodiscard]] bool is_convex(Index v) const {
    return turns_left(at(before_[v]), at(v), at(after_[v]));
  }
  /// Two neighbours in one place: whatever triangle their edge is in has no area.
  [[nodiscard]] bool is_double(Index v) const {
    return at(v) == at(before_[v]) || at(v) == at(after_[v]);
  }

  void begin() {
    std::vector<Index> others;
    queue_.clear();
    waiting_.clear();
    first_waiting_.assign(points_.size(), kNone);
    waits_for_.assign(points_.size(), kNone);
    Index v = some_;
    do {
      if (!is_convex(v)) others.push_back(v);
      enqueue(v);
      v = after_[v];
    } while (v != some_);
    in_the_way_.build(points_, std::move(others));
  }

  void enqueue(Index v) { queue_.push_back({v, ++stamp_[v]}); }

  void clip_all() {
    while (left_ > 3 && !queue_.empty()) {
      const auto [v, stamp] = queue_.front();
      queue_.pop_front();
      if (gone_[v] != 0 || stamp_[v] != stamp) continue;
      if (is_double(v)) {
        clip(v);
      } else if (is_convex(v)) {
        const Index blocker = blocker_of(v);
        if (blocker == kNone)
          clip(v);
        else
          wait(v, blocker);
      }
    }
  }

  /// A corner in the closed triangle of v and its neighbours that keeps it from being cut off.
  /// Only corners that are not convex need be looked at: if any corner is in the triangle, the one
  /// farthest from the line of the neighbours is, and it is not convex.
  [[nodiscard]] Index blocker_of(Index v) const {
    const Index u = before_[v], w = after_[v];
    const Point2 a = at(u), b = at(v), c = at(w);
    const double size = std::max({extent(a, b), extent(b, c), extent(c, a)});
    const double slack = slack_ * size;
    const auto inside = [&](Point2 from, Point2 to, Point2 p) {
      if (slack_ == 0) return turn(from, to, p) >= 0;
      return approx_turn(from, to, p) >= -slack * extent(from, to);
    };
    return in_the_way_.find({a, b, c}, slack, [&](Index k) {
      const Point2 p = at(k);
      if (k == u || k == v || k == w || p == a || p == c) return false;
      if (!inside(a, b, p) || !inside(b, c, p) || !inside(c, a, p)) return false;
      // The polygon touches itself at the ear's tip: only what enters the ear is in the way.
      return p != b || enters(at(before_[k]), a, b, c) || enters(at(after_[k]), a, b, c);
    });
  }
  static bool enters(Point2 q, Point2 a, Point2 b, Point2 c) {
    return turn(a, b, q) > 0 && turn(b, c, q) > 0;
  }

  void wait(Index v, Index blocker) {
    waits_for_[v] = blocker;
    waiting_.push_back({v, first_waiting_[blocker]});
    first_waiting_[blocker] = static_cast<Index>(waiting_.size()) - 1;
  }
  /// No longer in anyone's way.
  void release(Index blocker) {
    in_the_way_.take(blocker);
    Index place = first_waiting_[blocker];
    first_waiting_[blocker] = kNone;
    for (; place != kNone; place = waiting_[place].second) {
      const Index v = waiting_[place].first;
      if (waits_for_[v] != blocker || gone_[v] != 0) continue;
      waits_for_[v] = kNone;
      enqueue(v);
    }
  }

  void clip(Index v) {
    const Index u = before_[v], w = after_[v];
    triangles_->push_back({u, v, w});
    after_[u] = w;
    before_[w] = u;
    gone_[v] = 1;
    some_ = w;
    --left_;
    release(v);
    for (const Index neighbour : {u, w}) {
      if (is_convex(neighbour)) release(neighbour);
      waits_for_[neighbour] = kNone;
      enqueue(neighbour);  // behind all others, so that triangles do not become a fan of slivers
    }
  }

  /// Of a polygon that has no ear: it crosses itself.
  [[nodiscard]] Index least_bad() {
    Index v = some_;
    for (Index k = 0; k < left_ && !flat_; ++k, v = after_[v])
      if (turn(at(before_[v]), at(v), at(after_[v])) > 0) return v;
    flat_ = true;  // and so is what is left of it
    return some_;
  }

  void finish() {
    const Index u = before_[some_], v = some_, w = after_[some_];
    triangles_->push_back({u, v, w});
    if (turn(at(u), at(v), at(w)) <= 0 && !is_double(v) && at(u) != at(w)) clean_ = false;
  }

  std::span<const Point2> points_;
  std::vector<std::array<Index, 3>>* triangles_ = nullptr;
  std::vector<Index> before_, after_;
  std::vector<char> gone_;
  Index left_ = 0, some_ = 0;
  bool clean_ = true, flat_ = false;
  double slack_ = 0;
  CornerTree in_the_way_;  // corners that are not convex
  std::deque<std::pair<Index, unsigned>> queue_;
  std::vector<unsigned> stamp_;                   // of the entry of the queue that counts
  std::vector<std::pair<Index, Index>> waiting_;  // a corner, and the next that waits for the same
  std::vector<Index> first_waiting_, waits_for_;
};

EarClipper::EarClipper() : work_(std::make_unique<Work>()) {}
EarClipper::~EarClipper() = default;

bool EarClipper::cut(std::span<const Point2> corners,
                     std::vector<std::array<Index, 3>>& triangles) {
  return work_->cut(corners, triangles);
}

}  // namespace limn::mesh
