#include "limn/certify/all/interval_prover.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace limn::certify {
namespace {

constexpr int kMostIntervalSquarings = 24;
constexpr std::size_t kMostCellCuts = 9;  // of a cell
constexpr int kMostIntervalParts = 4000;  // that one interval's search looks at
constexpr std::size_t kMoreCuts = 1;      // than one valence needs; beyond, t's interval is halved
constexpr double kNearResidual = 1e-9;    // of a claimed eigenvector's residual

Error undecided(const std::string& what) { return Error{what}; }

/// The pair near a claim: an eigenpair of the middle to kNearResidual, its largest entry 1.
Result<EnclosedPair> claimed_pair(const number::BallMatrix& a, double value,
                                  const std::vector<double>& vector) {
  if (vector.size() != a.rows() || vector.empty())
    return Error{"an eigenvector has not the size of its matrix"};
  double largest = 0;
  bool is_near = true;
  for (std::size_t i = 0; i < vector.size(); ++i) {
    double residual = -value * vector[i];
    for (std::size_t j = 0; j < vector.size(); ++j) residual += a(i, j).approx() * vector[j];
    is_near = is_near && std::abs(residual) <= kNearResidual;
    if (std::abs(vector[i]) > std::abs(largest)) largest = vector[i];
  }
  if (!is_near || largest != 1)
    return Error{"what is claimed is no eigenvector of the interval's middle"};
  return enclose_eigenpair(a, value, vector);
}

}  // namespace

IntervalProver::IntervalProver(const CellMatrices& cells, const RangeRules& rules,
                               const CellSigns& signs, const RingCells& ring, bool searching)
    : cells_(cells),
      rules_(rules),
      signs_(signs),
      ring_(ring),
      searching_(searching),
      most_cuts_(searching ? kMoreCuts : kMostCellCuts) {}

Result<number::Ball> IntervalProver::show(ValenceInterval& claim) const {
  const Result<IntervalBlocks> blocks = IntervalBlocks::make(rules_, claim.begin, claim.end);
  if (!blocks) return blocks.error();
  if (Status found = fill(blocks->tangent(), claim.eigenvalue, claim.eigenvector); !found)
    return undecided("frequency 1 has no real leading eigenvalue");
  const Result<EnclosedPair> pair =
      claimed_pair(blocks->tangent(), claim.eigenvalue, claim.eigenvector);
  if (!pair) return undecided("frequency 1: " + pair.error().message);
  if (!pair->value.is_positive() || !number::is_less(pair->value, number::Ball(1)))
    return undecided("the leading eigenvalue of frequency 1 is not shown to lie between 0 and 1");
  if (!below(deflated(blocks->tangent(), *pair), pair->value, claim.squarings))
    return undecided("other eigenvalues of frequency 1 are not shown to be smaller than its first");
  if (Status shown = show_special(*blocks, *pair, claim); !shown) return shown.error();
  if (Status shown = show_constant(*blocks, *pair, claim); !shown) return shown.error();
  if (Status shown = show_ring(*blocks, *pair, claim); !shown) return shown.error();
  return pair->value;
}

bool IntervalProver::show_at(const Rational& t) {
  ValenceInterval point;
  point.begin = t;
  point.end = t;
  if (!show(point)) return false;
  for (const auto& words : point.parts)
    for (const std::string& word : words)
      most_cuts_ = std::clamp(word.size() + kMoreCuts, most_cuts_, kMostCellCuts);
  return true;
}

Status IntervalProver::show(TurnInterval& claim, const number::Ball& bound) const {
  const Result<TurnBlocks> blocks = turn_blocks(rules_, claim.begin, claim.end);
  if (!blocks) return blocks.error();
  if (searching_ || claim.right.empty()) {
    if (below(blocks->block, bound, claim.squarings)) return Done{};
    if (!searching_) return undecided("eigenvalues are not below the bound");
  }
  if (rules_.last_special() > 0)
    return undecided("eigenvalues of frequencies 2 … n/2 are not shown to be smaller");
  const number::BallMatrix transpose = transposed(blocks->block);
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

std::optional<int> IntervalProver::approx_rival(int n) const {
  const Rational t(Integer(1), Integer(n));
  const Result<IntervalBlocks> blocks = IntervalBlocks::make(rules_, t, t);
  const auto tangent = blocks ? approx_leader(blocks->tangent()) : std::nullopt;
  for (int frequency = rules_.last_special() + 1; tangent && frequency <= n / 2; ++frequency) {
    if (frequency == 1) continue;
    const Rational turn = Rational(4 * frequency * frequency) * t * t;
    const Result<TurnBlocks> other = turn_blocks(rules_, turn, turn);
    const auto leader = other ? approx_leader(other->block) : std::nullopt;
    if (leader && std::abs(leader->value) >= std::abs(tangent->value)) return frequency;
  }
  return std::nullopt;
}

Status IntervalProver::fill(const number::BallMatrix& a, double& value,
                            std::vector<double>& vector) const {
  if (!searching_) return Done{};
  std::optional<ApproxPair> found = approx_leader(a);
  if (!found) return undecided("no real eigenvalue leads");
  value = found->value;
  vector = std::move(found->vector);
  return Done{};
}

bool IntervalProver::below(const number::BallMatrix& a, const number::Ball& bound,
                           int& squarings) const {
  if (!searching_ && (squarings < 0 || squarings > kMostIntervalSquarings)) return false;
  const std::optional<int> found =
      squarings_below(a, bound, searching_ ? kMostIntervalSquarings : squarings);
  if (!found) return false;
  if (searching_) squarings = *found;
  return squarings == *found;
}

Status IntervalProver::show_special(const IntervalBlocks& blocks, const EnclosedPair& pair,
                                    ValenceInterval& claim) const {
  const auto count = static_cast<std::size_t>(std::max(rules_.last_special() - 1, 0));
  if (searching_) claim.special.assign(count, 0);
  if (claim.special.size() != count) return Error{"frequencies with other weights are missing"};
  for (std::size_t i = 0; i < count; ++i) {
    const int frequency = static_cast<int>(i) + 2;
    const Result<number::BallMatrix> block = blocks.special(frequency);
    if (!block) return block.error();
    if (!below(*block, pair.value, claim.special[i]))
      return undecided(
          fmt::format("eigenvalues of frequency {} are not shown to be smaller than "
                      "frequency 1's",
                      frequency));
  }
  return Done{};
}

Status IntervalProver::show_constant(const IntervalBlocks& blocks, const EnclosedPair& pair,
                                     ValenceInterval& claim) const {
  if (searching_ || claim.constant_squarings >= 0) {
    if (below(blocks.constant(), pair.value, claim.constant_squarings)) return Done{};
    if (!searching_) return undecided("eigenvalues of frequency 0 are not shown to be smaller");
  }
  claim.constant_squarings = -1;
  auto status = show_cup(blocks, pair, claim);
  if (status) return status;
  return undecided("frequency 0 is not shown to be smaller than frequency 1: " +
                   status.error().message);
}

Status IntervalProver::show_cup(const IntervalBlocks& blocks, const EnclosedPair& pair,
                                ValenceInterval& claim) const {
  if (!blocks.has_gap()) return undecided("powers of its matrix do not show it");
  const number::BallMatrix transpose = blocks.cup_transposed();
  if (!fill(transpose, claim.cup, claim.cup_vector))
    return undecided("no real eigenvalue leads it");
  const Result<EnclosedPair> cup = claimed_pair(transpose, claim.cup, claim.cup_vector);
  if (!cup) return cup.error();
  const number::Ball gap = blocks.cup_gap(*cup, pair);
  if (gap.is_negative()) return undecided("its leading eigenvalue is larger");
  if (!gap.is_positive() || !cup->value.is_positive())
    return undecided("the difference of their leading eigenvalues has no sign");
  if (!below(deflated(transpose, *cup), pair.value, claim.cup_squarings))
    return undecided("its second eigenvalue is close");
  if (!below(blocks.odd(), pair.value, claim.odd_squarings))
    return undecided("an eigenvalue of its imaginary parts is close");
  return Done{};
}

Status IntervalProver::show_ring(const IntervalBlocks& blocks, const EnclosedPair& pair,
                                 ValenceInterval& claim) const {
  IntervalRing ring(cells_, signs_, rules_, blocks, pair);
  if (searching_) claim.parts.assign(ring_.cells.size(), {});
  if (claim.parts.size() != ring_.cells.size()) return Error{"cells of the ring are missing"};
  const std::size_t count = ring_.cells.size();
  const std::size_t most_cuts = claim.begin == claim.end ? kMostCellCuts : most_cuts_;
  const long last_part = parts_seen_ + kMostIntervalParts;
  for (std::size_t at = 0; at < count; ++at) {
    const std::size_t i = (hardest_ + at) % count;
    const Result<CellMap> map = ring.map_on(ring_.cells[i]);
    if (!map) return map.error();
    std::vector<std::string> shown;
    PartSearch search{ring, claim.parts[i], most_cuts, shown, last_part};
    if (!show_part(search, *map, "")) {
      hardest_ = i;
      return undecided("the characteristic map's Jacobian, or its winding, is not decided");
    }
    if (searching_) claim.parts[i] = shown;
    if (claim.parts[i] != shown) return Error{"a cell has parts that are not needed"};
  }
  return Done{};
}

bool IntervalProver::show_part(PartSearch& search, const CellMap& map,
                               const std::string& word) const {
  const std::vector<std::string>& claimed = search.claimed;
  if (searching_ && ++parts_seen_ > search.last_part) return false;
  const bool is_claimed = std::find(claimed.begin(), claimed.end(), word) != claimed.end();
  if ((searching_ || is_claimed) && search.ring.agrees(map)) {
    search.shown.push_back(word);
    return true;
  }
  const auto is_within = [&](const std::string& one) {
    return one.size() > word.size() && one.starts_with(word);
  };
  const bool cut = word.size() < search.most_cuts &&
                   (searching_ || std::any_of(claimed.begin(), claimed.end(), is_within));
  if (!cut) return false;
  for (std::size_t digit = 0; digit < cells_.residual.size(); ++digit)
    if (!show_part(search, signs_.part(map, digit), word + static_cast<char>('0' + digit)))
      return false;
  return true;
}

}  // namespace limn::certify
