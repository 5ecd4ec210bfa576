#pragma once
/// The faces of a mesh that the fast engine refines, as arrays of Python.

#include <pybind11/pybind11.h>

#include "limn/fast/fast_refiner.h"

namespace limn::python {

/// (m, 3) or (m, 4) of int32, or (corners, offsets), as faces_object (arrays.h) has them; over
/// memory that they are written into at once.
[[nodiscard]] pybind11::object faces_of_refiner(const FastRefiner& refiner);

}  // namespace limn::python
