#include "support/reference_step.h"

#include <cmath>
#include <numbers>

#include "support/averaging_reference.h"
#include "support/corner_reference.h"
#include "support/old_values.h"
#include "support/quad_triangle_reference.h"
#include "support/ternary_reference.h"
#include "support/triangle_rules.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Reference : OldValues {
 public:
  Reference(const Mesh& mesh, const Births& births, const std::vector<double>& old)
      : OldValues(mesh, old), births_(births) {}

  /// Edges from a boundary vertex of k faces give their far end the weight gamma - cos(π/k)/4.
  Reference& with_smooth_pieces(double gamma) {
    boundary_gamma_ = gamma;
    return *this;
  }

  Reference& with_smooth_triangles() {
    smooth_triangles_ = true;
    return *this;
  }

  std::vector<double> triangle_dyadic(const TriangleRules& rules) {
    for (Index v = 0; v < births_.from_vertices; ++v) push(triangle_vertex(rules, v));
    for (Index e = 0; e < births_.from_edges; ++e)
      push(triangle_edge(rules, mesh_.halfedge_of_edge(e)));
    return std::move(fresh_);
  }

  std::vector<double> catmull_clark() {
    for (Index v = 0; v < births_.from_vertices; ++v) push(catmull_clark_vertex(v));
    for (Index e = 0; e < births_.from_edges; ++e) {
      const Index h = mesh_.halfedge_of_edge(e);
      if (const auto seen = from_boundary(h)) {
        push(*seen);
        continue;
      }
      const double ends = at(mesh_.origin(h)) + at(mesh_.target(h));
      const double of_faces = mesh_.is_boundary_edge(e) ? 0 : weight_of_faces(h);
      push(of_faces == 0 ? ends / 2
                         : (0.5 - of_faces) * ends +
                               of_faces * (mean(mesh_.face(h)) + mean(mesh_.face(mesh_.twin(h)))));
    }
    for (Index f = 0; f < births_.from_faces; ++f) push(mean(f));
    return std::move(fresh_);
  }

  std::vector<double> doo_sabin() {
    for (Index h = 0; h < births_.from_corners; ++h) {
      const int n = mesh_.degree(mesh_.face(h));
      double sum = at(mesh_.origin(h)) / 4;
      Index corner = h;
      for (int k = 0; k < n; ++k, corner = mesh_.next(corner))
        sum += (3 + 2 * std::cos(2 * kPi * k / n)) / (4 * n) * at(mesh_.origin(corner));
      push(sum);
    }
    for (const Index v : births_.isolated) push(at(v));
    return std::move(fresh_);
  }

  std::vector<double> sqrt3() {
    const bool boundary_moves = !births_.edge_ends.empty();
    for (Index v = 0; v < births_.from_vertices; ++v) {
      if (mesh_.is_boundary_vertex(v))
        push(boundary_moves ? (19 * at(v) + 4 * boundary_neighbours(v)) / 27 : at(v));
      else
        push(smoothed(v, (4 - 2 * std::cos(2 * kPi / mesh_.valence(v))) / (9 * mesh_.valence(v))));
    }
    for (const Index end : births_.edge_ends) {
      const Index h = end / 2;
      const bool at_target = end % 2 != 0;
      const Index near = at_target ? mesh_.target(h) : mesh_.origin(h);
      const Index far = at_target ? mesh_.origin(h) : mesh_.target(h);
      push((16 * at(near) + 10 * at(far) + at(beyond(h, at_target))) / 27);
    }
    for (Index i = 0; i < births_.from_faces; ++i)
      push(mean(births_.faces.empty() ? i : births_.faces[i]));
    return std::move(fresh_);
  }

  /// Velho and Zorin: a new vertex is the mean of its block's corners; an old one goes half the way
  /// to the mean of those across its blocks' edges.
  std::vector<double> four_eight() {
    const bool boundary_moves = births_.from_edges > 0;
    for (Index v = 0; v < births_.from_vertices; ++v) {
      if (mesh_.is_boundary_vertex(v))
        push(boundary_moves ? (6 * at(v) + boundary_neighbours(v)) / 8 : at(v));
      else
        push(mesh_.is_isolated(v) ? at(v) : (at(v) + neighbours(v) / mesh_.valence(v)) / 2);
    }
    for (const Index e : births_.edges) {
      const Index h = mesh_.halfedge_of_edge(e);
      push((at(mesh_.origin(h)) + at(mesh_.target(h))) / 2);
    }
    for (Index i = 0; i < births_.from_faces; ++i)
      push(mean(births_.faces.empty() ? i : births_.faces[i]));
    return std::move(fresh_);
  }

  /// Peters and Reif: the middle of every edge.
  std::vector<double> midedge() {
    for (Index i = 0; i < births_.from_edges; ++i) {
      const Index h = mesh_.halfedge_of_edge(births_.edges.empty() ? i : births_.edges[i]);
      push((at(mesh_.origin(h)) + at(mesh_.target(h))) / 2);
    }
    for (const Index v : births_.isolated) push(at(v));
    return std::move(fresh_);
  }

 private:
  void push(double value) { fresh_.push_back(value); }
  [[nodiscard]] double smoothed(Index v, double beta) const {
    if (mesh_.is_isolated(v)) return at(v);
    return (1 - mesh_.valence(v) * beta) * at(v) + beta * neighbours(v);
  }

  [[nodiscard]] double triangle_vertex(const TriangleRules& rules, Index v) const {
    if (!mesh_.is_boundary_vertex(v)) return smoothed(v, rules.beta(std::max(mesh_.valence(v), 1)));
    return rules.tension ? at(v) : (6 * at(v) + boundary_neighbours(v)) / 8;
  }

  [[nodiscard]] double triangle_edge(const TriangleRules& rules, Index h) const {
    const Index from = mesh_.origin(h), to = mesh_.target(h);
    if (mesh_.twin(h) == kNone) {
      const double ends = at(from) + at(to);
      if (!rules.tension) return ends / 2;
      const double w = *rules.tension;
      return (1 / 2. + w) * ends - w * (at(beyond(h, false)) + at(beyond(h, true)));
    }
    const bool odd_from = is_special(rules, from);
    const bool odd_to = is_special(rules, to);
    if (odd_from && odd_to) return (from_end(rules, h) + from_end(rules, mesh_.twin(h))) / 2;
    if (odd_from) return from_end(rules, h);
    if (odd_to) return from_end(rules, mesh_.twin(h));
    if (const auto seen = from_boundary(h)) return *seen;
    return edge_side(rules, h) + edge_side(rules, mesh_.twin(h));
  }

  [[nodiscard]] bool is_special(const TriangleRules& rules, Index v) const {
    return rules.ends && !mesh_.is_boundary_vertex(v) && rules.ends->special(mesh_.valence(v));
  }

  /// Round the origin of h, counterclockwise from h.
  [[nodiscard]] double from_end(const TriangleRules& rules, Index h) const {
    const int n = mesh_.valence(mesh_.origin(h));
    double sum = rules.ends->self(n) * at(mesh_.origin(h));
    Index spoke = h;
    for (int k = 0; k < n; ++k, spoke = mesh_.rotate(spoke))
      sum += rules.ends->spoke(n, k) * at(mesh_.target(spoke));
    return sum;
  }

  /// [Biermann, Levin, Zorin 2000] The mean of what h's ends on the boundary say of it; nothing
  /// where there is none, on the boundary itself, and in other schemes.
  [[nodiscard]] std::optional<double> from_boundary(Index h) const {
    if (!boundary_gamma_ || mesh_.twin(h) == kNone) return std::nullopt;
    double sum = 0;
    int ends = 0;
    for (const Index out : {h, mesh_.twin(h)}) {
      if (!mesh_.is_boundary_vertex(mesh_.origin(out))) continue;
      const int faces = mesh_.valence(mesh_.origin(out)) - 1;
      const double gamma = *boundary_gamma_ - std::cos(kPi / faces) / 4;
      double beside = 0;  // in either face next to either end: in a triangle one vertex twice
      for (const Index side : {h, mesh_.twin(h)})
        beside += at(mesh_.target(mesh_.next(side))) + at(mesh_.origin(mesh_.prev(side)));
      sum += (3 / 4. - gamma) * at(mesh_.origin(out)) + gamma * at(mesh_.target(out)) + beside / 16;
      ++ends;
    }
    if (ends == 0) return std::nullopt;
    return sum / ends;
  }

  /// What the edge rule takes on the left of h, and at h's target end.
  [[nodiscard]] double edge_side(const TriangleRules& rules, Index h) const {
    double sum = rules.end * at(mesh_.target(h)) + rules.wing * at(apex(h));
    for (const Index side : {mesh_.next(h), mesh_.prev(h)}) {
      const Index out = mesh_.twin(side);
      // beyond the boundary: the parallelogram's fourth corner
      sum += rules.outer * (out != kNone
                                ? at(apex(out))
                                : at(mesh_.origin(side)) + at(mesh_.target(side)) - at(apex(side)));
    }
    return sum + rules.opposite * (straight_on_left(h) + straight_on_right(h)) / 2;
  }

  /// 1/4; of smooth triangles 0.47, and the mean of both sides, as in
  /// OpenSubdiv's sdc/catmarkScheme.h.
  [[nodiscard]] double weight_of_faces(Index h) const {
    const auto seen = [&](Index f) {
      return smooth_triangles_ && mesh_.degree(f) == 3 ? 0.47 : 0.25;
    };
    return (seen(mesh_.face(h)) + seen(mesh_.face(mesh_.twin(h)))) / 2;
  }

  /// Q/n + 2R/n + S(n-3)/n: means of the new face points, of the edges' middles, the vertex.
  [[nodiscard]] double catmull_clark_vertex(Index v) const {
    if (mesh_.is_isolated(v)) return at(v);
    if (mesh_.is_boundary_vertex(v)) return (6 * at(v) + boundary_neighbours(v)) / 8;
    const double n = mesh_.valence(v);
    double faces = 0;
    const Index first = mesh_.halfedge_of_vertex(v);
    Index h = first;
    do {
      faces += mean(mesh_.face(h));
      h = mesh_.rotate(h);
    } while (h != first);
    const double middles = (n * at(v) + neighbours(v)) / 2;
    return (faces / n + 2 * middles / n + (n - 3) * at(v)) / n;
  }

  const Births& births_;
  std::optional<double> boundary_gamma_;
  bool smooth_triangles_ = false;
  std::vector<double> fresh_;
};

}  // namespace

bool has_reference(const std::string& scheme) {
  return triangle_rules(scheme, {}) || has_corner_reference(scheme) ||
         has_ternary_reference(scheme) || scheme == "catmull-clark" ||
         scheme == "catmull-clark, smooth triangles" ||
         scheme == "catmull-clark-piecewise-smooth" || scheme == "doo-sabin" || scheme == "sqrt3" ||
         scheme == "four-eight" || scheme == "midedge" || scheme == "box-spline-quad" ||
         scheme == "b-spline-quad" || scheme == "quad-triangle";
}

std::vector<double> reference_step(const std::string& scheme, std::optional<double> parameter,
                                   const Mesh& mesh, const Births& births,
                                   const std::vector<double>& old) {
  if (has_corner_reference(scheme))
    return corner_reference_step(scheme, parameter, mesh, births, old);
  if (scheme == "b-spline-quad")
    return averaging_reference_step(3, parameter.value_or(0), mesh, old);
  if (scheme == "quad-triangle")
    return quad_triangle_reference_step(mesh, old, parameter.value_or(0));
  Reference reference(mesh, births, old);
  if (scheme == "catmull-clark" || scheme == "box-spline-quad") return reference.catmull_clark();
  if (scheme == "catmull-clark, smooth triangles")
    return reference.with_smooth_triangles().catmull_clark();
  if (scheme == "catmull-clark-piecewise-smooth")
    return reference.with_smooth_pieces(3 / 8.).catmull_clark();
  if (scheme == "loop-piecewise-smooth") reference.with_smooth_pieces(1 / 2.);
  if (scheme == "doo-sabin") return reference.doo_sabin();
  if (scheme == "sqrt3") return reference.sqrt3();
  if (scheme == "four-eight") return reference.four_eight();
  if (scheme == "midedge") return reference.midedge();
  if (has_ternary_reference(scheme))
    return ternary_reference_step(scheme, parameter, mesh, births, old);
  return reference.triangle_dyadic(*triangle_rules(scheme, parameter));
}

}  // namespace limn::test
