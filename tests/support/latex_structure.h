#pragma once
/// Whether a piece of LaTeX can be typeset, as far as its structure tells.

#include <string>

namespace limn::test {

/// What is wrong: braces, $, \left and \right, \[ and \], environments that do not match; in array,
/// tabular and align* a row with another number of cells than there are columns, a column that is
/// empty in every row, or a \\ behind which nothing comes; & or \\ elsewhere; a control character;
/// text mode characters that need an escape. Empty: nothing.
[[nodiscard]] std::string latex_fault(const std::string& text);

}  // namespace limn::test
