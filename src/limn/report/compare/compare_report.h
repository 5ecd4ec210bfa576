#pragma once
/// Schemes side by side, as text and JSON: `limn compare`.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/report/compare/compare_figure.h"
#include "limn/report/fairness_report.h"
#include "limn/report/limit_report.h"
#include "limn/study/compare_record.h"

namespace limn::report {

/// The limit surfaces of schemes over one control mesh.
struct MeshComparison {
  std::string mesh;                                          ///< what the mesh is called
  std::vector<Result<study::FairnessRecord>> fairness = {};  ///< one for each scheme
  std::vector<NamedSurface> surfaces = {};   ///< of the schemes that have one, in their order
  std::vector<PairDistance> distances = {};  ///< by places in `surfaces`
  std::vector<std::string> missing = {};     ///< why a surface or a distance is missing
  /// Of each scheme: where its surface has no limit point or no normal (limit_surface).
  std::vector<LimitGaps> gaps = {};
};

struct Comparison {
  double tolerance = 1;  ///< percent, of the sampling densities
  std::vector<study::SchemeRecord> schemes = {};
  std::optional<MeshComparison> on_mesh = {};
};

struct MeshOptions {
  /// After which surfaces are sampled, of splits that make four faces of one; of others as many as
  /// come nearest to that number of faces.
  int steps = 4;
  int fairness_levels = 0;                                     ///< see FairnessOptions
  std::function<void(const std::string& what)> progress = {};  ///< called before each part
};

struct LabelledScheme {
  std::string label;
  Scheme scheme;
};

/// That the steps can be made by every scheme that refines this mesh at all: they are refused
/// before any work. The error names the scheme and the sizes.
[[nodiscard]] Status check_steps(const std::vector<LabelledScheme>& schemes, const Mesh& mesh,
                                 const MeshOptions& options);

/// What is missing of the surfaces at vertices, a sentence for each scheme and reason.
[[nodiscard]] Warnings gap_warnings(const MeshComparison& comparison,
                                    const std::vector<LabelledScheme>& schemes);

/// Limit surfaces, distances and fairness of the schemes that refine this mesh. A scheme that does
/// not (of triangles, on quads) is an error in its place. A vertex without a limit point stays
/// where the steps have put it, in the surface and in the energies, and is told.
[[nodiscard]] MeshComparison compare_on_mesh(const std::vector<LabelledScheme>& schemes,
                                             const std::string& name, const Mesh& mesh,
                                             const std::vector<Point3>& points,
                                             const MeshOptions& options = {});

/// A table with a column a scheme and a line a property, " *" at the best of its line; distances
/// and what is missing below. `differences`: only lines in which the schemes differ.
[[nodiscard]] std::string compare_text(const Comparison& comparison, bool differences = false);

/// Why parts of the records are missing, below a line that says what they show as: "–"; empty where
/// nothing is.
[[nodiscard]] std::string missing_text(const Comparison& comparison);

/// {"tolerance_percent", "mesh": name or null, "schemes": [record_json's, with "fairness": as in
/// fairness_json or null where there is a mesh], "distances": [{"a", "b", "largest", "mean",
/// "relative": largest over the diagonal of the box round both, "at": [point of a, point of b]}],
/// "missing": [reasons]}; where there is a mesh, each of the schemes has "gaps" besides
/// (gaps_json). The same values whatever the order of the schemes.
[[nodiscard]] nlohmann::ordered_json compare_json(const Comparison& comparison);

}  // namespace limn::report
