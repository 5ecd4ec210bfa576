#pragma once
/// The map of the field: many schemes in one table and one chart, a line and a point for each;
/// `limn compare --all`.

#include <string>

#include "limn/figure/figure.h"
#include "limn/report/compare/compare_report.h"

namespace limn::report {

/// Aligned lines, one for each scheme, and what is missing below.
[[nodiscard]] std::string field_text(const Comparison& comparison);

/// The same table in Markdown, for documents.
[[nodiscard]] std::string field_markdown(const Comparison& comparison);

/// Each scheme at its sampling density (control edges per wavelength, by all artifacts, in the
/// worst direction) and the lower end of the bracket of its Hölder exponent (0 where that
/// is less). Schemes of which one is missing are left out. Marks tell on which lattice and whether
/// the scheme interpolates.
[[nodiscard]] figure::Figure field_figure(const Comparison& comparison);

}  // namespace limn::report
