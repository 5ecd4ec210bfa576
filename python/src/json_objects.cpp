#include "json_objects.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace limn::python {

py::str to_str(std::string_view text) {
  PyObject* const made =
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

namespace {

py::object to_dict(const nlohmann::ordered_json& json) {
  py::dict dict;
  for (const auto& [key, value] : json.items()) dict[to_str(key)] = to_python(value);
  return dict;
}

py::object to_list(const nlohmann::ordered_json& json) {
  py::list list(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) list[i] = to_python(json[i]);
  return list;
}

}  // namespace

py::object to_python(const nlohmann::ordered_json& json) {
  using Type = nlohmann::ordered_json::value_t;
  switch (json.type()) {
    case Type::object: return to_dict(json);
    case Type::array: return to_list(json);
    case Type::string: return to_str(json.get_ref<const std::string&>());
    case Type::boolean: return py::bool_(json.get<bool>());
    case Type::number_integer: return py::int_(json.get<std::int64_t>());
    case Type::number_unsigned: return py::int_(json.get<std::uint64_t>());
    case Type::number_float: {
      const auto value = json.get<double>();
      if (std::isfinite(value)) return py::float_(value);
      return py::none();
    }
    default: return py::none();
  }
}

}  // namespace limn::python
