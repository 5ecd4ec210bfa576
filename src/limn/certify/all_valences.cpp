#include "limn/certify/all_valences.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include <fmt/core.h>

#include "limn/certify/range_proof.h"

namespace limn::certify {
namespace {

constexpr int kMostSquarings = 24;
constexpr int kDeepestPart = 3;          // of a cell: cuts; beyond, the interval of t is halved
constexpr int kDeepestInterval = 12;     // halvings of 0 … 1/N
constexpr int kDeepestAtInfinity = 24;   // of the interval at t = 0
constexpr int kProbedFrom = 5;           // halvings after which a failing middle ends the search
constexpr int kMostUncovered = 24;
constexpr int kDeepestTurn = 16;
constexpr double kNear = 1e-9;           // a claim's number and what it stands for

Error undecided(const std::string& what) { return Error{what}; }

/// The eigenvalue of largest modulus of the middle, if it is real, and its eigenvector.
struct Approximation {
  double value = 0;
  std::vector<double> vector;
};
std::optional<Approximation> approx_leader(const BallMatrix& a) {
  const auto size = static_cast<Eigen::Index>(a.rows());
  Eigen::MatrixXd middle(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      middle(i, j) = a(static_cast<std::size_t>(i), static_cast<std::size_t>(j)).approx();
  if (size == 0 || !middle.allFinite()) return std::nullopt;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(middle);
  Eigen::Index leader = 0;
  for (Eigen::Index i = 1; i < size; ++i)
    if (std::abs(solver.eigenvalues()(i)) > std::abs(solver.eigenvalues()(leader))) leader = i;
  if (solver.eigenvalues()(leader).imag() != 0) return std::nullopt;
  Approximation result{solver.eigenvalues()(leader).real(), {}};
  for (Eigen::Index i = 0; i < size; ++i)
    result.vector.push_back(solver.eigenvectors()(i, leader).real());
  return result;
}

/// The pair near what a claim says.
Result<EnclosedPair> claimed_pair(const BallMatrix& a, double value,
                                  const std::vector<double>& vector) {
  if (vector.size() != a.rows() || vector.empty())
    return Error{"an eigenvector has not the size of its matrix"};
  Result<EnclosedPair> pair = enclose_eigenpair(a, value, vector);
  if (!pair) return pair;
  const auto is_near = [](const Ball& enclosed, double claimed) {
    return enclosed.widened(kNear).overlaps(Ball(claimed));
  };
  bool near = is_near(pair->value, value);
  for (std::size_t i = 0; i < vector.size(); ++i)
    near = near && is_near(pair->vector[i], vector[i] / vector[pair->pivot]);
  if (!near) return Error{"an eigenvalue or eigenvector is not near the one claimed"};
  return pair;
}

/// Some 1/n, n whole, lies in begin … end (in the open interval: strictly between).
bool holds_valence(const Rational& begin, const Rational& end, bool open) {
  if (begin <= 0) return end > 0;
  const Rational first = Rational(1) / end;
  Integer n = numerator(first) / denominator(first);  // ≤ 1/end
  if (Rational(n) < first || (open && Rational(n) == first)) ++n;
  return open ? Rational(n) * begin < 1 : Rational(n) * begin <= 1;
}

/// Shows a claim of one interval, or, searching, fills it in. A claim that was filled in is what
/// the check shows again.
class Prover {
 public:
  Prover(const CellMatrices& cells, const RangeRules& rules, const CellSigns& signs,
         const RingCells& ring, bool searching)
      : cells_(cells), rules_(rules), signs_(signs), ring_(ring), searching_(searching) {}

  /// The enclosure of μ1.
  Result<Ball> show(ValenceInterval& claim) const {
    const Result<IntervalBlocks> blocks = IntervalBlocks::make(rules_, claim.begin, claim.end);
    if (!blocks) return blocks.error();
    if (Status found = fill(blocks->tangent(), claim.eigenvalue, claim.eigenvector); !found)
      return undecided("frequency 1 has no real leading eigenvalue");
    const Result<EnclosedPair> pair =
        claimed_pair(blocks->tangent(), claim.eigenvalue, claim.eigenvector);
    if (!pair) return undecided("frequency 1: " + pair.error().message);
    if (!pair->value.is_positive() || !is_less(pair->value, Ball(1)))
      return undecided("the leading eigenvalue of frequency 1 is not shown to lie between 0 and 1");
    if (!below(deflated(blocks->tangent(), *pair), pair->value, claim.squarings))
      return undecided("other eigenvalues of frequency 1 are not shown to be smaller than its first");
    if (Status shown = show_special(*blocks, *pair, claim); !shown) return shown.error();
    if (Status shown = show_constant(*blocks, *pair, claim); !shown) return shown.error();
    if (Status shown = show_ring(*blocks, *pair, claim); !shown) return shown.error();
    return pair->value;
  }

  /// All eigenvalues of the interval of turns that are not below `bound` fall with the turn.
  Status show(TurnInterval& claim, const Ball& bound) const {
    const Result<TurnBlocks> blocks = turn_blocks(rules_, claim.begin, claim.end);
    if (!blocks) return blocks.error();
    if (searching_ || claim.right.empty()) {
      if (below(blocks->block, bound, claim.squarings)) return Done{};
      if (!searching_) return undecided("eigenvalues are not below the bound");
    }
    if (rules_.last_special() > 0)
      return undecided("eigenvalues of frequencies 2 … n/2 are not shown to be smaller");
    const BallMatrix transpose = transposed(blocks->block);
    double same = claim.eigenvalue;
    if (!fill(blocks->block, claim.eigenvalue, claim.right) || !fill(transpose, same, claim.left))
      return undecided("frequencies 2 … n/2 have no real leading eigenvalue");
    const Result<EnclosedPair> right = claimed_pair(blocks->block, claim.eigenvalue, claim.right);
    const Result<EnclosedPair> left = claimed_pair(transpose, claim.eigenvalue, claim.left);
    if (!right || !left || !right->value.is_positive())
      return undecided("the leading eigenvalue of frequencies 2 … n/2 is not enclosed");
    if (!eigenvalue_slope(*blocks, *right, *left).is_negative())
      return undecided("the leading eigenvalue is not shown to fall as the frequency grows");
    if (!below(deflated(blocks->block, *right), bound, claim.squarings))
      return undecided("several eigenvalues of frequencies 2 … n/2 are not shown to be smaller");
    return Done{};
  }

 private:
  Status fill(const BallMatrix& a, double& value, std::vector<double>& vector) const {
    if (!searching_) return Done{};
    std::optional<Approximation> found = approx_leader(a);
    if (!found) return undecided("no real eigenvalue leads");
    value = found->value;
    vector = std::move(found->vector);
    return Done{};
  }

  [[nodiscard]] bool below(const BallMatrix& a, const Ball& bound, int& squarings) const {
    if (!searching_ && squarings < 0) return false;
    const std::optional<int> found =
        squarings_below(a, bound, searching_ ? kMostSquarings : squarings);
    if (!found) return false;
    if (searching_) squarings = *found;
    return squarings == *found;
  }

  Status show_special(const IntervalBlocks& blocks, const EnclosedPair& pair,
                      ValenceInterval& claim) const {
    const auto count = static_cast<std::size_t>(std::max(rules_.last_special() - 1, 0));
    if (searching_) claim.special.assign(count, 0);
    if (claim.special.size() != count) return Error{"frequencies with other weights are missing"};
    for (std::size_t i = 0; i < count; ++i) {
      const int frequency = static_cast<int>(i) + 2;
      const Result<BallMatrix> block = blocks.special(frequency);
      if (!block) return block.error();
      if (!below(*block, pair.value, claim.special[i]))
        return undecided(fmt::format("eigenvalues of frequency {} are not shown to be smaller than "
                                     "frequency 1's", frequency));
    }
    return Done{};
  }

  Status show_constant(const IntervalBlocks& blocks, const EnclosedPair& pair,
                       ValenceInterval& claim) const {
    const auto failed = [](const std::string& what) {
      return undecided("frequency 0 is not shown to be smaller than frequency 1: " + what);
    };
    if (searching_ || claim.constant_squarings >= 0) {
      if (below(blocks.constant(), pair.value, claim.constant_squarings)) return Done{};
      if (!searching_) return failed("its eigenvalues are not below");
    }
    claim.constant_squarings = -1;
    if (!blocks.has_gap()) return failed("powers of its matrix do not show it");
    const BallMatrix transpose = blocks.cup_transposed();
    if (!fill(transpose, claim.cup, claim.cup_vector)) return failed("no real eigenvalue leads it");
    const Result<EnclosedPair> cup = claimed_pair(transpose, claim.cup, claim.cup_vector);
    if (!cup) return failed(cup.error().message);
    const Ball gap = blocks.cup_gap(*cup, pair);
    if (gap.is_negative()) return failed("its leading eigenvalue is the larger one");
    if (!gap.is_positive() || !cup->value.is_positive())
      return failed("the difference of their leading eigenvalues has no sign");
    if (!below(deflated(transpose, *cup), pair.value, claim.cup_squarings))
      return failed("a second eigenvalue is close");
    if (!below(blocks.odd(), pair.value, claim.odd_squarings))
      return failed("an eigenvalue of odd vectors is close");
    return Done{};
  }

  Status show_ring(const IntervalBlocks& blocks, const EnclosedPair& pair,
                   ValenceInterval& claim) const {
    IntervalRing ring(cells_, signs_, rules_, blocks, pair);
    if (searching_) claim.parts.assign(ring_.cells.size(), {});
    if (claim.parts.size() != ring_.cells.size()) return Error{"cells of the ring are missing"};
    for (std::size_t i = 0; i < ring_.cells.size(); ++i) {
      const Result<CellMap> map = ring.map_on(ring_.cells[i]);
      if (!map) return map.error();
      std::vector<std::string> shown;
      if (!show_part(ring, *map, "", claim.parts[i], shown))
        return undecided("the characteristic map's Jacobian, or its winding, is not decided");
      if (searching_) claim.parts[i] = shown;
      if (claim.parts[i] != shown) return Error{"a cell has parts that are not needed"};
    }
    return Done{};
  }

  bool show_part(IntervalRing& ring, const CellMap& map, const std::string& word,
                 const std::vector<std::string>& claimed, std::vector<std::string>& shown) const {
    const bool is_claimed = std::find(claimed.begin(), claimed.end(), word) != claimed.end();
    if ((searching_ || is_claimed) && ring.agrees(map)) {
      shown.push_back(word);
      return true;
    }
    const bool cut = searching_ ? word.size() < kDeepestPart
                                : std::any_of(claimed.begin(), claimed.end(), [&](const auto& one) {
                                    return one.size() > word.size() && one.starts_with(word);
                                  });
    if (!cut) return false;
    for (std::size_t digit = 0; digit < cells_.residual.size(); ++digit)
      if (!show_part(ring, signs_.part(map, digit), word + static_cast<char>('0' + digit), claimed,
                     shown))
        return false;
    return true;
  }

  const CellMatrices& cells_;
  const RangeRules& rules_;
  const CellSigns& signs_;
  const RingCells& ring_;
  bool searching_;
};

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
  Search(const Prover& prover, AllValences& found, const Stop& stop)
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
  [[nodiscard]] bool is_hopeless(const Rational& begin, const Rational& middle, int depth) const {
    if (depth >= (begin == 0 ? kDeepestAtInfinity : kDeepestInterval)) return true;
    if (depth < kProbedFrom) return false;
    ValenceInterval point;
    point.begin = middle;
    point.end = middle;
    return !prover_.show(point);
  }

  void leave_out(const Rational& begin, const Rational& end, const std::string& reason) {
    std::vector<UncoveredValences>& all = found_.uncovered;
    if (!all.empty() && all.back().end == begin && all.back().reason == reason)
      all.back().end = end;
    else
      all.push_back({begin, end, reason});
  }

  const Prover& prover_;
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

}  // namespace

AllValences certify_all_valences(const Scheme& scheme, const CellMatrices& cells,
                                 const Contraction& bounds, int from, const Stop& stop) {
  AllValences found;
  found.from = from;
  const Result<RangeRules> rules = RangeRules::make(scheme, from);
  const Result<RingCells> ring = ring_cells(cells);
  if (!rules) found.reason = rules.error().message;
  if (!ring) found.reason = ring.error().message;
  if (rules && !rules->is_steady())
    found.reason = "weights that depend on n are in the blocks of all frequencies";
  if (!found.reason.empty()) return found;
  const CellSigns signs(cells, bounds);
  const Prover prover(cells, *rules, signs, *ring, true);
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
  const Result<RangeRules> rules = RangeRules::make(scheme, claim.from);
  if (!rules) return rules.error();
  if (!rules->is_steady()) return Error{"blocks of all frequencies depend on n"};
  const Result<RingCells> ring = ring_cells(cells);
  if (!ring) return ring.error();
  const CellSigns signs(cells, bounds);
  const Prover prover(cells, *rules, signs, *ring, false);
  LeastEigenvalue least;
  Rational reached(0);
  for (ValenceInterval interval : claim.intervals) {
    if (interval.begin > reached && holds_valence(reached, interval.begin, reached > 0))
      return Error{"the intervals leave out a valence"};
    if (interval.end < interval.begin) return Error{"an interval ends before it begins"};
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
