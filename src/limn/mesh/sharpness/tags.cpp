#include "limn/mesh/sharpness/sharpness.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/edges_between.h"

namespace limn {
namespace {

using mesh::at;

class Applying {
 public:
  Applying(const Mesh& mesh, const MeshSource& source, const SharpnessTags& tags, Sharpness& out)
      : mesh_(mesh), source_(source), tags_(tags), out_(out) {
    for (Index v = 0; v < static_cast<Index>(source.file_vertices.size()); ++v)
      copies_.emplace_back(source.file_vertices[at(v)], v);
    std::sort(copies_.begin(), copies_.end());
  }

  Status run() {
    for (const SharpnessTags::Crease& crease : tags_.creases)
      if (Status status = apply(crease); !status) return status;
    for (const SharpnessTags::Corner& corner : tags_.corners)
      if (Status status = apply(corner); !status) return status;
    if (Status status = apply_holes(); !status) return status;
    if (tags_.method) out_.method = *tags_.method;
    return Done{};
  }

 private:
  [[nodiscard]] Error fault(int line, std::string message, std::string hint = {}) const {
    return {std::move(message), std::move(hint), tags_.file, line, 0};
  }

  Status check(Index number, Index count, const char* what, int line) const {
    if (number >= 0 && number < count) return Done{};
    return fault(line,
                 fmt::format("{} {} is out of range: the mesh has {}", what,
                             static_cast<long long>(number) + tags_.first, count),
                 tags_.first == 0 ? "these numbers begin with 0" : "");
  }

  [[nodiscard]] bool repaired() const { return !source_.joined_with.empty(); }
  [[nodiscard]] Index vertex_count() const {
    return repaired() ? static_cast<Index>(source_.joined_with.size()) : mesh_.vertex_count();
  }
  /// The vertices of the mesh that one of the file has become.
  [[nodiscard]] std::vector<Index> vertices_of(Index v) const {
    if (!repaired()) return {v};
    const std::pair<Index, Index> wanted{source_.joined_with[at(v)], 0};
    std::vector<Index> found;
    for (auto i = std::lower_bound(copies_.begin(), copies_.end(), wanted);
         i != copies_.end() && i->first == wanted.first; ++i)
      found.push_back(i->second);
    return found;
  }
  [[nodiscard]] std::vector<Index> edges_of(Index a, Index b) const {
    std::vector<Index> edges;
    for (const Index from : vertices_of(a))
      for (const Index to : vertices_of(b))
        for (const Index e : mesh::edges_between(mesh_, from, to)) edges.push_back(e);
    return edges;
  }

  Status apply(const SharpnessTags::Crease& crease) {
    for (const Index v : crease.vertices)
      if (Status status = check(v, vertex_count(), "vertex", crease.line); !status) return status;
    for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i) {
      const Index a = crease.vertices[i], b = crease.vertices[i + 1];
      const std::vector<Index> edges = edges_of(a, b);
      if (edges.empty() && !repaired())  // else a face of it was dropped, or its ends joined
        return fault(crease.line,
                     fmt::format("no edge joins the vertices {} and {} of a crease",
                                 a + tags_.first, b + tags_.first),
                     tags_.first == 0 ? "these numbers begin with 0" : "");
      out_.edges.resize(at(mesh_.edge_count()), 0);
      for (const Index e : edges)
        out_.edges[at(e)] =
            crease.sharpness.size() == 1 ? crease.sharpness[0] : crease.sharpness[i];
    }
    return Done{};
  }

  Status apply(const SharpnessTags::Corner& corner) {
    if (Status status = check(corner.vertex, vertex_count(), "vertex", corner.line); !status)
      return status;
    out_.vertices.resize(at(mesh_.vertex_count()), 0);
    for (const Index v : vertices_of(corner.vertex)) out_.vertices[at(v)] = corner.sharpness;
    return Done{};
  }

  /// A face of the file may be several of the mesh, or none.
  Status apply_holes() {
    if (tags_.holes.empty()) return Done{};
    Index of_file = 0;
    for (Index f = 0; f < mesh_.face_count(); ++f)
      of_file = std::max(of_file, source_.file_face(f) + 1);
    std::vector<bool> holes(at(of_file), false);
    for (const SharpnessTags::Hole& hole : tags_.holes) {
      if (Status status = check(hole.face, of_file, "face", hole.line); !status) return status;
      holes[at(hole.face)] = true;
    }
    out_.holes.resize(at(mesh_.face_count()), false);
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (holes[at(source_.file_face(f))]) out_.holes[at(f)] = true;
    return Done{};
  }

  const Mesh& mesh_;
  const MeshSource& source_;
  const SharpnessTags& tags_;
  Sharpness& out_;
  std::vector<std::pair<Index, Index>> copies_;  // vertex of the file and of the mesh, sorted
};

}  // namespace

bool SharpnessTags::empty() const {
  return creases.empty() && corners.empty() && holes.empty() && !boundary && !method &&
         !smooth_triangles;
}

Status apply_tags(const Mesh& mesh, const MeshSource& source, const SharpnessTags& tags,
                  Sharpness& sharpness) {
  return Applying(mesh, source, tags, sharpness).run();
}

SharpnessTags tags_of(const Mesh& mesh, const Sharpness& sharpness) {
  SharpnessTags tags;
  for (Index e = 0; e < static_cast<Index>(sharpness.edges.size()); ++e) {
    if (!(sharpness.edges[at(e)] > 0) || mesh.is_boundary_edge(e)) continue;
    const Index h = mesh.halfedge_of_edge(e);
    tags.creases.push_back({{mesh.origin(h), mesh.target(h)}, {sharpness.edges[at(e)]}, 0});
  }
  for (Index v = 0; v < static_cast<Index>(sharpness.vertices.size()); ++v)
    if (sharpness.vertices[at(v)] > 0) tags.corners.push_back({v, sharpness.vertices[at(v)], 0});
  for (std::size_t f = 0; f < sharpness.holes.size(); ++f)
    if (sharpness.holes[f]) tags.holes.push_back({static_cast<Index>(f), 0});
  if (sharpness.method != CreaseMethod::uniform) tags.method = sharpness.method;
  return tags;
}

const std::vector<std::pair<std::string, BoundaryMode>>& boundary_modes() {
  static const std::vector<std::pair<std::string, BoundaryMode>> modes{
      {"none", BoundaryMode::none},
      {"edgeOnly", BoundaryMode::edge_only},
      {"edgeAndCorner", BoundaryMode::edge_and_corner}};
  return modes;
}

const std::vector<std::pair<std::string, CreaseMethod>>& crease_methods() {
  static const std::vector<std::pair<std::string, CreaseMethod>> methods{
      {"uniform", CreaseMethod::uniform}, {"chaikin", CreaseMethod::chaikin}};
  return methods;
}

}  // namespace limn
