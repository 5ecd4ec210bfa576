#include "limn/certify/ring/regular_rows.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "limn/certify/blocks/real_blocks.h"
#include "limn/certify/ring/eigen_net.h"
#include "limn/number/exact.h"
#include "limn/refine/rule_tables.h"

namespace limn::certify {
namespace {

constexpr int kMostCrossings = 5;  // sectors of 13 that a walk and its anchor's flags may pass
constexpr int kMostLeaves = 4;
constexpr int kFirstRegularValence = 3;
constexpr int kLastValence = 60;

int count(const Moves& moves, Move one) {
  return static_cast<int>(std::count(moves.begin(), moves.end(), one));
}

/// How far walks of the interior rules go from their anchors, in edges; fails beyond the bounds.
class Reach {
 public:
  explicit Reach(const Scheme& scheme) : scheme_(scheme) {}

  Result<int> find() {
    const Distance face = of_face_rule();
    int reach = 0;
    std::string far;
    for (const RuleKind kind :
         {RuleKind::vertex, RuleKind::edge, RuleKind::edge_end, RuleKind::edge_third,
          RuleKind::face, RuleKind::face_end, RuleKind::corner})
      for_each_weight(kind, [&](const Weight& weight) {
        Distance way = of(weight.walk);
        if (weight.walk.reads_face)
          way = {way.leaves + 1 + face.leaves, way.crosses + face.crosses};
        reach = std::max(reach, way.leaves);
        if (far.empty() && (way.leaves > kMostLeaves || way.crosses > kMostCrossings ||
                            !turns_by_one(weight.walk)))
          far = weight.role;
      });
    if (far.empty()) return reach + 1;  // from the middle of the anchor
    return Error{fmt::format(
        "the walk of role '{}' goes so far that it may meet itself round the vertex, which "
        "proofs here do not follow",
        far)};
  }

 private:
  struct Distance {
    int leaves = 0;   ///< edges to other vertices (dual: faces)
    int crosses = 0;  ///< edges to other faces (dual: vertices)
  };

  template <class Visit>
  void for_each_weight(RuleKind kind, Visit&& visit) const {
    if (const std::optional<Rule>& rule = scheme_.rule(kind))
      for (const RuleCase& one : *rule)
        for (const Weight& weight : one.weights) visit(weight);
  }

  [[nodiscard]] bool is_dual() const { return scheme_.split->is_dual(); }
  [[nodiscard]] Move leaving() const { return is_dual() ? Move::face : Move::vertex; }
  [[nodiscard]] Move crossing() const { return is_dual() ? Move::vertex : Move::face; }

  [[nodiscard]] Distance of(const Walk& walk) const {
    return {count(walk.before, leaving()) + count(walk.after, leaving()),
            count(walk.before, crossing()) + count(walk.after, crossing())};
  }

  /// What reading a face's new vertex adds to a walk.
  [[nodiscard]] Distance of_face_rule() const {
    Distance most;
    for (const RuleKind kind : {RuleKind::face, RuleKind::face_end})
      for_each_weight(kind, [&](const Weight& weight) {
        const Distance way = of(weight.walk);
        most = {std::max(most.leaves, way.leaves), std::max(most.crosses, way.crosses)};
      });
    return most;
  }

  /// A repeated step is to turn round the anchor by one.
  [[nodiscard]] bool turns_by_one(const Walk& walk) const {
    return !walk.repeated ||
           (count(walk.before, leaving()) == 0 && walk.step.size() == 2 &&
            count(walk.step, crossing()) == 1 && count(walk.step, Move::edge) == 1);
  }

  const Scheme& scheme_;
};

/// The same of stages: the cut sees the face's corners, and two averagings one refined edge more.
/// They turn round a vertex by one sector, fewer than the star tells apart however many they are.
/// The rows are made in doubles, and exact where the regular weights are fractions of powers of 2.
Result<int> reach_of(const Scheme& scheme) {
  static_assert(kMostAveragings / 2 + 1 <= kMostCrossings);
  constexpr int kFinest = 64;
  const Result<refine::Row<number::Exact>> pair =
      refine::tabulate_row<number::Exact>(scheme, RuleKind::vertex, 4);
  if (!pair) return pair.error();
  for (const number::Exact& weight : pair->weights)
    if (!weight.is_rational() || !is_integer(weight.rational() * kFinest))
      return Error{"its averagings have weights on quads that are no fractions of powers of 2"};
  return scheme.stages->count / 2 + 2;
}

/// A row: weights by column and by how many sectors on from the row's the column's point lies.
using Column = std::pair<int, int>;

/// The mask's row of refined value k; nothing where it weighs what is more than a sector away.
std::optional<std::map<Column, Rational>> mask_row(const CellMatrices& cells,
                                                   const RealBasis& basis, LatticeVector k,
                                                   int sectors_of_row) {
  std::map<Column, Rational> row;
  const int half = cells.dual ? 1 : 0;
  for (const auto& [j, weight] : sources_of(cells, k)) {
    const auto found = turned_into_sector(cells.lattice, {2 * j[0] + half, 2 * j[1] + half});
    if (!found) return std::nullopt;
    if (found->place == LatticeVector{0, 0}) {
      row[{spectrum::kCenter, 0}] += weight;
      continue;
    }
    const auto [ring, place] =
        ring_and_place(cells, {(found->place[0] - half) / 2, (found->place[1] - half) / 2});
    if (ring > basis.rings) return std::nullopt;
    const std::size_t number = basis.orbit(ring, place);
    const RealOrbit& orbit = basis.orbits[number];
    row[{static_cast<int>(number),
         found->sector + (place - orbit.place) / orbit.size - sectors_of_row}] += weight;
  }
  return row;
}

/// The rows of a pattern, with the weights of regular rules evaluated.
class RuleRows {
 public:
  RuleRows(const Scheme& scheme, const spectrum::SectorPattern& pattern)
      : scheme_(scheme), pattern_(pattern), turn_(scheme.split->dilation.turns() ? 0.5 : 0) {
    for (const spectrum::SectorTerm& term : pattern.terms) terms_[term.row].push_back(&term);
  }

  /// Whether the row is that of the mask.
  [[nodiscard]] Result<bool> is(int row, const std::map<Column, Rational>& expected) const {
    std::map<Column, number::Exact> sums;
    for (const auto& [column, weight] : expected) sums[column] = number::Exact(Rational(-weight));
    const auto terms = terms_.find(row);
    if (terms == terms_.end()) return expected.empty();
    for (const spectrum::SectorTerm* term : terms->second) {
      if (term->repeated >= 0 || term->every_sector) return false;
      const Result<number::Exact> weight = weight_of(*term);
      if (!weight) return weight.error();
      number::Exact& sum = sums[{term->column, sectors_on(*term)}];
      const Result<number::Exact> next = number::Exact::add(sum, *weight);
      if (!next) return next.error();
      sum = *next;
    }
    return std::all_of(sums.begin(), sums.end(),
                       [](const auto& one) { return one.second.is_zero(); });
  }

 private:
  [[nodiscard]] int sectors_on(const spectrum::SectorTerm& term) const {
    if (term.column == spectrum::kCenter) return 0;
    const auto angle = [&](int orbit) {
      return pattern_.orbits[static_cast<std::size_t>(orbit)].angle;
    };
    return static_cast<int>(std::lround(term.angle - angle(term.column) + angle(term.row) + turn_));
  }

  [[nodiscard]] Result<number::Exact> weight_of(const spectrum::SectorTerm& term) const {
    number::Exact product(Rational(term.coefficient));
    for (const int number : term.names) {
      const spectrum::NamedWeight& name = pattern_.names[static_cast<std::size_t>(number)];
      if (!name.regular) return Error{"a rule that knows the valence"};
      Result<number::Exact> value =
          scope_of<number::Exact>(scheme_, name, std::nullopt, 0)(name.weight->value);
      if (value) value = number::Exact::multiply(*value, number::Exact(name.share));
      if (value) value = number::Exact::multiply(product, *value);
      if (!value) return value.error();
      product = *value;
    }
    return product;
  }

  const Scheme& scheme_;
  const spectrum::SectorPattern& pattern_;
  double turn_;
  std::map<int, std::vector<const spectrum::SectorTerm*>> terms_;
};

/// So many rings that rows beyond see nothing of the centre's other side, and that all which rows
/// within see lies in them.
int rings_to_compare(const CellMatrices& cells, int reach) {
  const double growth = std::sqrt(cells.dilation.growth());
  return std::max(static_cast<int>(std::ceil(growth * (reach + 1))),
                  static_cast<int>(std::ceil(reach * growth / (growth - 1)))) +
         1;
}

/// The star at the first valence at which the centre has rules: the rows that are compared are the
/// same at all.
Result<spectrum::SectorPattern> star_pattern(const Scheme& scheme, int rings) {
  for (int n = kFirstRegularValence;; ++n) {
    const Result<spectrum::CenterCases> cases = spectrum::center_cases(scheme, n);
    if (cases) return exact_pattern(scheme, n, rings);
    if (n == kLastValence) return cases.error();
  }
}

}  // namespace

Status check_regular_rows(const Scheme& scheme, const CellMatrices& cells) {
  const Result<int> reach = scheme.stages ? reach_of(scheme) : Reach(scheme).find();
  if (!reach) return reach.error();
  const Result<spectrum::SectorPattern> pattern =
      star_pattern(scheme, rings_to_compare(cells, *reach));
  if (!pattern) return pattern.error();
  const RealBasis basis = real_basis(*pattern);
  const RuleRows rules(scheme, *pattern);
  const int first = cells.dual ? 0 : 1;
  for (int x = first; x <= pattern->rings; ++x)
    for (int y = 0; y <= pattern->rings; ++y) {
      const auto [ring, place] = ring_and_place(cells, {x, y});
      if (ring > pattern->rings || is_near_center(cells, {x, y})) continue;
      const std::size_t number = basis.orbit(ring, place);
      const RealOrbit& orbit = basis.orbits[number];
      const auto expected = mask_row(cells, basis, {x, y}, (place - orbit.place) / orbit.size);
      if (!expected) continue;  // no proof takes the mask there
      const Result<bool> same = rules.is(static_cast<int>(number), *expected);
      if (!same) return same.error();
      if (!*same)
        return Error{fmt::format(
            "next to a vertex of another valence, at ({}, {})/{} of a sector, the rules are not "
            "the regular mask, which proofs here take them for",
            x, y, cells.steps == 1 ? cells.scale : 1)};
    }
  return Done{};
}

}  // namespace limn::certify
