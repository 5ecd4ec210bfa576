#pragma once
/// The JSON that the command prints, as objects of Python.

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace limn::python {

namespace py = pybind11;

/// dict, list, str, int, float, bool and None, as json.loads makes them of the command's output:
/// what is no finite number is None, bytes that are not UTF-8 are U+FFFD.
[[nodiscard]] py::object to_python(const nlohmann::ordered_json& json);

[[nodiscard]] py::str to_str(std::string_view text);

}  // namespace limn::python
