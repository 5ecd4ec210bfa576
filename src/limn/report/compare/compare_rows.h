#pragma once
/// The rows of `limn compare`'s table.

#include <vector>

#include "limn/report/compare/compare_report.h"
#include "limn/report/compare/compare_table.h"

namespace limn::report {

[[nodiscard]] std::vector<TableSection> compare_sections(const Comparison& comparison);

/// Those of them that tell schemes apart at a glance, for `field_table`: split, interpolating,
/// Hölder exponent, sampling density by all artifacts in the worst direction, C1 proved, curvature
/// bounded.
[[nodiscard]] std::vector<TableRow> field_rows(const Comparison& comparison);

/// "3…5, 7"; "none" of none. Precondition: ascending.
[[nodiscard]] std::string numbers_text(const std::vector<int>& numbers);

}  // namespace limn::report
