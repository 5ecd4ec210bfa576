#pragma once
/// Roles: the names by which a rule's weights say whom they weigh. A role is a walk (mesh/mesh.h)
/// from the flags of the rule's anchor, and the weight goes to every position that the
/// walk reaches from any of them. The usual roles have names (the table in role.cpp); a scheme
/// file adds its own under [roles], so that a stencil of a new shape needs no C++.
///
/// As text a role is "MOVES", "MOVES(STEP)*MOVES" or either followed by "F":
///
///     ""        the anchor's own vertex            "v"    the other end of the edge
///     "(ef)*v"  the k-th neighbour round a vertex   "(ve)*" the k-th corner round a face
///     "F"       the *new* vertex of the face (so Catmull–Clark's face points are one role)
///
/// A starred step is repeated k = 0 … n-1 times, and the weight may depend on k.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/split/split.h"

namespace limn {

/// What a rule places a new vertex for. The anchor's flags, in this order, are the walks' starts.
enum class RuleKind : unsigned char {
  vertex,             ///< a vertex; per face round it, the flags of its two edges there
  edge,               ///< an interior edge; 2 ends × 2 faces
  edge_end,           ///< an interior edge seen from one of its ends; 2 faces
  edge_third,         ///< an interior edge cut in three, seen from the end that is near; 2 faces
  edge_side,          ///< an interior edge seen from one of its faces; 2 ends × 2 faces
  face,               ///< a face; per edge of it, 2 ends
  face_end,           ///< a face seen from one of its corners; its 2 edges there
  corner,             ///< a corner of a face; its 2 edges
  boundary_vertex,    ///< a boundary vertex; its 2 boundary edges
  boundary_edge,      ///< a boundary edge; 2 ends
  boundary_edge_end,  ///< a boundary edge seen from one of its ends; 1 flag
  boundary_spoke,     ///< an interior edge seen from its end on the boundary; 2 faces
};
/// How many kinds there are.
inline constexpr int kRuleKinds = 12;

/// "vertex", "edge-end", "boundary.vertex", …: as scheme files write it.
[[nodiscard]] std::string_view rule_name(RuleKind kind);
/// The kind of that name; nothing where there is none.
[[nodiscard]] std::optional<RuleKind> find_rule(std::string_view name);
/// Whether the rule belongs to a single vertex or face, so that n is defined in its weights: the
/// number of edges at the vertex (of what is seen from an end or a corner: at that one), or of the
/// face's corners (of an edge seen from a face: of that one's).
[[nodiscard]] bool rule_has_valence(RuleKind kind);
/// The rule that this one takes the place of wherever a case of it applies: edge_end, edge_side
/// and boundary_spoke of edge, face_end of face, boundary_edge_end of boundary_edge unless the
/// split trisects boundary edges. Nothing: every valence needs a case.
[[nodiscard]] std::optional<RuleKind> stands_in_for(RuleKind kind, const Split& split);
/// The valence of the rule's anchor on the regular lattice (6 or 4; faces 3 or 4; boundary
/// vertices 4 or 3).
[[nodiscard]] int regular_valence(RuleKind kind, Lattice lattice);

/// A role as moves between flags.
struct Walk {
  Moves before;             ///< made first
  Moves step;               ///< repeated k times; empty where `repeated` is false
  Moves after;              ///< made last
  bool repeated = false;    ///< whether there is a starred step
  bool reads_face = false;  ///< the new vertex of the face reached, instead of the old vertex

  /// The same moves.
  friend bool operator==(const Walk&, const Walk&) = default;
};

/// Reads a role's text. Fails with the 1-based column of the fault.
[[nodiscard]] Result<Walk> parse_walk(std::string_view text);
/// The text that `parse_walk` reads.
[[nodiscard]] std::string to_string(const Walk& walk);

/// A usual role.
struct NamedRole {
  std::string_view name;     ///< as scheme files write it: "wing"
  std::string_view walk;     ///< text that `parse_walk` reads: "ev"
  std::string_view meaning;  ///< in words, for listings
};
/// The roles with a name of their own in a rule of this kind on this lattice.
[[nodiscard]] std::vector<NamedRole> named_roles(RuleKind kind, Lattice lattice);

}  // namespace limn
