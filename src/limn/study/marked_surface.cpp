#include "limn/study/marked_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "limn/base/memory.h"
#include "limn/figure/space/space_curves.h"
#include "limn/mesh/index.h"
#include "limn/mesh/split/heritage.h"
#include "limn/refine/crease_step.h"
#include "limn/study/surface_scenes.h"
#include "limn/surface/refine_surface.h"
#include "limn/surface/surface_estimate.h"

namespace limn::study {
namespace {

using mesh::at;

// --- where edges and faces of the control mesh are in the refined one -------------------------

/// Of the refined mesh.
struct Heritage {
  struct Edge {
    Index from, to;  ///< vertices
    Index control;   ///< the edge of the control mesh that it lies on
  };
  std::vector<Edge> edges;   ///< those on edges of the control mesh
  std::vector<Index> faces;  ///< of each face, that of the control mesh
};

/// Precondition: keeps_old_edges.
Heritage heritage_of(const Split& split, Mesh mesh, int steps) {
  std::vector<Index> edge_of(at(mesh.edge_count())), face_of(at(mesh.face_count()));
  for (Index e = 0; e < mesh.edge_count(); ++e) edge_of[at(e)] = e;
  for (Index f = 0; f < mesh.face_count(); ++f) face_of[at(f)] = f;
  for (int step = 0; step < steps; ++step) {
    SplitResult fine = split.apply(mesh, step);
    const std::vector<Index> old = mesh::old_halfedges(mesh, fine);
    std::vector<Index> on(at(fine.mesh.edge_count()), kNone);
    for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
      const Index h = old[at(fine.mesh.halfedge_of_edge(e))];
      if (h != kNone) on[at(e)] = edge_of[at(mesh.edge(h))];
    }
    std::vector<Index> parents = mesh::faces_between(mesh, fine.mesh, old);
    for (Index& parent : parents)
      if (parent != kNone) parent = face_of[at(parent)];
    edge_of = std::move(on);
    face_of = std::move(parents);
    mesh = std::move(fine.mesh);
  }
  Heritage heritage;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (edge_of[at(e)] != kNone)
      heritage.edges.push_back({mesh.origin(h), mesh.target(h), edge_of[at(e)]});
  }
  heritage.faces = std::move(face_of);
  return heritage;
}

// --- marks ------------------------------------------------------------------------------------

/// A kind of sharpness that has a colour of its own: up to `most`.
struct Band {
  double most = 0;
  std::string name;
};

std::string text_of(double sharpness) {
  return sharpness >= kInfinitelySharp ? "infinite" : fmt::format("{:.3g}", sharpness);
}

/// One for each value, where these are few; else some that hold them all.
std::vector<Band> bands_of(std::vector<double> values) {
  constexpr std::size_t few = 5;
  for (double& value : values) value = std::min(value, kInfinitelySharp);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<Band> bands;
  if (values.size() <= few) {
    for (const double value : values) bands.push_back({value, text_of(value)});
    return bands;
  }
  double low = 0;
  for (const double high : {1.0, 2.0, 4.0, std::nextafter(kInfinitelySharp, 0)}) {
    if (std::any_of(values.begin(), values.end(), [&](double x) { return low < x && x <= high; }))
      bands.push_back({high, low == 0   ? "up to 1"
                             : high < 5 ? fmt::format("over {:g} to {:g}", low, high)
                                        : fmt::format("over {:g}", low)});
    low = high;
  }
  if (values.back() >= kInfinitelySharp) bands.push_back({kInfinitelySharp, "infinite"});
  return bands;
}

/// The sharper the darker and the wider.
figure::SceneMarks marks_of(double sharpness, std::string name) {
  figure::SceneMarks marks;
  marks.name = std::move(name);
  if (sharpness >= kInfinitelySharp) {
    marks.colour = {0.55, 0.02, 0.12};
    marks.stroke.width = 1.8;
    return marks;
  }
  const double t = std::min(sharpness, 4.0) / 4;
  marks.colour = {1 - 0.2 * t, 0.84 - 0.74 * t, 0.1 + 0.25 * t};
  marks.stroke.width = 0.8 + 0.7 * t;
  return marks;
}

figure::SceneMarks seam_marks() {
  figure::SceneMarks marks;
  marks.name = "seams of the texture";
  marks.colour = {0.10, 0.32, 0.80};
  marks.stroke = {1.1, {3, 2.5}};
  return marks;
}

/// Which control edges the texture is cut along.
std::vector<bool> seams_of(const Mesh& mesh, const TextureCoordinates& texture) {
  std::vector<bool> seams(at(mesh.edge_count()), false);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), t = mesh.twin(h);
    if (t == kNone) continue;
    const auto point = [&](Index corner) { return texture.of_corner[at(corner)]; };
    seams[at(e)] = point(h) != point(mesh.next(t)) || point(mesh.next(h)) != point(t);
  }
  return seams;
}

class Work {
 public:
  Work(const Scheme& scheme, const Mesh& control, const MarkedOptions& options)
      : scheme_(scheme), control_(control), options_(options) {}

  Result<MarkedSurface> run(const std::vector<Point3>& points) {
    if (Status takes = refine::check_takes_sharpness(scheme_, options_.sharpness); !takes)
      return takes.error();
    if (Status status = check_size(); !status) return status.error();
    const TextureCoordinates* const texture = options_.texture;
    const bool has_texture = texture != nullptr && !texture->empty();
    if (has_texture && options_.marks && mesh::keeps_old_edges(*scheme_.split))
      seams_ = seams_of(control_, *texture);
    MeshAttributes attributes;
    SurfaceOptions wanted{
        .levels = options_.steps, .limit = true, .normals = true, .partial = true};
    wanted.sharpness = options_.sharpness;
    wanted.sharpness.holes.clear();  // their vertices keep their numbers
    wanted.attribute_rules.texture = options_.rule;
    if (has_texture && options_.textured) {
      attributes.texture = *texture;
      wanted.attributes = &attributes;
    }
    if (needs_heritage()) wanted.engine = SurfaceOptions::Engine::plain;
    Result<RefinedSurface> surface = refine_surface(scheme_, control_, points, wanted);
    if (!surface) return surface.error();
    if (needs_heritage()) heritage_ = heritage_of(*scheme_.split, control_, options_.steps);
    MarkedSurface result;
    result.surface = sampled(*surface);
    if (options_.sharpness.any()) surface->gaps.normals.clear();
    if (options_.marks) {
      add_marks(surface->limit, result.marks);
      if (!mesh::keeps_old_edges(*scheme_.split)) add_lasting(*surface, result.marks);
    }
    result.gaps = std::move(surface->gaps);
    return result;
  }

  /// The control mesh itself.
  MarkedSurface run_flat(const std::vector<Point3>& points) {
    if (options_.texture != nullptr && !options_.texture->empty() && options_.marks)
      seams_ = seams_of(control_, *options_.texture);
    for (Index e = 0; e < control_.edge_count(); ++e) {
      const Index h = control_.halfedge_of_edge(e);
      heritage_.edges.push_back({control_.origin(h), control_.target(h), e});
    }
    MarkedSurface result;
    result.surface = flat(points);
    if (options_.marks) add_marks(points, result.marks);
    return result;
  }

 private:
  [[nodiscard]] bool needs_heritage() const {
    if (!mesh::keeps_old_edges(*scheme_.split)) return false;
    const bool seams = std::find(seams_.begin(), seams_.end(), true) != seams_.end();
    return (options_.marks && (options_.sharpness.any() || seams)) ||
           options_.sharpness.has_holes();
  }

  [[nodiscard]] Status check_size() const {
    const DrawingEstimate drawing = estimate_drawing(scheme_, control_, options_.steps);
    refine::RefineEstimate needed = surface::estimate_with_limit(scheme_, control_, options_.steps,
                                                                 {.quick = false, .limit = true});
    constexpr double sides = 56;  // which a vertex has: a list of its own
    needed.peak_bytes += (kSurfaceBytes + sides) * needed.vertices;
    needed.peak_bytes = std::max(needed.peak_bytes, drawing.bytes);
    return refine::check_memory(needed, options_.steps, base::available_memory());
  }

  /// A vertex for each side of each one, faces cut by fans.
  [[nodiscard]] figure::SmoothSurface sampled(const RefinedSurface& surface) const {
    figure::SmoothSurface sampled;
    const Polygons& mesh = surface.polygons;
    const TextureCoordinates& texture = surface.attributes.texture;
    const bool textured = !texture.empty();
    std::vector<std::vector<std::array<Index, 3>>> sides(mesh.positions.size());
    figure::SpaceVector face_normal{};
    const auto vertex_of = [&](Index c) {
      const Index v = mesh.corners[at(c)];
      const auto add = [&](const figure::SpaceVector& normal) {
        sampled.vertices.push_back(vector_of(surface.limit[at(v)]));
        sampled.normals.push_back(normal);
        if (textured) sampled.texture.push_back(coordinates(texture, c));
        return static_cast<Index>(sampled.vertices.size()) - 1;
      };
      const Index point = textured ? texture.of_corner[at(c)] : kNone;
      const Index side = surface.sides.empty() ? kNone : surface.sides.of_corner[at(c)];
      const Point3& normal =
          side == kNone ? surface.normals[at(v)] : surface.sides.normals[at(side)];
      if (normal == Point3{} && options_.sharpness.any()) return add(face_normal);  // a tip
      for (const auto& [known_point, known_side, number] : sides[at(v)])
        if (known_point == point && known_side == side) return number;
      sides[at(v)].push_back({point, side, add(vector_of(normal))});
      return sides[at(v)].back()[2];
    };
    std::vector<int> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (is_hole(f)) continue;
      corners.clear();
      face_normal = normal_of(surface, f);
      for (Index c = mesh.face_begin[at(f)]; c < mesh.face_begin[at(f) + 1]; ++c)
        corners.push_back(vertex_of(c));
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sampled.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
    return sampled;
  }

  /// By area, of a face with its corners on the limit surface; none where no sharp tip needs it.
  [[nodiscard]] figure::SpaceVector normal_of(const RefinedSurface& surface, Index f) const {
    figure::SpaceVector normal{};
    if (!options_.sharpness.any()) return normal;
    const Polygons& mesh = surface.polygons;
    const Index first = mesh.face_begin[at(f)], end = mesh.face_begin[at(f) + 1];
    const auto from_first = [&](Index c) {
      return figure::sum(vector_of(surface.limit[at(mesh.corners[at(c)])]),
                         vector_of(surface.limit[at(mesh.corners[at(first)])]), -1);
    };
    for (Index c = first + 1; c + 1 < end; ++c)
      normal = figure::sum(normal, figure::cross(from_first(c), from_first(c + 1)), 1);
    return normal;
  }

  /// The faces of the control mesh, each with a normal of its own.
  [[nodiscard]] figure::SmoothSurface flat(const std::vector<Point3>& points) const {
    figure::SmoothSurface flat;
    const bool textured =
        options_.textured && options_.texture != nullptr && !options_.texture->empty();
    for (Index f = 0; f < control_.face_count(); ++f) {
      if (options_.sharpness.has_holes() && options_.sharpness.holes[at(f)]) continue;
      const auto first = static_cast<int>(flat.vertices.size());
      const figure::SpaceVector origin =
          vector_of(points[at(control_.origin(control_.face_begin(f)))]);
      figure::SpaceVector normal{};
      for (Index h = control_.face_begin(f); h < control_.face_begin(f + 1); ++h) {
        flat.vertices.push_back(vector_of(points[at(control_.origin(h))]));
        const figure::SpaceVector next = vector_of(points[at(control_.target(h))]);
        normal = figure::sum(normal,
                             figure::cross(figure::sum(flat.vertices.back(), origin, -1),
                                           figure::sum(next, origin, -1)),
                             1);
        if (textured) flat.texture.push_back(coordinates(*options_.texture, h));
      }
      flat.normals.resize(flat.vertices.size(), normal);
      for (int i = first + 1; i + 1 < static_cast<int>(flat.vertices.size()); ++i)
        flat.triangles.push_back({first, i, i + 1});
    }
    return flat;
  }

  /// Not-a-numbers where the corner has none.
  static std::array<double, 2> coordinates(const TextureCoordinates& texture, Index corner) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Index point = texture.of_corner[at(corner)];
    if (point == kNone) return {nan, nan};
    return {texture.points[at(point)].u, texture.points[at(point)].v};
  }

  [[nodiscard]] bool is_hole(Index face) const {
    if (!options_.sharpness.has_holes() || heritage_.faces.empty()) return false;
    const Index parent = heritage_.faces[at(face)];
    return parent != kNone && options_.sharpness.holes[at(parent)];
  }

  struct SharpEdge {
    Index from, to;
    double sharpness;
  };

  /// Those on edges of the control mesh, and its vertices, which keep their numbers.
  void add_marks(const std::vector<Point3>& points, std::vector<figure::SceneMarks>& marks) const {
    std::vector<SharpEdge> edges;
    std::vector<figure::SpaceSegment> seams;
    for (const Heritage::Edge& edge : heritage_.edges) {
      const bool inside = !control_.is_boundary_edge(edge.control);
      const double sharp = sharpness_of_edge(control_, options_.sharpness, edge.control);
      if (inside && sharp > 0) edges.push_back({edge.from, edge.to, sharp});
      if (!seams_.empty() && seams_[at(edge.control)])
        seams.push_back(segment(points, edge.from, edge.to));
    }
    add_edges(points, edges, marks);
    add_corners(points, marks);
    if (seams.empty()) return;
    marks.push_back(seam_marks());
    marks.back().curves = figure::joined(seams);
  }

  /// What is still sharp, where all that is sharp is so for ever.
  static void add_lasting(const RefinedSurface& surface, std::vector<figure::SceneMarks>& marks) {
    std::vector<SharpEdge> edges;
    for (const SharpnessTags::Crease& crease : surface.sharp.creases)
      edges.push_back({crease.vertices[0], crease.vertices[1], crease.sharpness[0]});
    add_edges(surface.limit, edges, marks);
  }

  static figure::SpaceSegment segment(const std::vector<Point3>& points, Index from, Index to) {
    return {from, to, vector_of(points[at(from)]), vector_of(points[at(to)])};
  }

  static void add_edges(const std::vector<Point3>& points, const std::vector<SharpEdge>& edges,
                        std::vector<figure::SceneMarks>& marks) {
    std::vector<double> values;
    values.reserve(edges.size());
    for (const SharpEdge& edge : edges) values.push_back(edge.sharpness);
    double low = 0;
    for (const Band& band : bands_of(values)) {
      std::vector<figure::SpaceSegment> segments;
      for (const SharpEdge& edge : edges)
        if (const double s = std::min(edge.sharpness, kInfinitelySharp); low < s && s <= band.most)
          segments.push_back(segment(points, edge.from, edge.to));
      marks.push_back(marks_of(band.most, "edges of sharpness " + band.name));
      marks.back().curves = figure::joined(segments);
      low = band.most;
    }
  }

  void add_corners(const std::vector<Point3>& points,
                   std::vector<figure::SceneMarks>& marks) const {
    std::vector<double> values;
    for (const double s : options_.sharpness.vertices)
      if (s > 0) values.push_back(s);
    double low = 0;
    for (const Band& band : bands_of(values)) {
      figure::SceneMarks kind = marks_of(band.most, "vertices of sharpness " + band.name);
      for (std::size_t v = 0; v < options_.sharpness.vertices.size(); ++v) {
        const double s = std::min(options_.sharpness.vertices[v], kInfinitelySharp);
        if (low < s && s <= band.most) kind.points.push_back(vector_of(points[v]));
      }
      marks.push_back(std::move(kind));
      low = band.most;
    }
  }

  const Scheme& scheme_;
  const Mesh& control_;
  const MarkedOptions& options_;
  std::vector<bool> seams_;  // of the control mesh's edges
  Heritage heritage_;
};

}  // namespace

MarkedSurface marked_control(const Scheme& scheme, const Mesh& control,
                             const std::vector<Point3>& points, const MarkedOptions& options) {
  return Work(scheme, control, options).run_flat(points);
}

Result<MarkedSurface> marked_surface(const Scheme& scheme, const Mesh& control,
                                     const std::vector<Point3>& points,
                                     const MarkedOptions& options) {
  return Work(scheme, control, options).run(points);
}

}  // namespace limn::study
