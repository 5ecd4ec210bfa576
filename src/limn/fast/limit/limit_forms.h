#pragma once
/// Limit points as linear forms: what the fast engine reads its limit stencils from.

#include <array>
#include <optional>

#include "limn/limit/limit_kinds.h"
#include "limn/refine/linear_form.h"

namespace limn::fast {

/// The limit surface at a vertex of a mesh, as sums over the mesh's vertices: position and two
/// tangents, whose cross product points outward.
using LimitForms = std::array<refine::LinearForm<double>, 3>;

/// The same at a vertex whose normal is not that of two sums.
struct LimitChain {
  /// Position, and vectors t₀, t₁, … such that Σ tᵢ × tᵢ₊₁ points outward.
  std::vector<refine::LinearForm<double>> forms;
  /// As many rings, but for the outermost, must be regular so that these are the sums.
  Index rings = 1;
};

/// approx_limit_points on unit forms, so its positions, and its normals before they are normalized.
/// What it finds for a kind of vertex is kept from one mesh to the next.
class LimitReader {
 public:
  /// `scheme` must outlive it.
  explicit LimitReader(const Scheme& scheme) : scheme_(scheme), kinds_(scheme, false) {}

  /// How many rings round a regular vertex, interior or (`open`) on the boundary, must be regular
  /// but for the outermost, so that its sums are those of any such vertex.
  [[nodiscard]] Result<Index> regular_rings(bool open);
  /// At these vertices of a small mesh, which stands for part of a level made by `steps_made`
  /// steps. Its boundary is refined as the scheme has it, or (`closed`) stands for nothing: then
  /// vertices are far from it. An isolated vertex stays, its tangents are zero. Where no tangent
  /// plane follows from the eigenvectors, the tangents are those of the one face round the vertex;
  /// nothing where it has more. Fails as approx_limit_points.
  [[nodiscard]] Result<std::vector<std::optional<LimitForms>>> read(
      const Mesh& mesh, int steps_made, bool closed, const std::vector<Index>& vertices);
  /// At one vertex, not isolated, where `read` finds nothing: from the sum of the faces' normals
  /// round the vertex, or (dual splits) round its face.
  [[nodiscard]] Result<LimitChain> read_chain(const Mesh& mesh, int steps_made, bool closed,
                                              Index vertex);

 private:
  /// Calls read(LimitPlace) for each of the vertices.
  template <class Read>
  [[nodiscard]] Status search(const Mesh& mesh, int steps_made, bool closed,
                              const std::vector<Index>& vertices, Read read);

  const Scheme& scheme_;
  limit::LimitKinds kinds_;
};

}  // namespace limn::fast
