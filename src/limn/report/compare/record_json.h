#pragma once
/// All that `limn compare` says of one scheme, as JSON.

#include <nlohmann/json_fwd.hpp>

#include "limn/study/compare_record.h"

namespace limn::report {

/// {"scheme", "split", "interpolating", "regularity": regularity_json's,
/// "regular_part": regular_part_json's, "artifacts":
/// [{"edges_per_wavelength", "worst_percent", "worst_direction_degrees", "best_percent",
/// "best_direction_degrees"}], "sampling": {"total_energy", "mean_energy"}, each as density_json,
/// "valences": [eigen_json's without the blocks; "components" null where there are none],
/// "missing": [reasons]}. What is missing is null.
[[nodiscard]] nlohmann::ordered_json record_json(const study::SchemeRecord& record);

}  // namespace limn::report
