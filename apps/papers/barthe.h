#pragma once
/// Barthe, Gérot, Sabin, Kobbelt: Simple computation of the eigencomponents of a subdivision matrix
/// in the Fourier domain [BGSK], made anew: figures 1 and 2, the √3 example, and what the method
/// finds for every shipped scheme.

#include <string>

#include "limn/base/error.h"
#include "papers/paper_page.h"

namespace limn {

/// Writes fig01 … fig03 (.pdf, .svg; numbers as .csv, .json), the tables of the √3 example, a chart
/// and a table of each shipped scheme's eigencomponents at the valences 3 … 20, and index.html into
/// the folder, which is made if need be.
[[nodiscard]] Status write_barthe(const std::string& directory, const PaperProgress& progress);

}  // namespace limn
