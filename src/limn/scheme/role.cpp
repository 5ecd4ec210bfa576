#include "limn/scheme/role.h"

namespace limn {
namespace {

constexpr std::size_t kLongestWalk = 24;  // farther than any stencil in use; bounds the lattices

constexpr std::array<std::string_view, kRuleKinds> kRuleNames{
    "vertex",          "edge",          "edge-end",          "edge-third",
    "edge-side",       "face",          "face-end",          "corner",
    "boundary.vertex", "boundary.edge", "boundary.edge-end", "boundary.spoke"};

constexpr unsigned bit(RuleKind kind) { return 1U << static_cast<unsigned>(kind); }
constexpr unsigned kTriangle = 1;
constexpr unsigned kQuad = 2;
constexpr unsigned kAny = kTriangle | kQuad;

struct RoleRow {
  unsigned kinds;
  unsigned lattices;
  NamedRole role;
};

// The one table of role names.
constexpr unsigned kSpokes = bit(RuleKind::edge_end) | bit(RuleKind::boundary_spoke);
constexpr unsigned kOwnVertex = bit(RuleKind::vertex) | kSpokes | bit(RuleKind::face_end) |
                                bit(RuleKind::corner) | bit(RuleKind::boundary_vertex);
constexpr unsigned kWholeEdge = bit(RuleKind::edge) | bit(RuleKind::edge_third);
constexpr unsigned kThird = bit(RuleKind::edge_third) | bit(RuleKind::boundary_edge_end);
const std::array kRoles{
    RoleRow{kOwnVertex, kAny, {"self", "", "the vertex itself"}},
    RoleRow{bit(RuleKind::vertex), kAny, {"ring", "v", "its neighbours along edges"}},
    RoleRow{bit(RuleKind::vertex),
            kTriangle,
            {"across", "vefev", "the vertices across the edges that face it"}},
    RoleRow{bit(RuleKind::vertex), kQuad, {"diagonal", "vev", "the opposite corners of its faces"}},
    RoleRow{bit(RuleKind::vertex) | bit(RuleKind::edge) | bit(RuleKind::edge_side),
            kAny,
            {"face", "F", "the new vertices of its faces"}},
    RoleRow{bit(RuleKind::edge) | bit(RuleKind::edge_side) | bit(RuleKind::boundary_edge),
            kAny,
            {"end", "", "its ends"}},
    RoleRow{kWholeEdge, kTriangle, {"wing", "ev", "the third vertices of its two faces"}},
    RoleRow{bit(RuleKind::edge), kQuad, {"wing", "ev", "the other vertices of its two faces"}},
    RoleRow{bit(RuleKind::edge_third),
            kQuad,
            {"wing", "ev", "the vertices of its two faces next to the near end"}},
    RoleRow{bit(RuleKind::edge_third),
            kQuad,
            {"far-wing", "vev", "the vertices of its two faces next to the far end"}},
    RoleRow{bit(RuleKind::edge),
            kTriangle,
            {"outer", "efev", "the vertices beyond the other edges of its faces"}},
    RoleRow{bit(RuleKind::edge_third),
            kTriangle,
            {"outer", "efev", "the vertices beyond the other edges at the near end"}},
    RoleRow{bit(RuleKind::edge_third),
            kTriangle,
            {"far-outer", "vefev", "the vertices beyond the other edges at the far end"}},
    RoleRow{bit(RuleKind::edge_third),
            kTriangle,
            {"opposite", "efefev", "the vertex straight beyond the near end"}},
    RoleRow{bit(RuleKind::edge_third),
            kQuad,
            {"opposite", "efev", "the vertex straight beyond the near end"}},
    RoleRow{bit(RuleKind::edge),
            kTriangle,
            {"opposite", "efefev", "the vertices straight beyond its ends"}},
    RoleRow{
        bit(RuleKind::edge), kQuad, {"opposite", "efev", "the vertices straight beyond its ends"}},
    RoleRow{bit(RuleKind::edge_end),
            kAny,
            {"ring", "(ef)*v", "the end's neighbours, k = 0 along the edge"}},
    RoleRow{bit(RuleKind::edge_end),
            kQuad,
            {"diagonal", "(ef)*vev",
             "the opposite corners of the end's faces, k = 0 and n-1 in those of the edge"}},
    RoleRow{kSpokes, kAny, {"far", "v", "the other end"}},
    RoleRow{kSpokes, kTriangle, {"wing", "ev", "the third vertices of its two faces"}},
    RoleRow{kSpokes, kQuad, {"wing", "ev", "the vertices of its two faces beside the end"}},
    RoleRow{
        kSpokes, kQuad, {"far-wing", "vev", "the vertices of its two faces beside the other end"}},
    RoleRow{bit(RuleKind::face_end), kAny, {"next", "v", "the corners next to the corner"}},
    RoleRow{bit(RuleKind::face_end), kQuad, {"opposite", "vev", "the opposite corner"}},
    RoleRow{bit(RuleKind::face_end),
            kAny,
            {"ring", "(fe)*v", "the corner's neighbours, k = 0 and n-1 in the face"}},
    RoleRow{
        bit(RuleKind::face_end),
        kQuad,
        {"diagonal", "(ef)*vev", "the opposite corners of the corner's faces, k = 0 in the face"}},
    RoleRow{bit(RuleKind::face), kAny, {"corner", "", "its corners"}},
    RoleRow{bit(RuleKind::face),
            kAny,
            {"beyond", "fev", "the vertices beyond its edges, next to its corners"}},
    RoleRow{bit(RuleKind::corner),
            kAny,
            {"round", "(ve)*", "the face's corners, k = 0 the corner itself"}},
    RoleRow{
        bit(RuleKind::boundary_vertex), kAny, {"next", "v", "its neighbours along the boundary"}},
    RoleRow{bit(RuleKind::boundary_edge) | bit(RuleKind::boundary_edge_end),
            kAny,
            {"beyond", "bv", "the next vertex of the boundary, past the end"}},
    RoleRow{kThird, kAny, {"near", "", "the near end"}},
    RoleRow{kThird, kAny, {"far", "v", "the far end"}},
};

constexpr std::string_view kMoveLetters = "vefb";

/// Reads moves from text[at]; stops at the first other letter.
Moves read_moves(std::string_view text, std::size_t& at) {
  Moves moves;
  for (; at < text.size(); ++at) {
    const std::size_t letter = kMoveLetters.find(text[at]);
    if (letter == std::string_view::npos) break;
    moves.push_back(static_cast<Move>(letter));
  }
  return moves;
}

void write_moves(const Moves& moves, std::string& text) {
  for (const Move move : moves) text += kMoveLetters[static_cast<std::size_t>(move)];
}

Error fault(std::string message, std::size_t at) {
  return {std::move(message),
          "a walk is written in the moves v, e, f and b, with (…)* for a repeated step and a "
          "final F for a face's new vertex",
          {},
          0,
          static_cast<int>(at) + 1};
}

}  // namespace

std::string_view rule_name(RuleKind kind) { return kRuleNames[static_cast<std::size_t>(kind)]; }

std::optional<RuleKind> find_rule(std::string_view name) {
  for (std::size_t i = 0; i < kRuleNames.size(); ++i)
    if (kRuleNames[i] == name) return static_cast<RuleKind>(i);
  return std::nullopt;
}

bool rule_has_valence(RuleKind kind) {
  return kind != RuleKind::edge && kind != RuleKind::edge_third && kind != RuleKind::boundary_edge;
}

std::optional<RuleKind> stands_in_for(RuleKind kind, const Split& split) {
  switch (kind) {
    case RuleKind::edge_side: return RuleKind::edge;
    case RuleKind::edge_end:
    case RuleKind::boundary_spoke:
      return split.births.thirds ? RuleKind::edge_third : RuleKind::edge;
    case RuleKind::face_end: return RuleKind::face;
    case RuleKind::boundary_edge_end:
      if (split.births.thirds || split.odd_step_cut == 3) break;
      return RuleKind::boundary_edge;
    default: break;
  }
  return std::nullopt;
}

int regular_valence(RuleKind kind, Lattice lattice) {
  const bool triangles = lattice == Lattice::triangle;
  if (kind == RuleKind::face || kind == RuleKind::corner || kind == RuleKind::edge_side)
    return triangles ? 3 : 4;
  if (kind >= RuleKind::boundary_vertex) return triangles ? 4 : 3;
  return triangles ? 6 : 4;
}

Result<Walk> parse_walk(std::string_view text) {
  if (text.size() > kLongestWalk) return fault("the walk is too long", kLongestWalk);
  Walk walk;
  std::size_t at = 0;
  walk.before = read_moves(text, at);
  if (at < text.size() && text[at] == '(') {
    walk.repeated = true;
    walk.step = read_moves(text, ++at);
    if (text.substr(at, 2) != ")*") return fault("found no ')*' to end the repeated step", at);
    if (walk.step.empty()) return fault("the repeated step is empty", at);
    at += 2;
    walk.after = read_moves(text, at);
  }
  if (at < text.size() && text[at] == 'F') {
    walk.reads_face = true;
    ++at;
  }
  if (at < text.size()) return fault("found '" + std::string(text.substr(at, 1)) + "'", at);
  return walk;
}

std::string to_string(const Walk& walk) {
  std::string text;
  write_moves(walk.before, text);
  if (walk.repeated) {
    text += '(';
    write_moves(walk.step, text);
    text += ")*";
    write_moves(walk.after, text);
  }
  if (walk.reads_face) text += 'F';
  return text;
}

std::vector<NamedRole> named_roles(RuleKind kind, Lattice lattice) {
  const unsigned wanted = lattice == Lattice::triangle ? kTriangle : kQuad;
  std::vector<NamedRole> roles;
  for (const RoleRow& row : kRoles)
    if ((row.kinds & bit(kind)) != 0 && (row.lattices & wanted) != 0) roles.push_back(row.role);
  return roles;
}

}  // namespace limn
