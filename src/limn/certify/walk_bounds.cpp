#include "limn/certify/walk_bounds.h"

#include <fmt/core.h>

namespace limn::certify {
namespace {

constexpr int kMostAtAnchor = 6;  // sectors: less than half of the star that blocks are made from
constexpr int kMostSteps = 3;

struct Bounds {
  Move leaves;    ///< the move that leaves a vertex (dual: a face)
  Move turns;     ///< the move that, between two others, turns by a sector
  int elsewhere;  ///< most turns round what is not the anchor's
};

/// Whether moves stay within the bounds; `at_anchor`: they begin there.
bool within(const Moves& moves, const Bounds& bounds, bool at_anchor, int& steps) {
  int turns = 0;
  for (const Move move : moves) {
    if (move == bounds.leaves) {
      at_anchor = false;
      turns = 0;
      if (++steps > kMostSteps) return false;
    } else if (move == bounds.turns) {
      if (++turns > (at_anchor ? kMostAtAnchor : bounds.elsewhere)) return false;
    }
  }
  return true;
}

bool is_short(const Walk& walk, const Bounds& bounds) {
  int steps = 0;
  if (!within(walk.before, bounds, true, steps)) return false;
  if (!walk.repeated) return true;
  // a ring round the anchor: one turn a step, and no leaving
  int turns = 0;
  for (const Move move : walk.step) {
    if (move == bounds.leaves) return false;
    turns += move == bounds.turns ? 1 : 0;
  }
  return turns == 1 && steps == 0 && within(walk.after, bounds, false, steps);
}

}  // namespace

std::optional<std::string> walk_beyond_bounds(const Scheme& scheme) {
  const bool dual = scheme.split->is_dual();
  const Bounds bounds =
      dual ? Bounds{Move::face, Move::vertex, 1}
           : Bounds{Move::vertex, Move::edge, scheme.split->lattice == Lattice::triangle ? 2 : 1};
  for (const RuleKind kind : {RuleKind::vertex, RuleKind::edge, RuleKind::edge_end,
                              RuleKind::edge_third, RuleKind::face, RuleKind::corner}) {
    const std::optional<Rule>& rule = scheme.rule(kind);
    if (!rule) continue;
    for (const RuleCase& one : *rule)
      for (const Weight& weight : one.weights)
        if (!is_short(weight.walk, bounds))
          return fmt::format(
              "the walk of role '{}' goes so far that another valence near it may "
              "change where it ends, which proofs here do not follow",
              weight.role);
  }
  return std::nullopt;
}

}  // namespace limn::certify
