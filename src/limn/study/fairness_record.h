#pragma once
/// Energies of the limit surface that a scheme makes of a control mesh, level by level.

#include <functional>
#include <string>
#include <vector>

#include "limn/fairness/energy.h"
#include "limn/fairness/trend.h"
#include "limn/limit/limit_points.h"
#include "limn/scheme/scheme.h"

namespace limn::study {

/// One level: the control mesh after so many steps, with its vertices on the limit surface. An
/// energy that is no more than what rounding may change it by is 0.
struct FairnessLevel {
  int level = 0;
  Index vertices = 0, faces = 0;
  /// Σ |L p|² (fairness/laplacian.h). It falls with the number of vertices, for any smooth surface;
  /// compare it between schemes at one level and of one split only.
  double laplacian_energy = 0;
  /// … times (faces per old face)^level. It tends to a limit where second derivatives by the
  /// parameters of the lattice are square-integrable. At irregular vertices they need not be, be
  /// the surface as smooth as it may: there the lattice itself is bent.
  double scaled_laplacian = 0;
  double laplacian_rounding = 0;  ///< what rounding may change laplacian_energy by
  SurfaceEnergies energies;
};

struct FairnessRecord {
  std::string scheme;  ///< what it is called in reports
  std::string split;
  int growth = 0;                     ///< faces per old face
  std::vector<FairnessLevel> levels;  ///< 1, 2, …; the last is the best
  fairness::Trend scaled_laplacian, area, thin_plate, curvature_variation;  ///< over the levels
  /// Vertices of the last level without a limit point; only with FairnessOptions::partial.
  std::vector<LimitPoints::Refused> refused = {};

  [[nodiscard]] const FairnessLevel& last() const { return levels.back(); }
};

struct FairnessOptions {
  int levels = 0;  ///< at least 1; 0: as many as make up to kFairnessVertices vertices, at least 1
  std::function<void(int level, int levels)> progress = {};  ///< before each level
  /// Where a vertex has no limit point it stays where the level has put it (LimitOptions::partial),
  /// and is measured there.
  bool partial = false;
};
inline constexpr double kFairnessVertices = 200000;

/// Energies of the limit surface of a control mesh at levels 1, 2, …, and what they tend to.
/// `label` is what the record calls the scheme. Fails as `refine`, `approx_limit_points` and
/// `approx_energies` do. Cost: that of refining, of limit points, and some microseconds a vertex.
[[nodiscard]] Result<FairnessRecord> approx_fairness(const std::string& label, const Scheme& scheme,
                                                     const Mesh& control,
                                                     const std::vector<Point3>& points,
                                                     const FairnessOptions& options = {});

}  // namespace limn::study
