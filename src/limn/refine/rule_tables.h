#pragma once
/// Weights, tabulated per (rule, n, k) before a run, and the programs that walk from an anchor
/// to the vertices they weigh. No expression is evaluated inside a mesh loop.

#include <functional>
#include <memory>
#include <vector>

#include "limn/mesh/rings.h"
#include "limn/mesh/split/split.h"
#include "limn/refine/staged_mesh.h"
#include "limn/scheme/check.h"
#include "limn/scheme/placement.h"
#include "limn/scheme/scheme.h"

namespace limn::refine {

/// A walk from the half-edge that names an anchor, without its flags: which end of an edge a walk
/// is at is known beforehand, so that only moves between half-edges are left to make.
enum class Hop : std::uint8_t { next, prev, twin };

/// Hops, one after the other.
struct Way {
  std::array<Hop, 32> hops;
  std::uint8_t count = 0;
};

/// One walk of a rule's case, from one of the anchor's flags.
struct Step {
  Way way;
  /// Where the way begins: the end that an earlier step has kept under this number; -1: at the
  /// anchor. And under which number this step's end is kept; -1: it is not.
  int after = -1, kept = -1;
  /// The hops say it all: the vertex is the origin where they end. Of a repeated walk: `way` leads
  /// to k = 0, `turn` from each k to the next, and `out` from a k to its vertex.
  bool direct = false;
  Way turn, out;
  /// How a repeated walk turns round a vertex from one half-edge out of it to the next; none: it
  /// does not, or is not one of hops.
  enum class Turning : std::int8_t { none, counterclockwise, clockwise };
  Turning turning = Turning::none;
  bool per_sector = false;
  Walk walk;
  int flag = 0;
  scheme::Extension extension;
  Rational share = 1;
  const Weight* weight = nullptr;  // in the scheme that the tables were made for
};
using Program = std::vector<Step>;
inline constexpr std::size_t kSharedSteps = 16;  ///< ends that a program may keep

/// The weights of a rule at one valence: `weights` in the order of the program's steps, a
/// repeated step having n of them. `program` is null where no case applies (of rules that
/// stand in for another, or at a boundary that is left out), and in a scheme of stages. There the
/// face rule's row has the one weight of a corner in the middle of a face of n, and the vertex
/// rule's (RuleTables::pair) those of a pair of averagings, one for each PairRole.
template <class Number>
struct Row {
  std::shared_ptr<const Program> program;
  std::vector<Number> weights;
};

/// What a weight weighs: an old vertex, or the new vertex of an old face.
struct Source {
  Index index;
  bool is_face;
};

/// Whether the boundary is refined, or left out (its new values are zero): on a star the rim is
/// no part of the analysis, and a scheme need not have boundary rules for it.
enum class Boundary { refined, left_out };

/// The row of a rule at valence n: its case there, compiled and evaluated. `quads`: as for
/// applicable_case. Fails as RuleTables::prepare says. For double and Exact.
template <class Number>
[[nodiscard]] Result<Row<Number>> tabulate_row(const Scheme& scheme, RuleKind kind, int n,
                                               std::optional<int> quads = {});

template <class Number>
class RuleTables {
 public:
  /// Makes the row of a rule at valence n, the first time that it is needed; `quads` as for
  /// tabulate_row.
  using RowMaker =
      std::function<Result<Row<Number>>(RuleKind kind, int n, std::optional<int> quads)>;

  /// `scheme` must outlive the tables.
  explicit RuleTables(const Scheme& scheme, Boundary boundary = Boundary::refined)
      : RuleTables(scheme, boundary, [&scheme](RuleKind kind, int n, std::optional<int> quads) {
          return tabulate_row<Number>(scheme, kind, n, quads);
        }) {}
  RuleTables(const Scheme& scheme, Boundary boundary, RowMaker make_row)
      : scheme_(&scheme), boundary_(boundary), make_row_(std::move(make_row)) {}

  /// Tabulates every row that one step on `mesh` needs and that is not there yet. Fails, naming
  /// the rule, the valence and a vertex that has it, where a rule is missing or its weights do not
  /// sum to 1. Up to valence kLargestExactValence that is decided exactly; beyond, to 1e-9.
  [[nodiscard]] Status prepare(const Mesh& mesh, const Births& births);

  /// Precondition: `prepare` saw a mesh with this rule at this n.
  [[nodiscard]] const Row<Number>& row(RuleKind kind, Index n) const {
    if (boundary_ == Boundary::left_out && kind >= RuleKind::boundary_vertex) return none_;
    return rows_[static_cast<std::size_t>(kind)][rule_has_valence(kind) ? n : 0];
  }
  /// In a scheme of stages, what a pair of averagings weighs at a vertex of that many edges and
  /// quads. Precondition as for `row`.
  [[nodiscard]] const Row<Number>& pair(Index n, Index quads) const {
    return pairs_[static_cast<std::size_t>(n)][static_cast<std::size_t>(quads)].row;
  }
  /// The same as `row`; nullptr where `prepare` saw no such rule.
  [[nodiscard]] const Row<Number>* find_row(RuleKind kind, Index n) const {
    const auto at = static_cast<std::size_t>(rule_has_valence(kind) ? n : 0);
    return at < rows_[static_cast<std::size_t>(kind)].size() ? &row(kind, n) : nullptr;
  }

 private:
  Status add(RuleKind kind, Index n, Index example);
  /// What stands in for a rule, seen from a vertex of valence n.
  Status add_seen_from(bool boundary, Index n, Index example);
  Status prepare_vertices(const Mesh& mesh, bool boundary_refined);
  Status prepare_faces(const Mesh& mesh, RuleKind kind);
  Status prepare_edges(const Mesh& mesh, const Births& births);
  /// What stages weigh: at all faces, and at the vertices of the mesh that they cut.
  Status prepare_stages(const Mesh& mesh, const Births& births);
  Status add_pair(detail::StagedMesh::Star star, const Mesh& mesh, Index example);

  const Scheme* scheme_;
  Boundary boundary_;
  RowMaker make_row_;
  Row<Number> none_;
  std::array<std::vector<Row<Number>>, kRuleKinds> rows_;
  std::array<std::vector<bool>, kRuleKinds> known_;
  struct PairRow {
    Row<Number> row;
    bool known = false;
  };
  std::vector<std::vector<PairRow>> pairs_;  // by edges, then by quads
};

inline constexpr int kLargestExactValence = 64;

/// The program of one case; the same for every number type.
[[nodiscard]] Program compile(const RuleCase& rule_case, RuleKind kind, Lattice lattice);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// One walk by its flags, with the extension where it leaves the mesh.
template <class Number, class Sink>
void visit_walk(const Mesh& mesh, const Step& step, Flag flag, const Number& weight, Sink& sink) {
  const Flag start = flag;
  if (apply(mesh, step.walk.before, flag)) {
    if (step.walk.reads_face)
      sink(Source{mesh.face(flag.halfedge), true}, weight);
    else
      sink(Source{vertex_of(mesh, flag), false}, weight);
    return;
  }
  const scheme::Extension outside = step.extension;
  Flag across = start;
  Flag aside = start;
  (void)apply(mesh, Move::vertex, across);
  (void)apply(mesh, Move::edge, aside);
  (void)apply(mesh, Move::vertex, aside);
  sink(Source{vertex_of(mesh, start), false},
       Number(Number(1 - outside.along - outside.aside) * weight));
  sink(Source{vertex_of(mesh, across), false}, Number(Number(outside.along) * weight));
  sink(Source{vertex_of(mesh, aside), false}, Number(Number(outside.aside) * weight));
}

/// The half-edge where the way ends; kNone where it leaves the mesh.
[[nodiscard]] inline Index follow(const Mesh& mesh, const Way& way, Index h) {
  if (h == kNone) return h;
  for (std::uint8_t i = 0; i < way.count; ++i) {
    switch (way.hops[i]) {
      case Hop::next: h = mesh.next(h); break;
      case Hop::prev: h = mesh.prev(h); break;
      case Hop::twin: h = mesh.twin(h); break;
    }
    if (h == kNone) break;
  }
  return h;
}

/// A repeated step: positions k = 0 … n-1, each with its weight; returns past the last weight.
template <class Number, class Sink>
const Number* visit_repeated(const Mesh& mesh, const Step& step, Flag flag, const Number* weight,
                             Sink& sink) {
  (void)apply(mesh, step.walk.before, flag);
  const Flag first = flag;
  do {
    Flag end = flag;
    (void)apply(mesh, step.walk.after, end);
    if (step.walk.reads_face)
      sink(Source{mesh.face(end.halfedge), true}, *weight++);
    else
      sink(Source{vertex_of(mesh, end), false}, *weight++);
    (void)apply(mesh, step.walk.step, flag);
  } while (!(flag == first));
  return weight;
}

/// The same by hops, which do not leave the mesh: only an interior vertex or a face is gone round.
template <class Number, class Sink>
const Number* visit_turns(const Mesh& mesh, const Step& step, Index h, const Number* weight,
                          Sink& sink) {
  const Index first = follow(mesh, step.way, h);
  h = first;
  do {
    sink(Source{mesh.origin(follow(mesh, step.out, h)), false}, *weight++);
    h = follow(mesh, step.turn, h);
  } while (h != first);
  return weight;
}

/// The same, round a vertex whose ring is known.
template <class Number, class Sink>
const Number* visit_ring(const Mesh& mesh, const mesh::Rings& rings, const Step& step, Index h,
                         const Number* weight, Sink& sink) {
  const Index first = follow(mesh, step.way, h), v = mesh.origin(first);
  const Index begin = rings.begin[v], end = rings.begin[v + 1], from = rings.place[first];
  const bool neighbours = step.out.count == 1 && step.out.hops[0] == Hop::next;
  const auto visit = [&](Index at) {
    const Index vertex =
        neighbours ? rings.targets[at] : mesh.origin(follow(mesh, step.out, rings.halfedges[at]));
    sink(Source{vertex, false}, *weight++);
  };
  if (step.turning == Step::Turning::counterclockwise) {
    for (Index at = from; at < end; ++at) visit(at);
    for (Index at = begin; at < from; ++at) visit(at);
  } else {
    for (Index at = from; at >= begin; --at) visit(at);
    for (Index at = end - 1; at > from; --at) visit(at);
  }
  return weight;
}

}  // namespace detail

/// Calls sink(Source, weight) for everything that the rule weighs at the anchor named by h (and
/// `at_target`, for a boundary edge's ends; see AnchorFlags). A vertex may come more than once:
/// the weights add. Cost: the moves of the program's walks; `rings` (those of the mesh) are quicker
/// where vertices are gone round often.
template <class Number, class Sink>
void visit_stencil(const Mesh& mesh, RuleKind kind, Index h, bool at_target, const Row<Number>& row,
                   Sink&& sink, const mesh::Rings* rings = nullptr) {
  const Number* weight = row.weights.data();
  std::array<Index, kSharedSteps> ends;  // where steps' hops ended, for those that go on from there
  const auto visit = [&](const Step& step, Index anchor) {
    if (step.direct) {
      const Index end = detail::follow(mesh, step.way, step.after < 0 ? anchor : ends[step.after]);
      if (step.kept >= 0) ends[step.kept] = end;
      if (end != kNone) return sink(Source{mesh.origin(end), false}, *weight);
    }
    const Flag start = scheme::anchor_flags(kind, mesh, anchor, at_target).flags[step.flag];
    detail::visit_walk(mesh, step, start, *weight, sink);
  };
  for (const Step& step : *row.program) {
    if (step.walk.repeated && step.direct) {
      weight = rings != nullptr && step.turning != Step::Turning::none
                   ? detail::visit_ring(mesh, *rings, step, h, weight, sink)
                   : detail::visit_turns(mesh, step, h, weight, sink);
      continue;
    }
    if (step.walk.repeated) {
      const Flag start = scheme::anchor_flags(kind, mesh, h, at_target).flags[step.flag];
      weight = detail::visit_repeated(mesh, step, start, weight, sink);
      continue;
    }
    Index sector = h;
    do {
      visit(step, sector);
      if (!step.per_sector) break;
      sector = kind == RuleKind::face ? mesh.next(sector) : mesh.rotate(sector);
    } while (sector != h);
    ++weight;
  }
}

}  // namespace limn::refine
