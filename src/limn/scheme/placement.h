#pragma once
/// Where a role's positions lie round its anchor: computed once per (rule, lattice, walk) by
/// making the walk on a regular lattice and on a tree of faces, never typed in.
///
/// A role weighs *positions of the regular lattice*. Flags whose walks meet there share that
/// position's weight, and go on sharing it on an irregular mesh, where they may part; flags whose
/// walks meet on every mesh are represented by one of them. So the weights of a rule keep
/// their sum at every vertex, and where two positions fall on one vertex the weights add.

#include <vector>

#include "limn/base/rational.h"
#include "limn/scheme/role.h"

namespace limn::scheme {

/// Where a walk that leaves the mesh would have ended: the affine extension of the start flag's
/// own face, v + along·(v' − v) + aside·(w − v), with v' the other end of the flag's edge
/// and w the next vertex of the flag's face on v's other side. For the butterfly's outer vertex
/// this is the usual reflection across the boundary edge.
struct Extension {
  int along = 0;
  int aside = 0;
};

struct Start {
  int flag;        ///< which of the anchor's flags, or of a sector's two
  Rational share;  ///< of the position's weight
  Extension extension;
};

struct Placement {
  /// Vertex and face rules: whether the starts are repeated in each of the n sectors.
  bool per_sector = false;
  std::vector<Start> starts;
  /// The number of positions, weight · count being the role's part of the rule's sum:
  /// `count`, times n where `times_n`.
  Rational count = 0;
  bool times_n = false;
};

/// The flags of an anchor, in the order of RuleKind. `h` names the anchor:
///   vertex: any half-edge out of it (its sector); face: any of its half-edges (its sector);
///   corner: the half-edge out of it in its face; edge, boundary_edge: a half-edge of it;
///   face_end: the half-edge out of the corner in the face; edge_end, edge_third, boundary_edge_end
///   and boundary_spoke: see `at_target`; boundary_vertex: its boundary half-edge.
struct AnchorFlags {
  Flag flags[4];
  int count = 0;
};
[[nodiscard]] AnchorFlags anchor_flags(RuleKind kind, const Mesh& mesh, Index h,
                                       bool at_target = false);

/// Fails where the walk makes no sense there: b off the boundary, a face read beyond it, a
/// repeated step in a rule that has no n.
[[nodiscard]] Result<Placement> place(RuleKind kind, Lattice lattice, const Walk& walk);

}  // namespace limn::scheme
