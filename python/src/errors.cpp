#include "errors.h"

#include "json_objects.h"

namespace limn::python {
namespace {

py::object class_of(const char* name) { return py::module_::import("limn._errors").attr(name); }

}  // namespace

void raise(const Error& error, Fault fault) {
  const char* const name = fault == Fault::scheme ? "SchemeError"
                           : fault == Fault::mesh ? "MeshError"
                                                  : "Error";
  const py::object type = class_of(name);
  const py::object made =
      type(to_str(error.message), to_str(error.hint), to_str(error.file), error.line, error.column);
  PyErr_SetObject(type.ptr(), made.ptr());
  throw py::error_already_set();
}

void warn(const Warnings& warnings) {
  for (const Error& warning : warnings)
    if (PyErr_WarnEx(class_of("LimnWarning").ptr(), warning.text().c_str(), 2) != 0)
      throw py::error_already_set();
}

Error in_file(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

}  // namespace limn::python
