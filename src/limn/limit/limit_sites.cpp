#include "limn/limit/limit_sites.h"

#include "limn/refine/linear_form.h"
#include "limn/refine/refine.h"

namespace limn::limit {
namespace {

template <class Value>
Result<LimitPatch<Value>> refined(const Scheme& scheme, const Mesh& mesh,
                                  const std::vector<Value>& values, int step,
                                  refine::RuleTables<double>& tables) {
  Result<refine::Refined<Value>> fine = refine::refine_once(scheme, mesh, values, step, tables);
  if (!fine) return fine.error();
  return LimitPatch<Value>{std::move(fine->mesh), std::move(fine->values), {}};
}

/// Faces of a mesh as one of their own. Where they meet in a vertex only, each fan gets a copy of
/// it, so that the part is a manifold.
class Part {
 public:
  Part(const Mesh& mesh, const std::vector<bool>& faces)
      : mesh_(mesh),
        first_(static_cast<std::size_t>(mesh.face_count()), kNone),
        vertex_(static_cast<std::size_t>(mesh.halfedge_count()), kNone) {
    Mesh::Arrays& a = arrays_;
    a.face_begin.push_back(0);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (!faces[f]) continue;
      first_[f] = a.face_begin.back();
      a.face_begin.push_back(a.face_begin.back() + mesh.degree(f));
    }
    const bool uniform = mesh.uniform_degree() > 0;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (first_[f] != kNone)
        for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) add(h);
    if (uniform) {
      a.degree = mesh.uniform_degree();
      a.face_begin.clear();
    }
    a.vertex_count = static_cast<Index>(old_vertex.size());
  }

  std::vector<Index> old_vertex;  ///< of each vertex of the part
  [[nodiscard]] Mesh mesh() && { return Mesh::from_arrays(std::move(arrays_)); }
  /// The part's number of a half-edge of one of its faces.
  [[nodiscard]] Index halfedge(Index h) const {
    const Index f = mesh_.face(h);
    return first_[f] + (h - mesh_.face_begin(f));
  }
  [[nodiscard]] Index vertex_at(Index h) const { return vertex_[h]; }

 private:
  [[nodiscard]] Index twin(Index h) const {
    const Index t = mesh_.twin(h);
    return t != kNone && first_[mesh_.face(t)] != kNone ? t : kNone;
  }

  void add(Index h) {
    if (vertex_[h] == kNone) name_fan(h);
    const Index t = twin(h);
    arrays_.origin.push_back(vertex_[h]);
    arrays_.twin.push_back(t == kNone ? kNone : halfedge(t));
    const bool known = t != kNone && halfedge(t) < static_cast<Index>(arrays_.edge.size());
    arrays_.edge.push_back(known ? arrays_.edge[halfedge(t)] : arrays_.edge_count++);
  }

  /// The corners of one fan round the origin of h become one vertex.
  void name_fan(Index h) {
    const auto name = static_cast<Index>(old_vertex.size());
    old_vertex.push_back(mesh_.origin(h));
    for (Index g = h; g != kNone && vertex_[g] == kNone; g = twin(mesh_.prev(g))) vertex_[g] = name;
    for (Index t = twin(h); t != kNone;) {  // the other way round
      const Index g = mesh_.next(t);
      if (vertex_[g] != kNone) break;
      vertex_[g] = name;
      t = twin(g);
    }
  }

  const Mesh& mesh_;
  std::vector<Index> first_;   // half-edge of the part that begins each face
  std::vector<Index> vertex_;  // of the part, at the origin of each half-edge
  Mesh::Arrays arrays_;
};

/// The faces within `rings` rings of the sites.
std::vector<bool> surroundings(const Split& split, const Mesh& mesh,
                               const std::vector<LimitSite>& sites, int rings) {
  std::vector<bool> vertices(static_cast<std::size_t>(mesh.vertex_count()), false);
  std::vector<bool> faces(static_cast<std::size_t>(mesh.face_count()), false);
  const auto mark_corners = [&](Index f) {
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      vertices[mesh.origin(h)] = true;
  };
  for (const LimitSite& site : sites) {
    if (split.is_dual())
      mark_corners(mesh.face(site.at));
    else
      vertices[site.at] = true;
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1) && !faces[f]; ++h)
        if (vertices[mesh.origin(h)]) faces[f] = true;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (faces[f]) mark_corners(f);
  }
  return faces;
}

/// In the mesh of a dual split, after its first step: the half-edge of the face that stands for an
/// old vertex, or for the place on the surface that is nearest to it.
Index dual_site(const Split& split, const Mesh& old, const Mesh& fine, Index v) {
  // the new vertex at the origin of h: its corner's, or that of its edge
  const auto child = [&](Index h) { return split.births.corners ? h : old.edge(h); };
  const Index first = old.halfedge_of_vertex(v);
  const auto crossing = [&](Index h, Index to) {  // the new half-edge from child to child
    const Index begin = fine.halfedge_of_vertex(child(h));
    for (Index g = begin; g != kNone;) {
      if (fine.target(g) == child(to)) return g;
      g = fine.rotate(g);
      if (g == begin) break;
    }
    return kNone;
  };
  const Index second = old.rotate(first);
  if (old.twin(first) != kNone && old.valence(v) > 2) return crossing(first, second);
  if (old.twin(first) != kNone)  // valence 2: the squeezed face is the edge between its corners
    return crossing(first, old.next(old.twin(first)));
  // a boundary vertex: the middle of its faces, or the edge between the two in the middle
  const Index faces = old.valence(v) - 1;
  Index h = first;
  for (Index i = 0; i < faces / 2; ++i) h = old.rotate(h);
  if (faces % 2 != 0 || !split.births.corners) return h;  // a face keeps its half-edges' numbers
  return crossing(h, old.next(old.twin(h)));
}

}  // namespace

std::vector<LimitSite> limit_sites(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<LimitSite> sites;
  sites.reserve(vertices.size());
  for (const Index v : vertices)
    if (!mesh.is_isolated(v)) sites.push_back({v, v, false});
  return sites;
}

bool beside_boundary_edge(const Mesh& mesh, Index vertex) {
  if (mesh.is_boundary_vertex(vertex)) return true;
  const Index first = mesh.halfedge_of_vertex(vertex);
  Index h = first;
  do {
    if (mesh.twin(mesh.next(h)) == kNone) return true;
    h = mesh.rotate(h);
  } while (h != first);
  return false;
}

template <class Value>
Result<LimitPatch<Value>> dual_patch(const Scheme& scheme, const Mesh& mesh,
                                     const std::vector<Value>& values,
                                     const std::vector<Index>& vertices, int step,
                                     refine::RuleTables<double>& tables) {
  Result<LimitPatch<Value>> patch = refined(scheme, mesh, values, step, tables);
  if (!patch) return patch;
  for (const Index v : vertices)
    if (!mesh.is_isolated(v))
      patch->sites.push_back({v, dual_site(*scheme.split, mesh, patch->mesh, v), false});
  return patch;
}

template <class Value>
Result<LimitPatch<Value>> refined_patch(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Value>& values,
                                        const std::vector<LimitSite>& sites, int rings, int step,
                                        refine::RuleTables<double>& tables) {
  const bool dual = scheme.split->is_dual();
  Part part(mesh, surroundings(*scheme.split, mesh, sites, rings));
  std::vector<Value> part_values;
  part_values.reserve(part.old_vertex.size());
  for (const Index v : part.old_vertex) part_values.push_back(values[v]);
  std::vector<LimitSite> part_sites;
  part_sites.reserve(sites.size());
  for (const LimitSite& site : sites)
    part_sites.push_back(
        {site.result,
         dual ? part.halfedge(site.at) : part.vertex_at(mesh.halfedge_of_vertex(site.at)),
         site.has_limit});
  const Mesh part_mesh = std::move(part).mesh();
  Result<LimitPatch<Value>> patch = refined(scheme, part_mesh, part_values, step, tables);
  if (patch) patch->sites = std::move(part_sites);
  return patch;
}

using Form = refine::LinearForm<double>;
template Result<LimitPatch<Point3>> dual_patch(const Scheme&, const Mesh&,
                                               const std::vector<Point3>&,
                                               const std::vector<Index>&, int,
                                               refine::RuleTables<double>&);
template Result<LimitPatch<Form>> dual_patch(const Scheme&, const Mesh&, const std::vector<Form>&,
                                             const std::vector<Index>&, int,
                                             refine::RuleTables<double>&);
template Result<LimitPatch<Point3>> refined_patch(const Scheme&, const Mesh&,
                                                  const std::vector<Point3>&,
                                                  const std::vector<LimitSite>&, int, int,
                                                  refine::RuleTables<double>&);
template Result<LimitPatch<Form>> refined_patch(const Scheme&, const Mesh&,
                                                const std::vector<Form>&,
                                                const std::vector<LimitSite>&, int, int,
                                                refine::RuleTables<double>&);

}  // namespace limn::limit
