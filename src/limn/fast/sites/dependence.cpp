#include "limn/fast/sites/dependence.h"

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
    const scheme::AnchorFlags anchor = scheme::anchor_flags(kind, mesh_, h, at_target);
    for (int i = 0; i < anchor.count; ++i) {
      see(anchor.flags[i].halfedge);
      for (const RuleCase& rule_case : *rule)
        for (const Weight& weight : rule_case.weights) walk(weight.walk, anchor.flags[i]);
    }
  }

  /// Those of a rule that applies or not by the number of the edges at the origin of h.
  void explore_seen_from(RuleKind kind, Index h) {
    if (!scheme_.rule(kind)) return;
    see_round(mesh_.origin(h));
    explore(kind, h);
  }

  /// Those of a face's rule.
  void explore_face(Index f) {
    if (!explored_.insert(f).second) return;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) {
      explore(RuleKind::face, h);
      if (!mesh_.is_boundary_vertex(mesh_.origin(h))) explore_seen_from(RuleKind::face_end, h);
    }
  }

  /// That of an edge, or those of its ends.
  void explore_edge(Index h) {
    const Index twin = mesh_.twin(h);
    if (twin == kNone) {
      explore(RuleKind::boundary_edge, h);
      for (const bool at_target : {false, true}) explore(RuleKind::boundary_edge_end, h, at_target);
      return;
    }
    explore(RuleKind::edge, h);
    for (const Index end : {h, twin})
      explore_seen_from(mesh_.is_boundary_vertex(mesh_.origin(end)) ? RuleKind::boundary_spoke
                                                                    : RuleKind::edge_end,
                        end);
  }

  /// That of the point of an edge near one of its ends, or that of the end.
  void explore_third(Index h, bool at_target) {
    const Index twin = mesh_.twin(h);
    if (twin == kNone) return explore(RuleKind::boundary_edge_end, h, at_target);
    const Index near = at_target ? twin : h;
    explore(RuleKind::edge_third, near);
    if (!mesh_.is_boundary_vertex(mesh_.origin(near))) explore(RuleKind::edge_end, near);
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

Birth birth_of(const Mesh& mesh, const Births& births, Index made) {
  if (made < births.from_vertices) return {Birth::vertex, mesh.halfedge_of_vertex(made)};
  made -= births.from_vertices;
  if (made < births.from_edges) {
    const EdgeChild child = edge_child(mesh, births, made);
    return {child.third ? Birth::edge_end : Birth::edge, child.halfedge, child.at_target};
  }
  made -= births.from_edges;
  if (made < births.from_faces) {
    const Index f = births.faces.empty() ? made : births.faces[static_cast<std::size_t>(made)];
    return {Birth::face, mesh.face_begin(f)};
  }
  return {Birth::corner, made - births.from_faces};
}

Births first_births(const Split& split, const Mesh& mesh) {
  Births births;
  if (split.births.vertices) births.from_vertices = mesh.vertex_count();
  births.thirds = split.births.thirds;
  if (split.births.edges) births.from_edges = (births.thirds ? 2 : 1) * mesh.edge_count();
  if (split.births.faces) births.from_faces = mesh.face_count();
  if (split.births.corners) births.from_corners = mesh.halfedge_count();
  if (!split.is_dual()) return births;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) births.isolated.push_back(v);
  return births;
}

std::set<Index> dependence(const Scheme& scheme, const Mesh& mesh, const Births& births,
                           const Birth& birth) {
  Explorer explorer(scheme, mesh);
  const Index h = birth.halfedge, v = mesh.origin(h);
  switch (birth.kind) {
    case Birth::vertex:
      if (!mesh.is_boundary_vertex(v)) {
        for (Index sector = h, left = mesh.valence(v); left > 0;
             --left, sector = mesh.rotate(sector))
          explorer.explore(RuleKind::vertex, sector);
      } else if (scheme.split->boundary_rests() && births.from_edges == 0) {
        explorer.seen.insert(v);  // it stays
      } else {
        explorer.explore(RuleKind::boundary_vertex, mesh.halfedge_of_vertex(v));
      }
      break;
    case Birth::edge: explorer.explore_edge(h); break;
    case Birth::face: explorer.explore_face(mesh.face(h)); break;
    case Birth::edge_end: explorer.explore_third(h, birth.at_target); break;
    case Birth::corner: explorer.explore(RuleKind::corner, h); break;
  }
  return std::move(explorer.seen);
}

}  // namespace limn::fast
