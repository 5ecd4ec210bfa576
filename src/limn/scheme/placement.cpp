#include "limn/scheme/placement.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <map>
#include <mutex>
#include <tuple>

#include "limn/mesh/lattice.h"

namespace limn::scheme {
namespace {

constexpr Index kSide = 32;      // of the torus: more than twice the reach of the longest walk
constexpr int kDeepestTree = 9;  // crossings; beyond them walks count as different: safe
constexpr int kSectorReach = 2;  // how many sectors apart two equal walks are looked for

Error fault(std::string message) { return {std::move(message)}; }

/// A regular torus, cut open along a band of faces for boundary rules.
struct Arena {
  Mesh mesh;
  Index anchor = kNone;  // a half-edge: interior, or on the boundary
};

Arena make_arena(Lattice lattice, bool boundary) {
  Arena arena{mesh::torus(lattice, kSide, kSide), 0};
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
  const auto centred = [](Index d) {
    return ((d + kSide / 2) % kSide + kSide) % kSide - kSide / 2;
  };
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

bool has(const Moves& moves, Move move) {
  return std::find(moves.begin(), moves.end(), move) != moves.end();
}

/// The step must turn round the rule's own vertex or face, so that it is back after n of them.
Status check_repeated(RuleKind kind, const Walk& walk) {
  if (!rule_has_valence(kind) || kind == RuleKind::edge_side || kind >= RuleKind::boundary_vertex)
    return fault("a repeated step needs a rule with an n, at an interior vertex or a face");
  if (has(walk.before, Move::face) || has(walk.after, Move::face))
    return fault("only the repeated step may cross edges");
  if (has(walk.after, Move::boundary))
    return fault("the move b may not stand after a repeated step");
  const bool round_face = kind == RuleKind::face || kind == RuleKind::corner;
  const Move leaving = round_face ? Move::face : Move::vertex;
  const bool turns = walk.step.size() == 2 && walk.step[0] != walk.step[1] &&
                     has(walk.step, Move::edge) && !has(walk.step, leaving) &&
                     !has(walk.step, Move::boundary);
  if (!turns)
    return fault(round_face ? "the repeated step must turn round the face: (ve)* or (ev)*"
                            : "the repeated step must turn round the vertex: (ef)* or (fe)*");
  if (!round_face && has(walk.before, Move::vertex))
    return fault("the moves before a repeated step round a vertex may not leave the vertex");
  return Done{};
}

Status check_walk(RuleKind kind, const Walk& walk) {
  bool on_boundary = kind >= RuleKind::boundary_vertex && kind != RuleKind::boundary_spoke;
  for (const Move move : walk.before) {
    if (move == Move::boundary && !on_boundary)
      return fault("the move b is possible only along the boundary, from a boundary rule");
    on_boundary = on_boundary && (move == Move::vertex || move == Move::boundary);
  }
  if (walk.reads_face && has(walk.before, Move::face))
    return fault("a role that reads a face's new vertex may not cross an edge");
  if (walk.reads_face && kind != RuleKind::vertex && kind != RuleKind::edge &&
      kind != RuleKind::edge_side)
    return fault("only vertex and edge rules may read a face's new vertex");
  return walk.repeated ? check_repeated(kind, walk) : Status(Done{});
}

/// The moves from the anchor's first flag to its others, in the order of `anchor_flags`; of a
/// vertex or a face, to the second flag of its sector.
std::vector<Moves> flag_words(RuleKind kind) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::face_end:
    case RuleKind::corner: return {{}, {Move::edge}};
    case RuleKind::face: return {{}, {Move::vertex}};
    case RuleKind::edge:
    case RuleKind::edge_side: return {{}, {Move::vertex}, {Move::face, Move::vertex}, {Move::face}};
    case RuleKind::edge_end:
    case RuleKind::edge_third:
    case RuleKind::boundary_spoke: return {{}, {Move::face}};
    default: return {};  // at the boundary every flag stands for itself
  }
}

/// The moves from a vertex's or a face's flag to the same flag `count` sectors on.
Moves sector_word(RuleKind kind, int count) {
  const bool face = kind == RuleKind::face;
  Moves word;
  for (; count > 0; --count) {
    word.push_back(face ? Move::vertex : Move::edge);
    word.push_back(face ? Move::edge : Move::face);
  }
  for (; count < 0; ++count) {
    word.push_back(face ? Move::edge : Move::face);
    word.push_back(face ? Move::vertex : Move::edge);
  }
  return word;
}

Moves joined(std::initializer_list<Moves> words) {
  Moves result;
  for (const Moves& word : words) result.insert(result.end(), word.begin(), word.end());
  return result;
}

/// Whether two words of v, e, f are the same walk from every flag of every mesh of polygons, if
/// moves that keep the end in place are free at the end. The only laws are that each move
/// undoes itself and that v and f commute.
bool same_end_on_polygons(const Moves& a, const Moves& b, bool reads_face) {
  Moves reduced;  // of a backwards, then b
  const auto push = [&reduced](Move move) {
    const auto commutes = [move](Move other) {
      return move != other && move != Move::edge && other != Move::edge;
    };
    std::size_t i = reduced.size();
    while (i > 0 && commutes(reduced[i - 1])) --i;
    if (i > 0 && reduced[i - 1] == move)
      reduced.erase(reduced.begin() + static_cast<std::ptrdiff_t>(i) - 1);
    else
      reduced.push_back(move);
  };
  std::for_each(a.rbegin(), a.rend(), push);
  std::for_each(b.begin(), b.end(), push);
  const Move leaving = reads_face ? Move::face : Move::vertex;
  return std::find(reduced.begin(), reduced.end(), leaving) == reduced.end();
}

/// The same on every mesh of triangles; walks of many crossings count as different.
bool same_end_on_triangles(const Moves& a, const Moves& b, bool reads_face) {
  static const std::vector<Mesh> trees = [] {
    std::vector<Mesh> result;
    for (int depth = 0; depth <= kDeepestTree; ++depth)
      result.push_back(mesh::tree(Lattice::triangle, depth));
    return result;
  }();
  const auto crossings = [](const Moves& word) {
    return static_cast<std::size_t>(std::count(word.begin(), word.end(), Move::face));
  };
  const std::size_t depth = std::max(crossings(a), crossings(b));
  if (depth >= trees.size()) return false;
  const Mesh& mesh = trees[depth];
  const auto end = [&mesh, reads_face](const Moves& word) {
    return end_of(mesh, {0, false}, {word, {}, {}, false, reads_face});
  };
  return end(a) == end(b);
}

/// Whether two walks from one flag end together on every mesh of the lattice's kind: triangles
/// only, or any polygons.
bool same_end(Lattice lattice, const Moves& a, const Moves& b, bool reads_face) {
  return lattice == Lattice::triangle ? same_end_on_triangles(a, b, reads_face)
                                      : same_end_on_polygons(a, b, reads_face);
}

Result<Placement> place_flat(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Arena& regular = arena(lattice, kind >= RuleKind::boundary_vertex);
  const bool spoke = kind == RuleKind::boundary_spoke;
  const AnchorFlags anchors = anchor_flags(
      kind, regular.mesh, spoke ? regular.mesh.rotate(regular.anchor) : regular.anchor);
  const std::vector<Moves> words = flag_words(kind);

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
      const auto whole = [&](int flag) {
        return joined({words[static_cast<std::size_t>(flag)], walk.before});
      };
      const auto same = [&](const Start& start) {
        return !words.empty() && same_end(lattice, whole(start.flag), whole(i), walk.reads_face);
      };
      const auto found = std::find_if(starts.begin(), starts.end(), same);
      if (found != starts.end()) {
        found->share += share;
        continue;
      }
      const Flag flag = anchors.flags[i];
      const Extension outside = walk.reads_face ? Extension{} : extension(regular.mesh, flag, end);
      starts.push_back({i, share, outside});
    }
    placement.starts.insert(placement.starts.end(), starts.begin(), starts.end());
  }
  std::sort(placement.starts.begin(), placement.starts.end(),
            [](const Start& a, const Start& b) { return a.flag < b.flag; });
  return placement;
}

/// How many of the anchor's 2n flags walk to the position that the first one walks to.
int count_sharers(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Arena& regular = arena(lattice, false);
  const Flag first = anchor_flags(kind, regular.mesh, regular.anchor).flags[0];
  const auto end = [&](const Moves& word) {
    Walk whole = walk;
    whole.before = joined({word, walk.before});
    return end_of(regular.mesh, first, whole);
  };
  int sharers = 0;
  for (int s = 0; s < regular_valence(kind, lattice); ++s)
    for (const Moves& flag : flag_words(kind))
      sharers += end(joined({sector_word(kind, s), flag})) == end({}) ? 1 : 0;
  return sharers;
}

Result<Placement> place_in_sectors(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Arena& regular = arena(lattice, false);
  const AnchorFlags first = anchor_flags(kind, regular.mesh, regular.anchor);
  const int sharers = count_sharers(kind, lattice, walk);
  Placement placement;
  if (sharers == 2 * regular_valence(kind, lattice)) {
    if (!walk.before.empty())
      return fault("the walk returns to its start; give that weight to the role self");
    placement.starts.push_back({0, 1, {}});
    placement.count = 1;
    return placement;
  }
  const Moves second = flag_words(kind)[1];
  bool mirrored = false;  // does the second flag of some sector always end where ours does?
  for (int s = -kSectorReach; s <= kSectorReach; ++s)
    mirrored =
        mirrored || same_end(lattice, walk.before,
                             joined({sector_word(kind, s), second, walk.before}), walk.reads_face);
  placement.per_sector = true;
  placement.times_n = true;
  placement.count = Rational(2, sharers);
  for (int t = 0; t < (mirrored ? 1 : 2); ++t) {
    const Flag flag = first.flags[t];
    const Extension outside = walk.reads_face
                                  ? Extension{}
                                  : extension(regular.mesh, flag, end_of(regular.mesh, flag, walk));
    placement.starts.push_back({t, Rational(mirrored ? 2 : 1, sharers), outside});
  }
  return placement;
}

/// A repeated role, from the anchor's first flag where its mirror image meets the same positions
/// (in a rule with a first k: in the order 0, n-1, …, 1), and half from either flag elsewhere.
Placement place_repeated(RuleKind kind, Lattice lattice, const Walk& walk) {
  const Moves second = flag_words(kind)[1];
  const bool round = kind == RuleKind::vertex || kind == RuleKind::face;
  const Moves back(walk.step.rbegin(), walk.step.rend());
  const auto steps = [&](int count) {
    Moves word = walk.before;
    for (int i = 0; i < std::abs(count); ++i) word = joined({word, count > 0 ? walk.step : back});
    return joined({word, walk.after});
  };
  const auto mirrors = [&](int shift) {  // k from the second flag is shift - k from the first
    return same_end(lattice, joined({second, steps(0)}), steps(shift), walk.reads_face) &&
           same_end(lattice, joined({second, steps(1)}), steps(shift - 1), walk.reads_face);
  };
  bool mirrored = mirrors(0);
  for (int shift = -kSectorReach; round && shift <= kSectorReach; ++shift)
    mirrored = mirrored || mirrors(shift);
  Placement placement;
  placement.count = 1;
  placement.times_n = true;
  placement.starts.push_back({0, mirrored ? Rational(1) : Rational(1, 2), {}});
  if (!mirrored) placement.starts.push_back({1, Rational(1, 2), {}});
  return placement;
}

}  // namespace

AnchorFlags anchor_flags(RuleKind kind, const Mesh& mesh, Index h, bool at_target) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::face_end:
    case RuleKind::corner: return {{{h, false}, {mesh.prev(h), true}}, 2};
    case RuleKind::face:
    case RuleKind::boundary_edge: return {{{h, false}, {h, true}}, 2};
    case RuleKind::edge:
    case RuleKind::edge_side: {
      const Index twin = mesh.twin(h);
      return {{{h, false}, {h, true}, {twin, false}, {twin, true}}, 4};
    }
    case RuleKind::edge_end:
    case RuleKind::edge_third:
    case RuleKind::boundary_spoke: return {{{h, at_target}, {mesh.twin(h), !at_target}}, 2};
    case RuleKind::boundary_vertex: return {{{h, false}, other_boundary_flag(mesh, {h, false})}, 2};
    case RuleKind::boundary_edge_end: return {{{h, at_target}}, 1};
  }
  return {};
}

namespace {

Result<Placement> compute_placement(RuleKind kind, Lattice lattice, const Walk& walk) {
  if (Status status = check_walk(kind, walk); !status) return status.error();
  if (walk.repeated) return place_repeated(kind, lattice, walk);
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

}  // namespace limn::scheme
