#include "limn/certify/all_valences.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <fmt/core.h>

#include "limn/certify/interval_prover.h"

namespace limn::certify {
namespace {

constexpr int kDeepestInterval = 12;    // halvings of 0 … 1/N
constexpr int kDeepestAtInfinity = 24;  // of the interval at t = 0
constexpr int kProbedFrom = 5;          // halvings after which a failing middle ends the search
constexpr int kMostUncovered = 24;
constexpr int kDeepestTurn = 16;
constexpr double kNear = 1e-9;  // a claim's number and what it stands for

/// Some 1/n, n whole, lies in begin … end (in the open interval: strictly between).
bool holds_valence(const Rational& begin, const Rational& end, bool open) {
  if (begin <= 0) return end > 0;
  const Rational first = Rational(1) / end;
  Integer n = numerator(first) / denominator(first);  // ≤ 1/end
  if (Rational(n) < first || (open && Rational(n) == first)) ++n;
  return open ? Rational(n) * begin < 1 : Rational(n) * begin <= 1;
}

/// The least of what μ1 may be.
class LeastEigenvalue {
 public:
  void add(const Ball& value) { least_ = std::min(least_, value.lower()); }
  [[nodiscard]] Ball ball() const { return Ball(least_); }

 private:
  double least_ = 1;
};

class Search {
 public:
  Search(IntervalProver& prover, AllValences& found, const Stop& stop)
      : prover_(prover), found_(found), stop_(stop) {}

  void cover_valences() {
    struct Piece {
      Rational begin, end;
      int depth;
    };
    std::deque<Piece> todo{{Rational(0), Rational(Integer(1), Integer(found_.from)), 0}};
    while (!todo.empty()) {
      const Piece piece = todo.front();
      todo.pop_front();
      if (!holds_valence(piece.begin, piece.end, false)) continue;
      ValenceInterval claim;
      claim.begin = piece.begin;
      claim.end = piece.end;
      const Result<Ball> shown = prover_.show(claim);
      if (shown) {
        least_.add(*shown);
        found_.intervals.push_back(std::move(claim));
        continue;
      }
      const Rational middle = (piece.begin + piece.end) / 2;
      if (is_hopeless(piece.begin, middle, piece.depth) || asked(stop_) ||
          found_.uncovered.size() > kMostUncovered) {
        leave_out(piece.begin, piece.end, shown.error().message);
        continue;
      }
      todo.push_front({middle, piece.end, piece.depth + 1});
      todo.push_front({piece.begin, middle, piece.depth + 1});
    }
  }

  void cover_turns() {
    struct Piece {
      Rational begin, end;
      int depth;
    };
    std::deque<Piece> todo{{Rational(0), Rational(1), 0}};
    while (!todo.empty()) {
      const Piece piece = todo.front();
      todo.pop_front();
      TurnInterval claim;
      claim.begin = piece.begin;
      claim.end = piece.end;
      const Status shown = prover_.show(claim, least_.ball());
      if (shown) {
        found_.turns.push_back(std::move(claim));
        continue;
      }
      if (piece.depth >= kDeepestTurn || asked(stop_)) {
        found_.reason = fmt::format("frequencies ω with 2ω/n near {:.4f}: {}",
                                    std::sqrt(to_double(piece.begin)), shown.error().message);
        return;
      }
      const Rational middle = (piece.begin + piece.end) / 2;
      todo.push_front({middle, piece.end, piece.depth + 1});
      todo.push_front({piece.begin, middle, piece.depth + 1});
    }
  }

 private:
  [[nodiscard]] bool is_hopeless(const Rational& begin, const Rational& middle, int depth) {
    if (depth >= (begin == 0 ? kDeepestAtInfinity : kDeepestInterval)) return true;
    if (depth < kProbedFrom) return false;
    return !prover_.show_at(middle);
  }

  void leave_out(const Rational& begin, const Rational& end, const std::string& reason) {
    std::vector<UncoveredValences>& all = found_.uncovered;
    if (!all.empty() && all.back().end == begin && all.back().reason == reason)
      all.back().end = end;
    else
      all.push_back({begin, end, reason});
  }

  IntervalProver& prover_;
  AllValences& found_;
  const Stop& stop_;
  LeastEigenvalue least_;
};

/// "n = 7", "n = 7 … 9" or "n ≥ 7".
std::string valences_text(const Rational& begin, const Rational& end) {
  const int first = static_cast<int>(std::ceil(1 / to_double(end) - kNear));
  if (begin == 0) return fmt::format("n ≥ {}", first);
  const int last = static_cast<int>(std::floor(1 / to_double(begin) + kNear));
  return first == last ? fmt::format("n = {}", first) : fmt::format("n = {} … {}", first, last);
}

Result<RangeRules> rules_from(const Scheme& scheme, int from) {
  constexpr int kLargestRegular = 6;
  if (from <= kLargestRegular)
    return Error{"a proof for all valences begins beyond the regular ones, at 7 or later"};
  Result<RangeRules> rules = RangeRules::make(scheme, from);
  if (rules && !rules->is_steady())
    return Error{"weights that depend on n are in the blocks of all frequencies"};
  return rules;
}

}  // namespace

AllValences certify_all_valences(const Scheme& scheme, const CellMatrices& cells,
                                 const Contraction& bounds, int from, const Stop& stop) {
  AllValences found;
  found.from = from;
  const Result<RangeRules> rules = rules_from(scheme, from);
  const Result<RingCells> ring = ring_cells(cells);
  if (!rules) found.reason = rules.error().message;
  if (!ring) found.reason = ring.error().message;
  if (!found.reason.empty()) return found;
  const CellSigns signs(cells, bounds);
  IntervalProver prover(cells, *rules, signs, *ring, true);
  for (const int part : {1, 16}) prover.show_at(Rational(Integer(1), Integer(from * part)));
  Search search(prover, found, stop);
  search.cover_valences();
  if (!found.uncovered.empty()) {
    const UncoveredValences& first = found.uncovered.front();
    found.reason = fmt::format("{}: {}", valences_text(first.begin, first.end), first.reason);
  }
  if (found.intervals.empty()) return found;
  search.cover_turns();
  if (found.reason.empty()) found.c1 = Truth::yes;
  return found;
}

Status check_all_valences(const Scheme& scheme, const CellMatrices& cells,
                          const Contraction& bounds, const AllValences& claim) {
  if (claim.c1 != Truth::yes) return Error{"nothing is claimed for all valences"};
  const Result<RangeRules> rules = rules_from(scheme, claim.from);
  if (!rules) return rules.error();
  const Result<RingCells> ring = ring_cells(cells);
  if (!ring) return ring.error();
  const CellSigns signs(cells, bounds);
  const IntervalProver prover(cells, *rules, signs, *ring, false);
  LeastEigenvalue least;
  Rational reached(0);
  for (ValenceInterval interval : claim.intervals) {
    if (interval.begin > reached && holds_valence(reached, interval.begin, reached > 0))
      return Error{"the intervals leave out a valence"};
    if (interval.begin < 0 || interval.end < interval.begin)
      return Error{"an interval of 1/n does not begin at 0 or later and end after that"};
    const Result<Ball> shown = prover.show(interval);
    if (!shown) return shown.error();
    least.add(*shown);
    reached = std::max(reached, interval.end);
  }
  if (claim.intervals.empty() || reached < Rational(Integer(1), Integer(claim.from)))
    return Error{"the intervals leave out a valence"};
  Rational turned(0);
  for (TurnInterval interval : claim.turns) {
    if (interval.begin > turned) return Error{"the intervals leave out a turn"};
    if (Status shown = prover.show(interval, least.ball()); !shown) return shown;
    turned = std::max(turned, interval.end);
  }
  if (turned < 1) return Error{"the intervals leave out a turn"};
  return Done{};
}

}  // namespace limn::certify
