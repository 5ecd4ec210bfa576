#pragma once
/// Fairness of the limit surfaces that several schemes make of one control mesh: `limn fairness`.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/fairness/energy.h"
#include "limn/fairness/trend.h"
#include "limn/report/figure/figure.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// One level: the control mesh after so many steps, with its vertices on the limit surface.
struct FairnessLevel {
  int level = 0;
  Index vertices = 0, faces = 0;
  /// Σ |L p|² (fairness/laplacian.h). It falls with the number of vertices, for any smooth surface;
  /// compare it between schemes at one level and of one split only.
  double laplacian_energy = 0;
  /// … times (faces per old face)^level, which tends to a limit where second derivatives are
  /// square-integrable.
  double scaled_laplacian = 0;
  SurfaceEnergies energies;
};

struct FairnessRecord {
  std::string scheme;  ///< what it is called in reports
  std::string split;
  std::vector<FairnessLevel> levels;                              ///< 1 …; the last is the best
  Trend scaled_laplacian, area, thin_plate, curvature_variation;  ///< over the levels

  [[nodiscard]] const FairnessLevel& last() const { return levels.back(); }
};

struct FairnessOptions {
  int levels = 0;  ///< 0: as many as kFairnessVertices allow, at least one
  std::function<void(int level, int levels)> progress = {};  ///< before each level
};
inline constexpr double kFairnessVertices = 200000;

/// Energies of the limit surface of a control mesh at levels 1, 2, …, and what they tend to. Fails
/// as `refine`, `approx_limit_points` and `approx_energies` do. Cost: that of refining, of limit
/// points, and of some 2 µs per vertex.
[[nodiscard]] Result<FairnessRecord> approx_fairness(const std::string& label, const Scheme& scheme,
                                                     const Mesh& control,
                                                     const std::vector<Point3>& points,
                                                     const FairnessOptions& options = {});

/// {"mesh", "schemes": [{"scheme", "split", "level", "vertices", "area", "laplacian_energy",
/// "thin_plate", "curvature_variation" (all four at the last level), "trends": {NAME: {"converges":
/// "yes", "no" or "undecided", "ratio", "limit"}}, "levels": [{"level", "vertices", "faces", …}]}],
/// "fairest": {NAME: scheme}}. What is not finite or not known is null.
[[nodiscard]] nlohmann::ordered_json fairness_json(const std::string& mesh,
                                                   const std::vector<FairnessRecord>& records);

/// A table of levels for each scheme, with what they tend to, and one of all schemes, with the
/// fairest marked. An energy that grows without bound is never the fairest.
[[nodiscard]] std::string fairness_text(const std::string& mesh,
                                        const std::vector<FairnessRecord>& records);

/// The energies against the level, a line for each scheme.
[[nodiscard]] Figure fairness_figure(const std::string& mesh,
                                     const std::vector<FairnessRecord>& records);

}  // namespace limn
