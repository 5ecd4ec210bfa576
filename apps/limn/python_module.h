#pragma once
/// What the command leaves to limn's Python module.

#include <string>
#include <vector>

#include "limn/base/error.h"

namespace limn::app {

/// Becomes `python3 -m MODULE ARGUMENT…`: returns only where that cannot be, with what to do. The
/// interpreter is $LIMN_PYTHON, else the first of python3 in PATH and /usr/bin/python3 that has
/// limn and `needed`, another module. limn is also looked for beside this program: in python/ of a
/// build folder, and where `cmake --install` puts it.
[[nodiscard]] Error become_python(const std::string& module, const std::string& needed,
                                  const std::vector<std::string>& arguments);

}  // namespace limn::app
