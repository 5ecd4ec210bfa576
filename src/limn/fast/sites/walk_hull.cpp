#include "limn/fast/sites/walk_hull.h"

#include <algorithm>

#include "limn/scheme/placement.h"

namespace limn::fast {
namespace {

class Explorer {
 public:
  Explorer(const Scheme& scheme, const Mesh& mesh) : scheme_(scheme), mesh_(mesh) {}

  /// The walks of a rule from all flags of its anchor.
  void explore(RuleKind kind, Index h, bool at_target = false) {
    const std::optional<Rule>& rule = scheme_.rule(kind);
    if (!rule) return;
    const AnchorFlags anchor = anchor_flags(kind, mesh_, h, at_target);
    for (int i = 0; i < anchor.count; ++i) {
      see(anchor.flags[i].halfedge);
      for (const RuleCase& rule_case : *rule)
        for (const Weight& weight : rule_case.weights) walk(weight.walk, anchor.flags[i]);
    }
  }

  /// Those of a face's rule.
  void explore_face(Index f) {
    if (!explored_.insert(f).second) return;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      explore(RuleKind::face, h);
  }

  std::set<Index> seen;

 private:
  void see(Index h) {
    const Index f = mesh_.face(h);
    for (Index k = mesh_.face_begin(f); k < mesh_.face_begin(f + 1); ++k)
      seen.insert(mesh_.origin(k));
  }

  void see_round(Index v) {
    const Index first = mesh_.halfedge_of_vertex(v);
    Index h = first;
    do {
      see(h);
      h = mesh_.rotate(h);
    } while (h != kNone && h != first);
  }

  /// Follows the moves as far as they go.
  bool follow(const Moves& moves, Flag& flag) {
    for (const Move move : moves) {
      if (move == Move::boundary) {
        if (mesh_.twin(flag.halfedge) != kNone) return false;
        see_round(vertex_of(mesh_, flag));
      }
      if (!apply(mesh_, move, flag)) return false;
      see(flag.halfedge);
    }
    return true;
  }

  void walk(const Walk& walk, Flag flag) {
    if (!follow(walk.before, flag)) return;
    if (!walk.repeated) {
      if (walk.reads_face) explore_face(mesh_.face(flag.halfedge));
      return;
    }
    // round a vertex, or a face
    const Index turns =
        std::max(mesh_.valence(vertex_of(mesh_, flag)), mesh_.degree(mesh_.face(flag.halfedge)));
    for (Index k = 0; k < turns; ++k) {
      Flag end = flag;
      (void)follow(walk.after, end);
      if (walk.reads_face) explore_face(mesh_.face(end.halfedge));
      if (!follow(walk.step, flag)) return;
    }
  }

  const Scheme& scheme_;
  const Mesh& mesh_;
  std::set<Index> explored_;  // faces
};

}  // namespace

std::set<Index> vertex_hull(const Scheme& scheme, const Mesh& mesh, Index h) {
  Explorer explorer(scheme, mesh);
  const Index v = mesh.origin(h);
  const Index first = mesh.halfedge_of_vertex(v);
  if (mesh.is_boundary_vertex(v)) {
    explorer.explore(RuleKind::boundary_vertex, first);
    return explorer.seen;
  }
  Index sector = first;
  do {
    explorer.explore(RuleKind::vertex, sector);
    sector = mesh.rotate(sector);
  } while (sector != first);
  return explorer.seen;
}

std::set<Index> edge_hull(const Scheme& scheme, const Mesh& mesh, Index h) {
  Explorer explorer(scheme, mesh);
  const Index twin = mesh.twin(h);
  if (twin == kNone) {
    explorer.explore(RuleKind::boundary_edge, h);
    return explorer.seen;
  }
  explorer.explore(RuleKind::edge, h);
  for (const Index end : {h, twin})
    if (!mesh.is_boundary_vertex(mesh.origin(end))) explorer.explore(RuleKind::edge_end, end);
  return explorer.seen;
}

std::set<Index> face_hull(const Scheme& scheme, const Mesh& mesh, Index h) {
  Explorer explorer(scheme, mesh);
  explorer.explore_face(mesh.face(h));
  return explorer.seen;
}

std::set<Index> edge_end_hull(const Scheme& scheme, const Mesh& mesh, Index h, bool at_target) {
  Explorer explorer(scheme, mesh);
  explorer.explore(RuleKind::boundary_edge_end, h, at_target);
  return explorer.seen;
}

std::set<Index> corner_hull(const Scheme& scheme, const Mesh& mesh, Index h) {
  Explorer explorer(scheme, mesh);
  explorer.explore(RuleKind::corner, h);
  return explorer.seen;
}

}  // namespace limn::fast
