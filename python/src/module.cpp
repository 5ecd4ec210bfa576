#include "module.h"

#include "limn/base/budget.h"
#include "limn/base/progress.h"

PYBIND11_MODULE(_limn, module) {
  namespace python = limn::python;
  limn::base::ProgressLine::show_none();
  module.attr("__version__") = LIMN_VERSION;
  python::bind_schemes(module);
  python::bind_analyses(module);
  python::bind_lattice(module);
  python::bind_proofs(module);
  python::bind_meshes(module);
  python::bind_surfaces(module);
  python::bind_refiner(module);
  python::bind_limits(module);
  python::bind_reports(module);
  python::bind_papers(module);
  python::bind_studies(module);
  python::bind_tuning(module);
  python::bind_pictures(module);
  module.def("set_thread_limit", &limn::set_thread_limit, pybind11::arg("threads"));
  module.def("thread_limit", &limn::thread_limit);
}
