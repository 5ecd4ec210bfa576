#pragma once
/// The vertices at which something asked of a limit surface cannot be had.

#include <vector>

#include "limn/limit/limit_points.h"
#include "limn/limit/side_normals.h"

namespace limn {

/// Vertices at which something is missing, in ascending order.
struct LimitGaps {
  std::vector<LimitPoints::Refused> limits;  ///< without a limit point, and why
  std::vector<Index> normals;                ///< without a normal
  /// Vertices that have no curvature for one reason.
  struct Curvatures {
    NoCurvature reason;           ///< why
    std::vector<Index> vertices;  ///< where
  };
  std::vector<Curvatures> curvatures;  ///< by reason

  /// Whether anything is missing anywhere.
  [[nodiscard]] bool any() const {
    return !limits.empty() || !normals.empty() || !curvatures.empty();
  }
};

/// The vertices whose normal is zero.
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals);
/// The same where vertices may have several sides: those of which one has no normal. Cost O(H).
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals,
                                                const Mesh& mesh, const SideNormals& sides);
/// The vertices that have no curvature, by reason.
[[nodiscard]] std::vector<LimitGaps::Curvatures> without_curvature(
    const std::vector<NoCurvature>& reasons);

}  // namespace limn
