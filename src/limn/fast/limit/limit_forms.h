#pragma once
/// Limit points as linear forms: what the fast engine reads its limit stencils from.

#include <array>
#include <optional>

#include "limn/fast/families/family.h"
#include "limn/limit/limit_kinds.h"

namespace limn {

/// approx_limit_points on unit forms, so its positions, and its normals before they are normalized.
/// What it finds for a kind of vertex is kept from one mesh to the next.
class ApproxLimitReader final : public fast::LimitReader {
 public:
  /// `scheme` must outlive it.
  explicit ApproxLimitReader(const Scheme& scheme) : scheme_(scheme), kinds_(scheme, false) {}

  [[nodiscard]] Result<Index> regular_rings(bool open) override;
  /// Where no tangent plane follows from the eigenvectors, the tangents are those of the one face
  /// round the vertex; nothing where it has more. Fails as approx_limit_points.
  [[nodiscard]] Result<std::vector<std::optional<fast::LimitForms>>> read(
      const Mesh& mesh, int steps_made, bool closed, const std::vector<Index>& vertices) override;
  /// From the sum of the faces' normals round the vertex, or (dual splits) round its face.
  [[nodiscard]] Result<fast::LimitChain> read_chain(const Mesh& mesh, int steps_made, bool closed,
                                                    Index vertex) override;

 private:
  /// Calls read(LimitPlace) for each of the vertices.
  template <class Read>
  [[nodiscard]] Status search(const Mesh& mesh, int steps_made, bool closed,
                              const std::vector<Index>& vertices, Read read);

  const Scheme& scheme_;
  LimitKinds kinds_;
};

}  // namespace limn
