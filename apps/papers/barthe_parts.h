#pragma once
/// Private to the page of [BGSK]: its parts.

#include "papers/paper_page.h"

namespace limn::bgsk {

/// The largest valence of charts and tables.
inline constexpr int kLastValence = 20;

/// Fig. 1: three variants of Loop on a plane and on a saddle, shaded and with reflection lines.
[[nodiscard]] Status add_variants(PaperPage& page);

/// Fig. 2: what the orbits round a vertex are called, before and after a step.
[[nodiscard]] Status add_labels(PaperPage& page);

/// §4: blocks, eigenvalues and parameter of √3, the paper's beside limn's.
[[nodiscard]] Status add_sqrt3(PaperPage& page);

/// Charts and tables of every shipped scheme that has rules.
[[nodiscard]] Status add_schemes(PaperPage& page);

/// Claims and misprints.
[[nodiscard]] Status add_words(PaperPage& page);

}  // namespace limn::bgsk
