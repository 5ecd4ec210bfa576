#include "limn/scheme/placement.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <tuple>

#include "limn/mesh/lattice.h"

namespace limn {
namespace {

constexpr Index kSide = 32;       // of the torus: more than twice the reach of the longest walk
constexpr int kDeepestTree = 9;   // faces; beyond that walks count as different, which is safe
constexpr int kSectorReach = 2;   // how many sectors apart two equal walks are looked for

Error fault(std::string message) { return {std::move(message), {}, {}, 0, 0}; }

/// A regular torus, cut open along a band of faces for boundary rules.
struct Arena {
  Mesh mesh;
  Index anchor = kNone;  // a half-edge: interior, or on the boundary
};

Arena make_arena(Lattice lattice, bool boundary) {
  Arena arena{torus(lattice, kSide, kSide), 0};
  if (!boundary) return arena;
  const Index per_row = kSide * (lattice == Lattice::triangle ? 2 : 1);
  const Polygons whole = arena.mesh.polygons(std::vector<Point3>(kSide * kSide));
  Polygons cut;
  cut.positions = whole.positions;
  for (Index f = 0; f < whole.face_count() - 4 * per_row; ++f) {
    for (Index c = whole.face_begin[f]; c < whole.face_begin[f + 1]; ++c)
      cut.corners.push_back(whole.corners[c]);
    cut.face_begin.push_back(static_cast<Index>(cut.corners.size()));
  }
  arena.mesh = Mesh::build(cut).value();
  while (arena.mesh.twin(arena.anchor) != kNone) ++arena.anchor;
  return arena;
}

const Arena& arena(Lattice lattice, bool boundary) {
  static const std::array<Arena, 4> arenas{
      make_arena(Lattice::triangle, false), make_arena(Lattice::triangle, true),
      make_arena(Lattice::quad, false), make_arena(Lattice::quad, true)};
  return arenas[(lattice == Lattice::quad ? 2U : 0U) + (boundary ? 1U : 0U)];
}

/// Vertex reached, or ~face where the walk reads one; kNone-like minimum where it leaves the mesh.
constexpr Index kOutside = std::numeric_limits<Index>::min();

Index end_of(const Mesh& mesh, Flag flag, const Walk& walk) {
  if (!apply(mesh, walk.before, flag)) return kOutside;
  return walk.reads_face ? ~mesh.face(flag.halfedge) : vertex_of(mesh, flag);
}

std::array<Index, 2> difference(Index from, Index to) {
  const auto centred = [](Index d) { return ((d + kSide / 2) % kSide + kSide) % kSide - kSide / 2; };
  return {centred(to % kSide - from % kSide), centred(to / kSide - from / kSide)};
}

Extension extension(const Mesh& mesh, Flag flag, Index end) {
  const Index v = vertex_of(mesh, flag);
  Flag across = flag;
  Flag aside = flag;
  (void)apply(mesh, Move::vertex, across);
  (void)apply(mesh, Moves{Move::edge, Move::vertex}, aside);
  const auto a = difference(v, vertex_of(mesh, across));
  const auto b = difference(v, vertex_of(mesh, aside));
  const auto p = difference(v, end);
  const Index det = a[0] * b[1] - a[1] * b[0];  // ±1
  return {det * (p[0] * b[1] - p[1] * b[0]), det * (a[0] * p[1] - a[1] * p[0])};
}

Status check_walk(RuleKind kind, const Walk& walk) {
  const auto has = [](const Moves& moves, Move move) {
    return std::find(moves.begin(), moves.end(), move) != moves.end();
  };
  const bool at_boundary = kind >= RuleKind::boundary_vertex;
  bool on_boundary = at_boundary;
  for (const Move move : walk.before) {
    if (move == Move::boundary && !on_boundary)
      return fault("the move b is possible only along the boundary, from a boundary rule");
    on_boundary = on_boundary && (move == Move::vertex || move == Move::boundary);
  }
  if (walk.reads_face && has(walk.before, Move::face))
    return fault("a role that reads a face's new vertex may not cross an edge");
  if (walk.reads_face && kind != RuleKind::vertex && kind != RuleKind::edge)
    return fault("only vertex and edge rules may read a face's new vertex");
  if (!walk.repeated) return Done{};
  if (!rule_has_valence(kind) || at_boundary)
    return fault("a repeated step needs a rule with an n, at an interior vertex or a face");
  if (has(walk.before, Move::face) || has(walk.after, Move::face))
    return fault("only the repeated step may cross edges");
  if (has(walk.step, Move::boundary) || has(walk.after, Move::boundary))
    return fault("the move b may not stand in or after a repeated step");
  const bool round_face = kind == RuleKind::face || kind == RuleKind::corner;
  if (round_face && has(walk.step, Move::face))
    return fault("a step round a face may not cross its edges");
  return Done{};
}

int crossings(const Walk& walk) {
  return static_cast<int>(std::count(walk.before.begin(), walk.before.end(), Move::face));
}

/// The tree on which walks of `kind` are told apart; a single face where it would be too large.
Mesh tree_for(const Walk& walk, Lattice lattice, int extra) {
  const int depth = crossings(walk) + extra;
  return tree(lattice, depth <= kDeepestTree ? depth : 1);
}

/// Walks that leave the tree are never called equal.
bool same_end(const Mesh& mesh, Flag a, Flag b, const Walk& walk) {
  const Index end = end_of(mesh, a, walk);
  return end != kOutside && end == end_of(mesh, b, walk);
}

Result<Placement> place_flat(RuleKind kind, Lattice lattice, const Walk& walk) {
  const bool at_boundary = kind >= RuleKind::boundary_vertex;
  const Arena& regular = arena(lattice, at_boundary);
  const AnchorFlags anchors = anchor_flags(kind, regular.mesh, regular.anchor);
  const Mesh general = tree_for(walk, lattice, 2);
  const AnchorFlags twins = at_boundary ? AnchorFlags{} : anchor_flags(kind, general, 0);

  std::map<Index, std::vector<int>> classes;  // by lattice position
  for (int i = 0; i < anchors.count; ++i) {
    const Index end = end_of(regular.mesh, anchors.flags[i], walk);
    if (end == kOutside) return fault("the walk leaves the mesh at a regular boundary");
    classes[end].push_back(i);
  }
  Placement placement;
  placement.count = static_cast<int>(classes.size());
  for (const auto& [end, members] : classes) {
    std::vector<Start> starts;
    for (const int i : members) {
      const Rational share(1, static_cast<int>(members.size()));
      const auto same = [&](const Start& start) {
        return !at_boundary && same_end(general, twins.flags[start.flag], twins.flags[i], walk);
      };
      const auto found = std::find_if(starts.begin(), starts.end(), same);
      if (found != starts.end()) {
        found->share += share;
        continue;
      }
      const Flag flag = anchors.flags[i];
      const Extension outside =
          walk.reads_face ? Extension{} : extension(regular.mesh, flag, end);
      starts.push_back({i, share, outside});
    }
    placement.starts.insert(placement.starts.end(), starts.begin(), starts.end());
  }
  std::sort(placement.starts.begin(), placement.starts.end(),
            [](const Start& a, const Start& b) { return a.flag < b.flag; });
  return placement;
}

/// The half-edge that names the anchor's sector `steps` sectors on; kNone past a tree's rim.
Index sector(RuleKind kind, const Mesh& mesh, Index h, int steps) {
  for (; steps > 0 && h != kNone; --steps)
    h = kind == RuleKind::face ? mesh.next(h) : mesh.rotate(h);
  for (; steps < 0 && h != kNone; ++steps) {
    if (kind == RuleKind::face) {
      h = mesh.prev(h);
    } else {
      const Index twin = mesh.twin(h);
      h = twin == kNone ? kNone : mesh.next(twin);
    }
  }
  return h;
}

Result<Placement> place_in_sectors(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Arena& regular = arena(lattice, false);
  const int n = regular_valence(kind, lattice);
  const AnchorFlags first = anchor_flags(kind, regular.mesh, regular.anchor);
  const Index end = end_of(regular.mesh, first.flags[0], walk);
  int sharers = 0;
  for (int s = 0; s < n; ++s) {
    const Index h = sector(kind, regular.mesh, regular.anchor, s);
    const AnchorFlags flags = anchor_flags(kind, regular.mesh, h);
    for (int t = 0; t < 2; ++t) sharers += end_of(regular.mesh, flags.flags[t], walk) == end;
  }
  Placement placement;
  if (sharers == 2 * n) {
    if (!walk.before.empty())
      return fault("the walk returns to its start; give that weight to the role self");
    placement.starts.push_back({0, 1, {}});
    placement.count = 1;
    return placement;
  }
  const Mesh general = tree_for(walk, lattice, 2 + kSectorReach);
  const Flag start = anchor_flags(kind, general, 0).flags[0];
  bool mirrored = false;  // does the second flag of some sector always end where ours does?
  for (int s = -kSectorReach; s <= kSectorReach && !mirrored; ++s) {
    const Index h = sector(kind, general, 0, s);
    mirrored = h != kNone && same_end(general, start, anchor_flags(kind, general, h).flags[1], walk);
  }
  placement.per_sector = true;
  placement.times_n = true;
  placement.count = Rational(2, sharers);
  for (int t = 0; t < (mirrored ? 1 : 2); ++t) {
    const Flag flag = first.flags[t];
    const Extension outside =
        walk.reads_face ? Extension{}
                        : extension(regular.mesh, flag, end_of(regular.mesh, flag, walk));
    placement.starts.push_back({t, Rational(mirrored ? 2 : 1, sharers), outside});
  }
  return placement;
}

}  // namespace

AnchorFlags anchor_flags(RuleKind kind, const Mesh& mesh, Index h, bool at_target) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::corner: return {{{h, false}, {mesh.prev(h), true}}, 2};
    case RuleKind::face:
    case RuleKind::boundary_edge: return {{{h, false}, {h, true}}, 2};
    case RuleKind::edge: {
      const Index twin = mesh.twin(h);
      return {{{h, false}, {h, true}, {twin, false}, {twin, true}}, 4};
    }
    case RuleKind::edge_end: return {{{h, at_target}, {mesh.twin(h), !at_target}}, 2};
    case RuleKind::boundary_vertex:
      return {{{h, false}, other_boundary_flag(mesh, {h, false})}, 2};
    case RuleKind::boundary_edge_end: return {{{h, at_target}}, 1};
  }
  return {};
}

namespace {

Result<Placement> compute_placement(RuleKind kind, Lattice lattice, const Walk& walk) {
  if (Status status = check_walk(kind, walk); !status) return status.error();
  if (walk.repeated) {
    Placement placement;
    placement.starts.push_back({0, 1, {}});
    placement.count = 1;
    placement.times_n = true;
    return placement;
  }
  if (kind == RuleKind::vertex || kind == RuleKind::face)
    return place_in_sectors(kind, lattice, walk);
  return place_flat(kind, lattice, walk);
}

}  // namespace

Result<Placement> place(RuleKind kind, Lattice lattice, const Walk& walk) {
  using Key = std::tuple<RuleKind, Lattice, std::string>;
  static std::mutex mutex;
  static std::map<Key, Result<Placement>> known;
  const Key key{kind, lattice, to_string(walk)};
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  return known.try_emplace(key, compute_placement(kind, lattice, walk)).first->second;
}

}  // namespace limn
