#pragma once
/// Solved parameters as a scheme file: `limn tune -o`.

#include <string>
#include <vector>

#include "limn/tune/solve.h"

namespace limn::report {

/// A scheme file that extends `extends` (what it is to be called there: a shipped name or a path)
/// and gives the freed name its solution at each of these valences: of those that hold the one
/// nearest to the scheme's own value. A solution is written as the fraction it is, or as that of
/// its double, so that weights still sum to exactly 1. Where none holds, and at a regular valence
/// that is solved beside others (their neighbours have it), the scheme's own value is kept; a
/// comment says so. Fails where nothing is left to write, and where the name is one number
/// everywhere while more than one valence was solved.
[[nodiscard]] Result<std::string> tuned_scheme_text(const FreedScheme& freed,
                                                    const Requirement& requirement,
                                                    const std::vector<ValenceSolutions>& solutions,
                                                    const std::string& extends);

}  // namespace limn::report
