#include "limn/study/rule_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/number/exact.h"
#include "limn/refine/rule_tables.h"

namespace limn::study {
namespace {

using Place = RulePicture::Place;
constexpr int kRings = 4;

Place combined(double a, const Place& p, double b, const Place& q) {
  return {a * p[0] + b * q[0], a * p[1] + b * q[1]};
}

/// The unit vector at an angle that is given in sectors of `total` / `sectors`.
Place unit(double sector, int sectors, double total) {
  const double angle = total * sector / sectors;
  return {std::cos(angle), std::sin(angle)};
}

/// A neighbourhood with its vertices' places.
struct Scene {
  Mesh mesh;
  std::vector<Place> places;
  Index anchor = 0;  ///< the half-edge that names the rule's anchor
};

/// Adds ring r of a star or fan, whose sectors lie between the directions u(s) and u(s + 1).
template <class Direction>
void add_ring(Lattice lattice, int sectors, int r, const Direction& u, std::vector<Place>& places) {
  for (int s = 0; s < sectors; ++s) {
    const Place first = u(s), second = u(s + 1);
    const int size = lattice == Lattice::triangle ? r : 2 * r;
    for (int k = 0; k < size; ++k) {
      const double x = lattice == Lattice::triangle ? r - k : std::min(r, 2 * r - k);
      places.push_back(combined(x, first, std::min(k, r), second));
    }
  }
}

Scene star_scene(Lattice lattice, int n) {
  Scene scene{mesh::star(lattice, n, kRings), {{0, 0}}};
  const auto u = [n](int s) { return unit(s, n, 2 * std::numbers::pi); };
  for (int r = 1; r <= kRings; ++r) add_ring(lattice, n, r, u, scene.places);
  return scene;
}

/// Of a boundary vertex with n edges.
Scene fan_scene(Lattice lattice, int n) {
  const int sectors = n - 1;
  const double regular = std::numbers::pi / (lattice == Lattice::triangle ? 3 : 2);
  const double total = std::min(std::numbers::pi, sectors * regular);
  Scene scene{mesh::fan(lattice, sectors, kRings), {{0, 0}}};
  const auto u = [&](int s) { return unit(s, sectors, total); };
  for (int r = 1; r <= kRings; ++r) {
    add_ring(lattice, sectors, r, u, scene.places);
    scene.places.push_back(combined(r, u(sectors), 0, u(0)));
  }
  return scene;
}

/// Of a face with n corners on quads: corner s lies between the directions of two edges' middles.
Scene face_scene(int n) {
  Scene scene{mesh::face_star(n, kRings), {}};
  const auto u = [n](double s) { return unit(s, n, 2 * std::numbers::pi); };
  for (int r = 1; r <= kRings; ++r)
    for (int s = 0; s < n; ++s)
      for (int k = 0; k < 2 * r - 1; ++k) {
        const double x = std::min(r - 1, 2 * r - 2 - k) + 0.5, y = std::min(k, r - 1) + 0.5;
        scene.places.push_back(combined(x, u(s - 0.5), y, u(s + 0.5)));
      }
  return scene;
}

Scene scene_of(RuleKind kind, const Split& split, int n) {
  const Lattice lattice = split.lattice;
  switch (kind) {
    case RuleKind::face:
      if (lattice == Lattice::quad) return face_scene(n);
      return star_scene(lattice, regular_valence(RuleKind::vertex, lattice));
    case RuleKind::corner: return face_scene(n);
    case RuleKind::edge:
    case RuleKind::edge_side:
    case RuleKind::edge_third:
      return star_scene(lattice, regular_valence(RuleKind::vertex, lattice));
    case RuleKind::vertex:
    case RuleKind::edge_end:
    case RuleKind::face_end: return star_scene(lattice, n);
    default: break;
  }
  Scene scene = fan_scene(lattice, n);
  scene.anchor = scene.mesh.halfedge_of_vertex(0);
  if (kind == RuleKind::boundary_spoke) scene.anchor = scene.mesh.rotate(scene.anchor);
  return scene;
}

Place centre(const Scene& scene, Index f) {
  Place sum{};
  for (Index h = scene.mesh.face_begin(f); h < scene.mesh.face_begin(f + 1); ++h)
    sum = combined(1, sum, 1, scene.places[static_cast<std::size_t>(scene.mesh.origin(h))]);
  return combined(1. / scene.mesh.degree(f), sum, 0, sum);
}

Place made_at(const Scene& scene, RuleKind kind, const Split& split) {
  const Mesh& mesh = scene.mesh;
  const Place from = scene.places[static_cast<std::size_t>(mesh.origin(scene.anchor))];
  const Place to = scene.places[static_cast<std::size_t>(mesh.target(scene.anchor))];
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::boundary_vertex: return from;
    case RuleKind::face:
    case RuleKind::face_end: return centre(scene, mesh.face(scene.anchor));
    case RuleKind::corner: {
      const double own = split.is_dual() ? 1 / 2. : 1 / 3.;  // else at thirds of the face's sides
      return combined(own, from, 1 - own, centre(scene, mesh.face(scene.anchor)));
    }
    case RuleKind::edge_third: return combined(2 / 3., from, 1 / 3., to);
    case RuleKind::edge_end:
    case RuleKind::boundary_edge_end:
      if (split.births.thirds || !stands_in_for(kind, split))
        return combined(2 / 3., from, 1 / 3., to);
      break;
    default: break;
  }
  return combined(0.5, from, 0.5, to);
}

std::string weight_text(const number::Exact& value) {
  return value.is_rational() ? to_string(value.rational()) : fmt::format("{:.4g}", value.approx());
}

/// The vertices that the rule's anchor is made of.
std::set<Index> anchor_vertices(const Scene& scene, RuleKind kind) {
  const Mesh& mesh = scene.mesh;
  const Index h = scene.anchor, f = mesh.face(h);
  std::set<Index> result{mesh.origin(h)};
  if (kind == RuleKind::vertex || kind == RuleKind::boundary_vertex) return result;
  result.insert(mesh.target(h));
  if (kind == RuleKind::face || kind == RuleKind::face_end || kind == RuleKind::corner)
    for (Index k = mesh.face_begin(f); k < mesh.face_begin(f + 1); ++k)
      result.insert(mesh.origin(k));
  return result;
}

/// Shown are the faces at the anchor, and those that have weights at all corners.
void add_faces(const Scene& scene, const std::set<Index>& weighed, RulePicture& picture) {
  const Mesh& mesh = scene.mesh;
  const std::set<Index> anchor = anchor_vertices(scene, picture.kind);
  std::map<Index, int> number;
  std::set<std::array<int, 2>> edges;
  const auto numbered = [&](Index v) {
    const auto [at, fresh] = number.try_emplace(v, static_cast<int>(picture.vertices.size()));
    if (fresh) picture.vertices.push_back(scene.places[static_cast<std::size_t>(v)]);
    return at->second;
  };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::size_t corners = 0, with_weight = 0, at_anchor = 0;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h, ++corners) {
      with_weight += weighed.count(mesh.origin(h));
      at_anchor += anchor.count(mesh.origin(h));
    }
    if (with_weight < corners && at_anchor < anchor.size()) continue;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
      const int a = numbered(mesh.origin(h)), b = numbered(mesh.target(h));
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  for (const Index v : weighed) numbered(v);
  picture.edges.assign(edges.begin(), edges.end());
}

Result<RulePicture> picture_of(const Scheme& scheme, RuleKind kind, const RuleCase& one, int n) {
  const Split& split = *scheme.split;
  const int regular = regular_valence(kind, split.lattice);
  const Scene scene = scene_of(kind, split, rule_has_valence(kind) ? n : regular);
  const Result<refine::Row<number::Exact>> row =
      refine::tabulate_row<number::Exact>(scheme, kind, n);
  if (!row) return row.error();
  RulePicture picture;
  picture.kind = kind;
  if (one.when) picture.when = one.when->expression.text();
  if (rule_has_valence(kind)) picture.valence = n;
  std::map<std::pair<bool, Index>, number::Exact> weights;
  refine::visit_stencil(scene.mesh, kind, scene.anchor, false, *row,
                        [&](refine::Source source, const number::Exact& weight) {
                          weights[{source.is_face, source.index}] += weight;
                        });
  std::set<Index> weighed;
  for (const auto& [source, weight] : weights) {
    const auto& [of_face, index] = source;
    if (weight.is_zero()) continue;
    if (!of_face) weighed.insert(index);
    picture.weights.push_back(
        {of_face ? centre(scene, index) : scene.places[static_cast<std::size_t>(index)],
         weight_text(weight), of_face});
  }
  picture.made = made_at(scene, kind, split);
  add_faces(scene, weighed, picture);
  return picture;
}

/// The valence at which a case is shown.
std::optional<int> shown_valence(const Scheme& scheme, RuleKind kind, const RuleCase& one) {
  const int regular = regular_valence(kind, scheme.split->lattice);
  if (!rule_has_valence(kind)) return regular;
  std::vector<int> candidates{regular, 5, 3, 7};
  const bool at_corner = kind == RuleKind::boundary_vertex || kind == RuleKind::boundary_edge_end;
  if (at_corner) candidates.push_back(2);
  for (int n = scheme::kSmallestValence; n <= scheme::kLargestCheckedValence; ++n)
    candidates.push_back(n);
  const bool of_face = kind == RuleKind::face || kind == RuleKind::corner;
  if (of_face && !scheme.split->any_polygons) candidates = {regular};
  for (const int n : candidates)
    if (const Result<const RuleCase*> found = scheme::applicable_case(scheme, kind, n);
        found && *found == &one)
      return n;
  return std::nullopt;
}

}  // namespace

Result<std::vector<RulePicture>> rule_pictures(const Scheme& scheme) {
  const number::ExactBudget budget(scheme::kExactWork);
  std::vector<RulePicture> pictures;
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (!scheme.rule(kind)) continue;
    for (const RuleCase& one : *scheme.rule(kind)) {
      const std::optional<int> n = shown_valence(scheme, kind, one);
      if (!n) continue;
      Result<RulePicture> picture = picture_of(scheme, kind, one, *n);
      if (!picture) return picture.error();
      pictures.push_back(std::move(*picture));
    }
  }
  return pictures;
}

}  // namespace limn::study
