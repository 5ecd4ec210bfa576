/// Where roles put their weights: counted and located on regular lattices, and on any mesh the
/// same in the mirror and whatever the numbers of its vertices are.

#include "limn/scheme/placement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "limn/mesh/lattice.h"
#include "limn/refine/rule_tables.h"
#include "mesh/random_mesh.h"

namespace limn {
namespace {

using Stencil = std::map<std::pair<Index, bool>, double>;

/// What a role with weight 1 (or, where it is repeated, 1 + (k == 0)) weighs at an anchor.
Stencil stencil(const Mesh& mesh, Lattice lattice, RuleKind kind, const Walk& walk, Index h,
                Index n) {
  RuleCase rule_case;
  rule_case.weights.push_back({"role", walk, {Expression::constant(1), {}}});
  refine::Row<double> row;
  row.program = std::make_shared<refine::Program>(refine::compile(rule_case, kind, lattice));
  const bool first_k = kind == RuleKind::edge_end || kind == RuleKind::corner;
  for (const refine::Step& step : *row.program)
    for (Index k = 0; k < (walk.repeated ? n : 1); ++k)
      row.weights.push_back(to_double(step.share) * (walk.repeated && first_k && k == 0 ? 2 : 1));
  Stencil result;
  refine::visit_stencil(mesh, kind, h, false, row, [&](refine::Source source, double weight) {
    result[{source.index, source.is_face}] += weight;
  });
  std::erase_if(result, [](const auto& entry) { return std::abs(entry.second) < 1e-12; });
  return result;
}

double total(const Stencil& stencil) {
  double sum = 0;
  for (const auto& entry : stencil) sum += entry.second;
  return sum;
}

Walk walk_of(RuleKind kind, Lattice lattice, std::string_view name) {
  for (const NamedRole& role : named_roles(kind, lattice))
    if (role.name == name) return parse_walk(role.walk).value();
  ADD_FAILURE() << "no role " << name;
  return {};
}

struct Count {
  RuleKind kind;
  Lattice lattice;
  const char* role;
  int count;
  bool times_n;
};

TEST(Placement, CountsOfAllNamedRoles) {
  constexpr Lattice t = Lattice::triangle, q = Lattice::quad;
  const std::vector<Count> expected{
      {RuleKind::vertex, t, "self", 1, false},
      {RuleKind::vertex, t, "ring", 1, true},
      {RuleKind::vertex, t, "across", 1, true},
      {RuleKind::vertex, t, "face", 1, true},
      {RuleKind::vertex, q, "self", 1, false},
      {RuleKind::vertex, q, "ring", 1, true},
      {RuleKind::vertex, q, "diagonal", 1, true},
      {RuleKind::vertex, q, "face", 1, true},
      {RuleKind::edge, t, "end", 2, false},
      {RuleKind::edge, t, "wing", 2, false},
      {RuleKind::edge, t, "outer", 4, false},
      {RuleKind::edge, t, "opposite", 2, false},
      {RuleKind::edge, t, "face", 2, false},
      {RuleKind::edge, q, "end", 2, false},
      {RuleKind::edge, q, "wing", 4, false},
      {RuleKind::edge, q, "opposite", 2, false},
      {RuleKind::edge, q, "face", 2, false},
      {RuleKind::edge_end, t, "self", 1, false},
      {RuleKind::edge_end, t, "ring", 1, true},
      {RuleKind::edge_end, t, "far", 1, false},
      {RuleKind::edge_end, t, "wing", 2, false},
      {RuleKind::edge_end, q, "self", 1, false},
      {RuleKind::edge_end, q, "ring", 1, true},
      {RuleKind::edge_end, q, "diagonal", 1, true},
      {RuleKind::edge_end, q, "far", 1, false},
      {RuleKind::edge_end, q, "wing", 2, false},
      {RuleKind::edge_end, q, "far-wing", 2, false},
      {RuleKind::face, t, "corner", 1, true},
      {RuleKind::face, t, "beyond", 1, true},
      {RuleKind::face, q, "corner", 1, true},
      {RuleKind::face, q, "beyond", 2, true},
      {RuleKind::face_end, t, "self", 1, false},
      {RuleKind::face_end, t, "next", 2, false},
      {RuleKind::face_end, t, "ring", 1, true},
      {RuleKind::face_end, q, "self", 1, false},
      {RuleKind::face_end, q, "next", 2, false},
      {RuleKind::face_end, q, "opposite", 1, false},
      {RuleKind::face_end, q, "ring", 1, true},
      {RuleKind::face_end, q, "diagonal", 1, true},
      {RuleKind::corner, t, "self", 1, false},
      {RuleKind::corner, t, "round", 1, true},
      {RuleKind::corner, q, "self", 1, false},
      {RuleKind::corner, q, "round", 1, true},
      {RuleKind::boundary_vertex, t, "self", 1, false},
      {RuleKind::boundary_vertex, t, "next", 2, false},
      {RuleKind::boundary_vertex, q, "self", 1, false},
      {RuleKind::boundary_vertex, q, "next", 2, false},
      {RuleKind::boundary_edge, t, "end", 2, false},
      {RuleKind::boundary_edge, t, "beyond", 2, false},
      {RuleKind::boundary_edge, q, "end", 2, false},
      {RuleKind::boundary_edge, q, "beyond", 2, false},
      {RuleKind::boundary_edge_end, t, "near", 1, false},
      {RuleKind::boundary_edge_end, t, "far", 1, false},
      {RuleKind::boundary_edge_end, t, "beyond", 1, false},
      {RuleKind::boundary_edge_end, q, "near", 1, false},
      {RuleKind::boundary_edge_end, q, "far", 1, false},
      {RuleKind::boundary_edge_end, q, "beyond", 1, false},
      {RuleKind::edge_third, t, "near", 1, false},
      {RuleKind::edge_third, t, "far", 1, false},
      {RuleKind::edge_third, t, "wing", 2, false},
      {RuleKind::edge_third, t, "outer", 2, false},
      {RuleKind::edge_third, t, "far-outer", 2, false},
      {RuleKind::edge_third, t, "opposite", 1, false},
      {RuleKind::edge_third, q, "near", 1, false},
      {RuleKind::edge_third, q, "far", 1, false},
      {RuleKind::edge_third, q, "wing", 2, false},
      {RuleKind::edge_third, q, "far-wing", 2, false},
      {RuleKind::edge_third, q, "opposite", 1, false},
      {RuleKind::boundary_spoke, t, "self", 1, false},
      {RuleKind::boundary_spoke, t, "far", 1, false},
      {RuleKind::boundary_spoke, t, "wing", 2, false},
      {RuleKind::boundary_spoke, q, "self", 1, false},
      {RuleKind::boundary_spoke, q, "far", 1, false},
      {RuleKind::boundary_spoke, q, "wing", 2, false},
      {RuleKind::boundary_spoke, q, "far-wing", 2, false},
      {RuleKind::edge_side, t, "end", 2, false},
      {RuleKind::edge_side, t, "face", 2, false},
      {RuleKind::edge_side, q, "end", 2, false},
      {RuleKind::edge_side, q, "face", 2, false},
  };
  std::size_t named = 0;
  for (int i = 0; i < kRuleKinds; ++i)
    for (const Lattice lattice : {t, q})
      named += named_roles(static_cast<RuleKind>(i), lattice).size();
  EXPECT_EQ(named, expected.size()) << "a named role without its count here";
  for (const Count& e : expected) {
    const scheme::Placement placement =
        scheme::place(e.kind, e.lattice, walk_of(e.kind, e.lattice, e.role)).value();
    EXPECT_EQ(placement.count, e.count) << rule_name(e.kind) << " " << e.role;
    EXPECT_EQ(placement.times_n, e.times_n) << rule_name(e.kind) << " " << e.role;
  }
}

/// Vertices of the 9 × 9 torus as offsets from (4, 4), its middle.
using Offsets = std::set<std::pair<int, int>>;
constexpr Index kSide = 9;

Offsets offsets(Lattice lattice, RuleKind kind, const Walk& walk) {
  const Mesh mesh = mesh::torus(lattice, kSide, kSide);
  Index h = 0;  // from the middle along (1, 0)
  while (mesh.origin(h) != 4 * kSide + 4 || mesh.target(h) != 4 * kSide + 5) ++h;
  Offsets result;
  for (const auto& [source, weight] :
       stencil(mesh, lattice, kind, walk, h, regular_valence(kind, lattice))) {
    EXPECT_NEAR(weight, 1, 1e-12);
    result.insert({source.first % kSide - 4, source.first / kSide - 4});
  }
  return result;
}

Offsets named(Lattice lattice, RuleKind kind, std::string_view role) {
  return offsets(lattice, kind, walk_of(kind, lattice, role));
}

TEST(Placement, PlacesOnTheTriangleLattice) {
  constexpr Lattice t = Lattice::triangle;
  EXPECT_EQ(named(t, RuleKind::vertex, "self"), (Offsets{{0, 0}}));
  EXPECT_EQ(named(t, RuleKind::vertex, "ring"),
            (Offsets{{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}));
  EXPECT_EQ(named(t, RuleKind::vertex, "across"),
            (Offsets{{2, 1}, {1, 2}, {-1, 1}, {-2, -1}, {-1, -2}, {1, -1}}));
  // the edge from (0, 0) to (1, 0)
  EXPECT_EQ(named(t, RuleKind::edge, "end"), (Offsets{{0, 0}, {1, 0}}));
  EXPECT_EQ(named(t, RuleKind::edge, "wing"), (Offsets{{1, 1}, {0, -1}}));
  EXPECT_EQ(named(t, RuleKind::edge, "outer"), (Offsets{{0, 1}, {2, 1}, {-1, -1}, {1, -1}}));
  EXPECT_EQ(named(t, RuleKind::edge, "opposite"), (Offsets{{-1, 0}, {2, 0}}));
  // the face (0, 0) (1, 0) (1, 1)
  EXPECT_EQ(named(t, RuleKind::face, "corner"), (Offsets{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(named(t, RuleKind::face, "beyond"), (Offsets{{0, -1}, {2, 1}, {0, 1}}));
}

TEST(Placement, PlacesOnTheQuadLattice) {
  constexpr Lattice q = Lattice::quad;
  EXPECT_EQ(named(q, RuleKind::vertex, "ring"), (Offsets{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}));
  EXPECT_EQ(named(q, RuleKind::vertex, "diagonal"), (Offsets{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}));
  EXPECT_EQ(named(q, RuleKind::edge, "end"), (Offsets{{0, 0}, {1, 0}}));
  EXPECT_EQ(named(q, RuleKind::edge, "wing"), (Offsets{{0, 1}, {1, 1}, {0, -1}, {1, -1}}));
  EXPECT_EQ(named(q, RuleKind::edge, "opposite"), (Offsets{{-1, 0}, {2, 0}}));
  EXPECT_EQ(named(q, RuleKind::face, "corner"), (Offsets{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(named(q, RuleKind::face, "beyond"),
            (Offsets{{0, -1}, {1, -1}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {-1, 1}, {-1, 0}}));
}

TEST(Placement, PlacesOfAnOwnWalk) {
  const Walk straight = parse_walk("vefev").value();
  EXPECT_EQ(offsets(Lattice::quad, RuleKind::vertex, straight),
            (Offsets{{2, 0}, {0, 2}, {-2, 0}, {0, -2}}));
  const Walk knight = parse_walk("vefevev").value();
  EXPECT_EQ(offsets(Lattice::quad, RuleKind::vertex, knight),
            (Offsets{{2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}}));
}

TEST(Placement, ExtensionIsTheReflection) {
  const auto starts = [](Lattice lattice, std::string_view role) {
    return scheme::place(RuleKind::edge, lattice, walk_of(RuleKind::edge, lattice, role))
        .value()
        .starts;
  };
  for (const scheme::Start& start : starts(Lattice::triangle, "outer")) {  // v + w - v'
    EXPECT_EQ(start.extension.along, -1);
    EXPECT_EQ(start.extension.aside, 1);
  }
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    for (const scheme::Start& start : starts(lattice, "opposite")) {  // v - (v' - v)
      EXPECT_EQ(start.extension.along, -1);
      EXPECT_EQ(start.extension.aside, 0);
    }
  }
}

TEST(Placement, OuterBeyondTheBoundary) {
  // two triangles on the edge 0 1, wings 2 and 3: every outer vertex is a reflection
  const Mesh mesh = test::must_build(4, {{0, 1, 2}, {1, 0, 3}});
  const Walk outer = walk_of(RuleKind::edge, Lattice::triangle, "outer");
  const Stencil weights = stencil(mesh, Lattice::triangle, RuleKind::edge, outer, 0, 0);
  // Σ v + w - v' over the four flags
  EXPECT_EQ(weights, (Stencil{{{2, false}, 2.0}, {{3, false}, 2.0}}));
}

// ---------------------------------------------------------------------------------------------

/// The same surface seen from below, each face starting at another corner.
Mesh mirrored(const Mesh& mesh) {
  test::Faces faces = test::faces_of(test::polygons_of(mesh));
  for (auto& face : faces) {
    std::reverse(face.begin(), face.end());
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(face.size() / 2),
                face.end());
  }
  return test::must_build(mesh.vertex_count(), faces);
}

/// Of each anchor of the kind, by what names it on any numbering: its stencil.
std::map<std::vector<Index>, Stencil> stencils(const Mesh& mesh, Lattice lattice, RuleKind kind,
                                               const Walk& walk) {
  std::map<std::vector<Index>, Stencil> result;
  const auto at = [&](std::vector<Index> name, Index h, Index n) {
    result[std::move(name)] = stencil(mesh, lattice, kind, walk, h, n);
  };
  for (Index v = 0; kind == RuleKind::vertex && v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v))
      at({v}, mesh.halfedge_of_vertex(v), mesh.valence(v));
  for (Index f = 0; kind == RuleKind::face && f < mesh.face_count(); ++f)
    at({f}, mesh.face_begin(f), mesh.degree(f));
  for (Index f = 0; kind == RuleKind::corner && f < mesh.face_count(); ++f)
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      at({f, mesh.origin(h)}, h, mesh.degree(f));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (mesh.is_boundary_edge(e)) continue;
    const auto ends = std::minmax({mesh.origin(h), mesh.target(h)});
    if (kind == RuleKind::edge) at({ends.first, ends.second}, h, 0);
    if (kind != RuleKind::edge_end) continue;
    for (const Index from : {h, mesh.twin(h)})
      if (!mesh.is_boundary_vertex(mesh.origin(from)))
        at({mesh.origin(from), mesh.target(from)}, from, mesh.valence(mesh.origin(from)));
  }
  return result;
}

void expect_same(const std::map<std::vector<Index>, Stencil>& a,
                 const std::map<std::vector<Index>, Stencil>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, left] : a) {
    const Stencil& right = b.at(name);
    ASSERT_EQ(left.size(), right.size()) << what << " at " << name[0];
    for (const auto& [source, weight] : left) {
      ASSERT_TRUE(right.count(source) == 1) << what;
      ASSERT_NEAR(weight, right.at(source), 1e-12) << what << " at " << name[0];
    }
  }
}

constexpr RuleKind kInterior[] = {RuleKind::vertex, RuleKind::edge, RuleKind::edge_end,
                                  RuleKind::face, RuleKind::corner};

Mesh any_simple_mesh(Lattice lattice, bool closed) {
  for (;;) {
    test::RandomMesh random(*rc::gen::arbitrary<unsigned>());
    Mesh mesh = lattice == Lattice::triangle ? random.triangles() : random.polygons();
    if (test::is_simple(mesh) && !(closed && mesh.has_boundary()) && mesh.vertex_count() < 60)
      return mesh;
  }
}

RC_GTEST_PROP(PlacementLaws, NamedRolesInTheMirror, ()) {
  const auto lattice = *rc::gen::element(Lattice::triangle, Lattice::quad);
  const Mesh mesh = any_simple_mesh(lattice, false);
  const Mesh other = mirrored(mesh);
  for (const RuleKind kind : kInterior)
    for (const NamedRole& role : named_roles(kind, lattice)) {
      const Walk walk = parse_walk(role.walk).value();
      expect_same(stencils(mesh, lattice, kind, walk), stencils(other, lattice, kind, walk),
                  std::string(rule_name(kind)) + " " + std::string(role.name));
    }
}

Walk any_walk() {
  const auto word = [](std::vector<Move> alphabet, int size) {
    return *rc::gen::resize(size, rc::gen::container<Moves>(rc::gen::elementOf(alphabet)));
  };
  Walk walk;
  walk.repeated = *rc::gen::inRange(0, 4) == 0;
  if (!walk.repeated) {
    walk.before = word({Move::vertex, Move::edge, Move::face}, 9);
    return walk;
  }
  walk.before = word({Move::vertex, Move::edge}, 3);
  walk.step = *rc::gen::element(Moves{Move::edge, Move::face}, Moves{Move::face, Move::edge},
                                Moves{Move::vertex, Move::edge}, Moves{Move::edge, Move::vertex});
  walk.after = word({Move::vertex, Move::edge}, 4);
  return walk;
}

/// On closed meshes of any valences: the mirror image weighs the mirror images, and the weights
/// have the sum that the placement promises.
RC_GTEST_PROP(PlacementLaws, AnyWalkInTheMirror, ()) {
  const auto lattice = *rc::gen::element(Lattice::triangle, Lattice::quad);
  const Mesh mesh = any_simple_mesh(lattice, true);
  const Mesh other = mirrored(mesh);
  for (int i = 0; i < 8; ++i) {
    const RuleKind kind = *rc::gen::element(RuleKind::vertex, RuleKind::edge, RuleKind::edge_end,
                                            RuleKind::face, RuleKind::corner);
    const Walk walk = any_walk();
    const Result<scheme::Placement> placement = scheme::place(kind, lattice, walk);
    if (!placement) continue;
    const auto all = stencils(mesh, lattice, kind, walk);
    expect_same(all, stencils(other, lattice, kind, walk),
                std::string(rule_name(kind)) + " " + to_string(walk));
    for (const auto& [name, one] : all) {
      const Index n = kind == RuleKind::face || kind == RuleKind::corner ? mesh.degree(name[0])
                                                                         : mesh.valence(name[0]);
      const bool first_k = kind == RuleKind::edge_end || kind == RuleKind::corner;
      const double promised = to_double(placement->count) * (placement->times_n ? n : 1) +
                              (walk.repeated && first_k ? 1 : 0);
      RC_ASSERT(std::abs(total(one) - promised) < 1e-9);
    }
  }
}

/// On the regular lattice every position of a role has the same weight, that of one position.
RC_GTEST_PROP(PlacementLaws, PositionsShareOneWeight, ()) {
  const auto lattice = *rc::gen::element(Lattice::triangle, Lattice::quad);
  const RuleKind kind = *rc::gen::element(RuleKind::vertex, RuleKind::edge, RuleKind::edge_end,
                                          RuleKind::face, RuleKind::corner);
  Walk walk;
  walk.before = *rc::gen::resize(
      6, rc::gen::container<Moves>(rc::gen::element(Move::vertex, Move::edge, Move::face)));
  const Result<scheme::Placement> placement = scheme::place(kind, lattice, walk);
  RC_PRE(placement.ok());
  const Mesh mesh = mesh::torus(lattice, 24, 24);
  const Index n = regular_valence(kind, lattice);
  const Stencil weights = stencil(mesh, lattice, kind, walk, 6 * 24, n);
  RC_ASSERT(static_cast<double>(weights.size()) ==
            to_double(placement->count) * (placement->times_n ? n : 1));
  for (const auto& entry : weights) RC_ASSERT(std::abs(entry.second - 1) < 1e-12);
}

TEST(Placement, DiagonalOfAPentagonIsTheSameInTheMirror) {
  // a prism over a pentagon: at each vertex one pentagon and two quads
  test::Faces faces{{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}};
  for (Index i = 0; i < 5; ++i) {
    const Index j = (i + 1) % 5;
    faces.push_back({i, j, 5 + j, 5 + i});
  }
  const Mesh mesh = test::must_build(10, faces);
  const Walk diagonal = walk_of(RuleKind::vertex, Lattice::quad, "diagonal");
  const Stencil at_0 =
      stencil(mesh, Lattice::quad, RuleKind::vertex, diagonal, mesh.halfedge_of_vertex(0), 3);
  // the quads' opposite corners, and half of either of the pentagon's
  EXPECT_EQ(at_0,
            (Stencil{{{6, false}, 1.0}, {{9, false}, 1.0}, {{2, false}, 0.5}, {{3, false}, 0.5}}));
}

}  // namespace
}  // namespace limn
