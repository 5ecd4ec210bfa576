#pragma once
/// Augsdörfer, Dodgson, Sabin: Artifact analysis on triangular box-spline and subdivision meshes
/// [ADS], made anew: figures 1-12, tables 1-3, its claims and its misprints.

#include <string>

#include "limn/base/error.h"
#include "papers/paper_page.h"

namespace limn {

/// Writes fig01 … fig12 (.pdf, .svg; numbers as .csv, .json), table1 … table3 (.tex; numbers) and
/// index.html into the folder, which is made if need be.
[[nodiscard]] Status write_augsdorfer(const std::string& directory, const PaperProgress& progress);

}  // namespace limn
