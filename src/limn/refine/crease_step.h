#pragma once
/// One step of a mesh with sharpness (mesh/sharpness/sharpness.h): which rule, in which view of the
/// mesh, makes each new vertex. Nothing here knows a weight, or what is refined.
///
/// A *view* is the mesh cut along some of its edges: it has boundaries there, so that every rule of
/// a scheme, whatever its reach, finds what it would at a boundary. With P the view that is cut
/// along all edges that are sharp, and C the one cut along those whose children are sharp too, a
/// new vertex is
///
///     of a sharp edge           P, the mean of both sides; where not both of its children are
///                               sharp, s P + (1 - s) C
///     of a smooth edge, a face  P; where C differs, the mean of both by the edges that end near it
///     of a vertex               its rule: P's (smooth), the mean of P's over the sides (crease),
///     the
///                               whole mesh's (dart), or the vertex itself (corner); where it is
///                               another for its child, that one in C, blended by the mean
///                               sharpness of what ends at the vertex, at most 1
///
/// The vertex rules blend as OpenSubdiv's do. A split with a boundary that rests refines P itself,
/// which is joined again.

#include <vector>

#include "limn/mesh/sharpness/cut_mesh.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/scheme/scheme.h"

namespace limn::refine {

/// Whether a scheme can take the sharpness of a mesh: it has rules for boundaries (the error names
/// the first that is missing), its split is no dual one, that split does not cut edges in
/// three, and where it leaves the boundary alone in every second step, there are no holes, and what
/// is sharp is infinitely so.
[[nodiscard]] Status check_takes_sharpness(const Scheme& scheme, const Sharpness& sharpness);

/// One step; it keeps the meshes that it was made of.
class CreaseStep {
 public:
  /// The mesh, cut and refined.
  struct View {
    mesh::CutMesh cut;
    SplitResult fine;          ///< of the cut mesh
    std::vector<Index> first;  ///< of each new vertex: one copy in `fine`; kNone: an isolated one
    std::vector<Index> next;   ///< of each copy: another one of the same new vertex; or kNone
  };
  /// What makes a vertex's child.
  enum class Rule : std::uint8_t { smooth, dart, crease, corner };
  /// By the vertex's own sharpness, and the number of sharp edges at it.
  [[nodiscard]] static Rule rule_of(double own, Index sharp_edges) {
    if (own > 0 || sharp_edges > 2) return Rule::corner;
    if (sharp_edges == 2) return Rule::crease;
    return sharp_edges == 1 ? Rule::dart : Rule::smooth;
  }
  struct VertexRules {
    Rule now = Rule::smooth, after = Rule::smooth;  ///< by its sharpness, and by its child's
    Index view = 0;                                 ///< of `after`, among `afters`
    double part = 1;                                ///< of `now`; the rest is that of `after`
  };
  /// The same of an edge's child: `part` is that of the crease. It is the edge's sharpness unless
  /// both halves stay sharp; by chaikin one may not from up to 4/3 on, where the part is then more
  /// than 1, as in OpenSubdiv.
  struct EdgeRules {
    double part = 1;
    Index view = 0;
  };

  /// `mesh` must outlive it. Precondition: check_takes_sharpness. Fails as `join_again` does.
  /// Cost O(fine mesh), some times that of a split.
  static Result<CreaseStep> make(const Split& split, const Mesh& mesh, const Sharpness& sharpness,
                                 int step);

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const SplitResult& fine() const { return fine_; }
  [[nodiscard]] const Sharpness& fine_sharpness() const { return fine_sharpness_; }
  /// To take out of it; the step is of no use then.
  [[nodiscard]] SplitResult& fine() { return fine_; }
  [[nodiscard]] Sharpness& fine_sharpness() { return fine_sharpness_; }

  /// P.
  [[nodiscard]] const View& now() const { return now_; }
  /// C, where a rule needs it: none or one; more where chaikin leaves but one end of edges sharp.
  [[nodiscard]] const std::vector<View>& afters() const { return afters_; }
  /// Births of the whole mesh, where a rule needs these.
  [[nodiscard]] bool has_darts() const { return darts_; }
  [[nodiscard]] const Births& whole_births() const { return whole_births_; }

  [[nodiscard]] const VertexRules& rules_of_vertex(Index v) const {
    return vertices_[static_cast<std::size_t>(v)];
  }
  /// Of the edge that a new vertex is born from; precondition: it is a sharp one, inside the mesh.
  [[nodiscard]] EdgeRules rules_of_edge(Index e) const;
  /// The part of P, the rest being C's, of a new vertex of what is smooth. Cost O(its neighbours).
  [[nodiscard]] double part_near(Index fine_vertex) const;

 private:
  class Maker;
  CreaseStep() = default;

  const Mesh* mesh_ = nullptr;
  std::vector<double> sharpness_;  // of each edge
  ChildSharpness children_;
  SplitResult fine_;
  Sharpness fine_sharpness_;
  Births whole_births_;
  View now_;
  std::vector<View> afters_;
  std::vector<Index> edge_views_;  // of each edge, among afters_; empty: the first
  std::vector<VertexRules> vertices_;
  bool darts_ = false;
  std::vector<double> ending_sums_;  // of the edges that end in this step, at each vertex
  std::vector<Index> ending_counts_;
  double mean_ending_ = 1;
};

}  // namespace limn::refine
