#pragma once
/// Fairness of the limit surfaces that several schemes make of one control mesh, as text, JSON and
/// charts: `limn fairness`.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/figure/figure.h"
#include "limn/study/fairness_record.h"

namespace limn::report {

/// {"mesh", "schemes": [{"scheme", "split", "level", "vertices", VALUES, "trends": {NAME:
/// {"converges": "yes", "no" or "undecided", "order" (in the mesh width), "limit"}}, "levels":
/// [{"level", "vertices", "faces", "left_out", VALUES}]}], "fairest": {NAME: scheme}}. VALUES are
/// "area", "laplacian_energy", "scaled_laplacian", "thin_plate" and "curvature_variation", of the
/// last level those of a scheme; all but the second have a trend. What is not finite or not known
/// is null.
[[nodiscard]] nlohmann::ordered_json fairness_json(
    const std::string& mesh, const std::vector<study::FairnessRecord>& records);

/// A table of levels for each scheme, with what they tend to, and one of all schemes at their last
/// levels. There the fairest is marked: the least energy of those that do not grow without bound.
/// Of Σ |L p|² there is a fairest only among schemes of one split at one level.
[[nodiscard]] std::string fairness_text(const std::string& mesh,
                                        const std::vector<study::FairnessRecord>& records);

/// The energies against the level, a line for each scheme.
[[nodiscard]] figure::Figure fairness_figure(const std::string& mesh,
                                             const std::vector<study::FairnessRecord>& records);

}  // namespace limn::report
