#include "limn/mesh/repair/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/base/interrupt.h"
#include "limn/mesh/edge_sides.h"
#include "limn/mesh/finite_point.h"
#include "limn/mesh/joined_sets.h"
#include "limn/mesh/repair/face_shape.h"

namespace limn::mesh {
namespace {

using detail::EdgeSide;
using Kind = MeshFault::Kind;

constexpr double kNear = 1e-6;  // of the diagonal
constexpr double kBent = 1e-3;  // of a face's size

class Surveyor {
 public:
  explicit Surveyor(const Polygons& mesh)
      : mesh_(mesh),
        used_(mesh.positions.size(), 0),
        finite_(mesh.positions.size(), 1),
        out_(static_cast<std::size_t>(mesh.face_count()), 0) {}

  MeshSurvey survey() {
    found_.vertices = mesh_.vertex_count();
    found_.faces = mesh_.face_count();
    found_.faults = find_mesh_faults(mesh_);
    find_left_out();
    look_at_vertices();
    base::check_interrupt();
    look_at_faces();
    base::check_interrupt();
    look_at_edges();
    base::check_interrupt();
    look_at_places();
    found_.refinable = found_.faults.list.empty() && found_.not_finite.empty();
    return std::move(found_);
  }

 private:
  [[nodiscard]] Index vertex(Index corner) const { return mesh_.corners[corner]; }
  template <class Use>
  void for_each_corner(Index f, const Use& use) const {
    for (Index c = mesh_.face_begin[f]; c < mesh_.face_begin[f + 1]; ++c) use(c);
  }

  /// Faces with a corner that is no vertex.
  void find_left_out() {
    for (const MeshFault& fault : found_.faults.list) {
      if (fault.kind == Kind::out_of_range) out_[fault.faces[0]] = 1;
      if (fault.kind == Kind::flipped_edge && fault.one_sided) found_.orientable = false;
    }
  }

  void look_at_vertices() {
    JoinedSets parts(mesh_.vertex_count());
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (out_[f] != 0) continue;
      for_each_corner(f, [&](Index c) {
        used_[vertex(c)] = 1;
        parts.join(vertex(mesh_.face_begin[f]), vertex(c), false);
      });
    }
    constexpr double most = std::numeric_limits<float>::max();
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const Point3& p = mesh_.positions[v];
      found_.components += used_[v] != 0 && parts.root(v) == v ? 1 : 0;
      if (used_[v] == 0) found_.isolated.push_back(v);
      finite_[v] = is_finite(p) ? 1 : 0;
      if (finite_[v] == 0)
        found_.not_finite.push_back(v);
      else if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > most)
        found_.enormous.push_back(v);
    }
  }

  void look_at_faces() {
    std::vector<char> own(out_);  // faces that meet a vertex twice, or are too short
    for (const MeshFault& fault : found_.faults.list)
      if (fault.kind == Kind::few_corners || fault.kind == Kind::repeated_corner)
        own[fault.faces[0]] = 1;
    detail::FaceShapes shapes(mesh_);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      ++found_.degrees[mesh_.degree(f)];
      if (out_[f] != 0) continue;
      bool finite = true;
      for_each_corner(f, [&](Index c) { finite = finite && finite_[vertex(c)] != 0; });
      if (own[f] != 0) {
        found_.degenerate.push_back(f);
      } else if (finite) {
        note_shape(f, shapes.of(f));
      }
    }
  }

  void note_shape(Index f, const detail::FaceShape& shape) {
    if (shape.flat) found_.degenerate.push_back(f);
    if (shape.concave) found_.concave.push_back(f);
    if (shape.off_plane <= kBent) return;
    found_.bent.push_back(f);
    found_.most_bent = std::max(found_.most_bent, shape.off_plane);
  }

  void look_at_edges() {
    const std::vector<mesh::detail::EdgeSide> sides = detail::sorted_sides(mesh_, out_);
    JoinedSets fans(static_cast<Index>(mesh_.corners.size()));
    std::vector<Index> valence(used_.size(), 0);
    std::vector<char> open(used_.size(), 0);
    std::vector<mesh::detail::EdgeSide> boundary;
    detail::for_each_edge(sides, [&](std::size_t k, std::size_t last) {
      const Index v = detail::low_end(sides[k].edge), w = detail::high_end(sides[k].edge);
      if (v == w) return;  // a corner that is repeated at once
      ++found_.edges;
      for (const Index end : {v, w}) {
        ++valence[end];
        open[end] |= last - k != 2 ? 1 : 0;
      }
      if (last - k == 1) boundary.push_back(sides[k]);
      if (last - k == 2) mesh::detail::join_fans(mesh_, sides[k], sides[k + 1], fans);
    });
    for (std::size_t v = 0; v < used_.size(); ++v) {
      if (used_[v] != 0) ++found_.valences[valence[v]];
      if (valence[v] == 2 && open[v] == 0 && found_.faults.list.empty())
        found_.valence_two.push_back(static_cast<Index>(v));
    }
    count_loops(boundary, fans);
    const auto used = found_.vertices - static_cast<Index>(found_.isolated.size());
    found_.euler = std::int64_t{used} - found_.edges + found_.faces;
    const bool surface = std::all_of(found_.faults.list.begin(), found_.faults.list.end(),
                                     [](const MeshFault& fault) {
                                       return fault.kind == Kind::flipped_edge && !fault.one_sided;
                                     });
    if (surface)
      found_.genus =
          (2 * std::int64_t{found_.components} - found_.euler - found_.boundary_loops) / 2;
  }

  void count_loops(const std::vector<mesh::detail::EdgeSide>& boundary, JoinedSets& fans) {
    found_.boundary_edges = static_cast<Index>(boundary.size());
    JoinedSets loops(found_.boundary_edges);
    std::vector<Index> met(mesh_.corners.size(), kNone);  // a boundary edge at each fan
    std::vector<Index> ends;
    for (Index b = 0; b < found_.boundary_edges; ++b) {
      const mesh::detail::EdgeSide& side = boundary[b];
      const Index next = detail::next_corner(mesh_, side.face, side.corner);
      for (const Index corner : {side.corner, next}) {
        Index& first = met[fans.root(corner)];
        if (first == kNone) first = b;
        loops.join(first, b, false);
        ends.push_back(vertex(corner));
      }
    }
    for (Index b = 0; b < found_.boundary_edges; ++b)
      found_.boundary_loops += loops.root(b) == b ? 1 : 0;
    found_.seams = open_seams(ends, mesh_.positions);
  }

  void look_at_places() {
    const std::vector<Index> place = places_of(mesh_.positions);
    std::vector<Point3> different;
    std::vector<Index> numbers;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (place[v] == v) {
        different.push_back(mesh_.positions[v]);
        numbers.push_back(v);
        continue;
      }
      found_.coincident.push_back(v);
      found_.coincident_with.push_back(place[v]);
    }
    const std::vector<Index> near = places_of(different, kNear * diagonal_of(different));
    for (Index i = 0; i < static_cast<Index>(near.size()); ++i)
      if (near[i] != i) found_.near.push_back(numbers[i]);
  }

  const Polygons& mesh_;
  std::vector<char> used_, finite_;  // of vertices
  std::vector<char> out_;            // of faces
  MeshSurvey found_;
};

}  // namespace

MeshSurvey survey_mesh(const Polygons& polygons) { return Surveyor(polygons).survey(); }

OpenSeams open_seams(const Mesh& mesh, const std::vector<Point3>& points) {
  std::vector<Index> ends;
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    if (mesh.twin(h) == kNone) ends.insert(ends.end(), {mesh.origin(h), mesh.target(h)});
  return open_seams(ends, points);
}

}  // namespace limn::mesh
