#pragma once
/// What the engine's tests need of each family: meshes of its lattice, where the refined meshes
/// begin, rules that look far.

#include "fast/fast_check.h"
#include "fast/ternary_rules.h"
#include "refine/dual_meshes.h"
#include "refine/dual_rules.h"

namespace limn::test {

/// The plain engine's meshes, and for each control face's first corner v the half-edge out of v on
/// the face's first edge (at odd levels, towards the middle of the small triangle there).
struct PlainLevels {
  PlainLevels(const Mesh& control, int levels) : mesh(control) {
    for (Index f = 0; f < control.face_count(); ++f) starts.push_back(3 * f);
    for (int step = 0; step < levels; ++step) {
      const SplitResult split = find_split("sqrt3")->apply(mesh, step);
      for (Index& h : starts)
        h = step % 2 == 0 ? turned_towards(split, mesh.face(h), mesh.origin(h)) : turned(split, h);
      mesh = split.mesh;
    }
  }

  /// The half-edge from v to the vertex born of face f.
  static Index turned_towards(const SplitResult& split, Index f, Index v) {
    const Births& births = split.births;
    if (!births.faces.empty())
      f = static_cast<Index>(std::find(births.faces.begin(), births.faces.end(), f) -
                             births.faces.begin());
    Index h = split.mesh.halfedge_of_vertex(v);
    while (split.mesh.target(h) != births.from_vertices + births.from_edges + f)
      h = split.mesh.rotate(h);
    return h;
  }

  /// Of the face on the right of h, which lies on the old edge; or the boundary edge.
  [[nodiscard]] Index turned(const SplitResult& split, Index h) const {
    const Index v = mesh.origin(h), right = mesh.twin(h);
    if (mesh.twin(mesh.next(right)) == kNone) return split.mesh.halfedge_of_vertex(v);
    return turned_towards(split, mesh.face(right), v);
  }

  Mesh mesh;
  std::vector<Index> starts;
};

/// The quick engine's faces of a control face begin at its first corner; at odd levels the first of
/// them ends with the way back there from its centroid.
inline Starts start_sqrt3(const Mesh& control, int levels, const Mesh& quick) {
  const PlainLevels plain(control, levels);
  const bool odd = levels % 2 != 0;
  Starts starts;
  for (Index f = 0; f < control.face_count(); ++f) {
    const Index first = 3 * f * (quick.face_count() / control.face_count()), h = plain.starts[f];
    starts.emplace_back(odd ? plain.mesh.twin(h) : h, odd ? first + 2 : first);
  }
  return starts;
}

/// The vertex that a step of quad-sqrt2 puts into face f, or on its boundary edge.
inline Index sqrt2_point(const Mesh& mesh, const SplitResult& split, Index f) {
  const Births& births = split.births;
  const auto place = [](const std::vector<Index>& list, Index one) {
    return static_cast<Index>(std::find(list.begin(), list.end(), one) - list.begin());
  };
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
    if (const Index at = place(births.edges, mesh.edge(h)); at < births.from_edges)
      return births.from_vertices + at;
  const Index among = births.faces.empty() ? f : place(births.faces, f);
  return births.from_vertices + births.from_edges + among;
}

inline Index halfedge_to(const Mesh& mesh, Index from, Index to) {
  Index h = mesh.halfedge_of_vertex(from);
  while (mesh.target(h) != to) h = mesh.rotate(h);
  return h;
}

/// At even levels the first edge of each control face's patch; at odd ones the way from its first
/// corner to the first cell's centre, which has the quick engine's number.
inline Starts start_sqrt2(const Mesh& mesh, int levels, const Mesh& quick) {
  const Split& split = *find_split("quad-sqrt2");
  Mesh control = mesh;
  int step = 0;
  for (; control.uniform_degree() != 4 && step < 2 && step < levels; ++step)
    control = split.apply(control, step).mesh;
  if (step == 1 && levels > 1) control = split.apply(control, step++).mesh;
  Starts starts;
  if (control.uniform_degree() != 4 || step == 1) {  // the plain engine's own
    for (Index f = 0; f < control.face_count(); ++f)
      starts.emplace_back(control.face_begin(f), control.face_begin(f));
    return starts;
  }
  std::vector<Index> ways;
  for (Index f = 0; f < control.face_count(); ++f) ways.push_back(control.face_begin(f));
  Mesh plain = control;
  Index n = 1;
  for (; step < levels; ++step) {
    const SplitResult made = split.apply(plain, step);
    if (step % 2 != 0) n *= 2;
    for (Index& h : ways) {
      const Index face = plain.face(step % 2 == 0 ? h : plain.twin(h));
      h = halfedge_to(made.mesh, plain.origin(h), sqrt2_point(plain, made, face));
    }
    plain = made.mesh;
  }
  const Index centres = quick.vertex_count() - control.face_count() * n * n;
  const Index patch_faces = n * n;
  for (Index f = 0; f < control.face_count(); ++f) {
    const Index corner = control.origin(control.face_begin(f));
    starts.emplace_back(ways[f], levels % 2 == 0 ? quick.face_begin(f * patch_faces)
                                                 : halfedge_to(quick, corner, centres + f * n * n));
  }
  return starts;
}

/// The faces of the control faces are the first of both meshes.
inline Starts start_dual(const Mesh& control, int /*levels*/, const Mesh& /*quick*/) {
  Starts starts;
  for (Index f = 0; f < control.face_count(); ++f)
    starts.emplace_back(control.face_begin(f), control.face_begin(f));
  return starts;
}

/// The plain engine's quad at a corner has 8 times the corner's number.
inline Starts start_quad_ternary(const Mesh& control, int levels, const Mesh& quick) {
  Starts starts;
  for (Index f = 0; f < control.face_count(); ++f) {
    Index plain = control.face_begin(f);
    for (int level = 0; level < levels; ++level) plain *= 8;
    starts.emplace_back(plain, quick.face_begin(f * (quick.face_count() / control.face_count())));
  }
  return starts;
}

/// Where both refined meshes begin, for a split.
inline StartMaker start_of(const Split& split) {
  if (split.is_dual()) return start_dual;
  if (split.births.thirds && split.lattice == Lattice::quad) return start_quad_ternary;
  if (split.odd_step_cut == 3) return start_sqrt3;
  if (split.odd_step_cut == 2) return start_sqrt2;
  return start_each_face;
}

/// Rules that look as far as two rings, at edges' ends too, and differ by valence.
inline constexpr const char* kWideTriangles = R"toml(
[roles.vertex]
straight = "vefefev"

[roles.edge]
over = "evefefev"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
across = "1/(4*n)"

[[vertex]]
self = "5/8 - 1/16"
ring = "3/(8*n)"
straight = "1/(16*n)"

[edge]
end = "7/16"
wing = "1/16"
outer = "1/64"
over = "-1/64"

[[edge-end]]
when = "n == 7 or n == 6"
self = "5/8"
ring = "(3/8)/n + cos(2*pi*k/n)/(2*n)"

[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge]
end = "9/16"
beyond = "-1/16"
)toml";

inline constexpr const char* kWideQuads = R"toml(
[roles.vertex]
straight = "vefev"

[face]
corner = "9/(8*n)"
beyond = "-1/(16*n)"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
diagonal = "1/(4*n)"

[[vertex]]
self = "5/8"
ring = "1/(8*n)"
straight = "1/(8*n)"
face = "1/(8*n)"

[edge]
end = "7/16"
wing = "1/64"
opposite = "-1/32"
face = "1/16"

[[edge-end]]
when = "n == 7 or n == 4"
self = "5/8"
ring = "(3/8)/n + cos(2*pi*k/n)/(2*n)"
)toml";

inline constexpr const char* kQuadBoundary = R"toml(
[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge]
end = "9/16"
beyond = "-1/16"
)toml";

inline constexpr const char* kWideSqrt3 = R"toml(
[roles.vertex]
straight = "vefefev"

[roles.face]
outer = "fvev"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
across = "1/(4*n)"

[[vertex]]
self = "5/8 - 1/16"
ring = "3/(8*n)"
straight = "1/(16*n)"

[face]
corner = "3/8"
beyond = "1/96"
outer = "-5/96"

[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge-end]
near = "3/4"
far = "3/8"
beyond = "-1/8"
)toml";

/// The same of √2.
inline constexpr const char* kWideSqrt2 = R"toml(
[roles.vertex]
second = "vefev"

[[vertex]]
when = "n == 5"
self = "3/8"
ring = "1/(2*n)"
diagonal = "1/(8*n)"

[[vertex]]
self = "1/2"
ring = "1/(4*n)"
second = "1/(4*n)"

[face]
corner = "1/n - 1/16"
beyond = "1/32"

[boundary.vertex]
self = "3/4"
next = "1/8"

[boundary.edge]
end = "9/16"
beyond = "-1/16"
)toml";

/// The tensor product of the four-point scheme: of an edge's or face's two rings, not all.
inline constexpr const char* kFourPoint = R"toml(
[roles.face]
far = "fefvev"

[face]
corner = "81/(64*n)"
beyond = "-9/(64*n)"
far = "1/(64*n)"

[vertex]
self = 1

[edge]
end = "9/16"
opposite = "-1/16"
)toml";

/// New vertices of faces, with weights by position, that look beyond their faces.
inline constexpr const char* kFaces = R"toml(
[roles.vertex]
around = "(ef)*F"

[face]
corner = "9/(8*n)"
beyond = "-1/(16*n)"

[vertex]
self = "3/4"
around = "1/(4*n)"

[edge]
end = "1/4"
face = "1/4"
)toml";

/// A rule of the face alone whose weights differ by place and by number of corners.
inline constexpr const char* kNear = R"toml(
[[corner]]
when = "n == 5"
round = "((k == 0)*n/3 + 2/3 + cos(2*pi*k/n)/5 - cos(4*pi*k/n)/7)/n"

[[corner]]
when = "n == 4"
self = "1/8"
round = "((k == 0)*n/4 + 5/8 + cos(2*pi*k/n)/3 + cos(4*pi*k/n)/11)/n"

[[corner]]
round = "((k == 0)*n/2 + 1/2 + cos(2*pi*k/n)/9)/n"
)toml";

/// Rules that look beyond the face, one vertex or two.
inline constexpr const char* kWideDual = R"toml(
[roles.corner]
beyond = "fev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
beyond = "1/32"
)toml";
inline constexpr const char* kFarther = R"toml(
[roles.corner]
straight = "vefevefev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
straight = "1/32"
)toml";

}  // namespace limn::test
