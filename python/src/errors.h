#pragma once
/// The library's errors as exceptions of Python.

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

#include "limn/base/error.h"

namespace limn::python {

namespace py = pybind11;

/// Which class of limn/_errors.py.
enum class Fault { scheme, mesh, other };

[[noreturn]] void raise(const Error& error, Fault fault);

template <class T>
T value_of(Result<T>&& result, Fault fault) {
  if (!result) raise(result.error(), fault);
  return std::move(result).value();
}

inline void check(const Status& status, Fault fault) {
  if (!status) raise(status.error(), fault);
}

/// Each as a warning of class limn.LimnWarning.
void warn(const Warnings& warnings);

/// The error, its file that one where it has none: analyses do not know it.
[[nodiscard]] Error in_file(Error error, const std::string& file);

}  // namespace limn::python
