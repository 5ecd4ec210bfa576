#pragma once
/// The rows of `limn compare`'s table.

#include <vector>

#include "limn/report/compare_report.h"
#include "limn/report/compare_table.h"

namespace limn {

[[nodiscard]] std::vector<TableSection> compare_sections(const Comparison& comparison);

/// "3…5, 7"; "none" of none. Precondition: ascending.
[[nodiscard]] std::string numbers_text(const std::vector<int>& numbers);

/// "[2.976, 3.001]": ends rounded outwards to three decimals; one number where they are within
/// 1e-9; "≥ 2.976" without an upper end.
[[nodiscard]] std::string bracket_text(double lower, std::optional<double> upper);

}  // namespace limn
