#pragma once
/// The parts of the extension module limn._limn: what limn/*.py calls. Each adds its own to
/// `module`.

#include <pybind11/pybind11.h>

namespace limn::python {

void bind_schemes(pybind11::module_& module);
void bind_analyses(pybind11::module_& module);
void bind_lattice(pybind11::module_& module);
void bind_proofs(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_surfaces(pybind11::module_& module);
void bind_refiner(pybind11::module_& module);
void bind_limits(pybind11::module_& module);
void bind_reports(pybind11::module_& module);
void bind_papers(pybind11::module_& module);
void bind_studies(pybind11::module_& module);
void bind_tuning(pybind11::module_& module);
void bind_pictures(pybind11::module_& module);

}  // namespace limn::python
