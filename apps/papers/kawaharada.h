#pragma once
/// Kawaharada, Sugihara: Laplacian Subdivision and Optimal Schemes [KS], made anew: figures 6-15,
/// 23-34 and 36-46, the stencils of figures 16-22, and what limn finds of each of its claims.

#include <string>

#include "limn/base/error.h"
#include "papers/paper_page.h"

namespace limn {

/// Writes the figures (.pdf, .svg; numbers as .csv, .json), the control meshes (.obj), tables and
/// index.html into the folder, which is made if need be.
[[nodiscard]] Status write_kawaharada(const std::string& directory, const PaperProgress& progress);

}  // namespace limn
