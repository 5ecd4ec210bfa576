/// Limit stencils.

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "limn/limit/limit_stencil.h"
#include "module.h"

namespace limn::python {
namespace {

py::dict limit_stencil(const Scheme& scheme, int valence, bool boundary) {
  Result<LimitStencil> found = without_gil([&] {
    if (boundary) return approx_boundary_limit_stencil(scheme, valence);
    FrequencyAnalysis analysis(scheme);
    return approx_limit_stencil(analysis, valence);
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  py::dict stencil;
  stencil["rings"] = found->rings;
  stencil["position"] = array_of(std::move(found->position));
  stencil["first_tangent"] = array_of(std::move(found->first_tangent));
  stencil["second_tangent"] = array_of(std::move(found->second_tangent));
  stencil["has_plane"] = found->has_plane;
  return stencil;
}

}  // namespace

void bind_limits(py::module_& module) {
  module.def("limit_stencil", &limit_stencil, py::arg("scheme"), py::arg("valence"),
             py::arg("boundary"));
}

}  // namespace limn::python
