#include "limn/certify/all/all_valences.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <fmt/core.h>

#include "limn/certify/all/interval_prover.h"

namespace limn::certify {
namespace {

constexpr int kDeepestAtInfinity = 24;  // halvings of the interval at t = 0
constexpr int kProbedFrom = 5;          // halvings after which a failing middle ends the search
constexpr int kMostUncovered = 24;
constexpr long kMostParts = 400'000;  // of cells, that a search looks at
constexpr int kDeepestTurn = 16;

Integer floor_of(const Rational& positive) { return numerator(positive) / denominator(positive); }
Integer ceiling_of(const Rational& positive) {
  return (numerator(positive) + denominator(positive) - 1) / denominator(positive);
}

/// Some 1/n lies strictly between 0 ≤ begin and end.
bool is_valence_between(const Rational& begin, const Rational& end) {
  if (end <= begin) return false;
  return begin == 0 || floor_of(1 / end) + 1 < ceiling_of(1 / begin);
}

/// The least of what μ1 may be.
class LeastEigenvalue {
 public:
  void add(const number::Ball& value) { least_ = std::min(least_, value.lower()); }
  [[nodiscard]] number::Ball ball() const { return number::Ball(least_); }

 private:
  double least_ = 1;
};

class AllValencesSearch {
 public:
  AllValencesSearch(IntervalProver& prover, AllValences& found, const Stop& stop)
      : prover_(prover), found_(found), stop_(stop) {}

  void cover_valences() {
    std::deque<Piece> todo{{Rational(0), Rational(Integer(1), Integer(found_.from)), 0}};
    while (!todo.empty()) {
      const Piece piece = todo.front();
      todo.pop_front();
      const Integer first = ceiling_of(1 / piece.end);
      if (piece.begin > 0 && floor_of(1 / piece.begin) < first) continue;
      if (asked(stop_) || found_.uncovered.size() > kMostUncovered ||
          prover_.parts_seen() > kMostParts) {
        leave_out(piece, "not tried, the search being ended by its bounds");
        continue;
      }
      ValenceInterval claim;
      claim.begin = piece.begin;
      claim.end = piece.end;
      const Result<number::Ball> shown = prover_.show(claim);
      if (shown) {
        least_.add(*shown);
        found_.intervals.push_back(std::move(claim));
        continue;
      }
      const bool is_point = piece.begin == piece.end;
      const Rational middle = (piece.begin + piece.end) / 2;
      if (!is_point && piece.begin > 0 && floor_of(1 / piece.begin) == first) {
        todo.push_front({Rational(Integer(1), first), Rational(Integer(1), first), piece.depth});
      } else if (is_point || is_hopeless(piece, middle)) {
        leave_out(piece, shown.error().message);
      } else {
        todo.push_front({middle, piece.end, piece.depth + 1});
        todo.push_front({piece.begin, middle, piece.depth + 1});
      }
    }
  }

  void cover_turns() {
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
  /// Of 1/n, or of a turn's square.
  struct Piece {
    Rational begin, end;
    int depth;
  };

  [[nodiscard]] bool is_hopeless(const Piece& piece, const Rational& middle) {
    if (piece.begin == 0 && piece.depth >= kDeepestAtInfinity) return true;
    return piece.depth >= kProbedFrom && !prover_.show_at(middle);
  }

  void leave_out(const Piece& piece, const std::string& reason) {
    UncoveredValences here{ceiling_of(1 / piece.end).convert_to<long long>(), 0, reason};
    if (piece.begin > 0) here.last = floor_of(1 / piece.begin).convert_to<long long>();
    std::vector<UncoveredValences>& all = found_.uncovered;
    if (!all.empty() && all.back().reason == reason && all.back().first <= here.last + 1)
      all.back().first = here.first;
    else
      all.push_back(std::move(here));
  }

  IntervalProver& prover_;
  AllValences& found_;
  const Stop& stop_;
  LeastEigenvalue least_;
};

/// "n = 7", "n = 7 … 9" or "n ≥ 7".
std::string valences_text(const UncoveredValences& some) {
  if (some.last == 0) return fmt::format("n ≥ {}", some.first);
  return some.first == some.last ? fmt::format("n = {}", some.first)
                                 : fmt::format("n = {} … {}", some.first, some.last);
}

constexpr int kLargestRegular = 6;
constexpr int kLastStart = 60;

Result<RangeRules> rules_from(const Scheme& scheme, int from) {
  if (from <= kLargestRegular)
    return Error{"a proof for all valences begins beyond the regular ones, at 7 or later"};
  Result<RangeRules> rules = RangeRules::make(scheme, from);
  if (rules && !rules->is_steady())
    return Error{"weights that depend on n are in the blocks of all frequencies"};
  return rules;
}

}  // namespace

Result<int> first_of_all_valences(const Scheme& scheme) {
  for (int from = kLargestRegular + 1;; ++from) {
    const Result<RangeRules> rules = rules_from(scheme, from);
    if (rules) return from;
    if (from == kLastStart) return rules.error();
  }
}

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
  for (const int n : {from, 2 * from, 8 * from})
    if (const std::optional<int> rival = prover.approx_rival(n)) {
      found.reason = fmt::format("frequency {} seems to lead at n = {}", *rival, n);
      found.uncovered.push_back({from, 0, found.reason});
      return found;
    }
  for (const int part : {1, 16}) prover.show_at(Rational(Integer(1), Integer(from * part)));
  AllValencesSearch search(prover, found, stop);
  search.cover_valences();
  if (!found.uncovered.empty()) {
    const UncoveredValences& first = found.uncovered.front();
    found.reason = fmt::format("{}: {}", valences_text(first), first.reason);
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
    if (is_valence_between(reached, interval.begin))
      return Error{"the intervals leave out a valence"};
    if (interval.begin < 0 || interval.end < interval.begin)
      return Error{"an interval of 1/n does not begin at 0 or later and end after that"};
    const Result<number::Ball> shown = prover.show(interval);
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
