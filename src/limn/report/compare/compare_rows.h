#pragma once
/// The rows of `limn compare`'s table.

#include <vector>

#include "limn/report/compare/compare_report.h"
#include "limn/report/compare/compare_table.h"

namespace limn {

[[nodiscard]] std::vector<TableSection> compare_sections(const Comparison& comparison);

/// "3…5, 7"; "none" of none. Precondition: ascending.
[[nodiscard]] std::string numbers_text(const std::vector<int>& numbers);

}  // namespace limn
