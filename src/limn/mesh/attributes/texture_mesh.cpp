#include "limn/mesh/attributes/texture_mesh.h"

#include <algorithm>

#include "limn/base/large_vector.h"
#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/cut_mesh.h"
#include "limn/mesh/sharpness/resting_with.h"

namespace limn {
namespace {

using mesh::at;

/// The half-edges with twins whose corners, or those of the twin, name different points.
std::vector<bool> seams_of(const Mesh& mesh, const TextureCoordinates& texture, bool& any) {
  std::vector<bool> seams(at(mesh.edge_count()));
  const std::vector<Index>& point = texture.of_corner;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h);
    if (twin == kNone) continue;
    seams[at(e)] =
        point[at(h)] != point[at(mesh.next(twin))] || point[at(mesh.next(h))] != point[at(twin)];
    any = any || seams[at(e)];
  }
  return seams;
}

/// Some of the faces round a vertex, between seams or boundaries.
struct Fan {
  Index vertex = 0;  ///< of the texture mesh
  Index point = 0;
  Index faces = 0;
  bool cut = false;          ///< an infinitely sharp edge ends in it
  std::vector<double> fade;  ///< the sharpness of other edges that end in it
};

/// Finds the corners at one vertex of the mesh after the other.
class Corners {
 public:
  Corners(const Mesh& mesh, const TextureCoordinates& texture, TextureRule rule,
          mesh::TextureMesh& out)
      : mesh_(mesh), texture_(texture), rule_(rule), out_(out) {}

  /// `copies`: what the vertex has become.
  void classify(Index v, const std::vector<Index>& copies, bool at_seam) {
    if (rule_ >= TextureRule::boundaries) return;
    std::vector<Fan> fans;
    fans.reserve(copies.size());
    for (const Index copy : copies) fans.push_back(fan_of(copy));
    if (!at_seam) {
      if (mesh_.is_boundary_vertex(v) && fans[0].faces == 1 && rule_ != TextureRule::none)
        sharpen(fans[0], kInfinitelySharp);
      return;
    }
    if (all_rest(v, fans)) {
      for (const Fan& fan : fans) sharpen(fan, kInfinitelySharp);
      return;
    }
    for (const Fan& fan : fans) {
      const bool alone = faces_with(fans, fan.point) == 1 && rule_ != TextureRule::none;
      if (alone || is_disjoint(fans, fan))
        sharpen(fan, kInfinitelySharp);
      else if (depends() && points_of(fans) == 2)
        rest_with_other(fans, fan);
    }
  }

 private:
  [[nodiscard]] Fan fan_of(Index copy) const {
    Fan fan{copy, kNone, 0, false, {}};
    const Index first = out_.mesh.halfedge_of_vertex(copy);
    fan.point = texture_.of_corner[at(first)];
    for (Index h = first; h != kNone;) {
      ++fan.faces;
      h = out_.mesh.rotate(h);
      if (h == kNone) break;
      const double s = sharpness_of_edge(mesh_, out_.sharpness, mesh_.edge(h));
      fan.cut = fan.cut || s >= kInfinitelySharp;
      if (s > 0 && s < kInfinitelySharp) fan.fade.push_back(s);
      if (h == first) break;
    }
    return fan;
  }

  [[nodiscard]] bool depends() const {
    return rule_ == TextureRule::corners_plus1 || rule_ == TextureRule::corners_plus2;
  }
  static Index faces_with(const std::vector<Fan>& fans, Index point) {
    Index faces = 0;
    for (const Fan& fan : fans) faces += fan.point == point ? fan.faces : 0;
    return faces;
  }
  static std::size_t points_of(const std::vector<Fan>& fans) {
    std::vector<Index> points;
    points.reserve(fans.size());
    for (const Fan& fan : fans) points.push_back(fan.point);
    std::sort(points.begin(), points.end());
    return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
  }
  /// Whether its point is also that of another fan, or a sharp edge divides it.
  static bool is_disjoint(const std::vector<Fan>& fans, const Fan& fan) {
    return std::any_of(fans.begin(), fans.end(), [&](const Fan& other) {
      return other.point == fan.point && (other.cut || other.vertex != fan.vertex);
    });
  }

  /// Whether all points of a vertex at a seam rest.
  [[nodiscard]] bool all_rest(Index v, const std::vector<Fan>& fans) const {
    const bool plus2 = rule_ == TextureRule::corners_plus2;
    const std::size_t points = points_of(fans);
    if (depends() && points > 2) return true;
    if (plus2 && points == 1 && !mesh_.is_boundary_vertex(v)) return true;
    if (!depends() || points != 2) return false;
    return std::any_of(fans.begin(), fans.end(), [&](const Fan& fan) {
      return is_disjoint(fans, fan) || (plus2 && fan.faces == 1);
    });
  }

  /// A point without sharp edges rests as long as the other one does for its edges.
  void rest_with_other(const std::vector<Fan>& fans, const Fan& fan) {
    const bool own =
        !out_.sharpness.vertices.empty() && out_.sharpness.vertices[at(fan.vertex)] > 0;
    if (own || !fan.fade.empty()) return;
    for (const Fan& other : fans)
      if (!other.fade.empty()) sharpen(fan, mesh::resting_with(other.fade));
  }

  void sharpen(const Fan& fan, double sharpness) {
    std::vector<double>& vertices = out_.sharpness.vertices;
    vertices.resize(at(out_.mesh.vertex_count()), 0);
    vertices[at(fan.vertex)] = std::max(vertices[at(fan.vertex)], sharpness);
  }

  const Mesh& mesh_;
  const TextureCoordinates& texture_;
  TextureRule rule_;
  mesh::TextureMesh& out_;
};

/// Of each vertex of a cut mesh the first of the same original with the same point; empty where it
/// is each itself, and none is isolated.
std::vector<Index> first_with_point(const Mesh& cut, const std::vector<Index>& originals,
                                    const TextureCoordinates& texture) {
  std::vector<Index> first(originals.size()), order;
  for (Index v = 0; v < cut.vertex_count(); ++v) {
    first[at(v)] = v;
    if (!cut.is_isolated(v)) order.push_back(v);
  }
  const auto key = [&](Index v) {
    return std::pair{originals[at(v)], texture.of_corner[at(cut.halfedge_of_vertex(v))]};
  };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  bool merged = order.size() < first.size();
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (key(order[i]) != key(order[i - 1])) continue;
    first[at(order[i])] = first[at(order[i - 1])];
    merged = true;
  }
  return merged ? first : std::vector<Index>();
}

/// The sharpness of the cut mesh.
Sharpness cut_sharpness(const Sharpness& sharpness, const mesh::CutMesh& cut) {
  Sharpness result;
  result.method = sharpness.method;
  result.edges = sharpness.edges;
  if (!result.edges.empty()) result.edges.resize(at(cut.mesh.edge_count()), 0);
  if (!sharpness.vertices.empty())
    for (const Index v : cut.originals) result.vertices.push_back(sharpness.vertices[at(v)]);
  return result;
}

}  // namespace

const std::vector<std::pair<std::string, TextureRule>>& texture_rules() {
  static const std::vector<std::pair<std::string, TextureRule>> rules{
      {"none", TextureRule::none},
      {"cornersOnly", TextureRule::corners_only},
      {"cornersPlus1", TextureRule::corners_plus1},
      {"cornersPlus2", TextureRule::corners_plus2},
      {"boundaries", TextureRule::boundaries},
      {"all", TextureRule::all}};
  return rules;
}

bool mesh::has_seams(const Mesh& mesh, const TextureCoordinates& texture) {
  bool any = false;
  if (!texture.empty()) (void)seams_of(mesh, texture, any);
  return any;
}

mesh::TextureMesh mesh::make_texture_mesh(const Mesh& mesh, const Sharpness& sharpness,
                                          const TextureCoordinates& texture, TextureRule rule) {
  bool any = false;
  const std::vector<bool> seams = seams_of(mesh, texture, any);
  mesh::CutMesh cut = mesh::cut_along(mesh, seams);
  mesh::TextureMesh result;
  result.sharpness = cut_sharpness(sharpness, cut);
  result.mesh = std::move(cut.mesh);
  result.points.resize(cut.originals.size());
  for (Index h = 0; h < result.mesh.halfedge_count(); ++h) {
    const Index point = texture.of_corner[at(h)];
    if (point == kNone) continue;
    const TexturePoint& p = texture.points[at(point)];
    result.points[at(result.mesh.origin(h))] = {p.u, p.v, 0};
  }
  result.first = first_with_point(result.mesh, cut.originals, texture);
  std::vector<std::vector<Index>> copies(at(mesh.vertex_count()));
  for (std::size_t i = 0; i < cut.originals.size(); ++i)
    copies[at(cut.originals[i])].push_back(static_cast<Index>(i));
  std::vector<bool> at_seam(copies.size(), false);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!seams[at(e)]) continue;
    const Index h = mesh.halfedge_of_edge(e);
    at_seam[at(mesh.origin(h))] = at_seam[at(mesh.target(h))] = true;
  }
  Corners corners(mesh, texture, rule, result);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && (at_seam[at(v)] || mesh.is_boundary_vertex(v)))
      corners.classify(v, copies[at(v)], at_seam[at(v)]);
  return result;
}

std::vector<bool> mesh::faces_without(const Mesh& mesh, const TextureCoordinates& texture) {
  std::vector<bool> without;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (texture.of_corner[at(h)] != kNone) continue;
    without.resize(at(mesh.face_count()), false);
    without[at(mesh.face(h))] = true;
  }
  return without;
}

TextureCoordinates mesh::texture_of(Polygons polygons, const std::vector<Index>& first,
                                    const std::vector<bool>& without, NumberType type) {
  TextureCoordinates result;
  result.type = type;
  base::reserve_large(result.points, polygons.positions.size());
  if (first.empty() && without.empty()) {
    for (const Point3& p : polygons.positions) result.points.push_back({p.x, p.y});
    result.of_corner = std::move(polygons.corners);
    return result;
  }
  base::reserve_large(result.of_corner, polygons.corners.size());
  std::vector<Index> number(polygons.positions.size(), kNone);
  for (Index f = 0; f < polygons.face_count(); ++f)
    for (Index c = polygons.face_begin[at(f)]; c < polygons.face_begin[at(f + 1)]; ++c) {
      if (!without.empty() && without[at(f)]) {
        result.of_corner.push_back(kNone);
        continue;
      }
      Index vertex = polygons.corners[at(c)];
      if (at(vertex) < first.size()) vertex = first[at(vertex)];
      Index& of_vertex = number[at(vertex)];
      if (of_vertex == kNone) {
        const Point3& p = polygons.positions[at(vertex)];
        of_vertex = static_cast<Index>(result.points.size());
        result.points.push_back({p.x, p.y});
      }
      result.of_corner.push_back(of_vertex);
    }
  return result;
}

}  // namespace limn
