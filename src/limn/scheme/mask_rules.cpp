#include "limn/scheme/mask_rules.h"

/// Rules from a mask: every old vertex that a new one weighs is reached by a walk from the new
/// vertex's anchor; vertices that the anchor's symmetries exchange form one role.

#include <algorithm>
#include <deque>
#include <set>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/scheme/placement.h"

namespace limn::scheme {
namespace {

constexpr int kMaskSide = 64;  // of the torus; masks reach less than half of it

/// The new vertex that the anchor named by h gives birth to.
Index birth_of(RuleKind kind, const Mesh& mesh, const Births& births, Index h) {
  switch (kind) {
    case RuleKind::edge:
    case RuleKind::edge_third: return child_along(mesh, births, h);
    case RuleKind::face: return births.from_vertices + births.from_edges + mesh.face(h);
    case RuleKind::corner: return births.from_vertices + births.from_edges + births.from_faces + h;
    default: return mesh.origin(h);
  }
}

/// The shortest walk from `start` to each vertex that is wanted.
std::map<Index, Moves> shortest_walks(const Mesh& mesh, Flag start, std::set<Index> wanted) {
  std::map<Index, Moves> walks;
  std::set<std::pair<Index, bool>> seen{{start.halfedge, start.at_target}};
  std::deque<std::pair<Flag, Moves>> queue{{start, {}}};
  while (!queue.empty() && !wanted.empty()) {
    auto [flag, moves] = std::move(queue.front());
    queue.pop_front();
    if (wanted.erase(vertex_of(mesh, flag)) > 0) walks[vertex_of(mesh, flag)] = moves;
    for (const Move move : {Move::vertex, Move::edge, Move::face}) {
      Flag next = flag;
      if (!apply(mesh, move, next) || !seen.insert({next.halfedge, next.at_target}).second)
        continue;
      Moves longer = moves;
      longer.push_back(move);
      queue.emplace_back(next, std::move(longer));
    }
  }
  return walks;
}

/// All flags of the anchor: a sector's two for every sector, or the flat list.
std::vector<Flag> all_flags(RuleKind kind, const Mesh& mesh, Index h) {
  std::vector<Flag> flags;
  const bool sectors = kind == RuleKind::vertex || kind == RuleKind::face;
  Index sector = h;
  do {
    const AnchorFlags part = anchor_flags(kind, mesh, sector);
    flags.insert(flags.end(), part.flags, part.flags + part.count);
    sector = kind == RuleKind::face ? mesh.next(sector) : mesh.rotate(sector);
  } while (sectors && sector != h);
  return flags;
}

std::set<Index> ends(const Mesh& mesh, const std::vector<Flag>& flags, const Moves& moves) {
  std::set<Index> result;
  for (Flag flag : flags) {
    (void)apply(mesh, moves, flag);
    result.insert(vertex_of(mesh, flag));
  }
  return result;
}

std::string name_of(RuleKind kind, Lattice lattice, const Mesh& mesh,
                    const std::vector<Flag>& flags, const std::set<Index>& orbit,
                    const Walk& walk) {
  for (const NamedRole& role : named_roles(kind, lattice)) {
    const Walk named = parse_walk(role.walk).value();
    if (!named.repeated && !named.reads_face && ends(mesh, flags, named.before) == orbit)
      return std::string(role.name);
  }
  return to_string(walk);
}

/// The weights of one kind of new vertex; nothing where the mask lacks the anchor's symmetry.
std::optional<std::vector<Weight>> weights_of(const Mask& mask, RuleKind kind, const Mesh& mesh,
                                              const Births& births, const Place& place) {
  const Index h = 0;
  const mesh::Twelfths birth =
      mesh::torus_birth_place(mesh, kMaskSide, kMaskSide, births, birth_of(kind, mesh, births, h));
  std::map<Index, Rational> values;
  std::set<Index> wanted;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const mesh::Twelfths old{12 * (v % kMaskSide), 12 * (v / kMaskSide)};
    const auto found = mask.coefficients.find(
        mask_offset(mask.dilation, mesh::torus_difference(old, birth, kMaskSide, kMaskSide)));
    if (found == mask.coefficients.end()) continue;
    values[v] = found->second;
    wanted.insert(v);
  }
  const std::vector<Flag> flags = all_flags(kind, mesh, h);
  std::map<Index, Moves> walks = shortest_walks(mesh, flags.front(), wanted);
  std::vector<Weight> weights;
  while (!walks.empty()) {
    const auto shortest = std::min_element(
        walks.begin(), walks.end(),
        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    Walk walk;
    walk.before = shortest->second;
    const std::set<Index> orbit = ends(mesh, flags, walk.before);
    const Rational value = values[shortest->first];
    for (const Index v : orbit) {
      const auto found = values.find(v);
      if (found == values.end() || found->second != value) return std::nullopt;
      walks.erase(v);
    }
    weights.push_back({name_of(kind, mask.lattice, mesh, flags, orbit, walk),
                       walk,
                       {Expression::constant(value), place}});
  }
  return weights;
}

}  // namespace

Status add_rules_from_mask(Scheme& scheme) {
  const Place place = scheme.mask ? scheme.mask->place : scheme.factors->place;
  const Result<Mask> mask = scheme.mask ? mask_from_rows(scheme, *scheme.mask)
                                        : mask_from_factors(scheme, *scheme.factors);
  if (!mask) return mask.error();
  const Split& split = *scheme.split;
  std::vector<RuleKind> kinds;
  if (split.births.vertices) kinds.push_back(RuleKind::vertex);
  if (split.births.edges)
    kinds.push_back(split.births.thirds ? RuleKind::edge_third : RuleKind::edge);
  if (split.births.faces) kinds.push_back(RuleKind::face);
  if (split.births.corners) kinds.push_back(RuleKind::corner);
  const Mesh mesh = mesh::torus(split.lattice, kMaskSide, kMaskSide);
  const Births births = split.apply(mesh, 0).births;
  std::array<std::optional<Rule>, kRuleKinds> rules;
  for (const RuleKind kind : kinds) {
    std::optional<std::vector<Weight>> weights = weights_of(*mask, kind, mesh, births, place);
    if (!weights) {
      scheme.rules = {};
      return Done{};
    }
    RuleCase regular{std::nullopt, std::move(*weights), place};
    if (rule_has_valence(kind)) {
      const std::string guard = fmt::format("n == {}", regular_valence(kind, split.lattice));
      regular.when = Formula{Expression::parse(guard).value(), place};
    }
    rules[static_cast<std::size_t>(kind)] = Rule{std::move(regular)};
  }
  scheme.rules = std::move(rules);
  return Done{};
}

}  // namespace limn::scheme
